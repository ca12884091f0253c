// A case: everything a command needs to know, read from a TOML file with overrides and validated in
// full before anything is computed.
// The keys, with what each may be: case_schema.cpp.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/body/body.hpp"
#include "lib/body/motion.hpp"
#include "lib/material/material_coordinates.hpp"
#include "lib/material/potential.hpp"
#include "lib/number/elementary.hpp"
#include "lib/number/interval.hpp"
#include "solver/motion/event.hpp"
#include "solver/motion/problem.hpp"
#include "solver/program/case/case_curve.hpp"
#include "solver/program/case/case_grid.hpp"
#include "solver/program/case/case_potential.hpp"
#include "solver/program/case/case_toml.hpp"
#include "solver/solve/solve.hpp"

namespace stationary {

constexpr int most_checkpoints = 1'000'000;

struct Case {
  struct Solve {
    std::optional<Stretch> start;  ///< two-polar: xi, zeta are lambda, mu
    Method method = Method::automatic;
    bool all = false;
    /// Of `all`, of each of xi, zeta, rho (two-polar: lambda, mu, rho); none: the default.
    std::optional<std::array<Interval, 3>> box{};
  };
  struct Continuation {
    std::string parameter;  ///< one of case_parameters(), or a ratio of two
    double from;
    double to;
    double tolerance = 1e-10;
    double step = 0.01;  ///< the first, in ln S and the parameter over its range
    double max_points = 1e6;
    std::vector<std::string> events{};  ///< to be located; empty: all
    std::string start_row{};            ///< as after --from; empty: solved for

    EventSet event_set() const;
  };
  struct Atlas {
    bool complete = false;           ///< for every nu, not at the checkpoints alone
    std::optional<int> checkpoints;  ///< none: by the body's symmetry
  };
  struct Output {
    bool spectrum = true;
    bool certificate = false;
    std::vector<std::string> columns;  ///< empty: all that was computed
    /// Standard uncertainties of numbers of the case, for `sensitivity`.
    std::vector<std::pair<std::string, double>> uncertainty;
  };

  std::string title;
  Body own_body;  ///< as it is written
  Body body;      ///< the same, or of a fluid that in whose coordinates its J are equal
  std::vector<ModelChoice>
      models;           ///< plane and thickness, or coupled; then fibres, gravity and a held volume
  Potential potential;  ///< made of `models`
  Motion motion;
  MaterialCoordinates coordinates;  ///< of S of own_body
  Solve own_solve;                  ///< start and box in these
  Solve solve;                      ///< in those of `body`
  std::optional<Continuation> continuation;
  std::optional<CaseMap> map;
  std::optional<CaseCurve> curve;
  Atlas atlas;
  Output output;
  CaseTree source;  ///< where each key comes from

  std::string_view branch_name() const { return name(motion); }
  /// Of an axis rotation (std::bad_variant_access otherwise).
  Problem problem() const {
    return Problem(body, potential, std::get<AxisRotation>(motion).branch);
  }
  /// The stretch that those of its body are measured by (ContinuationOptions::unit).
  double unit_stretch() const {
    const std::optional<double> volume = potential.volume();
    return volume ? cube_root(*volume) : 1.0;
  }
};

/// Reads, overrides and validates. Throws InputError with all that is wrong.
Case read_case(const std::string& path, std::span<const std::string> overrides = {});

/// key=value, and where it is written (an empty place: it is an option).
struct Override {
  std::string text;
  Origin where = {};
};

/// The same of a tree at hand.
Case make_case(CaseTree tree, std::span<const Override> overrides = {});

}  // namespace stationary
