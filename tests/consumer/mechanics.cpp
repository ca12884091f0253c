// A program that uses stationary::mechanics alone: the balance at a closed-form equilibrium.
//
// V = c/d + (k/2) tr S^2 + a/rho + b rho^2/2, branch (i), A1 = k, A2 = k - J2 nu^2:
//   xi^4 = c A2^(1/2) A1^(-3/2),  zeta^4 = c A1^(1/2) A2^(-3/2),  rho^3 = a/(b - J3 nu^2).
#include <cmath>
#include <cstdio>
#include <stationary/lib/balance/balance.hpp>
#include <stationary/lib/number/double_double.hpp>

int main() {
  const double c = 1.0;
  const double k = 2.0;
  const double a = 1.0;
  const double b = 3.0;
  const double nu = 0.5;
  const stationary::Body body(1.0, 1.7, 0.6);
  const double plane[] = {c, k};
  const double thickness[] = {a, b};
  const stationary::Potential potential(
      stationary::Potential::planar("reciprocal-determinant", plane),
      stationary::Potential::thickness("reciprocal-quadratic", thickness));

  const double A1 = k;
  const double A2 = k - body.J2 * nu * nu;
  const stationary::Stretch q{0.0, std::pow(c * std::sqrt(A2) * std::pow(A1, -1.5), 0.25),
                              std::pow(c * std::sqrt(A1) * std::pow(A2, -1.5), 0.25),
                              std::cbrt(a / (b - body.J3 * nu * nu))};
  const auto check = stationary::check_balance(
      body, potential, q, stationary::angular_velocity(stationary::Branch::i, nu));
  std::printf("closed form: residual %.1e, compatibility %.1e\n", check.residual,
              check.compatibility);

  // A wrong state must be seen as wrong.
  stationary::Stretch wrong = q;
  wrong.xi *= 1.0 + 1e-9;
  const auto doubt = stationary::check_balance(
      body, potential, wrong, stationary::angular_velocity(stationary::Branch::i, nu));

  // Exact only where products are not contracted: 1 + 2^-29 + 2^-60 does not fit a double.
  const auto square = stationary::two_product(1.0 + 0x1p-30, 1.0 + 0x1p-30);

  const bool right = check.residual < 1e-14 && check.compatibility == 0.0 &&
                     doubt.residual > 1e-11 && square.hi == 1.0 + 0x1p-29 && square.lo == 0x1p-60;
  return right ? 0 : 1;
}
