// A program that uses stationary::solver: branch (i) of the reciprocal-determinant body at
// nu = 0.5, against the closed form (mechanics.cpp).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stationary/solver/solve/solve.hpp>

int main() {
  const double nu = 0.5;
  const double plane[] = {1.0, 2.0};
  const double thickness[] = {1.0, 3.0};
  const stationary::Body body(1.0, 1.7, 0.6);
  const stationary::Potential potential(
      stationary::Potential::planar("reciprocal-determinant", plane),
      stationary::Potential::thickness("reciprocal-quadratic", thickness));
  const stationary::Problem problem(body, potential, stationary::Branch::i);

  const stationary::Equilibrium found = stationary::solve(problem, nu);
  if (found.status != stationary::SolveStatus::solved) {
    std::printf("not solved: %s\n", found.message.c_str());
    return 1;
  }
  const double A1 = 2.0;
  const double A2 = 2.0 - body.J2 * nu * nu;
  const double xi = std::pow(std::sqrt(A2) * std::pow(A1, -1.5), 0.25);
  const double zeta = std::pow(std::sqrt(A1) * std::pow(A2, -1.5), 0.25);
  const double rho = std::cbrt(1.0 / (3.0 - body.J3 * nu * nu));
  const double error =
      std::max({std::fabs(found.q.xi / xi - 1.0), std::fabs(found.q.zeta / zeta - 1.0),
                std::fabs(found.q.rho / rho - 1.0)});
  std::printf("solved: xi %.16g, zeta %.16g, rho %.16g, relative error %.1e\n", found.q.xi,
              found.q.zeta, found.q.rho, error);
  return error < 2e-15 && found.q.alpha == 0.0 ? 0 : 1;
}
