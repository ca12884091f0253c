// A sweep in nu by a solver of all four equations: every solve from the parabola through the last
// three points, which is this library's own predictor, or from the last point.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "lib/body/motion.hpp"
#include "lib/body/stretch.hpp"

namespace stationary::bench {

/// Parabola through the last points of a sweep.
class Predictor {
 public:
  explicit Predictor(const Vector4<double>& start) : x_{start, start, start} {}
  Vector4<double> next() const {
    return known_ >= 3   ? Vector4<double>(3.0 * (x_[0] - x_[1]) + x_[2])
           : known_ == 2 ? Vector4<double>(2.0 * x_[0] - x_[1])
                         : x_[0];
  }
  const Vector4<double>& last() const { return x_[0]; }
  void push(const Vector4<double>& x) {
    x_[2] = x_[1];
    x_[1] = x_[0];
    x_[0] = x;
    ++known_;
  }

 private:
  std::array<Vector4<double>, 3> x_;
  int known_ = 0;
};

enum class Start { parabola, last_point };

/// solve(nu, x), x in place, at evenly spaced nu from the solution `first` at the first of them;
/// false stops the sweep as failed.
template <class Solve>
bool march(Branch branch, std::span<const double> nu, const Vector4<double>& first, Start start,
           Solve&& solve, std::span<Vector4<double>> out) {
  Predictor predictor(first);
  for (std::size_t k = 0; k < nu.size(); ++k) {
    Vector4<double> x = start == Start::parabola ? predictor.next() : predictor.last();
    if (!solve(angular_velocity(branch, nu[k]), x)) return false;
    predictor.push(x);
    out[k] = x;
  }
  return true;
}

}  // namespace stationary::bench
