#include "tests/bench/work_precision/spectra.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <complex>
#include <memory>

#include "lib/balance/balance.hpp"
#include "lib/stability/general_spectrum.hpp"
#include "solver/motion/model_stability.hpp"
#include "solver/solve/stability.hpp"
#include "tests/bench/bodies.hpp"

namespace stationary::bench {
namespace {

/// Lambda of one motion; the QR algorithm gives each twice, from s and -s.
using Lambdas = std::vector<std::complex<double>>;

Lambdas lambdas_of(const Spectrum& spectrum) {
  Lambdas out;
  for (std::size_t k = 0; k < static_cast<std::size_t>(spectrum.modes); ++k)
    out.emplace_back(spectrum.mode[k].lambda_re, spectrum.mode[k].lambda_im);
  return out;
}

Lambdas by_blocks(const Problem& problem, const Equilibrium& at) {
  return lambdas_of(stability(problem, at));
}

Lambdas by_general_path(const Problem& problem, const Equilibrium& at) {
  const Branch branch = problem.branch();
  const double nu = at.nu[axis(branch)];
  const auto x = visit(problem, [&](const auto& model) {
    return extended_q(problem.body(), branch, model, at.q, nu);
  });
  return lambdas_of(general_spectrum(
      problem.body(), problem.potential(), {DoubleDouble(0.0), x[0], x[1], x[2]},
      angular_velocity(branch, DoubleDouble(nu)), std::max(at.error_bound, 0x1p-53)));
}

using Matrix11 = Eigen::Matrix<double, 11, 11>;

/// d(z')/dz of pi' = nu x pi, q' = dH/dp, p' = -dH/dq, with nu = dH/dpi. The second variation of H
/// at a steady rotation is that of lib/leaf/symplectic_leaf.hpp before the leaf:
/// (dm - N dq)^T M^-1 (dm - N dq) + dq^T (V_qq - C) dq, m = (pi, p).
Matrix11 linearized(const Problem& problem, const Equilibrium& at) {
  const Body& body = problem.body();
  Eigen::Matrix<double, 7, 11> B = Eigen::Matrix<double, 7, 11>::Zero();
  B.topLeftCorner<3, 3>().setIdentity();
  B.bottomRightCorner<4, 4>().setIdentity();
  B.middleCols<4>(3) = -steady_momenta_jacobian(body, at.q, at.nu);
  Matrix11 H = B.transpose() * mass_matrix(body, at.q).ldlt().solve(B);
  H.block<4, 4>(3, 3) +=
      visit(problem, [&](const auto& model) { return balance_jacobian(body, model, at.q, at.nu); });
  const auto crossed_with = [](const Vector3<double>& a) {  // the matrix of x -> a x x
    Matrix3<double> out;
    out << 0.0, -a[2], a[1], a[2], 0.0, -a[0], -a[1], a[0], 0.0;
    return out;
  };
  const Vector3<double> pi = locked_inertia(body, at.q) * at.nu;
  Matrix11 out;
  out.topRows<3>() = -crossed_with(pi) * H.topRows<3>();
  out.topLeftCorner<3, 3>() += crossed_with(at.nu);
  out.middleRows<4>(3) = H.bottomRows<4>();
  out.bottomRows<4>() = -H.middleRows<4>(3);
  return out;
}

Lambdas by_qr(const Problem& problem, const Equilibrium& at) {
  const Eigen::EigenSolver<Matrix11> solver(linearized(problem, at), false);
  Lambdas out;
  for (const std::complex<double>& s : solver.eigenvalues()) out.push_back(s * s);
  return out;
}

/// |Lambda - exact|/|exact| of the nearest `copies`, the largest of them. Zeros that a symmetry
/// forces do not occur: J1 != J2, nu != 0.
double relative_error(const Lambdas& found, const ExactLambda& exact, std::size_t copies) {
  std::vector<double> off;
  for (const std::complex<double>& lambda : found) {
    off.push_back(
        std::hypot(double(lambda.real() - exact.re), double(std::abs(lambda.imag()) - exact.im)));
  }
  std::ranges::nth_element(off, off.begin() + static_cast<std::ptrdiff_t>(copies - 1));
  return off[copies - 1] / std::hypot(exact.re.hi, exact.im.hi);
}

using Method = Lambdas (*)(const Problem&, const Equilibrium&);

void add(const Spectra& of, const std::string& what, const char* name, std::size_t copies,
         Method method, std::vector<Entry>& out) {
  const auto found = std::make_shared<std::vector<Lambdas>>(of.motions.size());
  const auto pass = [found, &of, method] {
    for (std::size_t k = 0; k < of.motions.size(); ++k)
      (*found)[k] = method(of.problem, of.motions[k]);
  };
  const auto errors = [found, &of, copies] {
    std::vector<double> each;
    for (std::size_t k = 0; k < of.exact.size(); ++k)
      for (const ExactLambda& exact : of.exact[k])
        each.push_back(relative_error((*found)[k], exact, copies));
    return each;
  };
  out.push_back({what, name, of.model, of.problem.branch(), std::nullopt, of.motions.size(),
                 timed(pass), errors});
}

}  // namespace

Spectra spectra(std::string_view model, Branch branch, int count) {
  constexpr double last_nu = 0.5;
  Spectra out{std::string(model), problem_of(model, branch), {}, {}};
  for (int k = 1; k <= count; ++k) {
    out.motions.push_back(solve(out.problem, last_nu * k / count));
    out.exact.push_back(exact_lambdas(out.problem, out.motions.back()));
  }
  return out;
}

void add_spectra(const Spectra& of, const std::string& what, std::vector<Entry>& out) {
  add(of, what, "blocks", 1, by_blocks, out);
  add(of, what, "general", 1, by_general_path, out);
  add(of, what, "eigen-qr-11x11", 2, by_qr, out);
}

}  // namespace stationary::bench
