#include "solver/program/session/computation_plan.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/program/table/table.hpp"

namespace stationary::cli {
namespace {

std::vector<PlanItem> two_polar_unknowns(const Case& input) {
  const bool separable = input.potential.is_separable();
  return {{"alpha", "0, not an unknown",
           "the two-polar form: S is diagonal in the frame that turns at theta_dot"},
          separable ? PlanItem{"rho", "closed form", "separable potential; V_rho'(rho) = 0"}
                    : PlanItem{"rho", "an unknown", "the potential couples it to lambda and mu"},
          {"lambda, mu", separable ? "2 equations" : "3 equations with rho",
           "the balance at the prescribed rates or momenta, searched for globally; S has "
           "xi = lambda, zeta = mu at theta = 0"}};
}

std::vector<PlanItem> tilted_unknowns(const TiltedMotion& motion) {
  const char* rho = "sqrt(J1/J3) xi in the 1-3 plane, sqrt(J2/J3) zeta in the 2-3 plane";
  if (motion.plane)
    rho = *motion.plane == TiltPlane::one_three ? "sqrt(J1/J3) xi" : "sqrt(J2/J3) zeta";
  return {{"alpha", "0, not an unknown",
           "isotropic potential: the plane of the axis is a plane of material axes"},
          {"rho", rho, "compatibility: the locked inertias of the plane's two axes are equal"},
          {"xi, zeta", "2 equations", "the balance, its parts that know |nu| and no tilt"},
          {"nu", "closed form", "the rest of the balance gives the squares of its components"}};
}

std::vector<PlanItem> oblique_unknowns(const Case& input) {
  return {{"alpha", "an unknown", "nothing makes it 0 where the spin is about no material axis"},
          {"axis", "an unknown, its angle in the plane of axes 1 and 2",
           "compatibility: nu is an eigenvector of the locked inertia"},
          {"xi, zeta, rho", "5 equations with alpha and the axis",
           input.potential.is_separable()
               ? "the balance; rho's has no other unknown in it, and a search takes it apart"
               : "the balance"}};
}

/// Of a potential that is not isotropic.
PlanItem oriented_spectrum_item(const Case& input) {
  const bool straight = input.potential.anisotropic().shear_free();
  const auto* rotation = std::get_if<AxisRotation>(&input.motion);
  if (rotation != nullptr && straight && rotation->nu != 0.0) {
    return {"spectrum", "5 modes from blocks where alpha = 0, else from the whole problem",
            "V_alpha = 0 at alpha = 0: reflections split the dynamics about a material axis"};
  }
  const bool at_rest = rotation != nullptr && rotation->nu == 0.0;
  return {"spectrum",
          std::string(at_rest ? "4" : "5") +
              " modes from the whole problem, by a structure-preserving method",
          rotation == nullptr
              ? "no reflection makes blocks of the dynamics about an oblique axis"
              : "V_alpha != 0 at alpha = 0, or not known to vanish, or nu = 0: no blocks"};
}

/// The blocks that alpha = 0 and an isotropic potential split the linearization into.
PlanItem spectrum_item(const Case& input) {
  constexpr const char* split = "alpha = 0 and an isotropic potential: reflections split the ";
  const bool separable = input.potential.is_separable();
  if (!input.potential.is_isotropic()) return oriented_spectrum_item(input);
  if (input.two_polar()) {
    return {"spectrum",
            "4 modes from 2 blocks: lambda, mu, rho (3) and the wobble of axis 3 (1, none where "
            "s3 = 0); on the circle lambda = mu the 5 modes of branch (iii)",
            std::string(split) + "8-dimensional leaf of fixed |pi| and p_theta"};
  }
  if (input.tilted()) {
    return {"spectrum", "5 modes from the whole problem, by a structure-preserving method",
            "no reflection makes blocks of the dynamics about a tilted axis, on the 10-dimensional "
            "leaf of "
            "fixed |pi|"};
  }
  const auto& [branch, nu] = std::get<AxisRotation>(input.motion);
  if (nu == 0.0) {
    return {"spectrum",
            separable ? "4 modes from 2 blocks: rho (1) and alpha, xi, zeta (3)"
                      : "4 modes from 1 block: alpha, xi, zeta, rho (4)",
            "at rest there is no angular momentum, the leaf has 8 dimensions"};
  }
  std::string how = "5 modes from ";
  if (branch != Branch::iii) {
    how += branch == Branch::i ? "2 blocks: xi, zeta, rho (3) and alpha, pi2, pi3 (2)"
                               : "2 blocks: xi, zeta, rho (3) and alpha, pi1, pi3 (2)";
  } else if (separable) {
    how += "3 blocks: pi1, pi2 (1), rho (1) and alpha, xi, zeta (3)";
  } else {
    how += "2 blocks: pi1, pi2 (1) and alpha, xi, zeta, rho (4)";
  }
  return {"spectrum", how, std::string(split) + "10-dimensional leaf of fixed |pi|"};
}

bool names_spectral_column(const std::vector<std::string>& names) {
  return std::ranges::any_of(names, [](const std::string& name) {
    const auto column = find_column(name);
    return column && needs_spectrum(*column);
  });
}

}  // namespace

bool wants_spectrum(const Case& input, bool to_table) {
  if (!input.output.spectrum) return false;
  const std::vector<std::string>& columns = input.output.columns;
  if (!to_table || columns.empty() || names_spectral_column(columns)) return true;
  return input.continuation && !input.continuation->events.empty() &&
         std::ranges::any_of(spectral_events, [&](EventType each) {
           return input.continuation->event_set().has(each);
         });
}

bool wants_column(const Case& input, Column column, bool to_table) {
  const std::vector<std::string>& columns = input.output.columns;
  return to_table && (columns.empty() || std::ranges::find(columns, name(column)) != columns.end());
}

std::optional<PlanItem> proof_caveat(const Case& input) {
  const std::vector<std::string> assumed = input.potential.assumptions();
  if (assumed.empty()) return std::nullopt;
  return PlanItem{"proofs", "take for granted: " + fmt::format("{}", fmt::join(assumed, "; ")),
                  "found at points, which is no proof (`check`)"};
}

ComputationPlan computation_plan(const Case& input, bool to_table) {
  ComputationPlan out;
  if (const auto* tilted = std::get_if<TiltedMotion>(&input.motion)) {
    out.computed = tilted_unknowns(*tilted);
  } else if (input.oblique()) {
    out.computed = oblique_unknowns(input);
  } else {
    out.computed = input.two_polar() ? two_polar_unknowns(input) : input.problem().plan();
  }
  if (const auto caveat = proof_caveat(input)) out.computed.push_back(*caveat);
  if (input.solve.all) {
    out.computed.push_back({"all solutions", "exhaustive search, to be proven complete",
                            "every stretch in [1e-3, 1e3]: boxes in interval arithmetic"});
    if (input.solve.start || input.solve.method != Method::automatic) {
      out.skipped.push_back({"start, method", "not used", "solve.all = true searches everywhere"});
    }
  }
  if (input.output.certificate) {
    out.computed.push_back({"certificate",
                            "existence, uniqueness, error bound and class, to be proven",
                            "interval arithmetic, for all decimals that read as the inputs"});
  }
  if (input.continuation && !input.continuation->events.empty()) {
    out.computed.push_back({"events",
                            fmt::format("{}", fmt::join(input.continuation->events, ", ")),
                            "continuation.events: of no others is a function evaluated"});
  }
  if (wants_spectrum(input, to_table)) {
    out.computed.push_back(spectrum_item(input));
  } else if (!input.output.spectrum) {
    out.skipped.push_back({"spectrum", "skipped", "output.spectrum = false"});
  } else {
    out.skipped.push_back({"spectrum", "skipped",
                           "output.columns names none of its columns (without -o it is computed)"});
  }
  return out;
}

}  // namespace stationary::cli
