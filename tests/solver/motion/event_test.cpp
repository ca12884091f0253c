// What is an event and what is not: circle to ellipse by a closed form, folds by another, the
// symmetric body's silence, and the bookkeeping of types.
#include "solver/motion/event.hpp"

#include <gtest/gtest.h>

#include <set>

#include "solver/family/model_family.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/closed_forms.hpp"
#include "tests/support/followed.hpp"

namespace stationary {
namespace {

using namespace testing;

/// W = 1/d + (t^2 - 2d) - (b/2) e + (g/4) e^2, e = t^2 - 4d. With J1 = J2 = J in (iii), n = J nu^2:
///
///   circle    xi^4 (2 - n) = 1, whatever b and g;  K_alpha,alpha = 4 (2 - b - n);
///             its shears are +-(nu +- sqrt(nu^2 + K_alpha,alpha/2J)) i, until n = 2 (2 - b)
///   ellipses  d^2 (2 - n) = 1,  (xi - zeta)^2 = e = (n - 2 + b)/g
///
/// so that they branch off where n = 2 - b: towards larger nu for g > 0, smaller for g < 0.
template <class C = double>
struct Bifurcating {
  C b;
  C g;

  std::array<C, 2> coefficients() const { return {b, g}; }

  template <int order, class S>
  PlanarDerivatives<Product<C, S>> evaluate(const PlanarInvariants<S>& x) const {
    PlanarDerivatives<Product<C, S>> out;
    using R = Product<C, S>;
    const R reciprocal = R(1.0 / x.d);
    const R t(x.t);
    const R d(x.d);
    const R ge = g * x.e;
    out.w = reciprocal + (x.t * x.t - 2.0 * x.d) + (0.25 * ge - 0.5 * b) * x.e;
    if constexpr (order >= 1) {
      out.w_t = (R(2.0) - b + ge) * t;
      out.w_l = (2.0 * b - R(2.0) - 2.0 * ge) * d - reciprocal;
    }
    if constexpr (order >= 2) {
      out.w_tt = R(2.0) - b + ge + 2.0 * g * (t * t);
      out.w_tl = -4.0 * g * (t * d);
      out.w_ll = reciprocal + (2.0 * b - R(2.0) - 2.0 * ge) * d + 8.0 * g * (d * d);
    }
    return out;
  }
};

struct RoundPlate {
  double J = 0.8;
  double b = 0.7;
  double g = 0.9;

  double bifurcation() const { return std::sqrt((2.0 - b) / J); }
  AnyFamily family() const {
    using Model = Separable<Bifurcating<>, ReciprocalQuadratic<>>;
    const Model model{{b, g}, {1.0, 3.0}};
    return std::unique_ptr<Family<2>>(std::make_unique<ModelFamily<Model, 2>>(
        Body(J, J, 0.5), Branch::iii, model, AxisFamilyOptions{}));
  }
  double rho() const { return std::cbrt(1.0 / 3.0); }
  Stretch circle(double nu) const {
    const double x = std::pow(2.0 - J * nu * nu, -0.25);
    return {0.0, x, x, rho()};
  }
  Stretch ellipse(double nu) const {
    const double d = 1.0 / std::sqrt(2.0 - J * nu * nu);
    const double e = (J * nu * nu - 2.0 + b) / g;
    const double root = std::sqrt(e + 4.0 * d);
    return {0.0, 0.5 * (root + std::sqrt(e)), 0.5 * (root - std::sqrt(e)), rho()};
  }
};

const RoundPlate plates[] = {{0.8, 0.7, 0.9},   {1.0, 0.25, 0.05}, {2.5, 1.5, 3.0},
                             {0.8, 0.7, -0.03}, {1.3, 1.9, 0.4},   {1.0, 0.3, -0.02}};

double relative(double a, double b) { return std::abs(a - b) / std::abs(b); }

TEST(CircleToEllipse, IsFoundOnTheCircleThoughNoGrowthRateChanges) {
  for (const RoundPlate& plate : plates) {
    const double end = std::sqrt(2.0 / plate.J);
    for (const double tolerance : {1e-3, 1e-6, 1e-10}) {
      for (const double first : {0.3, 0.01}) {
        FollowOptions options = range(0.0, 0.995 * end, tolerance);
        options.continuation.step.first = first;
        const Followed sheet = followed(plate.family(), plate.circle(0.0), 0.0, options);
        const auto found = sheet.events({EventType::ellipse});
        ASSERT_EQ(found.size(), 1U) << plate.b << " " << tolerance << ": " << sheet.text();
        EXPECT_LE(relative(found[0].member.nu, plate.bifurcation()), 1e-13) << plate.b;
        EXPECT_EQ(found[0].member.q.xi, found[0].member.q.zeta);
        EXPECT_EQ(sheet.report.forward.event, EventType::limit) << "the circle goes on";
        double last = 0.0;
        for (const FollowedRow& row : sheet.rows) {
          EXPECT_EQ(row.member.q.xi, row.member.q.zeta);
          EXPECT_LE(relative(row.member.q.xi, plate.circle(row.member.nu).xi),
                    row.member.error_bound);
          if (row.member.nu < 1.3 * plate.bifurcation()) {
            EXPECT_EQ(row.member.spectrum->growth, 0.0) << "nothing to be seen in it";
          }
          EXPECT_GE(row.member.nu, last);
          last = row.member.nu;
        }
        EXPECT_TRUE(
            sheet.events({EventType::fold_nu, EventType::fold_parameter, EventType::unexplained})
                .empty())
            << sheet.text();
        const auto hopf = sheet.events({EventType::hamiltonian_hopf});
        const double nu = std::sqrt(2.0) * plate.bifurcation();
        if (nu < 0.99 * end) {
          ASSERT_EQ(hopf.size(), 1U) << plate.b << sheet.text();
          EXPECT_LE(relative(hopf[0].member.nu, nu), 1e-13) << plate.b;
        } else {
          EXPECT_TRUE(hopf.empty()) << plate.b << sheet.text();
        }
      }
    }
  }
}

TEST(CircleToEllipse, EndsTheSheetOfEllipses) {
  for (const RoundPlate& plate : plates) {
    const double n = 2.0 - plate.b;
    // Towards the other end of the ellipses; for g < 0 they meet rest's nu or zeta = 0 there.
    const double far = plate.g > 0.0 ? n + 0.4 * plate.b : n * 0.93;
    const double nu = std::sqrt(far / plate.J);
    for (const double tolerance : {1e-3, 1e-6, 1e-10}) {
      const double reach = std::abs(nu - plate.bifurcation());
      const FollowOptions options = range(std::min(nu, plate.bifurcation() - reach),
                                          std::max(nu, plate.bifurcation() + reach), tolerance);
      const Followed sheet = followed(plate.family(), plate.ellipse(nu), nu, options);
      ASSERT_EQ(sheet.report.failure, "");
      const bool first = plate.g > 0.0;
      const FollowedRow& end = first ? sheet.rows.front() : sheet.rows.back();
      ASSERT_EQ(end.event, EventType::ellipse) << plate.b << " " << tolerance << sheet.text();
      EXPECT_EQ(sheet.events({EventType::ellipse}).size(), 1U) << sheet.text();
      EXPECT_LE(relative(end.member.nu, plate.bifurcation()), 1e-13) << plate.b << tolerance;
      EXPECT_EQ(end.member.q.xi, end.member.q.zeta);
      EXPECT_LE(relative(end.member.q.xi, plate.circle(plate.bifurcation()).xi), 1e-13);
      for (const FollowedRow& row : sheet.rows) {
        if (&row == &end) continue;
        EXPECT_GT(row.member.q.xi, row.member.q.zeta);
        if (std::abs(row.member.nu - plate.bifurcation()) < 1e-6) continue;  // a square root there
        const Stretch exact = plate.ellipse(row.member.nu);
        EXPECT_LE(relative(row.member.q.xi, exact.xi), row.member.error_bound + 1e-13);
        EXPECT_LE(relative(row.member.q.zeta, exact.zeta), row.member.error_bound + 1e-13);
      }
    }
  }
}

TEST(CircleToEllipse, NeverWhereNoEllipsesAre) {
  const Body body(1.3, 1.3, 0.6);
  const Problem problem(body, make_potential("reciprocal-determinant", {1.0, 2.0}), Branch::iii);
  const Followed sheet = followed(problem, 0.0, range(0.0, 2.0));
  EXPECT_TRUE(sheet
                  .events({EventType::ellipse, EventType::shear, EventType::fold_nu,
                           EventType::fold_parameter})
                  .empty())
      << sheet.text();
  EXPECT_EQ(sheet.report.forward.event, EventType::escape);
  EXPECT_NEAR(sheet.rows.back().member.nu, std::sqrt(2.0 / 1.3), 1e-6);
}

TEST(CircleToEllipse, OfTheBuiltInModelsAtTheirClosedForms) {
  // biot: J nu^2 = 2 mu; neo-hookean: J nu^2 = mu where the circle escapes, so never before.
  const Problem biot(Body(1.0, 1.0, 0.6), make_potential("biot", {1.0, 2.0}), Branch::iii);
  const Followed sheet = followed(biot, 0.0, range(0.0, 2.0));
  const auto found = sheet.events({EventType::ellipse});
  ASSERT_EQ(found.size(), 1U) << sheet.text();
  EXPECT_LE(relative(found[0].member.nu, std::sqrt(2.0)), 1e-14);
}

/// J1 = J2, the paper's isotropic models: no axis in the plane is preferred.
TEST(EventTypes, NeitherObliqueNorShearAlongNuForIsotropicModels) {
  for (const std::string_view model : planar_models()) {
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
      for (const Body& body : {Body(1.0, 1.7, 0.6), Body(1.0, 1.0, 0.6)}) {
        const Problem problem(body, make_potential(model, {1.0, 2.0}), branch);
        const Followed sheet = followed(problem, 0.0, range(0.0, 3.0, 1e-5));
        EXPECT_TRUE(sheet.events({EventType::oblique, EventType::shear}).empty())
            << model << " " << name(branch) << sheet.text();
        EXPECT_TRUE(sheet.events({EventType::unexplained, EventType::stalled}).empty())
            << model << " " << name(branch) << " J1 " << body.J1 << " J2 " << body.J2 << ": "
            << sheet.text() << sheet.report.forward.reason << "; " << sheet.report.backward.reason;
      }
    }
  }
}

/// The fold of nu in (i) of hencky.
TEST(FoldNu, OfHenckyAtItsClosedForm) {
  support::Random random(311);
  for (int k = 0; k < 20; ++k) {
    const double mu = random.log_uniform(0.2, 5.0);
    const double lambda = mu * random.uniform(-0.5, 3.0);
    const Body body = random.body();
    const support::HenckyFold<double> fold(body.J2, mu, lambda);
    const Problem problem(body,
                          make_potential("hencky", {mu, lambda}, "reciprocal-quadratic",
                                         {1.0, 20.0 * body.J3 * fold.nu_squared}),
                          Branch::i);
    const double nu = std::sqrt(fold.nu_squared);
    const double tolerance = std::pow(10.0, random.uniform(-10.0, -3.0));
    const Followed sheet = followed(problem, 0.0, range(0.0, 2.0 * nu, tolerance));
    const auto found = sheet.events({EventType::fold_nu});
    ASSERT_EQ(found.size(), 1U) << k << " " << sheet.text();
    const Member& at = found[0].member;
    EXPECT_LE(relative(at.nu, nu), 1e-13) << k;
    EXPECT_LE(relative(at.q.zeta, fold.zeta), at.error_bound) << k;
    EXPECT_LE(relative(at.q.xi, fold.xi), at.error_bound) << k;
    EXPECT_LE(at.error_bound, 1e-11) << k;
    // nu falls again while zeta grows.
    double zeta = 0.0;
    for (const FollowedRow& row : sheet.rows) {
      EXPECT_LE(row.member.nu, nu * (1.0 + 1e-14));
      EXPECT_GE(row.member.q.zeta, zeta);
      zeta = row.member.q.zeta;
    }
    EXPECT_GT(zeta, 10.0);
  }
}

TEST(EventTypes, NamesAreTheContracts) {
  EXPECT_EQ(std::size(event_names), static_cast<std::size_t>(EventType::stalled) + 1);
  EXPECT_EQ(std::set<std::string_view>(std::begin(event_names), std::end(event_names)).size(),
            std::size(event_names));
  for (const auto& [type, text] : {std::pair{EventType::fold_nu, "fold-nu"},
                                   {EventType::fold_momentum, "fold-momentum"},
                                   {EventType::tilt, "tilt"},
                                   {EventType::ellipse, "ellipse"},
                                   {EventType::shear, "shear"},
                                   {EventType::oblique, "oblique"},
                                   {EventType::hamiltonian_hopf, "hamiltonian-hopf"},
                                   {EventType::krein_pass, "krein-pass"},
                                   {EventType::inertia_exchange, "inertia-exchange"},
                                   {EventType::collapse, "collapse"},
                                   {EventType::escape, "escape"},
                                   {EventType::limit, "limit"}}) {
    EXPECT_EQ(name(type), text);
    EXPECT_EQ(is_end(type),
              type == EventType::collapse || type == EventType::escape || type == EventType::limit);
  }
}

/// Which pair of locked inertias tilts the axis: the one with the spin's own in it.
TEST(EventTypes, TiltIsOfTheSpinsAxis) {
  for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
    const TestContext context{branch, false, Circle::none};
    const TestValues at{};
    const auto type = [&](std::size_t k) { return event_type(k, context, at); };
    EXPECT_EQ(type(TestValues::inertia_12), EventType::inertia_exchange);
    EXPECT_EQ(type(TestValues::inertia_13) == EventType::tilt, branch != Branch::ii);
    EXPECT_EQ(type(TestValues::inertia_23) == EventType::tilt, branch != Branch::i);
    EXPECT_EQ(type(TestValues::turn),
              branch == Branch::iii ? EventType::shear : EventType::oblique);
  }
}

TEST(EventTypes, PairsOfOneSignaturePassUnmentioned) {
  const TestContext context{Branch::i, false, Circle::none};
  TestValues at{};
  EXPECT_EQ(event_type(TestValues::crossings + 3, context, at), EventType::none);
  at.opposite = 1U << 3U;
  EXPECT_EQ(event_type(TestValues::crossings + 3, context, at), EventType::krein_pass);
  EXPECT_EQ(event_type(TestValues::crossings + 2, context, at), EventType::none);
  at.collides_imaginary = true;
  EXPECT_EQ(event_type(TestValues::collision, context, at), EventType::hamiltonian_hopf);
  at.collides_imaginary = false;
  EXPECT_EQ(event_type(TestValues::collision, context, at), EventType::real_collision);
}

TEST(TestValuesOf, AMember) {
  Member member;
  member.body = Body(1.0, 2.0, 3.0);
  member.nu = 0.5;
  member.q = {0.0, 1.0, 0.5, 0.5};  // J_k q_k^2: 1, 0.5, 0.75
  member.shear_stiffness = -0.25;
  const TestValues in_iii = test_values(member, {Branch::iii, false, Circle::none}, 0.1, -0.2);
  EXPECT_EQ(in_iii.value[TestValues::fold], 0.1);
  EXPECT_EQ(in_iii.value[TestValues::momentum], -0.2);
  EXPECT_DOUBLE_EQ(in_iii.value[TestValues::inertia_12], -1.0 / 3.0);
  EXPECT_LT(in_iii.value[TestValues::inertia_13], 0.0);
  EXPECT_GT(in_iii.value[TestValues::inertia_23], 0.0);
  EXPECT_LT(in_iii.value[TestValues::turn], 0.0);
  EXPECT_TRUE(std::isnan(in_iii.value[TestValues::ellipse]));
  EXPECT_TRUE(std::isnan(in_iii.value[TestValues::collision])) << "no spectrum";
  const TestValues circle = test_values(member, {Branch::iii, true, Circle::xi_zeta}, 0.1, -0.2);
  EXPECT_LT(circle.value[TestValues::ellipse], 0.0);
  EXPECT_TRUE(std::isnan(circle.value[TestValues::turn]));
  EXPECT_TRUE(std::isnan(circle.value[TestValues::inertia_12]));
  EXPECT_TRUE(std::isnan(circle.value[TestValues::inertia_23]));
  const TestValues in_i = test_values(member, {Branch::i, false, Circle::none}, 0.1, -0.2);
  EXPECT_LT(in_i.value[TestValues::turn], 0.0) << "J1 < J2";
}

/// Of two functions that both are of a tilt one may not be known.
TEST(Events, TheNearestFunctionIsOneThatIsKnown) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const TestContext context{.branch = Branch::iii, .material_symmetry = false};
  TestValues at;
  at.value.fill(none);
  EXPECT_FALSE(nearest_function(EventType::tilt, context, at));
  at.value[TestValues::inertia_23] = -0.2;
  EXPECT_EQ(nearest_function(EventType::tilt, context, at), TestValues::inertia_23);
  at.value[TestValues::inertia_13] = 0.1;
  EXPECT_EQ(nearest_function(EventType::tilt, context, at), TestValues::inertia_13);
  at.value[TestValues::inertia_13] = 0.3;
  EXPECT_EQ(nearest_function(EventType::tilt, context, at), TestValues::inertia_23);
}

}  // namespace
}  // namespace stationary
