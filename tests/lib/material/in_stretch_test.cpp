// From derivatives in (t, ln d, ln rho) those in the stretch, of a potential whose variables are
// mixed in all of them: t d rho is a polynomial in (alpha, xi, zeta, rho).
#include <gtest/gtest.h>

#include "lib/material/models/potential_derivatives.hpp"

namespace stationary {
namespace {

TEST(InStretch, OfAPolynomial) {
  for (const Stretch& q : {Stretch{0.3, 1.2, 0.9, 1.1}, Stretch{-0.2, 0.7, 1.9, 0.4}}) {
    const auto x = planar_invariants(q);
    const double V = x.t * x.d * q.rho;
    const double per_t = x.d * q.rho;
    const CoupledDerivatives<double> w{{V, per_t, V, 0.0, per_t, V}, V, V, per_t, V};
    const PotentialDerivatives<double> found = in_stretch<2>(w, q);

    const double a = q.alpha;
    const Vector4<double> d(-2.0 * a, q.zeta, q.xi, 0.0);
    const Vector4<double> t(0.0, 1.0, 1.0, 0.0);
    const Vector4<double> r(0.0, 0.0, 0.0, 1.0);
    Matrix4<double> d_second = Matrix4<double>::Zero();
    d_second(0, 0) = -2.0;
    d_second(1, 2) = d_second(2, 1) = 1.0;
    const Vector4<double> gradient = x.d * q.rho * t + x.t * q.rho * d + x.t * x.d * r;
    const Matrix4<double> half = q.rho * t * d.transpose() + x.d * t * r.transpose() +
                                 x.t * d * r.transpose() + 0.5 * x.t * q.rho * d_second;
    const Matrix4<double> hessian = half + half.transpose();
    const double rounding = 1e-14 * hessian.cwiseAbs().maxCoeff();
    EXPECT_EQ(found.value, V);
    for (int i = 0; i < 4; ++i) {
      EXPECT_NEAR(found.gradient[i], gradient[i], rounding) << i;
      for (int j = 0; j < 4; ++j)
        EXPECT_NEAR(found.hessian(i, j), hessian(i, j), rounding) << i << j;
    }
  }
}

}  // namespace
}  // namespace stationary
