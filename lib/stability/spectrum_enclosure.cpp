#include "lib/stability/spectrum_enclosure.hpp"

#include "lib/stability/enclosure_collector.hpp"
#include "lib/stability/held_linearization.hpp"

namespace stationary {
namespace {

/// Roots of p; krein(Lambda) of a simple imaginary one. definite: they are real, semisimple and of
/// positive energy where imaginary.
template <int D, class Krein>
void add_roots(const Polynomial<Interval, D>& p, bool all_real, bool definite, const Krein& krein,
               EnclosureCollector& out) {
  for (const RootEnclosure& root : enclose_roots(p, all_real || definite))
    out.add(root, definite ? 1 : root.simple && root.real() ? krein(root.z.re) : unknown, definite);
}

/// A symmetric pencil: real Lambda, energies +1 where imaginary.
template <class Pencil>
void add_symmetric(const Pencil& pencil, EnclosureCollector& out) {
  for (const RootEnclosure& root : enclose_roots(pencil.characteristic(), true)) {
    out.add(root, 1, true);
    out.negative.add_if_negative(-root.z.re);
  }
}

void add_odd_i(const StraightState<Interval>& s, bool material_symmetry, EnclosureCollector& out) {
  OddForms<Interval> odd = odd_forms_i(s);
  // P[0] = I3/D > 0: one sign of det P says all of P.
  const int sign_P = proven_sign(odd.det_P);
  const Interval trace = odd.P[0] * odd.Q1[0] + 2.0 * (odd.P[1] * odd.Q1[1]) + odd.P[2] * odd.Q1[2];
  if (material_symmetry) {
    // Q1 = sigma q q^T exactly; the mode's energy is sigma (q^T P q)^2, its -Lambda sigma q^T P q.
    const int sigma = proven_sign(odd.Q1[0] + odd.Q1[2]);
    out.add_forced_zero();
    out.add_real(-trace, sigma);
    out.negative.add(sigma == unknown ? std::nullopt : std::optional(sigma < 0 ? 1 : 0));
    out.negative.add_if_negative(odd.det_P);
    return;
  }
  out.negative.add(negatives_2(odd.Q1[0], odd.Q1[2], odd.det_Q1));
  out.negative.add_if_negative(odd.det_P);
  // With P or Q1 definite P Q1 is similar to a symmetric matrix; with P > 0 the energy of a mode is
  // -Lambda v^T P^-1 v > 0.
  const bool all_real = sign_P > 0 || odd.det_Q1.positive();
  const auto krein = [&](const Interval& lambda) {
    if (sign_P > 0) return 1;
    const Interval m = -lambda;
    const Interval n11 = odd.P[0] * odd.Q1[0] + odd.P[1] * odd.Q1[1];
    const Interval n12 = odd.P[0] * odd.Q1[1] + odd.P[1] * odd.Q1[2];
    const Interval n21 = odd.P[1] * odd.Q1[0] + odd.P[2] * odd.Q1[1];
    const Interval n22 = odd.P[1] * odd.Q1[1] + odd.P[2] * odd.Q1[2];
    const auto energy = [&](const Interval& x, const Interval& y) {
      return odd.Q1[0] * square(x) + 2.0 * (odd.Q1[1] * (x * y)) + odd.Q1[2] * square(y);
    };
    const int first = proven_sign(energy(n12, m - n11));
    return first != unknown ? first : proven_sign(energy(m - n22, n21));
  };
  add_roots(odd.characteristic(), all_real, false, krein, out);
}

/// (iii), odd: the rigid body's pair.
void add_odd_iii(const StraightState<Interval>& s, EnclosureCollector& out) {
  const int s1 = proven_sign(s.I3() - s.I1());
  const int s2 = proven_sign(s.I3() - s.I2());
  out.add_real(odd_lambda_iii(s), s1 == s2 ? s1 : unknown);
  out.negative.add_if_negative(s.I3() - s.I1());
  out.negative.add_if_negative(s.I3() - s.I2());
}

void add_rho(const StraightState<Interval>& s, EnclosureCollector& out) {
  out.add_real(-(s.V_rr / s.J.J3), 1);
  out.negative.add_if_negative(s.V_rr);
}

/// The direction of the material symmetry (at rest V alone counts, isotropic as it mostly is).
bool forced_zero(const EnclosureFacts& facts) {
  return !facts.circle && (facts.material_symmetry || (facts.at_rest && facts.isotropic));
}

/// The roots of a cubic of (alpha, xi, zeta), the forced zero among them left out.
template <class Krein>
void add_even_cubic(const Polynomial<Interval, 3>& p, bool forced, bool definite,
                    const Krein& krein, EnclosureCollector& out) {
  if (forced) {
    add_roots(Polynomial<Interval, 2>{{p.c[1], p.c[2], p.c[3]}}, false, definite, krein, out);
  } else {
    add_roots(p, false, definite, krein, out);
  }
}

/// Signature of a simple imaginary root, from tr adj of the pencil.
auto krein_of(const auto& p, const auto& trace) {
  return [&p, &trace](const Interval& lambda) {
    return proven_sign(p.slope(lambda)) * proven_sign(trace(lambda));
  };
}

void add_even_iii(const StraightState<Interval>& s, const EnclosureFacts& facts,
                  EnclosureCollector& out) {
  const GyroscopicBlock<Interval> block = even_block_iii(s);
  const bool forced = forced_zero(facts);
  const auto& K = block.rest.K;
  const Interval det_K = block.planar_determinant().c[0];
  const bool planar_definite = K[0][0].positive() && det_K.positive();
  const bool alpha_definite = forced || block.K_alpha.positive();
  if (forced) {
    out.add_forced_zero();
  } else {
    out.negative.add_if_negative(block.K_alpha);
  }
  if (!facts.rho_coupled) {
    out.negative.add(negatives_2(K[0][0], K[1][1], det_K));
    auto p = block.characteristic();
    if (forced) p.c[0] = 0.0;
    const auto trace = block.trace_adjugate();
    const auto krein = krein_of(p, trace);
    const bool definite = planar_definite && alpha_definite;
    add_even_cubic(p, forced, definite, krein, out);
    return;
  }
  // Sylvester: the (xi, zeta, rho) stiffness has as many negative eigenvalues as its pencil with
  // mass has positive Lambda.
  const auto stiffness = block.rest.characteristic();
  for (const RootEnclosure& root : enclose_roots(stiffness, true))
    out.negative.add_if_negative(-root.z.re);
  const bool definite = planar_definite && alpha_definite && stiffness.c[0].positive();
  auto p = block.characteristic_coupled();
  if (forced) p.c[0] = 0.0;
  const auto trace = block.trace_adjugate_coupled();
  const auto krein = krein_of(p, trace);
  if (forced) {
    add_roots(Polynomial<Interval, 3>{{p.c[1], p.c[2], p.c[3], p.c[4]}}, false, definite, krein,
              out);
  } else {
    add_roots(p, false, definite, krein, out);
  }
}

/// The two shears of the circle: see spectrum.cpp.
void add_shears(const StraightState<Interval>& s, const Interval& K_alpha,
                const EnclosureFacts& facts, EnclosureCollector& out) {
  out.negative.add_if_negative(K_alpha);
  out.negative.add_if_negative(K_alpha);

  const Interval omega = sqrt(square(s.omega));
  const Interval shear = K_alpha / (2.0 * s.J.J1);
  const Interval Omega2 = square(omega) + shear;
  if (Omega2.positive()) {
    const Interval Omega = sqrt(Omega2);
    const Interval fast = omega + Omega;
    const Interval slow = shear / fast;
    out.add_real(-square(fast), 1);
    out.add_real(-square(slow), proven_sign(slow));
    const Interval margin = 0.5 * fast + omega * (s.I3() / s.I1() - Interval(1.0));
    if (omega.positive() && margin.positive()) out.set_definite_with_momentum();
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
void add_circle(const StraightState<Interval>& s, const EnclosureFacts& facts,
                EnclosureCollector& out) {
  const GyroscopicBlock<Interval> block = even_block_iii(s);
  const Interval breathing = block.rest.K[0][0] + block.rest.K[0][1];
  if (facts.rho_coupled) {
    const Polynomial<Interval, 2> p{
        {(breathing * s.V_rr - 2.0 * square(s.V_xr)) / (s.J.J1 * s.J.J3),
         breathing / s.J.J1 + s.V_rr / s.J.J3, Interval(1.0)}};
    for (const RootEnclosure& root : enclose_roots(p, true)) {
      out.add(root, 1, true);
      out.negative.add_if_negative(-root.z.re);
    }
  } else {
    out.add_real(-(breathing / s.J.J1), 1);
    out.negative.add_if_negative(breathing);
  }
  add_shears(s, block.K_alpha, facts, out);
}

/// (iii), even, of a held volume.
void add_held_iii(const StraightState<Interval>& s, const EnclosureFacts& facts,
                  EnclosureCollector& out) {
  const HeldGyroscopicBlock<Interval> block = held_even_iii(s);
  const PlanarPencil<Interval>& plane = block.plane;
  if (facts.circle && facts.material_symmetry) {
    const Interval stiffness = plane.K[0] + plane.K[1];
    out.add_real(-(stiffness / (plane.mass[0] + plane.mass[1])), 1);
    out.negative.add_if_negative(stiffness);
    add_shears(s, block.K_alpha, facts, out);
    return;
  }
  const bool forced = forced_zero(facts);
  const Interval det = plane.K[0] * plane.K[2] - square(plane.K[1]);
  if (forced) {
    out.add_forced_zero();
  } else {
    out.negative.add_if_negative(block.K_alpha);
  }
  out.negative.add(negatives_2(plane.K[0], plane.K[2], det));
  auto p = block.characteristic();
  if (forced) p.c[0] = 0.0;
  const auto trace = block.trace_adjugate();
  const bool definite =
      plane.K[0].positive() && det.positive() && (forced || block.K_alpha.positive());
  add_even_cubic(p, forced, definite, krein_of(p, trace), out);
}

}  // namespace

SpectrumEnclosure enclose_spectrum(const EnclosureFacts& facts,
                                   const StraightState<Interval>& state,
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
    add_odd_i(s, facts.material_symmetry, out);
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
