// log, exp and pow of each element of an array of Eigen's by elementary.hpp. Eigen's own are the C
// library's, which round otherwise on another processor.
#pragma once

#include <Eigen/Core>

#include "lib/number/elementary.hpp"

namespace stationary {

template <class X>
typename X::PlainObject logarithms(const Eigen::ArrayBase<X>& x) {
  return x.unaryExpr([](double each) { return log(each); });
}

template <class X>
typename X::PlainObject exponentials(const Eigen::ArrayBase<X>& x) {
  return x.unaryExpr([](double each) { return exp(each); });
}

template <class X>
typename X::PlainObject powers(const Eigen::ArrayBase<X>& x, double p) {
  return x.unaryExpr([p](double each) { return pow(each, p); });
}

}  // namespace stationary
