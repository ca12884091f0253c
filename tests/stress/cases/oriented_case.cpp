#include "tests/stress/cases/oriented_case.hpp"

#include <Eigen/LU>
#include <cmath>
#include <sstream>

#include "solver/motion/oriented_system.hpp"
#include "solver/proof/anisotropic_enclosure.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"
#include "tests/support/bodies/random_anisotropic.hpp"

namespace stationary::stress {
namespace {

using Coordinates = std::array<DoubleDouble, 5>;

struct Found {
  Coordinates y;
  bool converged = false;
};

/// Newton's method with the residual in pairs of doubles, the slopes in doubles.
template <class Layout>
Found corrected(const Body& body, const AnisotropicPotential& V, Branch branch, double nu,
                Coordinates y) {
  constexpr int N = Layout::dimension;
  const Inertia3<DoubleDouble> J{body.J1, body.J2, body.J3};
  const auto model = V.model(AsExtended());
  const auto plain = V.model();
  double last = 1.0;
  for (int step = 0; step < 60; ++step) {
    std::array<double, 5> rounded;
    for (std::size_t k = 0; k < y.size(); ++k) rounded[k] = double(y[k]);
    const auto g = balance_at<Layout, 1>(J, model, branch, two_product(nu, nu), y).g;
    const auto slope =
        balance_at<Layout, 2>({body.J1, body.J2, body.J3}, plain, branch, nu * nu, rounded).slope;
    Eigen::Matrix<double, N, N> A;
    Eigen::Matrix<double, N, 1> b;
    for (int i = 0; i < N; ++i) {
      const std::size_t row = Layout::places[static_cast<std::size_t>(i)];
      b[i] = double(g[row]);
      for (int j = 0; j < N; ++j) A(i, j) = slope[row][Layout::places[static_cast<std::size_t>(j)]];
    }
    const Eigen::Matrix<double, N, 1> change = A.fullPivLu().solve(b);
    const double size = change.cwiseAbs().maxCoeff();
    if (!(size < 0.1)) return {y};
    for (int i = 0; i < N; ++i) {
      DoubleDouble& each = y[Layout::places[static_cast<std::size_t>(i)]];
      const DoubleDouble d(-change[i]);
      each = each * (DoubleDouble(1.0) + d * (DoubleDouble(1.0) + 0.5 * d));  // exp(d)
    }
    if (size < 1e-24) return {y, true};
    if (size < 1e-20 && size >= 0.5 * last) return {y, true};
    last = size;
  }
  return {y};
}

testing::Number50 as_number_50(const DoubleDouble& x) {
  return testing::Number50(x.hi) + testing::Number50(x.lo);
}

}  // namespace

Outcome try_oriented(Random& random) {
  const int kind = random.integer(0, 7);
  const auto of = support::random_anisotropic(random, kind);
  const Body body = random.body(3.0);
  const double nu = random.log_uniform(1e-3, 1.0);
  const bool oblique = random.integer(0, 1) == 1;
  std::ostringstream out_text;
  out_text.precision(17);
  out_text << (oblique ? "oblique, " : "(iii), ") << of.text << ", J (" << body.J1 << ", "
           << body.J2 << ", " << body.J3 << "), nu " << nu;
  const std::string text = out_text.str();
  const Potential potential(of.V);
  const Problem problem(body, potential, Branch::iii);
  SolveOptions options;
  options.search = false;
  const Equilibrium at =
      oblique ? solve_oblique(body, potential, {nu}, options) : solve(problem, nu, options);
  Outcome out;
  out.status = at.status;
  out.work = work(at.counts);
  if (at.status != SolveStatus::solved) return out;
  const double phi = std::atan2(at.nu[1], at.nu[0]);
  const Coordinates y{at.q.xi, at.q.zeta, at.q.rho, shear_coordinate(at.q),
                      oblique ? axis_coordinate(phi) : 1.0};
  const Found exact = oblique ? corrected<ObliqueLayout>(body, of.V, Branch::i, nu, y)
                              : corrected<ShearedLayout>(body, of.V, Branch::iii, nu, y);
  if (!exact.converged) {
    out.fault = "no solution in 30 digits: " + text;
    return out;
  }
  judge_stretch({as_number_50(exact.y[0]), as_number_50(exact.y[1]), as_number_50(exact.y[2])},
                {at.q.xi, at.q.zeta, at.q.rho}, at.error_bound, text, out);
  const std::optional<Spectrum> spectrum =
      oblique ? oblique_stability(body, potential, at) : anisotropic_stability(problem, at);
  const ObliqueRotation motion{nu};
  const Certificate proof =
      oblique ? certify_oblique(body, potential, motion, at) : certify(problem, at);
  if (!spectrum) return out;
  judge_by_proof(
      proof, *spectrum,
      [&] {
        return oblique ? enclose_oblique_spectrum(body, potential, motion, proof, *spectrum)
                       : enclose_spectrum(problem, at, proof, *spectrum);
      },
      text, out);
  return out;
}

}  // namespace stationary::stress
