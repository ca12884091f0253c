#include "solver/oriented_stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/general_spectrum.hpp"

namespace stationary {
namespace {

/// Names the block of the real Lambda nearest to one known by itself.
void name_block(double lambda, Block block, Spectrum& spectrum) {
  Mode* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < spectrum.modes; ++k) {
    Mode& mode = spectrum.mode[static_cast<std::size_t>(k)];
    const double apart = std::abs(mode.lambda_re - lambda);
    if (mode.lambda_im != 0.0 || mode.block != Block::even || !(apart < least)) continue;
    least = apart;
    nearest = &mode;
  }
  if (nearest != nullptr) nearest->block = block;
}

}  // namespace

Spectrum oriented_stability(const OrientedSpin& spin, const OrientedModels& models,
                            const BasicStretch<DoubleDouble>& q, const Vector3<DoubleDouble>& nu,
                            double bound) {
  const double uncertainty = std::isnan(bound) ? 1e-15 : std::max(bound, 0x1p-53);
  const Body& body = spin.body;
  const AnisotropicPotential& V = models.potential;
  const bool straight = spin.about_axis && double(q.alpha) == 0.0 && V.even_in_alpha();
  const DoubleDouble omega = nu[axis(spin.branch)];
  if (straight && double(omega) != 0.0) {
    const auto input = [](const auto& x) { return Conditioned::input(leading(x)); };
    const BlockFacts facts{spin.branch, false, !V.is_separable(), uncertainty};
    return block_spectrum(
        facts,
        straight_state(Inertia3<DoubleDouble>{body.J1, body.J2, body.J3}, models.extended, q,
                       omega),
        straight_state(Inertia3<Conditioned>{input(body.J1), input(body.J2), input(body.J3)},
                       V.model(AsConditioned()),
                       BasicStretch<Conditioned>{0.0, input(q.xi), input(q.zeta), input(q.rho)},
                       input(omega)));
  }
  Spectrum out = general_spectrum(body, Potential(V), q, nu, uncertainty);
  if (spin.about_axis && spin.branch == Branch::iii && double(omega) != 0.0) {
    // The reflection in the plane of axes 1 and 2 leaves pi1, pi2 to themselves, and of a separable
    // V rho.
    const Stretch at{double(q.alpha), double(q.xi), double(q.zeta), double(q.rho)};
    const Matrix3<double> I = locked_inertia(body, at);
    const auto det = [](double a, double b, double c) { return a * c - b * b; };
    const double spread =
        det(I(2, 2) - I(0, 0), -I(0, 1), I(2, 2) - I(1, 1)) / det(I(0, 0), I(0, 1), I(1, 1));
    name_block(-double(omega * omega) * spread, Block::odd, out);
    if (V.is_separable()) {
      const double V_rr = potential_derivatives<2>(models.plain, at).hessian(3, 3);
      name_block(-V_rr / body.J3, Block::thickness, out);
    }
  }
  return out;
}

double turn_of(const Body& body, Branch branch, double V_aa, const Stretch& q, double nu) {
  const double omega2 = nu * nu;
  if (branch == Branch::iii) {
    const double pull = (body.J1 + body.J2) * omega2;
    const double stiffness = V_aa - pull;
    return stiffness / (std::abs(stiffness) + 2.0 * pull);
  }
  const double own = branch == Branch::i ? body.J1 : body.J2;
  const Vector3<double> m = second_moments(body, q);
  // I1 - I2 is the difference of the moments along 2 and 1; (ii) exchanges them.
  const double inertias = branch == Branch::i ? m[1] - m[0] : m[0] - m[1];
  const double h = body.J1 * q.xi + body.J2 * q.zeta;
  const double stiff = (V_aa - own * omega2) * inertias;
  const double pull = h * h * omega2;
  return (stiff - pull) / (std::abs(stiff) + pull);
}

}  // namespace stationary
