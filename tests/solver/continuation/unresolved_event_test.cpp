// An event is located as far as the sign change of its function is certain: of a family that is
// made up, with two frequencies that collide at p = 1/2 and are known to a given error.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "tests/support/followed.hpp"

namespace stationary {
namespace {

using namespace testing;

constexpr double collision = 0.5;

/// xi = zeta = e^p; the two Lambda of the even block are -4 +- sqrt(c (1/2 - p)), known to `error`.
/// Beyond p = 1/2 they are a complex pair. Up to `noise` around it what is computed is `noisy`.
class MadeUp final : public Family<2> {
 public:
  MadeUp(double error, double noise) : error_(error), noise_(noise) {}
  Branch branch() const override { return Branch::iii; }
  bool along_nu() const override { return true; }
  bool material_symmetry() const override { return false; }
  FamilyLinearization<2> linearize(const ReducedVector<2>& x, double p) const override {
    FamilyLinearization<2> out;
    out.g << std::log(x[0]) - p, std::log(x[1]) - p;
    out.jacobian.setIdentity();
    out.slope << -1.0, -1.0;
    out.nu_slope = out.slope;
    return out;
  }
  Refined refine_at(ReducedVector<2>& x, ReducedVector<2>& tail, double p) const override {
    x.setConstant(std::exp(p));
    tail.setZero();
    Refined out;
    out.converged = true;
    out.error_bound = 1e-15;
    return out;
  }
  ReducedVector<2> extended_residual(const ReducedVector<2>& x, double p) const override {
    return linearize(x, p).g;
  }
  ReducedVector<2> input_perturbation(const ReducedVector<2>&, double) const override {
    return ReducedVector<2>::Constant(1e-16);
  }
  Member member(const ReducedVector<2>& x, const ReducedVector<2>&, double p,
                double error_bound) const override {
    Member out;
    out.parameter = out.nu = p;
    out.body = Body(1.0, 2.0, 40.0);  // the locked inertias keep their order
    out.angular_velocity = {0.0, 0.0, p};
    out.q = {0.0, x[0], x[1], 1.0};
    out.error_bound = error_bound;
    out.spectrum = spectrum_at(p);
    return out;
  }

 private:
  Spectrum spectrum_at(double p) const {
    // Within the noise the sign of what is under the root is any.
    double square = collision - p;
    if (std::abs(square) < noise_) square = std::sin(1e5 * p) * noise_;
    const double root = std::sqrt(std::abs(square));
    Spectrum out;
    out.modes = 2;
    out.negative = 2;
    for (int k = 0; k < 2; ++k) {
      Mode& mode = out.mode[static_cast<std::size_t>(k)];
      mode.lambda_re = -4.0 + (square < 0.0 ? 0.0 : k == 0 ? root : -root);
      mode.lambda_im = square < 0.0 ? root : 0.0;
      mode.lambda_error = error_;
      mode.im = std::sqrt(-mode.lambda_re);
      mode.krein = square < 0.0 ? 0 : k == 0 ? -1 : 1;
    }
    const bool open = 2.0 * root <= 2.0 * error_;
    out.verdict = open           ? StabilityClass::marginal
                  : square < 0.0 ? StabilityClass::oscillatory
                                 : StabilityClass::elliptic;
    return out;
  }

  double error_;
  double noise_;
};

Followed made_up(double error, double noise) {
  const auto family = std::make_shared<const MadeUp>(error, noise);
  Kept kept;
  Followed out;
  const double start = std::exp(0.0);
  out.report =
      follow_family<2>(*family, {0.0, start, start, 1.0}, 0.0, range(0.0, 1.0, 1e-8), kept);
  out.rows = std::move(kept.rows);
  return out;
}

TEST(Unresolved, ACertainChangeOfSignIsLocated) {
  const Followed found = made_up(1e-12, 0.0);
  ASSERT_EQ(found.events().size(), 1U) << found.text();
  EXPECT_EQ(found.events()[0].event, EventType::hamiltonian_hopf);
  EXPECT_NEAR(found.events()[0].member.parameter, collision, 1e-12);
  ASSERT_EQ(found.report.events.size(), 1U);
  const EventRecord& event = found.report.events[0];
  EXPECT_EQ(event.status, EventStatus::located);
  EXPECT_NEAR(event.before, collision, 1e-12);
  EXPECT_NEAR(event.after, collision, 1e-12);
}

TEST(Unresolved, WithinTheErrorsThereIsABracketAndNoRow) {
  // The root is below the error within 1e-4 of the collision.
  for (const double noise : {0.0, 1e-4}) {
    const Followed found = made_up(1e-2, noise);
    EXPECT_TRUE(found.events().empty()) << found.text();
    ASSERT_EQ(found.report.events.size(), 1U);
    const EventRecord& event = found.report.events[0];
    EXPECT_EQ(event.type, EventType::hamiltonian_hopf);
    EXPECT_EQ(event.status, EventStatus::unresolved);
    EXPECT_LT(event.before, collision - 1e-5);
    EXPECT_GT(event.after, collision + 1e-5);
    EXPECT_LT(event.after - event.before, 0.5);
  }
}

TEST(Unresolved, NoiseIsNoEvent) {
  // Never certain again before the range ends.
  const Followed found = made_up(1.0, 0.0);
  EXPECT_TRUE(found.events().empty()) << found.text();
  EXPECT_TRUE(found.report.events.empty());
}

}  // namespace
}  // namespace stationary
