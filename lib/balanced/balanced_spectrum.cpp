#include "lib/balanced/balanced_spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/balanced/chain_bound.hpp"
#include "lib/stability/mode_collector.hpp"
#include "lib/stability/odd_signature.hpp"

namespace stationary {
namespace {

/// (i), even: a symmetric matrix, all energies +1 where imaginary. Returns the negative directions.
int add_chain(const InPlaneBlocks& blocks, const BalancedBound& bound, double u,
              ModeCollector& out) {
  const ChainBound error(even_chain_i(bound).entries(), u);
  const SeparatedRoots& roots = blocks.chain_roots;
  int negative = 0;
  const auto add = [&](double lambda, double spread) {
    out.add_real(lambda, spread, 1);
    negative += lambda > 0.0;
  };
  if (roots.found && error.resolves(*std::min_element(roots.gap.begin(), roots.gap.end()))) {
    for (std::size_t k = 0; k < 3; ++k)
      add(roots.root[k], error(roots.root[k], roots.slope[k], roots.gap[k]));
    return negative;
  }
  std::array<double, 3> careful = roots.root;
  if (!roots.found) {
    const auto [single, pair] = shifted(cubic_roots(blocks.chain), DoubleDouble(blocks.chain_mean));
    careful = {leading(single), leading(pair.small), leading(pair.large)};
  }
  const double any = error.largest();
  for (const double lambda : careful) add(lambda, any + 0x1p-53 * std::abs(lambda));
  return negative;
}

/// Sign of Q1 where it has a direction of no energy: its diagonal has one sign then, of which the
/// entry that cancels less is the more certain. Q_22: up to a positive factor.
int semidefinite_sign(const LeadingState& s, double Q_22) {
  const double V_aa = s.apart ? -2.0 * s.omega2 * s.J1 * s.J2 * s.zeta * s.sum / s.E : s.V_aa;
  const double h = s.J1 * s.xi + s.J2 * s.zeta;
  const double spin = s.omega2 * h * h / (s.m1 + s.m3);
  const double Q_11 = V_aa - s.J1 * s.omega2 + spin;
  const double size = std::abs(V_aa) + s.J1 * s.omega2 + spin;
  return std::abs(Q_11) * (s.m1 + s.m2) > std::abs(Q_22) * size ? sign(Q_11) : sign(Q_22);
}

int add_odd(const InPlaneBlocks& blocks, const BalancedBound& bound, bool material_symmetry,
            double u, ModeCollector& out) {
  const LeadingState& s = blocks.state;
  const OddQuadratic<DoubleDouble>& odd = blocks.odd;
  const OddQuadratic<Conditioned> conditioned = odd_quadratic_i(bound);
  const double Q_22 = leading(odd.Q_22);
  const double det_P = leading(odd.det_P);
  const UncertainPolynomial<2> uncertain(
      Polynomial<Conditioned, 2>{{conditioned.c, conditioned.b, Conditioned(1.0)}}, u);
  if (material_symmetry) {
    out.add_forced_zero();
    const double lambda = -leading(odd.b);
    const int energy = semidefinite_sign(s, Q_22);
    out.add_real(lambda, uncertain.spread.c[1] + 0x1p-53 * std::abs(lambda), energy);
    return (energy < 0) + (det_P < 0.0);
  }
  const double det_Q = leading(odd.det_Q);
  const bool definite =
      positive(conditioned.det_P, u) || positive(conditioned.det_Q, u);  // then Lambda is real
  const auto krein = [&](const DoubleDouble& lambda) {
    const double middle = -0.5 * leading(odd.b);
    return odd_signature(det_P, det_Q, sign(Q_22), leading(lambda), middle, [&] {
      const double I2 = s.m1 + s.m3;
      const double I3 = s.m1 + s.m2;
      return sign(-Q_22 * s.omega2 * det_P - middle * I2 * I3);
    });
  };
  out.add_pair(blocks.odd_roots, uncertain, !definite, krein);
  const int of_Q = det_Q < 0.0 ? 1 : 2 * (Q_22 < 0.0);
  return of_Q + (det_P < 0.0);
}

int add_normal(const NormalBlocks& blocks, const BalancedBound& bound, bool material_symmetry,
               double u, ModeCollector& out) {
  const NormalBlock<DoubleDouble>& block = blocks.even;
  NormalBlock<Conditioned> conditioned = normal_block(bound);
  if (material_symmetry) conditioned.k = Conditioned(0.0);
  const bool definite = positive(conditioned.trace, u) && positive(conditioned.det, u) &&
                        (material_symmetry || positive(conditioned.k, u));
  const Polynomial<DoubleDouble, 3>& p = blocks.cubic;
  const UncertainPolynomial<3> uncertain(conditioned.characteristic(), u);
  const auto krein = [&](const DoubleDouble& lambda) {
    return definite ? 1 : sign(leading(p.slope(lambda)) * leading(block.trace_adjugate()(lambda)));
  };
  const int negative =
      (leading(block.k) < 0.0) + negatives_2(leading(block.trace), 0.0, leading(block.det));
  const SeparatedRoots& roots = blocks.cubic_roots;
  std::array<double, 3> error;
  bool apart = roots.found;
  for (std::size_t k = 0; apart && k < 3; ++k) {
    error[k] = uncertain.root_error(roots.root[k]);
    apart = 16.0 * error[k] < roots.gap[k];
  }
  if (!apart) {
    out.add_cubic(p, uncertain, material_symmetry, definite, krein);
    return negative;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    out.add_real(roots.root[k], error[k], krein(DoubleDouble(roots.root[k])),
                 definite ? Axis::stays : Axis::may_leave);
  }
  return negative;
}

/// A pair that stands alone; second: of its error, what is of second order.
void add_single(double lambda, const Conditioned& bound, int signature, double u, double second,
                ModeCollector& out) {
  out.add_real(lambda, u * bound.condition + second + 0x1p-53 * std::abs(lambda), signature);
}

/// What is of second order in I3 - I1 and I3 - I2: all there is where both are 0.
double second_of_odd(const BalancedBound& c, double u) {
  const double both = u * (c.m1 - c.m3).condition * (u * (c.m2 - c.m3).condition);
  return both * std::abs(leading(c.omega2 / ((c.m1 + c.m3) * (c.m2 + c.m3))));
}

}  // namespace

bool in_range(const LeadingState& s) {
  const auto between = [](double x, double low, double high) {
    const double size = std::abs(x);
    return low < size && size < high;
  };
  for (const double m : {s.m1, s.m2, s.m3, s.J2})
    if (!between(m, 0x1p-120, 0x1p120)) return false;
  const double uv = std::abs(s.uv);
  const double largest =
      (std::abs(s.uu) + uv) / s.m1 + (std::abs(s.vv) + uv) / s.m2 + std::abs(s.ww) / s.m3;
  return largest < 0x1p200 && between(s.omega2, 0.5, 5.0);
}

Spectrum balanced_spectrum(const BlockFacts& facts, const InPlaneBlocks& blocks,
                           const BalancedBound& conditioned, const SpinUnits& units) {
  ModeCollector out(1.0 / units.rate);
  const double u = facts.uncertainty;
  int negative = add_chain(blocks, conditioned, u, out);
  out.begin(Block::odd);
  negative += add_odd(blocks, conditioned, facts.material_symmetry, u, out);
  out.set_negative(negative);
  return out.finish();
}

Spectrum balanced_spectrum(const BlockFacts& facts, const NormalBlocks& blocks,
                           const BalancedBound& conditioned, const SpinUnits& units) {
  ModeCollector out(1.0 / units.rate);
  const double u = facts.uncertainty;
  out.begin(Block::odd);
  const int first = sign(blocks.I3_I1);
  const int second = sign(blocks.I3_I2);
  add_single(blocks.odd, odd_lambda_iii(conditioned), first > 0 ? 1 : -1, u,
             second_of_odd(conditioned, u), out);
  out.begin(Block::thickness);
  add_single(blocks.rho, conditioned.ww / conditioned.m3, 1, u, 0.0, out);
  out.begin(Block::even);
  out.set_negative((first < 0) + (second < 0) + (blocks.rho > 0.0) +
                   add_normal(blocks, conditioned, facts.material_symmetry, u, out));
  return out.finish();
}

}  // namespace stationary
