// What is true of a motion, from 50 digits (tests/support), as pairs of doubles: good to 30. Apart
// from what is measured, which it would slow the compiler down for.
#pragma once

#include <array>
#include <vector>

#include "lib/number/double_double.hpp"
#include "solver/solve/solve.hpp"

namespace stationary::bench {

/// (xi, zeta, rho) near q, a good approximation.
std::array<DoubleDouble, 3> exact_stretches(const Problem& problem, double nu, const Stretch& q);

/// How far (ln xi, ln zeta, ln rho, nu/scale) of stretches near the sheet of steady rotations is from
/// it: the shortest correction, to first order, of the residual in 50 digits.
double distance_from_sheet(const Problem& problem, const std::array<DoubleDouble, 3>& stretches,
                           double nu, double scale);

struct ExactLambda {
  DoubleDouble re;
  DoubleDouble im;  ///< >= 0; a complex pair is in the list twice
};

/// Of the exact motion near a solved one.
std::vector<ExactLambda> exact_lambdas(const Problem& problem, const Equilibrium& at);

}  // namespace stationary::bench
