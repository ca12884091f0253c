// Random bodies, states and models from fixed seeds, the same on every machine.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "lib/body/body.hpp"
#include "lib/body/stretch.hpp"

namespace stationary::support {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  double log_uniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  double sign() { return (engine_() >> 63) != 0 ? 1.0 : -1.0; }
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }

  Body body(double ratio = 4.0) {
    return {log_uniform(1.0 / ratio, ratio), log_uniform(1.0 / ratio, ratio),
            log_uniform(1.0 / ratio, ratio)};
  }
  Body symmetric_body() {
    const double J = log_uniform(0.25, 4.0);
    return {J, J, log_uniform(0.25, 4.0)};
  }

  /// Positive definite with alpha != 0, principal stretches and rho within [1/ratio, ratio].
  Stretch stretch(double ratio = 3.0) {
    for (;;) {
      const double lambda = log_uniform(1.0 / ratio, ratio);
      const double mu = log_uniform(1.0 / ratio, ratio);
      const double theta = uniform(-0.5, 0.5) * std::numbers::pi;
      const double c = std::cos(theta);
      const double s = std::sin(theta);
      const Stretch q{(lambda - mu) * s * c, lambda * c * c + mu * s * s,
                      lambda * s * s + mu * c * c, log_uniform(1.0 / ratio, ratio)};
      if (violated_inequality(q) == nullptr && q.alpha != 0.0) return q;
    }
  }
  Stretch diagonal_stretch(double ratio = 3.0) {
    return {0.0, log_uniform(1.0 / ratio, ratio), log_uniform(1.0 / ratio, ratio),
            log_uniform(1.0 / ratio, ratio)};
  }

  template <int n>
  Eigen::Matrix<double, n, 1> direction() {
    Eigen::Matrix<double, n, 1> out;
    for (int k = 0; k < n; ++k) out[k] = uniform(-1.0, 1.0);
    return out;
  }

  /// Coefficients inside Model's domain, whatever it is (negative ones included where it allows).
  template <class Model>
  Model coefficients() {
    std::array<double, Model::parameters.size()> c;
    for (;;) {
      for (double& value : c) value = uniform(-0.5, 3.0);
      const Model model = build<Model>(c, std::make_index_sequence<Model::parameters.size()>{});
      bool inside = true;
      for (const bool holds : model.in_domain()) inside = inside && holds;
      if (inside) return model;
    }
  }

 private:
  template <class Model, std::size_t n, std::size_t... K>
  static Model build(const std::array<double, n>& c, std::index_sequence<K...>) {
    return Model{c[K]...};
  }

  std::mt19937_64 engine_;
};

}  // namespace stationary::support
