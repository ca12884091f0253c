// Stationary motions to take spectra of: solved, every potential and branch, from fixed seeds.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/stability/general_spectrum.hpp"
#include "solver/motion/problem.hpp"
#include "solver/solve/solve.hpp"
#include "solver/solve/stability.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary::testing {
/// The modes, without the unused ones.
inline std::vector<Mode> modes(const Spectrum& spectrum) {
  return {spectrum.mode.begin(), spectrum.mode.begin() + spectrum.modes};
}
}  // namespace stationary::testing

namespace stationary {
inline std::ostream& operator<<(std::ostream& out, const Spectrum& spectrum) {
  out.precision(17);
  out << name(spectrum.verdict) << ", negative " << spectrum.negative << ", growth "
      << spectrum.growth;
  for (const Mode& m : testing::modes(spectrum)) {
    out << "\n    Lambda " << m.lambda_re << " " << m.lambda_im << " +- " << m.lambda_error
        << " krein " << m.krein << (m.forced_zero ? " forced" : "");
  }
  return out;
}
}  // namespace stationary

namespace stationary::testing {

inline constexpr Branch branches[] = {Branch::i, Branch::ii, Branch::iii};

struct SolvedMotion {
  Problem problem;
  Equilibrium at;
  std::string text;  ///< all of it, for messages

  double nu() const { return at.nu[axis(problem.branch())]; }
  Spectrum blocks() const { return stability(problem, at); }
};

/// A potential's names: a planar and a thickness model, or a coupled one alone.
struct PotentialName {
  std::string_view model;
  std::string_view thickness;
};

/// Every planar model, every thickness model, every coupled one.
inline const std::vector<PotentialName>& potential_names() {
  static const std::vector<PotentialName> names = [] {
    std::vector<PotentialName> out;
    std::string_view plane;
    for (const ModelDescription& model : model_descriptions()) {
      using Kind = ModelDescription::Kind;
      if (model.kind == Kind::planar) out.push_back({plane = model.name, "reciprocal-quadratic"});
      if (model.kind == Kind::thickness && model.name != "reciprocal-quadratic")
        out.push_back({plane, model.name});
      if (model.kind == Kind::coupled) out.push_back({model.name, ""});
    }
    return out;
  }();
  return names;
}

inline Potential named_potential(const PotentialName& name, std::array<double, 2> plane,
                                 std::array<double, 2> axial = {1.0, 3.0}) {
  if (name.thickness.empty()) return Potential(Potential::coupled(name.model, plane));
  return {Potential::planar(name.model, plane), Potential::thickness(name.thickness, axial)};
}

inline std::string describe(const Body& body, const PotentialName& name,
                            std::array<double, 2> plane, std::array<double, 2> axial, Branch branch,
                            const Equilibrium& at) {
  std::ostringstream text;
  text.precision(17);
  text << name.model << " " << plane[0] << " " << plane[1] << " " << name.thickness << " "
       << axial[0] << " " << axial[1] << ", J (" << body.J1 << ", " << body.J2 << ", " << body.J3
       << "), (" << stationary::name(branch) << "), nu " << at.nu[axis(branch)] << ", q ("
       << at.q.xi << ", " << at.q.zeta << ", " << at.q.rho << ") ";
  return text.str();
}

/// A solved motion; a cold start, or Newton from anywhere, which also reaches other sheets.
inline SolvedMotion random_motion(support::Random& random, const PotentialName& name, Branch branch,
                                  bool symmetric) {
  for (;;) {
    const std::array<double, 2> plane{random.log_uniform(0.3, 3.0), random.log_uniform(0.3, 3.0)};
    const std::array<double, 2> axial{random.log_uniform(0.3, 3.0), random.log_uniform(0.3, 3.0)};
    const Body body = symmetric ? random.symmetric_body() : random.body();
    const Problem problem(body, named_potential(name, plane, axial), branch);
    const double J = branch == Branch::i    ? body.J2
                     : branch == Branch::ii ? body.J1
                                            : std::max(body.J1, body.J2);
    const double nu = random.sign() * std::sqrt(plane[0] / J) * random.log_uniform(0.05, 1.4);
    SolveOptions options;
    if (random.integer(0, 1) == 0) {
      options.method = Method::newton;
      options.start = random.diagonal_stretch();
    }
    Equilibrium at = solve(problem, nu, options);
    if (at.status != SolveStatus::solved || !(at.error_bound < 1e-12)) continue;
    std::string text = describe(body, name, plane, axial, branch, at);
    return {problem, std::move(at), std::move(text)};
  }
}

/// One motion: throws where it cannot be solved.
inline SolvedMotion motion(const Body& body, const PotentialName& name, std::array<double, 2> plane,
                           std::array<double, 2> axial, Branch branch, double nu,
                           const SolveOptions& options = {}) {
  const Problem problem(body, named_potential(name, plane, axial), branch);
  Equilibrium at = solve(problem, nu, options);
  if (at.status != SolveStatus::solved) throw std::runtime_error("not solved: " + at.message);
  std::string text = describe(body, name, plane, axial, branch, at);
  return {problem, std::move(at), std::move(text)};
}

/// The uncertainty stability() allows for.
inline double uncertainty(const Equilibrium& at) {
  return std::isnan(at.error_bound) ? 1e-15 : std::max(at.error_bound, 0x1p-53);
}

/// max |Lambda|.
inline double scale(const Spectrum& spectrum) {
  double out = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(spectrum.modes); ++k)
    out = std::max(out, std::hypot(spectrum.mode[k].lambda_re, spectrum.mode[k].lambda_im));
  return out;
}

/// Modes by Lambda, ascending: the pairing of two lists of reals that keeps the largest difference
/// least.
inline std::vector<Mode> by_lambda(const Spectrum& spectrum) {
  std::vector<Mode> out = modes(spectrum);
  std::sort(out.begin(), out.end(), [](const Mode& a, const Mode& b) {
    return a.lambda_re != b.lambda_re ? a.lambda_re < b.lambda_re : a.lambda_im < b.lambda_im;
  });
  return out;
}

}  // namespace stationary::testing
