#include "lib/stability/general_spectrum.hpp"

#include <cmath>
#include <complex>
#include <stdexcept>

#include "lib/leaf/circle_momentum.hpp"
#include "lib/leaf/iterated_modes.hpp"
#include "lib/leaf/reversible_leaf.hpp"
#include "lib/leaf/whole_leaf.hpp"
#include "lib/material/models/first_order_bound_model.hpp"
#include "lib/stability/mode_collector.hpp"

namespace stationary {
namespace {

/// E'' = [a c; c b]:  Lambda = c^2 - a b.
LeafModes<1> one_pair_modes(const Leaf& leaf, const LeafFacts& facts) {
  const DoubleDouble& a = leaf.second_variation[0][0];
  const DoubleDouble& b = leaf.second_variation[1][1];
  const DoubleDouble& c = leaf.second_variation[0][1];
  const double size_a = std::abs(leading(a));
  const double size_b = std::abs(leading(b));
  const double size_c = std::abs(leading(c));
  const double of_a = leaf.magnitude[0][0];
  const double of_b = leaf.magnitude[1][1];
  const double of_c = leaf.magnitude[0][1];
  LeafModes<1> out;
  if (facts.forced_zero) {
    out.lambda[0] = 0.0;
    out.error[0] = 0.0;
    out.forced = 0;
    out.negative = negatives_2(leading(a), leading(b), 0.0);
    out.definite = false;
    return out;
  }
  const double det = leading(renormalized(DoubleDouble(a * b - c * c)));
  const double u = facts.uncertainty;
  const double spread =
      u * (size_a * of_b + size_b * of_a + 2.0 * size_c * of_c + u * (of_a * of_b + of_c * of_c));
  out.lambda[0] = -det;
  out.error[0] = spread + 0x1p-53 * std::abs(det);
  out.negative = negatives_2(leading(a), leading(b), det);
  out.definite = leading(a) > u * of_a && leading(b) > u * of_b && det > spread;
  if (det > 0.0) out.energy[0] = energy_sign(leading(a) / of_a, leading(b) / of_b);
  return out;
}

template <std::size_t n>
LeafModes<n> leaf_modes(const Leaf& leaf, const LeafFacts& facts) {
  if constexpr (n == 1) {
    return one_pair_modes(leaf, facts);
  } else {
    LeafModes<n> out;
    const auto parts = reversible<n>(leaf);
    if (parts ? ReversibleProblem<n>(*parts, facts).find(out)
              : WholeLeafProblem<n>(leaf, facts).find(out))
      return out;
    out.forced = n;
    const std::vector<IteratedMode> modes = iterated_modes(leaf, facts, out.definite);
    for (std::size_t k = 0; k < n; ++k) {
      out.lambda[k] = modes[k].lambda;
      out.error[k] = modes[k].error;
      out.energy[k] = modes[k].energy;
      if (modes[k].forced) out.forced = k;
    }
    return out;
  }
}

template <std::size_t n>
Spectrum spectrum_of(const GeneralFacts& facts, const Leaf& leaf) {
  const LeafModes<n> modes =
      leaf_modes<n>(leaf, {facts.symmetry == MaterialSymmetry::ellipse, facts.uncertainty});
  ModeCollector out;
  out.set_negative(modes.negative);
  for (std::size_t k = 0; k < n; ++k) {
    const std::complex<double> lambda = modes.lambda[k];
    if (k == modes.forced) {
      out.add_forced_zero();
    } else if (lambda.imag() > 0.0) {
      out.add_complex(lambda.real(), lambda.imag(), modes.error[k]);
    } else if (lambda.imag() == 0.0) {
      out.add_real(lambda.real(), modes.error[k], modes.definite ? 1 : modes.energy[k],
                   modes.definite ? Axis::stays : Axis::may_leave);
    }
  }
  if (facts.symmetry == MaterialSymmetry::circle && n == 5 && !modes.definite &&
      definite_with_momentum(leaf, facts.uncertainty)) {
    out.set_definite_with_momentum();
  }
  return out.finish();
}

/// As inputs.
BasicStretch<Conditioned> conditioned(const BasicStretch<DoubleDouble>& q) {
  const auto input = [](const DoubleDouble& x) { return Conditioned::input(leading(x)); };
  const double size = std::sqrt(leading(q.xi) * leading(q.zeta));
  return {leading(q.alpha) == 0.0 ? Conditioned(0.0) : Conditioned(leading(q.alpha), size),
          input(q.xi), input(q.zeta), input(q.rho)};
}

Leaf leaf_of(const Body& body, bool volume_held, const BasicStretch<DoubleDouble>& q,
             const Vector3<DoubleDouble>& spin, const Matrix4<DoubleDouble>& V_qq,
             const Matrix4<Conditioned>& V_qq_conditioned) {
  // The two parts of a component that cancels have products that need not cancel. The momentum would
  // have a component here that it has not in doubles below, and the two leaves other coordinates.
  const auto uncancelled = [](const DoubleDouble& x) {
    return std::abs(double(x)) < 0.5 * std::abs(x.hi) ? renormalized(x) : x;
  };
  const Vector3<DoubleDouble> nu{uncancelled(spin[0]), uncancelled(spin[1]), uncancelled(spin[2])};
  const auto input = [](const auto& x) { return Conditioned::input(leading(x)); };
  const Vector3<Conditioned> nu_c{input(nu[0]), input(nu[1]), input(nu[2])};
  // Below this the squares of momenta underflow.
  constexpr double least = 1e-130;
  const bool turns = std::abs(nu_c[0].value) > least || std::abs(nu_c[1].value) > least ||
                     std::abs(nu_c[2].value) > least;
  const LeafShape shape{turns, volume_held};
  Leaf out;
  out.pairs = shape.pairs();
  const std::size_t aside =
      leaf_reductions().second_variation(body, q, nu, shape, V_qq, out.second_variation);
  const LeafForm<Conditioned> with_conditions = second_variation(
      Inertia3<Conditioned>{input(body.J1), input(body.J2), input(body.J3)}, conditioned(q), nu_c,
      shape, V_qq_conditioned, [&](const std::array<Conditioned, 3>& pi) {
        return leaf_spin(leaf_frame(pi, aside), nu_c, pi);
      });
  for (std::size_t i = 0; i < 2 * out.pairs; ++i)
    for (std::size_t j = 0; j < 2 * out.pairs; ++j)
      out.magnitude[i][j] = with_conditions[i][j].condition;
  return out;
}

}  // namespace

Spectrum general_spectrum(const GeneralFacts& facts, const Leaf& leaf) {
  switch (leaf.pairs) {
    case 1:
      return spectrum_of<1>(facts, leaf);
    case 2:
      return spectrum_of<2>(facts, leaf);
    case 3:
      return spectrum_of<3>(facts, leaf);
    case 4:
      return spectrum_of<4>(facts, leaf);
    case 5:
      return spectrum_of<5>(facts, leaf);
    default:
      throw std::invalid_argument("a leaf has one to five pairs of coordinates");
  }
}

Leaf motion_leaf(const Body& body, const Potential& potential, const BasicStretch<DoubleDouble>& q,
                 const Vector3<DoubleDouble>& nu) {
  if (!potential.is_isotropic()) {
    const AnisotropicPotential& V = potential.anisotropic();
    return motion_leaf(body, V.model(AsExtended()), V.model(AsConditioned()), q, nu);
  }
  Leaf out;
  potential.visit_parts([&](const auto& model) {
    out = leaf_of(body, potential.holds_volume(), q, nu, potential_derivatives<2>(model, q).hessian,
                  potential_derivatives<2>(conditioned_model(model), conditioned(q)).hessian);
  });
  return out;
}

Leaf motion_leaf(const Body& body, const AnisotropicModel<DoubleDouble>& V,
                 const AnisotropicModel<Conditioned>& conditioned_V,
                 const BasicStretch<DoubleDouble>& q, const Vector3<DoubleDouble>& nu) {
  return leaf_of(body, V.body.volume.has_value(), q, nu, potential_derivatives<2>(V, q).hessian,
                 potential_derivatives<2>(conditioned_V, conditioned(q)).hessian);
}

Spectrum general_spectrum(const Body& body, const Potential& potential,
                          const BasicStretch<DoubleDouble>& q, const Vector3<DoubleDouble>& nu,
                          double uncertainty) {
  const bool at_rest = nu[0] == 0.0 && nu[1] == 0.0 && nu[2] == 0.0;
  const bool circle = q.alpha == 0.0 && q.xi == q.zeta;
  // Gravity of J1 != J2 is bound to the material axes, at rest too.
  const BodyModel<>* const whole = potential.body_model();
  const bool isotropic = potential.is_isotropic() && (whole == nullptr || whole->isotropic());
  const bool symmetric = isotropic && (body.symmetric() || at_rest);
  const MaterialSymmetry symmetry = !symmetric ? MaterialSymmetry::none
                                    : circle   ? MaterialSymmetry::circle
                                               : MaterialSymmetry::ellipse;
  const bool turned = circle && nu[2] < 0.0;  // see definite_with_momentum()
  return general_spectrum(
      {symmetry, uncertainty},
      motion_leaf(body, potential, q, turned ? Vector3<DoubleDouble>(-nu) : nu));
}

}  // namespace stationary
