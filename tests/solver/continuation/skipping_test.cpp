// What a followed family does not need is not computed: counted by a model that counts.
#include <gtest/gtest.h>

#include <array>

#include "solver/family/model_family.hpp"
#include "tests/support/followed.hpp"

namespace stationary {

/// Evaluations by order; those in double-double apart.
struct Tally {
  std::array<long, 3> evaluations{};
  std::array<long, 3> extended{};

  template <int order, class S>
  void add() {
    auto& counts = std::is_same_v<S, DoubleDouble> ? extended : evaluations;
    ++counts[order];
  }
  long all(std::size_t order) const { return evaluations[order] + extended[order]; }
};
Tally planar_tally;
Tally thickness_tally;

/// A model that counts, by the one it passes on to.
template <class C>
struct CountedPlane {
  NeoHookean<C> model;

  std::array<C, 2> coefficients() const { return model.coefficients(); }
  template <int order, class S>
  auto evaluate(const PlanarInvariants<S>& x) const {
    planar_tally.add<order, S>();
    return model.template evaluate<order>(x);
  }
};
template <class C>
struct CountedThickness {
  ReciprocalQuadratic<C> model;

  std::array<C, 2> coefficients() const { return model.coefficients(); }
  double balanced(const DoubleDouble& m) const { return model.balanced(m); }
  template <int order, class S>
  auto evaluate(const S& rho) const {
    thickness_tally.add<order, S>();
    return model.template evaluate<order>(rho);
  }
};

namespace testing {
namespace {

using Model = Separable<CountedPlane<double>, CountedThickness<double>>;
const Body body(1.0, 1.7, 0.6);

struct Counted {
  Followed sheet;
  EvaluationCounts family;
  Tally plane;
  Tally thickness;
};

/// The rest sheet of (iii) or (i) to nu.
template <int N>
Counted follow_counted(Branch branch, const AxisFamilyOptions& what, double to,
                       EventSet events = {}) {
  const Model model{{{1.0, 2.0}}, {{1.0, 3.0}}};
  planar_tally = thickness_tally = {};
  auto family = std::make_unique<ModelFamily<Model, N>>(body, branch, model, what);
  const auto* const counts = family.get();
  FollowOptions options = range(0.0, to);
  options.events = events;
  const AnyFamily any = std::move(family);
  const double rho = std::cbrt(1.0 / 3.0);
  Counted out{followed(any, {0.0, 1.0, 1.0, rho}, 0.0, options), {}, {}, {}};
  out.family = counts->evaluations();
  out.plane = planar_tally;
  out.thickness = thickness_tally;
  EXPECT_EQ(out.sheet.report.failure, "");
  return out;
}

constexpr AxisFamilyOptions bare{
    .nu = 0.0, .parameter = {}, .spectrum = false, .errors = false, .energy = false};

TEST(Skipping, WithoutOutputsOnlyNewtonsOwnDerivatives) {
  const Counted run = follow_counted<2>(Branch::iii, bare, 0.7);
  EXPECT_EQ(run.plane.all(2), run.family.jacobians);
  EXPECT_EQ(run.plane.all(0), 0);
  EXPECT_EQ(run.plane.extended[1], run.family.extended_residuals);
  EXPECT_EQ(run.plane.evaluations[1], run.family.sensitivities);
  EXPECT_EQ(run.family.potentials, 0);
  EXPECT_EQ(run.family.second_derivatives, 0);
  EXPECT_EQ(run.family.spectra, 0);
  for (const auto& [member, event] : run.sheet.rows) {
    EXPECT_TRUE(std::isnan(member.residual) && std::isnan(member.energy));
    EXPECT_FALSE(member.spectrum);
  }
}

TEST(Skipping, EachOutputCostsItsOwnEvaluations) {
  const auto run_with = [](AxisFamilyOptions what) {
    return follow_counted<2>(Branch::iii, what, 0.7);
  };
  const Counted none = run_with(bare);
  AxisFamilyOptions energy = bare;
  energy.energy = true;
  const Counted with_energy = run_with(energy);
  EXPECT_EQ(with_energy.plane.all(0), with_energy.family.potentials);
  EXPECT_EQ(with_energy.plane.all(2), none.plane.all(2));
  AxisFamilyOptions errors = bare;
  errors.errors = true;
  const Counted with_errors = run_with(errors);
  EXPECT_EQ(with_errors.plane.all(2), none.plane.all(2) + with_errors.family.second_derivatives);
  EXPECT_EQ(with_errors.family.second_derivatives, with_errors.sheet.report.counts.members);
  AxisFamilyOptions spectrum = bare;
  spectrum.spectrum = true;
  const Counted with_spectrum = run_with(spectrum);
  EXPECT_EQ(with_spectrum.family.spectra, with_spectrum.sheet.report.counts.members);
  EXPECT_GT(with_spectrum.plane.all(2), none.plane.all(2) + with_spectrum.family.spectra);
}

/// (iii), separable: V_rho'(rho) = 0 once, however long the sheet.
TEST(Skipping, ThicknessIsSolvedOnceInBranchThree) {
  const Counted near = follow_counted<2>(Branch::iii, bare, 0.1);
  const Counted far = follow_counted<2>(Branch::iii, bare, 0.75);
  ASSERT_GT(far.sheet.rows.size(), 2 * near.sheet.rows.size());
  for (const std::size_t order : {0U, 1U, 2U})
    EXPECT_EQ(near.thickness.all(order), far.thickness.all(order)) << order;
  const Counted in_plane = follow_counted<3>(Branch::i, bare, 0.7);
  EXPECT_GT(in_plane.thickness.extended[1], in_plane.sheet.report.counts.steps);
}

/// Events not asked for: no function, no point of their search; the others stay where they were.
TEST(Skipping, EventsNotAskedForCostNothing) {
  const Counted all = follow_counted<3>(Branch::i, {}, 0.9);
  EventSet tilt = EventSet::none();
  tilt.add(EventType::tilt);
  const Counted one = follow_counted<3>(Branch::i, bare, 0.9, tilt);
  const Counted none = follow_counted<3>(Branch::i, bare, 0.9, EventSet::none());
  ASSERT_EQ(all.sheet.events({EventType::tilt}).size(), 1U) << all.sheet.text();
  ASSERT_EQ(one.sheet.events().size(), 1U);
  EXPECT_NEAR(one.sheet.events()[0].member.nu, all.sheet.events({EventType::tilt})[0].member.nu,
              1e-14);
  EXPECT_TRUE(none.sheet.events().empty());
  EXPECT_LT(one.sheet.report.counts.members, all.sheet.report.counts.members);
  const ModelFamily<Model, 3> family(body, Branch::i, Model{{{1.0, 2.0}}, {{1.0, 3.0}}}, bare);
  const Curve<3> curve(family, 1.0, Circle::none, std::nullopt, EventSet::none());
  for (const std::size_t k : {TestValues::momentum, TestValues::inertia_12, TestValues::ellipse,
                              TestValues::collision, TestValues::crossings})
    EXPECT_FALSE(curve.context().seeks(k)) << k;
}

}  // namespace
}  // namespace testing
}  // namespace stationary
