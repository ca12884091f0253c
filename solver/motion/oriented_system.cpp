#include "solver/motion/oriented_system.hpp"

#include <numbers>

namespace stationary {

Direction<Dual2> CoefficientDuals::direction(double degrees) const {
  const Direction<DoubleDouble> at = stationary::direction(degrees);
  const double cosine = double(at.cosine);
  const double sine = double(at.sine);
  const Dual2 angle = seeded(0.0, (relative ? degrees : 1.0) * (std::numbers::pi / 180.0));
  Direction<Dual2> out{Dual2(cosine), Dual2(sine)};
  for (std::size_t k = 0; k < 2; ++k) {
    out.cosine.slope[k] = -sine * angle.slope[k];
    out.sine.slope[k] = cosine * angle.slope[k];
  }
  return out;
}

namespace {

/// dV in (u, v, w, a).
template <class S>
std::array<S, 4> elastic_part(const AnisotropicModel<S>& model, const OrientedStretch<double>& at) {
  const BasicStretch<double>& q = at.q;
  const OrientedStretch<S> point{{q.alpha, q.xi, q.zeta, q.rho}, at.root, at.tanh, at.sech};
  const AnisotropicDerivatives<S> V = model.template evaluate<1>(point.invariants(), point.q);
  OrientedBalance<S> out;
  add_in_logarithms<1>(point, V.isotropic, out);
  add_in_logarithms<1>(point, V.directed.gradient, V.directed.hessian, out);
  return {out.g[0], out.g[1], out.g[2], out.g[3]};
}

}  // namespace

std::array<Dual2, 4> elastic_slopes(const AnisotropicPotential& potential,
                                    const CoefficientDuals& duals,
                                    const OrientedStretch<double>& at) {
  return elastic_part(potential.model(duals), at);
}

std::array<double, 4> decimal_conditions(const AnisotropicPotential& potential,
                                         const OrientedStretch<double>& at) {
  std::array<double, 4> out;
  const auto pulls = elastic_part(potential.model(AsExactConditioned()), at);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = pulls[i].condition;
  return out;
}

std::array<double, 5> inertial_part(const Inertia3<double>& J, const OrientedStretch<double>& at,
                                    const SpinProducts<double>& n, const AxisAngle<double>* axis) {
  OrientedBalance<double> out;
  const Vector4<double> force = -(centrifugal_matrix(J, n) * at.q.vector());
  add_in_logarithms<1>(at, force, Matrix4<double>(), out);
  if (axis != nullptr) add_axis<1>(J, at, 0.0, *axis, out);
  return out.g;
}

}  // namespace stationary
