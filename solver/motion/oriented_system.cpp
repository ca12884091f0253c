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

/// The balance of w as an unknown.
template <class S>
std::array<S, 4> balance_of(const AnisotropicModel<S>& model, const Inertia3<double>& J,
                            const OrientedStretch<double>& at, const SpinProducts<double>& n) {
  const BasicStretch<double>& q = at.q;
  const OrientedStretch<S> point{{q.alpha, q.xi, q.zeta, q.rho}, at.root, at.tanh, at.sech};
  const auto out =
      oriented_balance<1>(Inertia3<S>{J.J1, J.J2, J.J3}, model, point,
                          SpinProducts<S>{n.square_1, n.square_2, n.square_3, n.product_12});
  return {out.g[0], out.g[1], out.g[2], out.g[3]};
}

}  // namespace

std::array<Dual2, 4> coefficient_slopes(const AnisotropicModel<Dual2>& model,
                                        const Inertia3<double>& J,
                                        const OrientedStretch<double>& at,
                                        const SpinProducts<double>& n) {
  return balance_of(model, J, at, n);
}

OrientedModels::OrientedModels(const AnisotropicPotential& from)
    : potential(from),
      plain(from.model()),
      extended(from.model(AsExtended())),
      conditioned(from.model(AsConditioned())) {
  for (int first = 0; first < from.coefficient_count(); first += 2)
    relative.push_back(from.model(CoefficientDuals{first, true}));
}

std::array<double, 4> decimal_conditions(const AnisotropicPotential& potential,
                                         const OrientedStretch<double>& at) {
  std::array<double, 4> out;
  const auto pulls =
      balance_of(potential.model(AsExactConditioned()), {0.0, 0.0, 0.0}, at, {0.0, 0.0, 0.0, 0.0});
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = pulls[i].condition;
  return out;
}

}  // namespace stationary
