#include "lib/stability/spectrum_enclosure.hpp"

#include <algorithm>
#include <array>

#include "lib/stability/enclosure_collector.hpp"
#include "lib/stability/held_linearization.hpp"
#include "lib/stability/state_units.hpp"

namespace stationary {
namespace {

/// Roots of p; krein(Lambda) of a simple imaginary one. definite: they are real, semisimple and of
/// positive energy where imaginary.
template <class S, int D, class Krein>
void add_roots(const Polynomial<S, D>& p, bool all_real, bool definite, const Krein& krein,
               EnclosureCollector& out) {
  for (const RootEnclosure& root : enclose_roots(ranges(p), all_real || definite))
    out.add(root, definite ? 1 : root.simple && root.real() ? krein(root.z.re) : unknown, definite);
}

/// A symmetric pencil: real Lambda, energies +1 where imaginary.
template <class Pencil>
void add_symmetric(const Pencil& pencil, EnclosureCollector& out) {
  for (const RootEnclosure& root : enclose_roots(ranges(pencil.characteristic()), true)) {
    out.add(root, 1, true);
    out.negative.add_if_negative(-root.z.re);
  }
}

/// Differences of the moments without the term they share: of a long ellipsoid that is most of both.
template <class S>
S I1_minus_I3(const StraightState<S>& s) {
  return s.J.J3 * square(s.rho) - s.J.J1 * square(s.xi);
}
template <class S>
S I1_minus_I2(const StraightState<S>& s) {
  return s.J.J2 * square(s.zeta) - s.J.J1 * square(s.xi);
}

/// odd_forms_i() with these.
template <class S>
OddForms<S> narrow_odd_forms_i(const StraightState<S>& s) {
  OddForms<S> out = odd_forms_i(s);
  const S D = s.J.J1 * s.J.J2 * square(s.xi + s.zeta);
  out.Q1[2] = I1_minus_I2(s) / (s.I1() * s.I2());
  out.det_P = square(s.omega) * (s.I1() * I1_minus_I3(s) / D);
  return out;
}

/// det_Q1 at a stationary motion of an isotropic V that holds no volume, xi != zeta: there V_xi = 0
/// and V_zeta = J2 omega^2 zeta make V_aa.
template <class S>
S isotropic_det_Q1(const StraightState<S>& s) {
  const S ratio = (s.xi + s.zeta) / (s.xi - s.zeta);
  const S turned = s.J.J2 * (s.J.J1 - s.J.J2) * (s.zeta * s.zeta) * ratio;
  return s.omega * s.omega * turned / (s.I1() * s.I2());
}

/// tr P Q1 where det Q1 = 0, Q1 = Q1_22 (r, 1)(r, 1)^T with r = omega h I1/(I1 - I2): with a = J1
/// xi^2, b = J2 zeta^2, c = J3 rho^2 it is omega^2 (I1 I3 - (b - a)^2)/(I2 (b - a)).
template <class S>
S singular_odd_trace(const StraightState<S>& s) {
  const S a = s.J.J1 * square(s.xi);
  const S b = s.J.J2 * square(s.zeta);
  const S c = s.J.J3 * square(s.rho);
  return square(s.omega) * ((a * (3.0 * b - a) + c * (a + b)) / (s.I2() * I1_minus_I2(s)));
}

/// As isotropic_det_Q1(), tr P Q1: P_11 det Q1/Q1_22 more than that.
template <class S>
S isotropic_odd_trace(const StraightState<S>& s) {
  const S zeta2 = square(s.zeta);
  const S turned = s.I3() * (s.J.J1 - s.J.J2) * zeta2;
  const S scale = s.J.J1 * (square(s.xi) - zeta2) * I1_minus_I2(s);
  return square(s.omega) * (turned / scale) + singular_odd_trace(s);
}

/// Another formula of one and the same number.
template <class S>
void take_narrower(const S& other, S& x) {
  if (range(other).bounded() && range(other).width() < range(x).width()) x = other;
}

/// Signs of both Lambda of P Q1, ascending, where determinants alone tell them: their product is
/// det P det Q1; with P > 0 they are those of -Q1 (Sylvester), P[0] = I3/D being positive.
std::optional<std::array<int, 2>> odd_signs(int sign_P, int sign_Q, std::optional<int> negatives) {
  if (sign_P * sign_Q < 0) return {{-1, 1}};
  if (sign_P < 0 || !negatives || *negatives == 1) return std::nullopt;
  if (sign_P == unknown) return std::nullopt;
  return *negatives == 0 ? std::array{-1, -1} : std::array{1, 1};
}

template <class S>
void add_odd_i(const StraightState<S>& s, const EnclosureFacts& facts, EnclosureCollector& out) {
  OddForms<S> odd = narrow_odd_forms_i(s);
  const int sign_P = proven_sign(range(odd.det_P));
  if (facts.material_symmetry) {
    // Q1 = sigma q q^T exactly; the mode's energy is sigma (q^T P q)^2, its -Lambda sigma q^T P q.
    const int sigma = proven_sign(range(odd.Q1[2]));
    out.add_forced_zero();
    S trace = odd.characteristic().c[1];
    take_narrower(singular_odd_trace(s), trace);
    out.add_real(range(-trace), sigma);
    out.negative.add(sigma == unknown ? std::nullopt : std::optional(sigma < 0 ? 1 : 0));
    out.negative.add_if_negative(range(odd.det_P));
    return;
  }
  const bool isotropic = facts.isotropic && !facts.volume_held;
  if (isotropic) take_narrower(isotropic_det_Q1(s), odd.det_Q1);
  Polynomial<S, 2> p = odd.characteristic();
  if (isotropic) take_narrower(isotropic_odd_trace(s), p.c[1]);
  const Interval det_Q = range(odd.det_Q1);
  const auto negatives = negatives_2(range(odd.Q1[0]), range(odd.Q1[2]), det_Q);
  out.negative.add(negatives);
  out.negative.add_if_negative(range(odd.det_P));
  if (sign_P < 0 || negatives.value_or(0) > 0) out.set_indefinite();
  // With P or Q1 definite P Q1 is similar to a symmetric matrix; with P > 0 the energy of a mode is
  // -Lambda v^T P^-1 v > 0.
  const bool all_real = sign_P > 0 || det_Q.positive();
  const auto krein = [&](const Interval& lambda) {
    if (sign_P > 0) return 1;
    const S m(-lambda);
    const S n11 = odd.P[0] * odd.Q1[0] + odd.P[1] * odd.Q1[1];
    const S n12 = odd.P[0] * odd.Q1[1] + odd.P[1] * odd.Q1[2];
    const S n21 = odd.P[1] * odd.Q1[0] + odd.P[2] * odd.Q1[1];
    const S n22 = odd.P[1] * odd.Q1[1] + odd.P[2] * odd.Q1[2];
    const auto energy = [&](const S& x, const S& y) {
      return range(odd.Q1[0] * square(x) + 2.0 * (odd.Q1[1] * (x * y)) + odd.Q1[2] * square(y));
    };
    const int first = proven_sign(energy(n12, m - n11));
    return first != unknown ? first : proven_sign(energy(m - n22, n21));
  };
  const auto signs = odd_signs(sign_P, proven_sign(det_Q), negatives);
  if (!signs) {
    add_roots(p, all_real, false, krein, out);
    return;
  }
  auto roots = enclose_roots(ranges(p), true);
  std::ranges::sort(roots, {}, [](const RootEnclosure& each) { return each.z.re.mid(); });
  for (std::size_t k = 0; k < 2; ++k)
    out.add_of_sign(roots[k].z.re, (*signs)[k], (*signs)[k] < 0 ? krein(roots[k].z.re) : unknown);
}

/// (iii), odd: the rigid body's pair.
template <class S>
void add_odd_iii(const StraightState<S>& s, EnclosureCollector& out) {
  const S both[2] = {-I1_minus_I3(s), -I1_minus_I3(s.exchanged())};
  const Interval first = range(both[0]);
  const Interval second = range(both[1]);
  const int sign = proven_sign(first);
  const S lambda = -(square(s.omega) * (both[0] * both[1] / (s.I1() * s.I2())));
  out.add_real(range(lambda), sign == proven_sign(second) ? sign : unknown);
  out.negative.add_if_negative(first);
  out.negative.add_if_negative(second);
}

template <class S>
void add_rho(const StraightState<S>& s, EnclosureCollector& out) {
  out.add_real(range(-(s.V_rr / s.J.J3)), 1);
  out.negative.add_if_negative(range(s.V_rr));
}

/// The direction of the material symmetry (at rest V alone counts, isotropic as it mostly is).
bool forced_zero(const EnclosureFacts& facts) {
  return !facts.circle && (facts.material_symmetry || (facts.at_rest && facts.isotropic));
}

/// What is left of a characteristic polynomial beside a forced zero. alpha is cyclic then, and without
/// it M x'' + (K + g g^T/m_alpha) x = 0: a symmetric pencil.
template <class S, int D>
void add_beside_forced_zero(const Polynomial<S, D>& p, EnclosureCollector& out) {
  Polynomial<Interval, D - 1> rest;
  for (std::size_t k = 0; k < D; ++k) rest.c[k] = range(p.c[k + 1]);
  for (const RootEnclosure& root : enclose_roots(rest, true)) out.add(root, 1, true);
}

/// The roots of a cubic of (alpha, xi, zeta), the forced zero among them left out.
template <class S, class Krein>
void add_even_cubic(const Polynomial<S, 3>& p, bool forced, bool definite, const Krein& krein,
                    EnclosureCollector& out) {
  if (forced) {
    add_beside_forced_zero(p, out);
  } else {
    add_roots(p, false, definite, krein, out);
  }
}

/// Signature of a simple imaginary root, from tr adj of the pencil.
template <class S, int D, int E>
auto krein_of(const Polynomial<S, D>& p, const Polynomial<S, E>& trace) {
  return [&p, &trace](const Interval& lambda) {
    return proven_sign(range(p.slope(S(lambda)))) * proven_sign(range(trace(S(lambda))));
  };
}

template <class S>
void add_even_iii(const StraightState<S>& s, const EnclosureFacts& facts, EnclosureCollector& out) {
  const GyroscopicBlock<S> block = even_block_iii(s);
  const bool forced = forced_zero(facts);
  const auto& K = block.rest.K;
  const Interval det_K = range(block.planar_determinant().c[0]);
  const bool planar_definite = range(K[0][0]).positive() && det_K.positive();
  const bool alpha_definite = forced || range(block.K_alpha).positive();
  if (forced) {
    out.add_forced_zero();
  } else {
    out.negative.add_if_negative(range(block.K_alpha));
  }
  if (!facts.rho_coupled) {
    out.negative.add(negatives_2(range(K[0][0]), range(K[1][1]), det_K));
    auto p = block.characteristic();
    if (forced) p.c[0] = S(0.0);
    const auto trace = block.trace_adjugate();
    const auto krein = krein_of(p, trace);
    const bool definite = planar_definite && alpha_definite;
    add_even_cubic(p, forced, definite, krein, out);
    return;
  }
  // Sylvester: the (xi, zeta, rho) stiffness has as many negative eigenvalues as its pencil with
  // mass has positive Lambda.
  const auto stiffness = ranges(block.rest.characteristic());
  for (const RootEnclosure& root : enclose_roots(stiffness, true))
    out.negative.add_if_negative(-root.z.re);
  const bool definite = planar_definite && alpha_definite && stiffness.c[0].positive();
  auto p = block.characteristic_coupled();
  if (forced) p.c[0] = S(0.0);
  const auto trace = block.trace_adjugate_coupled();
  const auto krein = krein_of(p, trace);
  if (forced) {
    add_beside_forced_zero(p, out);
  } else {
    add_roots(p, false, definite, krein, out);
  }
}

/// The two shears of the circle: see spectrum.cpp.
template <class S>
void add_shears(const StraightState<S>& s, const S& K_alpha, const EnclosureFacts& facts,
                EnclosureCollector& out) {
  out.negative.add_if_negative(range(K_alpha));
  out.negative.add_if_negative(range(K_alpha));

  const S spin = sqrt(square(s.omega));
  const S shear_rate = K_alpha / (2.0 * s.J.J1);
  const S between = square(spin) + shear_rate;
  const Interval omega = range(spin);
  const Interval Omega2 = range(between);
  if (Omega2.positive()) {
    const S fast = spin + sqrt(between);
    const S slow = shear_rate / fast;
    out.add_real(range(-square(fast)), 1);
    out.add_real(range(-square(slow)), proven_sign(range(slow)));
    const Interval margin = range(0.5 * fast + spin * (s.I3() / s.I1() - S(1.0)));
    if (omega.positive() && margin.positive()) {
      out.set_definite_with_momentum();
    } else if (!facts.at_rest && !margin.negative()) {
      out.set_momentum_open();
    }
  } else if (Omega2.negative()) {
    const Interval rate = sqrt(-Omega2);
    const Interval re = -Omega2 - square(omega);
    if (facts.at_rest) {
      out.add_real(re, unknown);
      out.add_real(re, unknown);
    } else {
      const Interval im = 2.0 * (omega * rate);
      out.add({{re, im}, true}, unknown, false);
      out.add({{re, -im}, true}, unknown, false);
    }
  } else {
    const double reach = square(omega + sqrt(Interval(0.0, Omega2.magnitude()))).magnitude();
    const Interval any(-reach, reach);
    out.add({{any, any}, false}, unknown, false);
    out.add({{any, any}, false}, unknown, false);
  }
}

/// (iii), even, on the circle: see spectrum.cpp for the modes of the two shears.
template <class S>
void add_circle(const StraightState<S>& s, const EnclosureFacts& facts, EnclosureCollector& out) {
  const GyroscopicBlock<S> block = even_block_iii(s);
  const S breathing = block.rest.K[0][0] + block.rest.K[0][1];
  if (facts.rho_coupled) {
    const Polynomial<S, 2> p{{(breathing * s.V_rr - 2.0 * square(s.V_xr)) / (s.J.J1 * s.J.J3),
                              breathing / s.J.J1 + s.V_rr / s.J.J3, S(1.0)}};
    for (const RootEnclosure& root : enclose_roots(ranges(p), true)) {
      out.add(root, 1, true);
      out.negative.add_if_negative(-root.z.re);
    }
  } else {
    out.add_real(range(-(breathing / s.J.J1)), 1);
    out.negative.add_if_negative(range(breathing));
  }
  add_shears(s, block.K_alpha, facts, out);
}

/// (iii), even, of a held volume.
template <class S>
void add_held_iii(const StraightState<S>& s, const EnclosureFacts& facts, EnclosureCollector& out) {
  const HeldGyroscopicBlock<S> block = held_even_iii(s);
  const PlanarPencil<S>& plane = block.plane;
  if (facts.circle && facts.material_symmetry) {
    const S stiffness = plane.K[0] + plane.K[1];
    out.add_real(range(-(stiffness / (plane.mass[0] + plane.mass[1]))), 1);
    out.negative.add_if_negative(range(stiffness));
    add_shears(s, block.K_alpha, facts, out);
    return;
  }
  const bool forced = forced_zero(facts);
  const Interval det = range(plane.K[0] * plane.K[2] - square(plane.K[1]));
  if (forced) {
    out.add_forced_zero();
  } else {
    out.negative.add_if_negative(range(block.K_alpha));
  }
  out.negative.add(negatives_2(range(plane.K[0]), range(plane.K[2]), det));
  auto p = block.characteristic();
  if (forced) p.c[0] = S(0.0);
  const auto trace = block.trace_adjugate();
  const bool definite =
      range(plane.K[0]).positive() && det.positive() && (forced || range(block.K_alpha).positive());
  add_even_cubic(p, forced, definite, krein_of(p, trace), out);
}

template <class S>
SpectrumEnclosure enclosed(const EnclosureFacts& facts, const StraightState<S>& state,
                           const Spectrum& approximate) {
  EnclosureCollector out;
  if (facts.branch != Branch::iii && !facts.at_rest) {
    auto s = facts.branch == Branch::ii ? state.exchanged() : state;
    if (facts.volume_held) s = with_thickness_pull(s, s.J.J3 * square(s.omega));
    if (facts.volume_held) {
      add_symmetric(held_even_i(s), out);
    } else {
      add_symmetric(even_pencil_i(s), out);
    }
    add_odd_i(s, facts, out);
  } else {
    if (!facts.at_rest) add_odd_iii(state, out);
    if (facts.volume_held) {
      add_held_iii(state, facts, out);
      return out.finish(approximate);
    }
    if (!facts.rho_coupled) add_rho(state, out);
    if (facts.circle && facts.material_symmetry) {
      add_circle(state, facts, out);
    } else {
      add_even_iii(state, facts, out);
    }
  }
  return out.finish(approximate);
}

/// In the units of the state, or in others where these are far from one.
template <class S>
SpectrumEnclosure enclosed_in_units(const EnclosureFacts& facts, const StraightState<S>& state,
                                    const Spectrum& approximate) {
  const StateUnits units = units_of(state);
  if (units.are_own()) return enclosed(facts, state, approximate);
  const double square_rate = units.rate * units.rate;
  Spectrum near = approximate;
  for (Mode& mode : near.mode) {
    mode.lambda_re *= square_rate;
    mode.lambda_im *= square_rate;
  }
  SpectrumEnclosure out = enclosed(facts, in_units(state, units), near);
  for (ComplexInterval& lambda : out.lambda) {
    lambda.re = Interval(lambda.re.lo / square_rate, lambda.re.hi / square_rate);
    lambda.im = Interval(lambda.im.lo / square_rate, lambda.im.hi / square_rate);
  }
  return out;
}

}  // namespace

SpectrumEnclosure enclose_spectrum(const EnclosureFacts& facts,
                                   const StraightState<Interval>& state,
                                   const Spectrum& approximate) {
  return enclosed_in_units(facts, state, approximate);
}

SpectrumEnclosure enclose_spectrum(const EnclosureFacts& facts, const StraightState<Sloped>& state,
                                   const Spectrum& approximate) {
  return enclosed_in_units(facts, state, approximate);
}

SpectrumEnclosure enclose_two_polar_spectrum(const StraightState<Interval>& state,
                                             const Interval& theta_dot, bool wobbles,
                                             const Spectrum& approximate, bool volume_held) {
  EnclosureCollector out;
  if (volume_held) {
    add_symmetric(held_two_polar(state, theta_dot), out);
  } else {
    add_symmetric(two_polar_pencil(state, theta_dot), out);
  }
  if (wobbles) {
    const TwoPolarWobble<Interval> wobble = two_polar_wobble(state, theta_dot);
    const Interval energy_1 = -(wobble.a * wobble.s3);
    const Interval energy_2 = -(wobble.b * wobble.s3);
    out.add_real(-(wobble.a * wobble.b), proven_sign(energy_1));
    out.negative.add_if_negative(energy_1);
    out.negative.add_if_negative(energy_2);
  }
  return out.finish(approximate);
}

}  // namespace stationary
