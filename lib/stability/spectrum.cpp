#include "lib/stability/spectrum.hpp"

#include <algorithm>
#include <cmath>

#include "lib/number/elementary.hpp"
#include "lib/stability/held_linearization.hpp"
#include "lib/stability/mode_collector.hpp"
#include "lib/stability/odd_signature.hpp"
#include "lib/stability/state_units.hpp"

namespace stationary {
namespace {

using Extended = DoubleDouble;

/// Sign of the diagonal of Q1 - m P^-1, det P < 0: of its entries, that which cancels less.
int sign_of_diagonal(const OddForms<Extended>& odd, const Extended& m) {
  int out = 0;
  double best = -1.0;
  for (const int k : {0, 2}) {
    const Extended own = odd.det_P * odd.Q1[k];
    const Extended other = m * odd.P[2 - k];
    const double entry = leading(other - own);
    const double certain = std::abs(entry) / (std::abs(leading(own)) + std::abs(leading(other)));
    if (!(certain > best)) continue;
    best = certain;
    out = sign(entry);
  }
  return out;
}

bool positive_definite_2(const Conditioned& a, const Conditioned& b, const Conditioned& c,
                         double u) {
  return positive(a, u) && positive(a * c - b * b, u);
}

/// |change of an eigenvalue| of mass^-1 K: Weyl, on mass^-1/2 K mass^-1/2.
double pencil_error(const SymmetricPencil<Conditioned>& pencil, double u) {
  double worst = 0.0;
  for (int i = 0; i < 3; ++i) {
    double row = 0.0;
    for (int j = 0; j < 3; ++j) {
      const Conditioned& k = pencil.K[std::min(i, j)][std::max(i, j)];
      row += (k.condition + std::abs(k.value)) /
             std::sqrt(pencil.mass[i].value * pencil.mass[j].value);
    }
    worst = std::max(worst, u * row);
  }
  return worst;
}

/// Likewise of two coordinates, their masses uncertain too: M exceeds diag(least).
double pencil_error(const PlanarPencil<Conditioned>& pencil, double lambda, double u) {
  const auto size = [&](int k) {
    const Conditioned& stiffness = pencil.K[k];
    const Conditioned& mass = pencil.mass[k];
    return stiffness.condition + std::abs(stiffness.value) +
           std::abs(lambda) * (mass.condition + std::abs(mass.value));
  };
  const double first = pencil.least[0].value;
  const double second = pencil.least[1].value;
  const double mixed = size(1) / std::sqrt(first * second);
  return u * std::max(size(0) / first + mixed, size(2) / second + mixed);
}

/// Of roots that are near one another the characteristic polynomial knows a third of the digits: they are those
/// of the pencil moved by their mean.
CubicRoots<Extended> roots_of(const SymmetricPencil<Extended>& pencil) {
  const Polynomial<Extended, 3> p = pencil.characteristic();
  if (!is_cluster(p)) return cubic_roots(p);
  const Extended mean(leading(p.c[2] / (-3.0 * p.c[3])));
  SymmetricPencil<Extended> about = pencil;
  for (int i = 0; i < 3; ++i)
    about.K[i][i] = renormalized(Extended(pencil.K[i][i] + mean * pencil.mass[i]));
  return shifted(cubic_roots(about.characteristic()), mean);
}

/// A symmetric block: three real Lambda, all energies +1 where imaginary. Returns the negative
/// directions.
int add_symmetric(const SymmetricPencil<Extended>& pencil,
                  const SymmetricPencil<Conditioned>& conditioned, double u, ModeCollector& out) {
  const CubicRoots<Extended> roots = roots_of(pencil);
  const double error = pencil_error(conditioned, u);
  int negative = 0;
  for (const Extended& root : {roots.single, roots.pair.small, roots.pair.large}) {
    const double lambda = leading(root);
    out.add_real(lambda, error + 0x1p-53 * std::abs(lambda), 1);
    negative += lambda > 0.0;
  }
  return negative;
}

/// Its first two coordinates.
template <class S>
PlanarPencil<S> in_plane(const SymmetricPencil<S>& pencil) {
  const auto& [m, K] = pencil;
  return {{m[0], S(0.0), m[1]}, {K[0][0], K[0][1], K[1][1]}, {m[0], m[1]}};
}

/// Of two coordinates whose masses are coupled too.
int add_symmetric(const PlanarPencil<Extended>& pencil,
                  const PlanarPencil<Conditioned>& conditioned, double u, ModeCollector& out) {
  const Polynomial<Extended, 2> p = pencil.characteristic();
  const auto pair = quadratic_roots(p.c[1] / p.c[2], p.c[0] / p.c[2]);
  int negative = 0;
  for (const Extended& root : {pair.small, pair.large}) {
    const double lambda = leading(root);
    out.add_real(lambda, pencil_error(conditioned, lambda, u) + 0x1p-53 * std::abs(lambda), 1);
    negative += lambda > 0.0;
  }
  return negative;
}

int add_odd_i(const StraightState<Extended>& s, const StraightState<Conditioned>& c,
              bool material_symmetry, double u, ModeCollector& out) {
  OddForms<Extended> odd = odd_forms_i(s);
  OddForms<Conditioned> conditioned = odd_forms_i(c);
  if (material_symmetry) {
    odd.det_Q1 = Extended(0.0);
    conditioned.det_Q1 = Conditioned(0.0);
  }
  const double q1[3] = {leading(odd.Q1[0]), leading(odd.Q1[1]), leading(odd.Q1[2])};
  const double det_q1 = leading(odd.det_Q1);
  const double det_p = leading(odd.det_P);
  const int negative = negatives_2(q1[0], q1[2], det_q1) + (det_p < 0.0 ? 1 : 0);

  const Polynomial<Extended, 2> characteristic = odd.characteristic();
  const Extended middle = -0.5 * characteristic.c[1];
  const auto krein = [&](const Extended& lambda) {
    return odd_signature(det_p, det_q1, sign(leading(odd.Q1[0] + odd.Q1[2])), leading(lambda),
                         leading(middle), [&] { return sign_of_diagonal(odd, -middle); });
  };
  const UncertainPolynomial<2> uncertain(conditioned.characteristic(), u);
  if (material_symmetry) {
    out.add_forced_zero();
    const double lambda = -leading(characteristic.c[1]);
    out.add_real(lambda, uncertain.spread.c[1] + 0x1p-53 * std::abs(lambda),
                 krein(Extended(lambda)));
    return negative;
  }
  const bool definite =
      positive(conditioned.det_P, u) || positive(conditioned.det_Q1, u);  // then Lambda is real
  out.add_pair(quadratic_roots(characteristic.c[1], characteristic.c[0]), uncertain, !definite,
               krein);
  return negative;
}

/// (iii), odd: the rigid body's pair.
int add_odd_iii(const StraightState<Extended>& s, const StraightState<Conditioned>& c, double u,
                ModeCollector& out) {
  const double lambda = leading(odd_lambda_iii(s));
  // Where I3 is I1 and I2, as on a circle, what is of second order is all there is.
  const double both = u * (c.I3() - c.I1()).condition * (u * (c.I3() - c.I2()).condition);
  const double error = u * odd_lambda_iii(c).condition +
                       std::abs(leading(c.omega * c.omega / (c.I1() * c.I2()))) * both +
                       0x1p-53 * std::abs(lambda);
  const int s1 = sign(leading(s.I3() - s.I1()));
  const int s2 = sign(leading(s.I3() - s.I2()));
  out.add_real(lambda, error, s1 > 0 ? 1 : -1);
  return (s1 < 0) + (s2 < 0);
}

int add_rho(const StraightState<Extended>& s, const StraightState<Conditioned>& c, double u,
            ModeCollector& out) {
  const double lambda = -leading(s.V_rr / s.J.J3);
  out.add_real(lambda, u * (c.V_rr / c.J.J3).condition + 0x1p-53 * std::abs(lambda), 1);
  return lambda > 0.0;
}

/// Whether alpha's Lambda is a zero that a symmetry forces, away from the circle. Not every K_alpha
/// that is 0: an anisotropic V's is where its ellipse turns away (`shear`).
bool forced_zero(const StraightState<Extended>& s, const BlockFacts& facts) {
  return facts.material_symmetry ||
         (facts.isotropic && leading(s.omega) == 0.0 && leading(s.xi) != leading(s.zeta));
}

/// (iii), even, at rest: alpha is by itself, and the rest a symmetric block. Returns the negative directions but
/// for alpha's.
int add_at_rest(const GyroscopicBlock<Extended>& block,
                const GyroscopicBlock<Conditioned>& conditioned, bool forced, bool rho_coupled,
                double u, ModeCollector& out) {
  if (forced) {
    out.add_forced_zero();
  } else {
    const double lambda = -leading(block.K_alpha / block.mass_alpha);
    const Conditioned bound = conditioned.K_alpha / conditioned.mass_alpha;
    out.add_real(lambda, u * bound.condition + 0x1p-53 * std::abs(lambda), 1);
  }
  if (rho_coupled) return add_symmetric(block.rest, conditioned.rest, u, out);
  return add_symmetric(in_plane(block.rest), in_plane(conditioned.rest), u, out);
}

/// (iii), even, away from the circle.
int add_even_iii(const StraightState<Extended>& s, const StraightState<Conditioned>& c,
                 const BlockFacts& facts, ModeCollector& out) {
  const double u = facts.uncertainty;
  GyroscopicBlock<Extended> block = even_block_iii(s);
  GyroscopicBlock<Conditioned> conditioned = even_block_iii(c);
  const bool forced = forced_zero(s, facts);
  if (forced) {
    // The direction of the material symmetry (at rest V alone counts, and V is isotropic).
    block.K_alpha = Extended(0.0);
    conditioned.K_alpha = Conditioned(0.0);
  }
  const auto& K = conditioned.rest.K;
  const double det_K = leading(block.planar_determinant().c[0]);
  const bool planar_definite = positive_definite_2(K[0][0], K[0][1], K[1][1], u);
  bool definite = planar_definite && (forced || positive(conditioned.K_alpha, u));
  const int negative_alpha = leading(block.K_alpha) < 0.0 ? 1 : 0;
  if (leading(s.omega) == 0.0)
    return negative_alpha + add_at_rest(block, conditioned, forced, facts.rho_coupled, u, out);

  if (!facts.rho_coupled) {
    const auto p = block.characteristic();
    const UncertainPolynomial<3> uncertain(conditioned.characteristic(), u);
    const auto trace = block.trace_adjugate();
    const auto krein = [&](const Extended& lambda) {
      return definite ? 1 : sign(leading(p.slope(lambda)) * leading(trace(lambda)));
    };
    out.add_cubic(p, uncertain, forced, definite, krein);
    return negative_alpha +
           negatives_2(leading(block.rest.K[0][0]), leading(block.rest.K[1][1]), det_K);
  }

  const auto p = block.characteristic_coupled();
  const UncertainPolynomial<4> uncertain(conditioned.characteristic_coupled(), u);
  const auto trace = block.trace_adjugate_coupled();
  definite = definite && positive(conditioned.rest.characteristic().c[0], u);
  const auto krein = [&](const Extended& lambda) {
    return definite ? 1 : sign(leading(p.slope(lambda)) * leading(trace(lambda)));
  };
  if (forced) {
    out.add_forced_zero();
    const CubicRoots<Extended> roots =
        cubic_roots(Polynomial<Extended, 3>{{p.c[1], p.c[2], p.c[3], p.c[4]}});
    const double single = leading(roots.single);
    out.add_real(single, uncertain.root_error(single), krein(roots.single),
                 definite ? Axis::stays : Axis::may_leave);
    out.add_pair(roots.pair, uncertain, !definite, krein);
  } else {
    const QuarticRoots<Extended> roots = quartic_roots(p);
    out.add_pair(roots.first, uncertain, !definite, krein);
    out.add_pair(roots.second, uncertain, !definite, krein);
  }
  // Sylvester: the (xi, zeta, rho) stiffness has as many negative eigenvalues as its pencil with
  // mass has positive Lambda.
  const CubicRoots<Extended> stiffness = cubic_roots(block.rest.characteristic());
  int negative = negative_alpha;
  for (const Extended& root : {stiffness.single, stiffness.pair.small, stiffness.pair.large})
    negative += leading(root) > 0.0;
  return negative;
}

/// The two shears of the circle (add_circle), K_alpha that of alpha. Returns the negative directions.
int add_shears(const StraightState<Extended>& s, const StraightState<Conditioned>& c,
               const Extended& K_alpha, const Conditioned& K_alpha_conditioned, double u,
               ModeCollector& out) {
  out.begin(Block::shear);
  const Extended omega = leading(s.omega) < 0.0 ? -s.omega : s.omega;
  const Extended shear = K_alpha / (2.0 * s.J.J1);
  const Extended Omega2 = renormalized(omega * omega + shear);
  const double w = leading(omega);
  const double k = leading(shear);
  const double spread_k = u * (K_alpha_conditioned / (2.0 * c.J.J1)).condition;
  const double spread_2 = spread_k + 2.0 * u * w * w;
  if (leading(Omega2) > spread_2) {
    const Extended Omega = sqrt(Omega2);
    const double fast = w + leading(Omega);
    const double slow = k / fast;  // Omega - omega, without cancellation
    const double spread_fast = u * w + 0.5 * spread_2 / leading(Omega);
    const double spread_slow = spread_k / fast + std::abs(slow) / fast * spread_fast;
    out.add_real(-fast * fast, 2.0 * fast * spread_fast, 1, Axis::may_leave);
    // At slow = 0 the ellipse leaves the circle; the pair touches zero and does not cross.
    out.add_real(-slow * slow, (2.0 * std::abs(slow) + spread_slow) * spread_slow, sign(slow),
                 Axis::may_leave, std::abs(slow) > 2.0 * spread_slow);
    // E'' + c (P - |pi|)'' > 0: -(Omega + omega)/2 < c < (Omega - omega)/2 and c < omega (I3/I1 -
    // 1).
    const Conditioned ratio = c.I3() / c.I1() - Conditioned(1.0);
    const Conditioned margin =
        Conditioned(fast, spread_fast / u) * Conditioned(0.5) + Conditioned::input(w) * ratio;
    if (w > 0.0 && positive(margin, u)) out.set_definite_with_momentum();
  } else if (leading(Omega2) < -spread_2) {
    const double rate = std::sqrt(-leading(Omega2));
    const double re = rate * rate - w * w;
    const double error = spread_2 + 2.0 * u * w * w;
    if (w > 0.0) {
      const double spread_rate = spread_2 / (rate + std::sqrt(rate * rate - spread_2));
      out.add_complex(re, 2.0 * w * rate,
                      error + 2.0 * w * (spread_rate + u * rate) + 0x1p-53 * (w * w + rate * rate));
    } else {
      out.add_real(re, error, 0);
      out.add_real(re, error, 0);
    }
  } else {
    // The two shears may be about to collide: not decided.
    out.add_real(-w * w, 2.0 * w * std::sqrt(spread_2) + w * w + spread_2, 0);
    out.add_real(-w * w, 2.0 * w * std::sqrt(spread_2) + w * w + spread_2, 0);
  }
  return k < 0.0 ? 2 : 0;
}

/// (iii), even, on the circle xi = zeta (J1 = J2): breathing (with rho where coupled) apart from
/// the two shears, which in the plane (xi - zeta, 2 alpha) are an isotropic oscillator seen from a
/// frame turning at omega: s = i (omega +- Omega), Omega^2 = omega^2 + K_aa/(2 J), energies (Omega
/// +- omega).
int add_circle(const StraightState<Extended>& s, const StraightState<Conditioned>& c,
               const BlockFacts& facts, ModeCollector& out) {
  const double u = facts.uncertainty;
  const auto block = even_block_iii(s);
  const auto conditioned = even_block_iii(c);
  int negative = 0;

  // Breathing: (xi + zeta)/2 with mass 2 J and stiffness 2 (K_xx + K_xz).
  const Extended breathing = block.rest.K[0][0] + block.rest.K[0][1];
  const Conditioned breathing_c = conditioned.rest.K[0][0] + conditioned.rest.K[0][1];
  if (facts.rho_coupled) {
    const Extended b = (breathing / s.J.J1) + (s.V_rr / s.J.J3);
    const Extended coupling = 2.0 * (s.V_xr * s.V_xr);
    const Extended det = (breathing * s.V_rr - coupling) / (s.J.J1 * s.J.J3);
    const Conditioned det_c = (breathing_c * c.V_rr - 2.0 * (c.V_xr * c.V_xr)) / (c.J.J1 * c.J.J3);
    const Conditioned b_c = breathing_c / c.J.J1 + c.V_rr / c.J.J3;
    const UncertainPolynomial<2> uncertain(
        Polynomial<Conditioned, 2>{{det_c, b_c, Conditioned(1.0)}}, u);
    const auto pair = quadratic_roots(b, det);
    out.add_pair(pair, uncertain, false, [](const Extended&) { return 1; });
    negative += (leading(pair.small) > 0.0) + (leading(pair.large) > 0.0);
  } else {
    const double lambda = -leading(breathing / s.J.J1);
    out.add_real(lambda, u * (breathing_c / c.J.J1).condition + 0x1p-53 * std::abs(lambda), 1);
    negative += lambda > 0.0;
  }

  return negative + add_shears(s, c, block.K_alpha, conditioned.K_alpha, u, out);
}

/// (iii), even, of a held volume: away from the circle, and on it.
int add_held_iii(const StraightState<Extended>& s, const StraightState<Conditioned>& c,
                 const BlockFacts& facts, ModeCollector& out) {
  const double u = facts.uncertainty;
  HeldGyroscopicBlock<Extended> block = held_even_iii(s);
  HeldGyroscopicBlock<Conditioned> conditioned = held_even_iii(c);
  const bool circle = facts.material_symmetry && leading(s.xi) == leading(s.zeta);
  if (circle) {
    const Extended mass = block.plane.mass[0] + block.plane.mass[1];
    const Extended stiffness = block.plane.K[0] + block.plane.K[1];
    const double lambda = -leading(stiffness / mass);
    const Conditioned ratio = (conditioned.plane.K[0] + conditioned.plane.K[1]) /
                              (conditioned.plane.mass[0] + conditioned.plane.mass[1]);
    out.add_real(lambda, u * ratio.condition + 0x1p-53 * std::abs(lambda), 1);
    const int negative = lambda > 0.0;
    return negative + add_shears(s, c, block.K_alpha, conditioned.K_alpha, u, out);
  }
  const bool forced = forced_zero(s, facts);
  if (forced) {
    block.K_alpha = Extended(0.0);
    conditioned.K_alpha = Conditioned(0.0);
  }
  const auto& K = conditioned.plane.K;
  const bool definite =
      positive_definite_2(K[0], K[1], K[2], u) && (forced || positive(conditioned.K_alpha, u));
  const auto p = block.characteristic();
  const auto trace = block.trace_adjugate();
  const auto krein = [&](const Extended& lambda) {
    return definite ? 1 : sign(leading(p.slope(lambda)) * leading(trace(lambda)));
  };
  out.add_cubic(p, UncertainPolynomial<3>(conditioned.characteristic(), u), forced, definite,
                krein);
  const double det = leading(block.plane.characteristic().c[0]);
  return (leading(block.K_alpha) < 0.0 ? 1 : 0) +
         negatives_2(leading(block.plane.K[0]), leading(block.plane.K[2]), det);
}

}  // namespace

bool Spectrum::away_from_zero() const {
  return std::all_of(mode.begin(), mode.begin() + modes, [](const Mode& m) {
    return m.forced_zero || std::abs(m.lambda_re) > m.lambda_error ||
           hypotenuse(m.lambda_re, m.lambda_im) > m.lambda_error;
  });
}

namespace {

Spectrum spectrum_of_blocks(const BlockFacts& facts, const StraightState<DoubleDouble>& state,
                            const StraightState<Conditioned>& conditioned, ModeCollector out) {
  int negative = 0;
  const double u = facts.uncertainty;
  const bool at_rest = leading(state.omega) == 0.0;
  if (facts.branch != Branch::iii && !at_rest) {
    const bool second = facts.branch == Branch::ii;
    auto s = second ? state.exchanged() : state;
    auto c = second ? conditioned.exchanged() : conditioned;
    if (facts.volume_held) {
      s = with_thickness_pull(s, Extended(s.J.J3 * (s.omega * s.omega)));
      c = with_thickness_pull(c, Conditioned(c.J.J3 * (c.omega * c.omega)));
      negative += add_symmetric(held_even_i(s), held_even_i(c), u, out);
    } else {
      negative += add_symmetric(even_pencil_i(s), even_pencil_i(c), u, out);
    }
    out.begin(Block::odd);
    negative += add_odd_i(s, c, facts.material_symmetry, u, out);
  } else {
    out.begin(Block::odd);
    if (!at_rest) negative += add_odd_iii(state, conditioned, u, out);
    if (facts.volume_held) {
      out.begin(Block::even);
      out.set_negative(negative + add_held_iii(state, conditioned, facts, out));
      return out.finish();
    }
    out.begin(Block::thickness);
    if (!facts.rho_coupled) negative += add_rho(state, conditioned, u, out);
    out.begin(Block::even);
    const bool circle = facts.material_symmetry && leading(state.xi) == leading(state.zeta);
    negative += circle ? add_circle(state, conditioned, facts, out)
                       : add_even_iii(state, conditioned, facts, out);
  }
  out.set_negative(negative);
  return out.finish();
}

}  // namespace

Spectrum block_spectrum(const BlockFacts& facts, const StraightState<DoubleDouble>& state,
                        const StraightState<Conditioned>& conditioned) {
  const StateUnits units = units_of(state);
  if (units.are_own()) return spectrum_of_blocks(facts, state, conditioned, ModeCollector());
  return spectrum_of_blocks(facts, in_units(state, units), in_units(conditioned, units),
                            ModeCollector(1.0 / units.rate));
}

Spectrum two_polar_spectrum(const StraightState<DoubleDouble>& state, const DoubleDouble& theta_dot,
                            const StraightState<Conditioned>& conditioned,
                            const Conditioned& theta_dot_conditioned, double s3, double uncertainty,
                            bool volume_held) {
  ModeCollector out;
  int negative =
      volume_held
          ? add_symmetric(held_two_polar(state, theta_dot),
                          held_two_polar(conditioned, theta_dot_conditioned), uncertainty, out)
          : add_symmetric(two_polar_pencil(state, theta_dot),
                          two_polar_pencil(conditioned, theta_dot_conditioned), uncertainty, out);
  if (s3 != 0.0) {
    out.begin(Block::odd);
    const auto wobble = two_polar_wobble(state, theta_dot);
    const auto wobble_c = two_polar_wobble(conditioned, theta_dot_conditioned);
    const int energy_1 = -sign(leading(wobble.a)) * sign(s3);
    const int energy_2 = -sign(leading(wobble.b)) * sign(s3);
    const double lambda = -leading(wobble.a * wobble.b);
    const double error =
        uncertainty * (wobble_c.a * wobble_c.b).condition + 0x1p-53 * std::abs(lambda);
    out.add_real(lambda, error, energy_1);
    negative += (energy_1 < 0) + (energy_2 < 0);
  }
  out.set_negative(negative);
  return out.finish();
}

}  // namespace stationary
