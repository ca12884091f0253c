// The blocks of balanced_blocks.hpp in pairs of doubles, with the roots that need no bound to be
// found: what a processor may compute by fused multiply-adds (pair_kernels.hpp). P: the kind of
// pair, DoubleDouble or FusedPair, which give the same bits.
#pragma once

#include "lib/balanced/balanced_blocks.hpp"
#include "lib/balanced/separated_roots.hpp"

namespace stationary {

/// A spin in pairs, for (ii) with axes 1 and 2 exchanged.
using PairSpin = SpinningBody<DoubleDouble, double>;
using PairCurvatures = Curvatures<DoubleDouble>;
using LeadingState = BalancedState<double, double>;

/// Branch (i).
struct InPlaneBlocks {
  LeadingState state;
  Polynomial<DoubleDouble, 3> chain;  ///< in Lambda - chain_mean
  double chain_mean = 0.0;            ///< of roots near one another
  SeparatedRoots chain_roots;
  OddQuadratic<DoubleDouble> odd;
  RootPair<DoubleDouble> odd_roots;  ///< not where a symmetry forces a zero
};

/// Branch (iii).
struct NormalBlocks {
  LeadingState state;
  double I3_I1, I3_I2;  ///< in the units of the state
  double odd, rho;      ///< Lambda of the odd block and of the thickness
  NormalBlock<DoubleDouble> even;
  Polynomial<DoubleDouble, 3> cubic;  ///< of `even`
  SeparatedRoots cubic_roots;         ///< likewise
};

template <class P>
[[gnu::always_inline]] inline P pair_of(const DoubleDouble& x) {
  return {x.hi, x.lo};
}
template <class P>
[[gnu::always_inline]] inline DoubleDouble doubles_of(const P& x) {
  return {double(x.hi), double(x.lo)};
}

template <class P>
[[gnu::always_inline]] inline SpinningBody<P, double> spin_of(const PairSpin& of) {
  return {of.J1,
          of.J2,
          of.J3,
          pair_of<P>(of.xi),
          pair_of<P>(of.zeta),
          pair_of<P>(of.rho),
          of.omega,
          of.normal,
          of.least_apart};
}

template <class P, class Plane>
[[gnu::always_inline]] inline void plane_pairs(const Plane& model, const PairSpin& spin,
                                               PairCurvatures& out) {
  Curvatures<P> own;
  add_plane(model, spin_of<P>(spin), own);
  out.plane = {doubles_of(own.plane.uu), doubles_of(own.plane.uv), doubles_of(own.plane.vv)};
  out.w_l = doubles_of(own.w_l);
}
template <class P, class Thickness>
[[gnu::always_inline]] inline void thickness_pairs(const Thickness& model, const PairSpin& spin,
                                                   PairCurvatures& out) {
  Curvatures<P> own;
  add_thickness(model, spin_of<P>(spin), own);
  out.ww = doubles_of(own.ww);
}

template <class P>
[[gnu::always_inline]] inline BalancedState<P, double> state_of(const PairSpin& spin,
                                                                const PairCurvatures& curvatures,
                                                                const SpinUnits& units) {
  const auto own = [](const DoubleDouble& x) { return pair_of<P>(x); };
  const Curvatures<P> of{
      {own(curvatures.plane.uu), own(curvatures.plane.uv), own(curvatures.plane.vv)},
      own(curvatures.w_l),
      own(curvatures.ww)};
  return balanced_state(spin_of<P>(spin), of, units);
}

template <class P>
[[gnu::always_inline]] inline LeadingState leading_state(const BalancedState<P, double>& s) {
  return {.J1 = s.J1,
          .J2 = s.J2,
          .xi = leading(s.xi),
          .zeta = leading(s.zeta),
          .zeta2 = leading(s.zeta2),
          .m1 = leading(s.m1),
          .m2 = leading(s.m2),
          .m3 = leading(s.m3),
          .omega2 = leading(s.omega2),
          .uu = leading(s.uu),
          .uv = leading(s.uv),
          .vv = leading(s.vv),
          .ww = leading(s.ww),
          .sum = leading(s.sum),
          .apart = s.apart,
          .E = leading(s.E),
          .V_aa = leading(s.V_aa)};
}

template <class P, int D>
[[gnu::always_inline]] inline Polynomial<DoubleDouble, D> doubles_of(const Polynomial<P, D>& p) {
  Polynomial<DoubleDouble, D> out;
  for (std::size_t k = 0; k <= D; ++k) out.c[k] = doubles_of(p.c[k]);
  return out;
}

template <class P>
[[gnu::flatten]] void in_plane_blocks(const PairSpin& spin, const PairCurvatures& curvatures,
                                      const SpinUnits& units, bool material_symmetry,
                                      InPlaneBlocks& out) {
  const BalancedState<P, double> s = state_of<P>(spin, curvatures, units);
  out.state = leading_state(s);
  const ChainParts<P> parts = even_chain_i(s);
  const Polynomial<P, 3> chain = parts.characteristic();
  out.chain = doubles_of(chain);
  out.chain_mean = 0.0;
  out.chain_roots = separated_roots(chain);
  if (!out.chain_roots.found && is_cluster(out.chain)) {
    out.chain_mean = leading(chain.c[2]) * (-1.0 / 3.0);
    out.chain = doubles_of(parts.entries().characteristic_about(out.chain_mean));
  }
  const OddQuadratic<P> odd = odd_quadratic_i(s);
  out.odd = {doubles_of(odd.b), doubles_of(odd.c), doubles_of(odd.det_P), doubles_of(odd.det_Q),
             doubles_of(odd.Q_22)};
  if (material_symmetry) return;
  const RootPair<P> roots = quadratic_roots(odd.b, odd.c);
  out.odd_roots = {doubles_of(roots.mean), doubles_of(roots.separation), doubles_of(roots.large),
                   doubles_of(roots.small)};
}

template <class P>
[[gnu::flatten]] void normal_blocks(const PairSpin& spin, const PairCurvatures& curvatures,
                                    const SpinUnits& units, bool material_symmetry,
                                    NormalBlocks& out) {
  const BalancedState<P, double> s = state_of<P>(spin, curvatures, units);
  out.state = leading_state(s);
  out.I3_I1 = leading(P(s.m1 - s.m3));
  out.I3_I2 = leading(P(s.m2 - s.m3));
  out.odd = leading(odd_lambda_iii(s));
  out.rho = leading(P(-(s.ww / s.m3)));
  NormalBlock<P> even = normal_block(s);
  if (material_symmetry) even.k = P(0.0);
  out.even = {doubles_of(even.k), doubles_of(even.trace), doubles_of(even.det),
              doubles_of(even.det0), doubles_of(even.gain)};
  const Polynomial<P, 3> cubic = even.characteristic();
  out.cubic = doubles_of(cubic);
  if (!material_symmetry) out.cubic_roots = separated_roots(cubic);
}

}  // namespace stationary
