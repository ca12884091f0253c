// Wide numbers that stand for the exact ones: 50 digits for the mechanics, 100 for the arithmetic
// of DoubleDouble. Expression templates are off, so that a sum has the type of its terms.
#pragma once

#include <Eigen/Core>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <string>

#include "lib/body/stretch.hpp"
#include "lib/number/double_double.hpp"

namespace stationary::support {

template <unsigned digits>
using Binary = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<digits>,
                                             boost::multiprecision::et_off>;
using Real50 = Binary<50>;
using Real100 = Binary<100>;
using Decimal50 = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>,
                                                boost::multiprecision::et_off>;

/// The value of x, without rounding.
template <class T>
T exact(double x) {
  return T(x);
}
template <class T>
T exact(const DoubleDouble& x) {
  return T(x.hi) + T(x.lo);
}

template <class T, class S>
BasicStretch<T> widen_stretch(const BasicStretch<S>& q) {
  return {T(q.alpha), T(q.xi), T(q.zeta), T(q.rho)};
}

template <class T, class Vector>
auto widen_vector(const Vector& x) {
  Eigen::Matrix<T, Vector::RowsAtCompileTime, 1> out;
  for (Eigen::Index k = 0; k < x.size(); ++k) out[k] = T(x[k]);
  return out;
}

/// The double nearest to x.
template <class T>
double nearest(const T& x) {
  return x.template convert_to<double>();
}

}  // namespace stationary::support
