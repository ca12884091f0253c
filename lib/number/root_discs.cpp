#include "lib/number/root_discs.hpp"

#include <Eigen/Eigenvalues>

namespace stationary {
namespace {

using Complex = std::complex<double>;

template <int D>
Polynomial<DoubleDouble, D> middle(const Polynomial<Interval, D>& p) {
  Polynomial<DoubleDouble, D> out;
  for (std::size_t k = 0; k <= D; ++k) out.c[k] = p.c[k].mid();
  return out;
}

/// The discs need distinct centers: about a double root, as far apart as keeps them small.
std::array<Complex, 2> both(const RootPair<DoubleDouble>& pair) {
  const double least = 0x1p-26 * std::abs(leading(pair.mean));
  if (std::abs(leading(pair.separation)) < least * least)
    return {Complex(leading(pair.mean) - least), Complex(leading(pair.mean) + least)};
  if (pair.real()) return {Complex(leading(pair.small)), Complex(leading(pair.large))};
  const double im = std::sqrt(-leading(pair.separation));
  return {Complex(leading(pair.mean), im), Complex(leading(pair.mean), -im)};
}

}  // namespace

std::array<Complex, 2> middle_roots(const Polynomial<Interval, 2>& p) {
  const auto m = middle(p);
  return both(quadratic_roots(m.c[1] / m.c[2], m.c[0] / m.c[2]));
}

std::array<Complex, 3> middle_roots(const Polynomial<Interval, 3>& p) {
  const CubicRoots<DoubleDouble> roots = cubic_roots(middle(p));
  const auto pair = both(roots.pair);
  return {Complex(leading(roots.single)), pair[0], pair[1]};
}

std::array<Complex, 4> middle_roots(const Polynomial<Interval, 4>& p) {
  const QuarticRoots<DoubleDouble> roots = quartic_roots(middle(p));
  const auto first = both(roots.first);
  const auto second = both(roots.second);
  return {first[0], first[1], second[0], second[1]};
}

std::array<Complex, 5> middle_roots(const Polynomial<Interval, 5>& p) {
  const auto m = middle(p);
  Eigen::Matrix<double, 5, 5> companion = Eigen::Matrix<double, 5, 5>::Zero();
  for (int k = 0; k < 4; ++k) companion(k + 1, k) = 1.0;
  for (int k = 0; k < 5; ++k) companion(k, 4) = -leading(m.c[static_cast<std::size_t>(k)] / m.c[5]);
  const Eigen::EigenSolver<Eigen::Matrix<double, 5, 5>> solver(companion, false);
  std::array<Complex, 5> out;
  for (int k = 0; k < 5; ++k) {
    Complex& z = out[static_cast<std::size_t>(k)];
    z = solver.eigenvalues()[k];
    // Two Newton steps, which keep a real root real and a pair conjugate.
    for (int step = 0; step < 2; ++step) {
      Complex value(leading(m.c[5]));
      Complex slope(0.0);
      for (std::size_t j = 5; j-- > 0;) {
        slope = slope * z + value;
        value = value * z + leading(m.c[j]);
      }
      const Complex change = quotient(value, slope);
      if (modulus(change) < 1e-3 * modulus(z)) z -= change;
    }
  }
  return out;
}

}  // namespace stationary
