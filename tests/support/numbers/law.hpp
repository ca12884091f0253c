// Matchers of laws. Each says where it was tried, what was expected, what came, and how far apart
// they are against what is allowed; a NaN anywhere fails.
#pragma once

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>
#include <type_traits>

#include "lib/body/body.hpp"
#include "lib/body/stretch.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary::support {

constexpr double unit_roundoff = 0x1p-53;

/// What a failed law prints as x: any number of labels and values.
template <class... Parts>
std::string at(const Parts&... parts) {
  std::ostringstream out;
  out.precision(17);
  const auto put = [&out](const auto& part) {
    using T = std::remove_cvref_t<decltype(part)>;
    if constexpr (std::is_same_v<T, Body>) {
      out << "J = (" << part.J1 << ", " << part.J2 << ", " << part.J3 << ") ";
    } else if constexpr (requires { part.zeta, part.alpha; }) {
      out << "q = (" << part.alpha << ", " << part.xi << ", " << part.zeta << ", " << part.rho
          << ") ";
    } else if constexpr (requires { part.transpose(); }) {
      out << "(" << part.transpose() << ") ";
    } else {
      out << part << " ";
    }
  };
  (put(parts), ...);
  return out.str();
}

/// |actual - expected| <= allowed.
template <class T>
::testing::AssertionResult agrees(const std::string& x, const T& expected, const T& actual,
                                  const T& allowed) {
  const T signed_difference = actual - expected;
  const T difference = signed_difference < 0 ? T(-signed_difference) : signed_difference;
  if (difference <= allowed) return ::testing::AssertionSuccess();
  std::ostringstream out;
  out.precision(std::numeric_limits<T>::max_digits10);
  out << "\n  x          " << x << "\n  expected   " << expected << "\n  actual     " << actual;
  out.precision(3);
  out << "\n  difference " << signed_difference << "\n  allowed    " << allowed;
  return ::testing::AssertionFailure() << out.str();
}

/// The same of vectors and matrices, entry by entry, with one allowance.
template <class M>
::testing::AssertionResult all_agree(const std::string& x, const M& expected, const M& actual,
                                     const typename M::Scalar& allowed) {
  for (Eigen::Index i = 0; i < expected.rows(); ++i) {
    for (Eigen::Index j = 0; j < expected.cols(); ++j) {
      const auto result =
          agrees<typename M::Scalar>(at(x, "entry", i, j), expected(i, j), actual(i, j), allowed);
      if (!result) return result;
    }
  }
  return ::testing::AssertionSuccess();
}

}  // namespace stationary::support
