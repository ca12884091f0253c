#include "solver/motion/oriented_stability.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace stationary {
namespace {

/// The part of a leaf with these coordinates and their momenta.
Leaf part_of(const Leaf& whole, std::span<const std::size_t> coordinates) {
  const std::size_t n = coordinates.size();
  Leaf out;
  out.pairs = n;
  const auto place = [&](std::size_t k) {
    return k < n ? coordinates[k] : coordinates[k - n] + whole.pairs;
  };
  for (std::size_t i = 0; i < 2 * n; ++i) {
    for (std::size_t j = 0; j < 2 * n; ++j) {
      out.second_variation[i][j] = whole.second_variation[place(i)][place(j)];
      out.magnitude[i][j] = whole.magnitude[place(i)][place(j)];
    }
  }
  return out;
}

/// The order of a spectrum's modes.
bool before(const Mode& a, const Mode& b) { return a.im != b.im ? a.im < b.im : a.re < b.re; }

/// Spectra of parts that do not see each other, as one.
Spectrum united(const std::vector<std::pair<Block, Spectrum>>& parts) {
  Spectrum out;
  const auto has = [&](StabilityClass verdict) {
    return std::ranges::any_of(parts,
                               [&](const auto& part) { return part.second.verdict == verdict; });
  };
  out.verdict = StabilityClass::stable;
  for (const StabilityClass each : {StabilityClass::unstable, StabilityClass::marginal,
                                    StabilityClass::oscillatory, StabilityClass::elliptic}) {
    if (!has(each)) continue;
    out.verdict = each;
    break;
  }
  for (const auto& [block, part] : parts) {
    out.negative += part.negative;
    out.growth = std::max(out.growth, part.growth);
    for (int k = 0; k < part.modes; ++k) {
      Mode& mode = out.mode[static_cast<std::size_t>(out.modes++)];
      mode = part.mode[static_cast<std::size_t>(k)];
      mode.block = block;
    }
  }
  for (std::size_t k = 1; k < static_cast<std::size_t>(out.modes); ++k)
    for (std::size_t j = k; j > 0 && before(out.mode[j], out.mode[j - 1]); --j)
      std::swap(out.mode[j], out.mode[j - 1]);
  return out;
}

}  // namespace

Spectrum spectrum_by_parts(const Leaf& whole, LeafParts parts, double uncertainty) {
  parts.turns = whole.pairs == LeafShape{true, parts.volume_held}.pairs();
  std::vector<std::pair<Block, Spectrum>> found;
  for_each_leaf_part(parts, [&](Block block, const auto& coordinates) {
    found.emplace_back(block, general_spectrum({MaterialSymmetry::none, uncertainty},
                                               part_of(whole, coordinates)));
  });
  return united(found);
}

Spectrum oriented_stability(const OrientedSpin& spin, const OrientedModels& models,
                            const BasicStretch<DoubleDouble>& q, const Vector3<DoubleDouble>& nu,
                            double bound) {
  const double uncertainty = stretch_uncertainty(bound);
  const Body& body = spin.body;
  const AnisotropicPotential& V = models.potential;
  const bool straight = spin.about_axis && double(q.alpha) == 0.0 && V.shear_free();
  const DoubleDouble omega = nu[axis(spin.branch)];
  const bool volume_held = V.body().volume.has_value();
  if (straight && double(omega) != 0.0 && !volume_held) {
    const auto input = [](const auto& x) { return Conditioned::input(leading(x)); };
    const BlockFacts facts{spin.branch, false, !V.is_separable(), uncertainty};
    return block_spectrum(
        facts,
        straight_state(Inertia3<DoubleDouble>{body.J1, body.J2, body.J3}, models.extended, q,
                       omega),
        straight_state(Inertia3<Conditioned>{input(body.J1), input(body.J2), input(body.J3)},
                       models.conditioned,
                       BasicStretch<Conditioned>{0.0, input(q.xi), input(q.zeta), input(q.rho)},
                       input(omega)));
  }
  LeafParts parts{.coupled = !V.is_separable(), .volume_held = volume_held};
  // At rest there is no axis.
  parts.about_third = spin.about_axis && (spin.branch == Branch::iii || double(omega) == 0.0);
  parts.straight = straight && !parts.about_third;
  const Leaf leaf = motion_leaf(body, models.extended, models.conditioned, q, nu);
  return parts.divided() ? spectrum_by_parts(leaf, parts, uncertainty)
                         : general_spectrum({MaterialSymmetry::none, uncertainty}, leaf);
}

Turn turn_of(const Body& body, Branch branch, double V_aa, const Stretch& q, double nu) {
  const double omega2 = nu * nu;
  if (branch == Branch::iii) {
    const double pull = (body.J1 + body.J2) * omega2;
    const double stiffness = V_aa - pull;
    return {stiffness / (std::abs(stiffness) + 2.0 * pull), 4.0};
  }
  const double own = branch == Branch::i ? body.J1 : body.J2;
  const Vector3<double> m = second_moments(body, q);
  // I1 - I2 is the difference of the moments along 2 and 1; (ii) exchanges them.
  const double inertias = branch == Branch::i ? m[1] - m[0] : m[0] - m[1];
  const double h = body.J1 * q.xi + body.J2 * q.zeta;
  const double stiff = (V_aa - own * omega2) * inertias;
  const double pull = h * h * omega2;
  const double size = std::abs(stiff) + pull;
  // The moments may cancel: of a slow motion of a round body they nearly do.
  const double cancelled = std::abs(V_aa - own * omega2) * (m[0] + m[1]);
  return {(stiff - pull) / size, 4.0 * (1.0 + cancelled / size)};
}

}  // namespace stationary
