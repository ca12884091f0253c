// Another peer on the same four equations (four_equations.hpp): MINPACK's hybrj (Powell's hybrid
// method, analytic Jacobian) through cminpack.
#pragma once

#include <cminpack.h>

#include <algorithm>
#include <array>

#include "lib/balance/balance.hpp"

namespace stationary::bench {

template <class Model>
struct MinpackHybrj {
  const Body& body;
  const Model& model;
  double tolerance;  ///< xtol

  bool operator()(const Vector3<double>& nu, Vector4<double>& x) const {
    Call call{*this, nu};
    Vector4<double> F;
    Matrix4<double> J;
    int residuals = 0;
    int jacobians = 0;
    std::array<double, 10> r;
    std::array<Vector4<double>, 6> work;
    const int info =
        hybrj(&evaluate, &call, 4, x.data(), F.data(), J.data(), 4, tolerance, 400, work[0].data(),
              1, 100.0, 0, &residuals, &jacobians, r.data(), 10, work[1].data(), work[2].data(),
              work[3].data(), work[4].data(), work[5].data());
    return x.allFinite() && info != 0 && info != 2;  // 3, 4, 5: as far as rounding lets it
  }

 private:
  struct Call {
    const MinpackHybrj& self;
    const Vector3<double>& nu;
  };
  static int evaluate(void* p, int, const double* x, double* F, double* J, int, int flag) {
    const auto& [self, nu] = *static_cast<const Call*>(p);
    const Stretch q{x[0], x[1], x[2], x[3]};
    if (flag == 1) {
      const Vector4<double> value = balance_residual(self.body, self.model, q, nu);
      std::copy_n(value.data(), value.size(), F);
    } else {
      const Matrix4<double> value = balance_jacobian(self.body, self.model, q, nu);
      std::copy_n(value.data(), value.size(), J);
    }
    return 0;
  }
};

}  // namespace stationary::bench
