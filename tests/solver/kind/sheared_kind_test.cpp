// Motions with alpha != 0 of isotropic bodies (sheared_balance.hpp): about axis 3, which their branch finds beside the
// others, and the laws that all of them obey.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "solver/atlas/atlas.hpp"
#include "solver/kind/kind.hpp"
#include "tests/support/bodies/whole_body.hpp"
#include "tests/support/followed.hpp"

namespace stationary {
namespace {

using namespace testing;

/// W_t = 0 at xi + zeta = 1.8.
Potential heavy(const Body& body, double mu, double rest, std::optional<double> volume) {
  return whole_body(AnyPlane<>{Biot<>{mu, 8.0 * mu}}, AnyThickness<>{Harmonic<>{1.0, rest}}, volume,
                    2.0, body);
}

struct ShearedCase {
  const char* text;
  double mu;
  double rest;
  std::optional<double> volume;
  Motion motion;
  Stretch start;
};

std::vector<ShearedCase> sheared_cases() {
  const Stretch start{0.26, 1.05, 0.75, 1.0};
  return {
      {"Held", 0.5, 1.91, 0.72, AxisRotation{Branch::iii, 0.5365}, start},
      {"HeldOblique", 0.5, 1.91, 0.72, ObliqueRotation{0.48}, {0.565, 0.915, 0.885, 1.467}},
      {"AxisThree", 0.3755, 1.5321, {}, AxisRotation{Branch::iii, 0.5605}, {0.4, 0.97, 0.83, 0.73}},
      {"Oblique", 0.4081, 1.5096, {}, ObliqueRotation{0.450879}, start},
      {"InNoPlane", 0.3755, 1.5321, {}, SpatialRotation{0.5026}, {0.26, 1.05, 0.75, 0.92}}};
}

double nu_of(const Motion& motion) {
  if (const auto* axis = std::get_if<AxisRotation>(&motion)) return axis->nu;
  if (const auto* oblique = std::get_if<ObliqueRotation>(&motion)) return oblique->nu;
  return std::get<SpatialRotation>(motion).nu;
}

class ShearedMotions : public ::testing::TestWithParam<ShearedCase> {
 protected:
  static Body plate() { return {1.0, 1.7, 0.6}; }
  std::unique_ptr<Kind> kind(const Body& body) const {
    const ShearedCase& of = GetParam();
    return kind_of(body, heavy(body, of.mu, of.rest, of.volume), of.motion);
  }
  static SolveOptions from(const Stretch& start) { return {.start = start}; }
};

TEST_P(ShearedMotions, AreSolvedAndProven) {
  const auto kind = this->kind(plate());
  const Equilibrium at = kind->solve(from(GetParam().start));
  ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
  EXPECT_NEAR(at.q.xi + at.q.zeta, 1.8, 1e-15);
  EXPECT_GT(at.q.alpha, 0.2);
  EXPECT_LE(at.residual, 1e-15);
  EXPECT_LE(at.compatibility, 1e-15);
  const Certificate proof = kind->certify(at);
  ASSERT_TRUE(proof.proven) << proof.reason;
  EXPECT_LE(proof.error_bound, 1e-11);
  for (const int k : {0, 2}) {
    Equilibrium fake = at;
    fake.nu[k] += 1e-6;
    EXPECT_FALSE(kind->certify(fake).proven) << k;
  }
  const auto spectrum = kind->spectrum(at);
  ASSERT_TRUE(spectrum);
  EXPECT_EQ(spectrum->modes, GetParam().volume ? 4 : 5);
  const SpectrumEnclosure enclosed = kind->enclose(at, proof, *spectrum);
  EXPECT_EQ(enclosed.verdict, spectrum->verdict);
  EXPECT_EQ(enclosed.negative, spectrum->negative);
}

/// J1 and J2 exchanged, with xi and zeta and nu1 and nu2.
TEST_P(ShearedMotions, MayExchangeTheirTwoAxes) {
  const Equilibrium at = kind(plate())->solve(from(GetParam().start));
  ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
  const auto exchanged = kind(Body(1.7, 1.0, 0.6));
  Stretch start = GetParam().start;
  std::swap(start.xi, start.zeta);
  const Equilibrium image = exchanged->solve(from(start));
  ASSERT_EQ(image.status, SolveStatus::solved) << image.message;
  EXPECT_NEAR(image.q.xi, at.q.zeta, 1e-14);
  EXPECT_NEAR(image.q.zeta, at.q.xi, 1e-14);
  EXPECT_NEAR(image.q.alpha, at.q.alpha, 1e-14);
  EXPECT_NEAR(image.q.rho, at.q.rho, 1e-14);
  EXPECT_NEAR(std::abs(image.nu[0]), std::abs(at.nu[1]), 1e-13);
  EXPECT_NEAR(std::abs(image.nu[1]), std::abs(at.nu[0]), 1e-13);
  EXPECT_NEAR(std::abs(image.nu[2]), std::abs(at.nu[2]), 1e-13);
}

/// Each end is an event of the family with alpha = 0 that it leaves, enclosed by the equations of that one, and its tilt
/// one of the family in no plane.
TEST_P(ShearedMotions, BeginAndEndWhereOthersSaySo) {
  const auto kind = this->kind(plate());
  const Equilibrium at = kind->solve(from(GetParam().start));
  ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
  const AnyFamily family = kind->family({}, {}, at.q);
  const Followed sheet = followed(family, at.q, nu_of(GetParam().motion), range(0.3, 0.7));
  ASSERT_TRUE(sheet.report.failure.empty()) << sheet.report.failure;
  int ends = 0;
  for (const FollowedRow& row : sheet.rows) {
    if (row.event != EventType::shear && row.event != EventType::oblique) continue;
    ++ends;
    EXPECT_EQ(row.member.q.alpha, 0.0);
    const auto event = kind->enclose_event({}, row.event, row.member);
    ASSERT_TRUE(event);
    EXPECT_TRUE(event->proven) << event->reason;
    EXPECT_LE((event->parameter - Interval(row.member.nu)).magnitude(), 2e-12);
  }
  const bool spatial = std::holds_alternative<SpatialRotation>(GetParam().motion);
  EXPECT_EQ(ends, spatial ? 1 : 2) << sheet.text();
}

/// nu -> -nu about axis 3.
TEST(ShearedMotionsAboutAxisThree, TurnEitherWay) {
  const Body plate(1.0, 1.7, 0.6);
  const Potential V = heavy(plate, 0.5, 1.91, 0.72);
  const SolveOptions how{.start = Stretch{0.26, 1.05, 0.75, 1.0}};
  const auto one = kind_of(plate, V, AxisRotation{Branch::iii, 0.5365});
  const auto other = kind_of(plate, V, AxisRotation{Branch::iii, -0.5365});
  const Equilibrium a = one->solve(how);
  const Equilibrium b = other->solve(how);
  ASSERT_EQ(a.status, SolveStatus::solved);
  ASSERT_EQ(b.status, SolveStatus::solved);
  EXPECT_EQ(a.q.alpha, b.q.alpha);
  EXPECT_EQ(a.nu[2], -b.nu[2]);
  EXPECT_TRUE(other->certify(b).proven);
  EXPECT_EQ(one->spectrum(a)->negative, other->spectrum(b)->negative);
}

/// Beside those with alpha = 0.
TEST(ShearedMotionsAboutAxisThree, AreFoundByTheSearchOfTheirBranch) {
  const Body plate(1.0, 1.7, 0.6);
  SearchOptions box;
  box.min_stretch = 0.4;
  box.max_stretch = 2.0;
  const auto counted = [&](double nu) {
    const SearchResult all =
        kind_of(plate, heavy(plate, 0.5, 1.91, 0.72), AxisRotation{Branch::iii, nu})->search(box);
    EXPECT_EQ(all.status, SearchStatus::complete) << all.message;
    EXPECT_THAT(all.message, ::testing::HasSubstr("proven to be all"));
    EXPECT_TRUE(
        std::ranges::is_sorted(all.solutions, {}, [](const Equilibrium& at) { return at.q.xi; }));
    return std::ranges::count_if(all.solutions,
                                 [](const Equilibrium& at) { return at.q.alpha > 0.0; });
  };
  EXPECT_EQ(counted(0.5365), 1);
  EXPECT_EQ(counted(0.3), 0);
}

/// A potential that is known to rise with t, or has no gravity, has none.
TEST(ShearedMotionsAboutAxisThree, AreNotOfEveryBody) {
  const Body plate(1.0, 1.7, 0.6);
  const AnyThickness<> thickness{Harmonic<>{1.0, 1.9}};
  const auto may = [&](const AnyPlane<>& plane, std::optional<double> volume,
                       std::optional<double> g) {
    return whole_body(plane, thickness, volume, g, plate).may_shear();
  };
  EXPECT_TRUE(may(AnyPlane<>{Biot<>{1.0, 1.0}}, {}, 2.0));
  EXPECT_TRUE(may(AnyPlane<>{SaintVenantKirchhoff<>{1.0, 1.0}}, 1.0, 2.0));
  EXPECT_FALSE(may(AnyPlane<>{Biot<>{1.0, 1.0}}, 1.0, {}));
  EXPECT_FALSE(may(AnyPlane<>{NeoHookean<>{1.0, 1.0}}, {}, 2.0));
  EXPECT_FALSE(may(AnyPlane<>{Hencky<>{1.0, 1.0}}, {}, 2.0));
  EXPECT_FALSE(may(AnyPlane<>{ReciprocalDeterminant<>{1.0, 1.0}}, {}, 2.0));
  // Which they do: W_t > 0 at any t and d.
  for (const double t : {2.001, 3.0, 50.0}) {
    const PlanarInvariants<double> x{t, 1.0, t * t - 4.0};
    EXPECT_GT((NeoHookean<>{1.0, 1.0}.evaluate<1>(x).w_t), 0.0);
    EXPECT_GT((Hencky<>{1.0, 1.0}.evaluate<1>(x).w_t), 0.0);
    EXPECT_GT((ReciprocalDeterminant<>{1.0, 1.0}.evaluate<1>(x).w_t), 0.0);
    EXPECT_GT((NeoHookean3d<>{1.0, 1.0}.evaluate<1>(x, 1.3).plane.w_t), 0.0);
  }
}

/// Of a fluid J is a choice of coordinates: alpha = 0 is one, whatever J is.
TEST(ShearedMotionsAboutAxisThree, AreNotOfAFluid) {
  const Body plate(1.0, 1.7, 0.6);
  BodyModel<> model;
  model.volume = 1.0;
  model.gravitates = true;
  model.g = 4.0;
  model.J = {plate.J1, plate.J2, plate.J3};
  const Potential fluid(model);
  SearchOptions box;
  box.min_stretch = 0.3;
  box.max_stretch = 3.0;
  EXPECT_FALSE(fluid.may_shear());
  const SearchResult all = kind_of(plate, fluid, AxisRotation{Branch::iii, 0.3})->search(box);
  EXPECT_EQ(all.status, SearchStatus::complete) << all.message;
  EXPECT_GE(all.solutions.size(), 1U);
  for (const Equilibrium& each : all.solutions) EXPECT_EQ(each.q.alpha, 0.0);
  const auto oblique = kind_of(plate, fluid, ObliqueRotation{0.3});
  EXPECT_EQ(oblique->solve({}).status, SolveStatus::none_exists);
  AtlasOptions options;
  options.from = 0.1;
  options.to = 0.2;
  options.checkpoints = 1;
  options.search = box;
  const Atlas sheets = atlas(plate, fluid, options);
  EXPECT_FALSE(std::ranges::any_of(sheets.sheets, &AtlasSheet::oblique));
}

INSTANTIATE_TEST_SUITE_P(All, ShearedMotions, ::testing::ValuesIn(sheared_cases()),
                         [](const auto& info) { return std::string(info.param.text); });

}  // namespace
}  // namespace stationary
