// The unknowns ln x, or the equations, of the reduced balance of a family: N = 1, 2 or 3 (reduced_system.hpp).
#pragma once

#include <Eigen/Core>

namespace stationary {

template <int N>
using ReducedVector = Eigen::Matrix<double, N, 1>;

}  // namespace stationary
