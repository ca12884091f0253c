// Followed two-polar families: against closed forms, branch (iii), the exchange of the two rates,
// and single motions solved one at a time.
#include "solver/family/two_polar_family.hpp"

#include <gtest/gtest.h>

#include "solver/kind/kind.hpp"
#include "solver/solve/two_polar_equilibrium.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/followed.hpp"

namespace stationary::testing {
namespace {

constexpr FamilyParameter first{FamilyParameter::Kind::nu, 0};
constexpr FamilyParameter second{FamilyParameter::Kind::nu, 1};
const Body round(1.25, 1.25, 0.6);

Stretch solved(const Potential& potential, const TwoPolarMotion& motion) {
  const Equilibrium at = solve_two_polar(round, potential, motion);
  if (at.status != SolveStatus::solved) throw std::runtime_error(at.message);
  return at.q;
}

Followed along(const Potential& potential, const TwoPolarMotion& motion, FamilyParameter parameter,
               double p, const FollowOptions& options) {
  return followed(two_polar_family(round, potential, {motion, parameter}),
                  solved(potential, motion), p, options);
}

void expect_near(const Stretch& a, const Stretch& b, double tolerance) {
  EXPECT_NEAR(std::log(a.xi / b.xi), 0.0, tolerance);
  EXPECT_NEAR(std::log(a.zeta / b.zeta), 0.0, tolerance);
  EXPECT_NEAR(std::log(a.rho / b.rho), 0.0, tolerance);
}

/// Every row balances, and is the motion solve_two_polar() finds from there.
void expect_members(const Potential& potential, const Followed& sheet, bool by_momenta) {
  ASSERT_GT(sheet.rows.size(), 10U);
  for (std::size_t k = 0; k < sheet.rows.size(); k += 7) {
    const auto& [member, event] = sheet.rows[k];
    if (event != EventType::none) continue;
    EXPECT_LE(member.residual, 1e-13);
    ASSERT_TRUE(member.two_polar && member.spectrum);
    SolveOptions how;
    how.start = member.q;
    const TwoPolarRates<double>& rates = member.two_polar->rates;
    const TwoPolarMomenta<double>& momenta = member.two_polar->momenta;
    const bool held = member.two_polar->by_momenta;
    EXPECT_EQ(held, by_momenta);
    const TwoPolarMotion motion = by_momenta ? TwoPolarMotion(momenta) : TwoPolarMotion(rates);
    const Equilibrium one = solve_two_polar(round, potential, motion, how);
    ASSERT_EQ(one.status, SolveStatus::solved) << one.message;
    const double bound = member.error_bound + one.error_bound;
    expect_near(member.q, one.q, 2.0 * bound + 1e-15);
    const Spectrum spectrum = two_polar_stability(round, potential, one);
    EXPECT_EQ(spectrum.negative, member.spectrum->negative) << member.parameter;
  }
}

/// At a motion, where G = 0, the slope of its rows by the parameter is that of their values.
TEST(TwoPolarFamily, SlopesByEveryParameterAreSlopes) {
  using Kind = FamilyParameter::Kind;
  const double numbers[] = {1.0, 3.0};
  const Potential potential = make_potential("hencky", {numbers[0], numbers[1]});
  SolveOptions how;
  how.start = Stretch{0.0, 2.3, 0.64, 0.69};
  const TwoPolarRates<double> rates{0.65, 0.02};
  const Equilibrium at = solve_two_polar(round, potential, rates, how);
  ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
  ASSERT_FALSE(at.circle);
  for (const Kind kind : {Kind::nu, Kind::plane}) {
    for (const int index : {0, 1}) {
      const double p = kind == Kind::plane ? numbers[index] : index == 0 ? 0.65 : 0.02;
      const AnyFamily any = two_polar_family(round, potential, {rates, {kind, index}, false});
      const Family<2>& family = *std::get<std::unique_ptr<Family<2>>>(any);
      const ReducedVector<2> x = family.coordinates(at.q, p);
      const FamilyLinearization<2> found = family.linearize(x, p);
      constexpr double h = 1e-5;
      const ReducedVector<2> ahead = family.extended_residual(x, p + h);
      const ReducedVector<2> behind = family.extended_residual(x, p - h);
      for (int i = 0; i < 2; ++i) {
        const double slope = (ahead[i] - behind[i]) / (2.0 * h);
        EXPECT_NEAR(found.slope[i], slope, 1e-8) << static_cast<int>(kind) << index << i;
        EXPECT_GT(std::abs(slope), 1e-3);
      }
    }
  }
}

/// Closed form: c/d^2 = -2 J omega theta', J (omega^2 + theta'^2) = k, s3 +- p_theta of t and d.
TEST(TwoPolarFamily, ReciprocalDeterminantInAMomentum) {
  const double c = 0.96;
  const double k = 1.25;
  const Potential potential = make_potential("reciprocal-determinant", {c, k});
  const TwoPolarMotion motion = TwoPolarMomenta<double>{2.75, -1.1875};  // t = 5/2, d = 1
  const Followed sheet = along(potential, motion, first, 2.75, range(1.5, 4.0));
  ASSERT_EQ(sheet.report.failure, "");
  expect_members(potential, sheet, true);
  for (const auto& [member, event] : sheet.rows) {
    const auto& rates = member.two_polar->rates;
    const double squares = rates.omega * rates.omega + rates.theta_dot * rates.theta_dot;
    const double d = member.q.xi * member.q.zeta;
    EXPECT_NEAR(round.J1 * squares / k, 1.0, 1e-13);
    EXPECT_NEAR(c / (d * d), -2.0 * round.J1 * rates.omega * rates.theta_dot, 1e-12);
    EXPECT_EQ(member.two_polar->momenta.s3, member.parameter);
    EXPECT_NE(event, EventType::unexplained);
  }
}

/// theta' = 0 is branch (iii) there; omega and theta' exchanged is the same ellipse.
TEST(TwoPolarFamily, ThroughBranchThreeAndItsExchange) {
  const Potential potential = make_potential("hencky", {1.0, 3.0});
  const double omega = 0.65;
  const Problem third(round, potential, Branch::iii);
  SolveOptions how;
  how.method = Method::newton;
  how.start = Stretch{0.0, 2.3, 0.64, 0.69};
  const Equilibrium ellipse = solve(third, omega, how);
  ASSERT_EQ(ellipse.status, SolveStatus::solved) << ellipse.message;
  ASSERT_GT(std::abs(ellipse.q.xi - ellipse.q.zeta), 0.1);
  const auto by_rates = [&](double a, double b, FamilyParameter which) {
    return followed(two_polar_family(round, potential, {TwoPolarRates<double>{a, b}, which}),
                    ellipse.q, 0.0, range(-0.15, 0.15));
  };
  const Followed sheet = by_rates(omega, 0.0, second);
  const Followed exchanged = by_rates(0.0, omega, first);
  ASSERT_EQ(sheet.report.failure, "");
  expect_members(potential, sheet, false);
  const auto between_events = [](const Followed& of) {  // the wobbles differ
    std::vector<Member> out;
    for (const auto& [member, event] : of.rows)
      if (event == EventType::none) out.push_back(member);
    return out;
  };
  const auto members = between_events(sheet);
  const auto others = between_events(exchanged);
  ASSERT_EQ(members.size(), others.size());
  for (std::size_t k = 0; k < members.size(); ++k) {
    expect_near(members[k].q, others[k].q, 1e-12);
    if (members[k].parameter == 0.0) expect_near(members[k].q, ellipse.q, 1e-14);
  }
}

/// hencky's circle, u = ln lambda: 2 (mu + lambda) u = J e^(2u) (omega + theta')^2; ellipses leave
/// it where J e^(2u) (omega^2 + theta'^2) = mu.
TEST(TwoPolarFamily, EllipseOffTheCircle) {
  const double mu = 1.0;
  const double lambda = 3.0;
  const Potential potential = make_potential("hencky", {mu, lambda});
  const double theta_dot = -0.2;
  const TwoPolarMotion motion = TwoPolarRates<double>{0.5, theta_dot};
  const Followed circle = along(potential, motion, first, 0.5, range(0.3, 1.1));
  const auto events = circle.events({EventType::ellipse});
  ASSERT_EQ(events.size(), 1U) << circle.text();
  const Member& at = events[0].member;
  EXPECT_EQ(at.q.xi, at.q.zeta);
  const double omega = at.parameter;
  const double pull = round.J1 * at.q.xi * at.q.xi;
  EXPECT_NEAR(pull * (omega * omega + theta_dot * theta_dot), mu, 1e-12);
  EXPECT_NEAR(pull * (omega + theta_dot) * (omega + theta_dot),
              2.0 * (mu + lambda) * std::log(at.q.xi), 1e-12);
  EXPECT_TRUE(circle.events({EventType::unexplained}).empty()) << circle.text();
}

/// s3 = 0: no Lambda is, but the wobble's signature is another beyond. At given rates and in s3 itself.
TEST(TwoPolarFamily, TheMomentumPassesZero) {
  const Body body(1.1140512247561987, 1.1140512247561987, 0.80698629346427531);
  const Potential potential =
      Potential(make_potential("hencky", {0.69030789872063525, 0.62600236112043262}).plane(),
                ReciprocalQuadratic<>{0.72191634950235206, 0.56340260408996812});
  const double theta_dot = -0.29590454318639337;
  const TwoPolarMotion rates = TwoPolarRates<double>{0.60828918005922683, theta_dot};
  const auto kind = kind_of(body, potential, rates);
  const Equilibrium start = kind->solve({});
  ASSERT_EQ(start.status, SolveStatus::solved);
  for (const double tolerance : {1e-5, 1e-10}) {
    const Followed sheet = followed(kind->family(first, {}, start.q), start.q, 0.60828918005922683,
                                    range(0.0, 1.0, tolerance));
    EXPECT_TRUE(sheet.events({EventType::unexplained}).empty()) << sheet.text();
    const auto found = sheet.events({EventType::zero_momentum});
    ASSERT_EQ(found.size(), 1U) << sheet.text();
    const Member& at = found[0].member;
    const double squares = at.q.xi * at.q.xi + at.q.zeta * at.q.zeta;
    const double product = -2.0 * at.q.xi * at.q.zeta * theta_dot;
    EXPECT_NEAR(squares * at.parameter, product, 1e-13 * product);
    const auto proof = kind->enclose_event(first, EventType::zero_momentum, at);
    ASSERT_TRUE(proof);
    EXPECT_TRUE(proof->proven) << proof->reason;
    int of[2] = {-1, -1};  // the counts beside it
    for (const FollowedRow& row : sheet.rows)
      if (row.event == EventType::none && std::abs(row.member.parameter - at.parameter) < 1e-3)
        of[row.member.parameter > at.parameter] = row.member.spectrum->negative;
    if (tolerance == 1e-10) {
      EXPECT_EQ(of[0], 0);
      EXPECT_EQ(of[1], 2);
    }
    // The same ellipses in s3.
    const TwoPolarMotion momenta = TwoPolarMomenta<double>{0.1, at.two_polar->momenta.p_theta};
    const auto by_s3 = kind_of(body, potential, momenta);
    SolveOptions near;
    near.start = at.q;
    const Equilibrium beside = by_s3->solve(near);
    ASSERT_EQ(beside.status, SolveStatus::solved);
    const Followed in_s3 =
        followed(by_s3->family(first, {}, beside.q), beside.q, 0.1, range(-0.1, 0.1, tolerance));
    const auto zero = in_s3.events({EventType::zero_momentum});
    ASSERT_EQ(zero.size(), 1U) << in_s3.text();
    EXPECT_NEAR(zero[0].member.parameter, 0.0, 1e-12);
    EXPECT_NEAR(zero[0].member.q.xi, at.q.xi, 1e-9 * at.q.xi);
    EXPECT_TRUE(in_s3.events({EventType::unexplained}).empty()) << in_s3.text();
  }
}

/// An axis tilts inside the step in which the ellipses meet the circle, however long that is.
TEST(TwoPolarFamily, ATiltInTheLastStepIsFound) {
  const Body body(1.8436338131161401, 1.8436338131161401, 1.4615131464400442);
  const Potential potential(BiotLog<>{0.78686029287011927, 1.5298820169229108},
                            ReciprocalQuadratic<>{1.6426975043747094, 1.1246853750326709});
  const double omega = 0.81399323489050368;
  const auto kind =
      kind_of(body, potential, TwoPolarMotion(TwoPolarRates<double>{omega, -0.086557156545163674}));
  const Equilibrium start = kind->solve({});
  ASSERT_EQ(start.status, SolveStatus::solved);
  for (const double tolerance : {1e-4, 1e-5, 1e-10}) {
    const Followed sheet =
        followed(kind->family(first, {}, start.q), start.q, omega, range(0.0, 0.9, tolerance));
    const auto found = sheet.events({EventType::tilt});
    ASSERT_EQ(found.size(), 1U) << tolerance << " " << sheet.text();
    EXPECT_NEAR(found[0].member.parameter, 0.70603264552, 1e-10);
    EXPECT_EQ(sheet.events({EventType::ellipse}).size(), 1U) << sheet.text();
    EXPECT_TRUE(sheet.events({EventType::fold_nu, EventType::fold_parameter}).empty())
        << sheet.text();
  }
}

/// In a coefficient and in J3; the ellipse does not know J3, its wobble does.
TEST(TwoPolarFamily, OtherParameters) {
  const Potential potential = make_potential("saint-venant-kirchhoff", {0.9, 2.1});
  const TwoPolarMotion motion = TwoPolarRates<double>{0.96, -0.28};
  const FamilyParameter coefficient{FamilyParameter::Kind::plane, 1};
  const Followed in_lambda = along(potential, motion, coefficient, 2.1, range(1.9, 2.3));
  ASSERT_EQ(in_lambda.report.failure, "");
  EXPECT_EQ(in_lambda.rows.back().member.parameter, 2.3);
  for (const auto& [member, event] : in_lambda.rows) EXPECT_LE(member.residual, 1e-13);
  const FamilyParameter thickness{FamilyParameter::Kind::inertia, 2};
  const Followed in_J3 = along(potential, motion, thickness, 0.6, range(0.5, 4.0));
  ASSERT_EQ(in_J3.report.failure, "");
  expect_near(in_J3.rows.front().member.q, in_J3.rows.back().member.q, 1e-15);
  EXPECT_NE(in_J3.rows.front().member.spectrum->mode[0].im,
            in_J3.rows.back().member.spectrum->mode[0].im);
  EXPECT_THROW(two_polar_family(round, potential, {motion, {FamilyParameter::Kind::inertia, 0}}),
               std::invalid_argument);
  EXPECT_THROW(two_polar_family(Body(1.0, 1.1, 0.6), potential, {motion, first}),
               std::invalid_argument);
}

/// With three unknowns: every rate's ellipses of a coupled potential, or none.
TEST(TwoPolarFamily, Random) {
  support::Random random(77);
  int followed_sheets = 0;
  for (int k = 0; k < 60 && followed_sheets < 20; ++k) {
    const std::string_view model = k % 3 == 0   ? "hencky"
                                   : k % 3 == 1 ? "saint-venant-kirchhoff"
                                                : "biot-log";
    const Potential potential =
        make_potential(model, {random.log_uniform(0.5, 2.0), random.log_uniform(0.5, 4.0)});
    const TwoPolarRates<double> rates{random.uniform(0.4, 1.3), random.uniform(-0.5, 0.5)};
    const Equilibrium at = solve_two_polar(round, potential, rates);
    if (at.status != SolveStatus::solved || at.circle) continue;
    ++followed_sheets;
    FollowOptions options = range(rates.omega - 0.2, rates.omega + 0.2, 1e-6);
    options.max_points = 500;
    const Followed sheet =
        followed(two_polar_family(round, potential, {rates, first}), at.q, rates.omega, options);
    EXPECT_EQ(sheet.report.failure, "");
    for (const auto& [member, event] : sheet.rows) {
      EXPECT_NE(event, EventType::stalled) << model << k << sheet.text();
      EXPECT_NE(event, EventType::unexplained) << model << k << sheet.text();
      EXPECT_LE(member.residual, 1e-12);
    }
  }
  EXPECT_GE(followed_sheets, 10);
}

}  // namespace
}  // namespace stationary::testing
