// Eigenvalues in 50 digits, by Eigen's real Schur form: ten seconds of the compiler's time.
#pragma once

#include <Eigen/Eigenvalues>
#include <stdexcept>
#include <vector>

#include "tests/support/numbers/high_precision.hpp"

namespace stationary::testing {

struct WideEigenvalue {
  Number50 re;
  Number50 im;
};

inline std::vector<WideEigenvalue> wide_eigenvalues(
    const Eigen::Matrix<Number50, Eigen::Dynamic, Eigen::Dynamic>& A) {
  const Eigen::RealSchur<Eigen::Matrix<Number50, Eigen::Dynamic, Eigen::Dynamic>> schur(A, false);
  if (schur.info() != Eigen::Success) throw std::runtime_error("no Schur form");
  const auto& T = schur.matrixT();
  std::vector<WideEigenvalue> out;
  for (Eigen::Index k = 0; k < T.rows();) {
    if (k + 1 == T.rows() || T(k + 1, k) == 0) {
      out.push_back({T(k, k), 0});
      ++k;
      continue;
    }
    const Number50 mean = (T(k, k) + T(k + 1, k + 1)) / 2;
    const Number50 half = (T(k, k) - T(k + 1, k + 1)) / 2;
    const Number50 separation = half * half + T(k, k + 1) * T(k + 1, k);
    const Number50 root = sqrt(Number50(abs(separation)));
    if (separation < 0) {
      out.push_back({mean, root});
      out.push_back({mean, -root});
    } else {
      out.push_back({mean + root, 0});
      out.push_back({mean - root, 0});
    }
    k += 2;
  }
  return out;
}

}  // namespace stationary::testing
