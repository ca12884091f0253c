// What every kind of motion keeps, whatever the potential: what is solved is proven and is among all
// that there are, what is moved off is refused, the class is proven, and the family through it is
// made of such motions, its events too.
#include "solver/kind/kind.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <tuple>

#include "tests/support/bodies/anisotropic_motions.hpp"
#include "tests/support/bodies/models.hpp"
#include "tests/support/bodies/whole_body.hpp"
#include "tests/support/bodies/written_potential.hpp"
#include "tests/support/followed.hpp"

namespace stationary {
namespace {

using namespace testing;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Potential made_of(std::string_view plane, std::string_view thickness = "reciprocal-quadratic") {
  const double first[] = {1.0, 2.0};
  const double second[] = {thickness == "harmonic" ? 3.0 : 1.0,
                           thickness == "harmonic" ? 0.9 : 3.0};
  return {Potential::planar(plane, first), Potential::thickness(thickness, second)};
}
Potential coupled_model() {
  const double coefficients[] = {1.0, 2.0};
  return Potential(Potential::coupled("neo-hookean-3d", coefficients));
}
Potential formula() {
  return Potential(support::written_coupled(
      "mu/2*(I1 + rho^2 - 3 - 2*log(d*rho)) + la/2*log(d*rho)^2 + mu/20*log(d)^2", {"mu", "la"},
      {1.0, 2.0}));
}

Potential held_fibre(double degrees = 30.0) {
  BodyTerms<double> volume;
  volume.volume = 1.0;
  return Potential(
      AnisotropicPotential(Biot<>{1.0, 0.6}, ReciprocalQuadratic<>{1.0, 3.0}, {{0.4, degrees}})
          .with_body(volume));
}

struct Posed {
  std::string text;
  Body body;
  Potential potential;
  Motion motion;
  bool has_events = false;  ///< on the part followed
};
void PrintTo(const Posed& posed, std::ostream* out) { *out << posed.text; }

std::vector<Posed> all_kinds() {
  const Body plate(1.0, 1.7, 0.6);
  const Body round(1.0, 1.0, 0.6);
  std::vector<Posed> out;
  const auto add = [&](const std::string& text, const Body& body, const Potential& V,
                       const Motion& motion, bool has_events = false) {
    out.push_back({std::string(name(motion)) + ", " + text, body, V, motion, has_events});
  };
  const std::pair<const char*, Potential> isotropic[] = {
      {"reciprocal-determinant", made_of("reciprocal-determinant")},
      {"saint-venant-kirchhoff", made_of("saint-venant-kirchhoff", "harmonic")},
      {"biot", made_of("biot")},
      {"biot-log", made_of("biot-log", "harmonic")},
      {"neo-hookean", made_of("neo-hookean")},
      {"hencky", made_of("hencky")},
      {"neo-hookean-3d", coupled_model()},
      {"formula", formula()}};
  for (const auto& [text, V] : isotropic) {
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii})
      add(text, plate, V, AxisRotation{branch, 0.3});
    add(text, round, V, AxisRotation{Branch::iii, 0.3});
  }
  add("reciprocal-determinant", plate, made_of("reciprocal-determinant"),
      TiltedMotion{TiltPlane::one_three, 1.07}, true);
  add("neo-hookean", plate, made_of("neo-hookean"), TiltedMotion{TiltPlane::two_three, 0.995},
      true);
  for (const char* plane : {"biot-log", "hencky"}) {
    add(plane, round, made_of(plane), TwoPolarRates<double>{1.2, -0.35});
    add(plane, round, made_of(plane), TwoPolarMomenta<double>{2.2, 0.3});
  }
  const Potential fibre = fibred(NeoHookean<>{1.0, 2.0}, 0.4, 25.0);
  add("fibre", plate, fibre, AxisRotation{Branch::iii, 0.25});
  add("fibre", plate, fibre, ObliqueRotation{0.25, Branch::i});
  add("fibre", plate, fibre, ObliqueRotation{0.25, Branch::ii});

  const AnyThickness<> thickness{ReciprocalQuadratic<>{1.0, 3.0}};
  const AnyPlane<> hencky{Hencky<>{1.1, 0.8}};
  const std::tuple<const char*, std::optional<double>, std::optional<double>> whole[] = {
      {"held", 1.0, {}}, {"held, gravitating", 1.0, 0.4}, {"gravitating", {}, 0.4}};
  for (const auto& [text, volume, g] : whole) {
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii})
      add(text, plate, whole_body(hencky, thickness, volume, g, plate), AxisRotation{branch, 0.3});
    const Potential V = whole_body(hencky, thickness, volume, g, round);
    add(text, round, V, AxisRotation{Branch::iii, 0.3});
    add(text, round, V, TwoPolarRates<double>{1.2, -0.35});
  }
  add("held", Body(1.0, 0.8, 1.1), held(hencky, AnyThickness<>{Harmonic<>{2.0, 1.0}}),
      TiltedMotion{TiltPlane::two_three, 0.8});
  add("held", Body(1.0, 1.7, 0.9), held(AnyPlane<>{Biot<>{1.0, 8.0}}, thickness),
      SpatialRotation{2.6});
  const AnyPlane<> soft{Biot<>{0.4081, 3.2648}};
  const AnyThickness<> thick{Harmonic<>{1.0, 1.5096}};
  add("gravitating", plate, whole_body(soft, thick, {}, 2.0, plate), ObliqueRotation{0.450879});
  add("gravitating", plate,
      whole_body(AnyPlane<>{Biot<>{0.3755, 3.004}}, AnyThickness<>{Harmonic<>{1.0, 1.5321}}, {},
                 2.0, plate),
      SpatialRotation{0.5026});
  add("held, gravitating", plate,
      whole_body(AnyPlane<>{Biot<>{0.5, 4.0}}, AnyThickness<>{Harmonic<>{1.0, 1.91}}, 0.72, 2.0,
                 plate),
      ObliqueRotation{0.48});
  add("held fibre", plate, held_fibre(), AxisRotation{Branch::iii, 0.25});
  for (const Branch branch : {Branch::i, Branch::ii, Branch::iii})
    add("held fibre along axis 1", plate, held_fibre(0.0), AxisRotation{branch, 0.25});
  for (const Branch branch : {Branch::i, Branch::ii})
    add("held fibre", plate, held_fibre(), ObliqueRotation{0.4, branch});
  return out;
}

double apart(const Stretch& a, const Stretch& b) {
  return std::max({std::abs(a.xi / b.xi - 1.0), std::abs(a.zeta / b.zeta - 1.0),
                   std::abs(a.rho / b.rho - 1.0),
                   std::abs(a.alpha - b.alpha) / std::sqrt(b.xi * b.zeta)});
}

/// The modes are where the enclosure has them, and its class and count are theirs.
void expect_enclosed(const SpectrumEnclosure& enclosed, const Spectrum& spectrum) {
  EXPECT_EQ(enclosed.verdict, spectrum.verdict);
  EXPECT_EQ(enclosed.negative, spectrum.negative);
  ASSERT_EQ(enclosed.modes, spectrum.modes);
  for (std::size_t k = 0; k < static_cast<std::size_t>(spectrum.modes); ++k) {
    const Mode& mode = spectrum.mode[k];
    const Interval error(-mode.lambda_error, mode.lambda_error);
    EXPECT_FALSE((enclosed.lambda[k].re + error).apart_from(Interval(mode.lambda_re))) << k;
    EXPECT_FALSE((enclosed.lambda[k].im + error).apart_from(Interval(mode.lambda_im))) << k;
    EXPECT_LE(enclosed.lambda[k].re.width(), 1e-5 * (1.0 + std::abs(mode.lambda_re))) << k;
  }
}

class EveryKind : public ::testing::TestWithParam<Posed> {
 protected:
  void SetUp() override {
    const Posed& posed = GetParam();
    kinds_ = alternatives(posed.body, posed.potential, posed.motion, false);
    const auto [found, kind] = first_found(kinds_, {});
    ASSERT_EQ(found.status, SolveStatus::solved) << found.message;
    found_ = found;
    kind_ = kind;
  }
  Alternatives kinds_;
  Equilibrium found_;
  const Kind* kind_ = nullptr;
};

TEST_P(EveryKind, SolvesWhatItProves) {
  EXPECT_EQ(name(kind_->motion()), name(GetParam().motion));
  EXPECT_LE(found_.residual, acceptable_residual);
  EXPECT_LE(found_.compatibility, acceptable_residual);
  const Certificate proof = kind_->certify(found_);
  ASSERT_TRUE(proof.proven) << proof.reason;
  // Gravity and elastic force all but cancel where alpha != 0 of an isotropic body.
  const bool sheared = GetParam().potential.may_shear() && found_.q.alpha != 0.0;
  EXPECT_LE(proof.error_bound, sheared ? 1e-11 : 1e-13);
  for (const double factor : {1.0 - 1e-9, 1.0 + 1e-9}) {
    Equilibrium fake = found_;
    fake.q.zeta *= factor;
    if (found_.circle) fake.q.xi = fake.q.zeta;
    EXPECT_FALSE(kind_->certify(fake).proven) << factor;
  }
}

/// The number of a motion with this index among its own.
double& number_in(Motion& motion, int number) {
  return std::visit(
      [&](auto& each) -> double& {
        if constexpr (requires { each.nu; }) {
          return each.nu;
        } else if (auto* rates = std::get_if<TwoPolarRates<double>>(&each)) {
          return number == 0 ? rates->omega : rates->theta_dot;
        } else {
          auto& momenta = std::get<TwoPolarMomenta<double>>(each);
          return number == 0 ? momenta.s3 : momenta.p_theta;
        }
      },
      motion);
}
/// The motion at another value of it.
Motion at_number(Motion motion, int number, double value) {
  number_in(motion, number) = value;
  return motion;
}

TEST_P(EveryKind, SaysHowManyModesItHas) {
  const auto spectrum = kind_->spectrum(found_);
  ASSERT_TRUE(spectrum);
  // Of a two-polar motion before it is known whether it is on the circle.
  const std::string modes = std::to_string(spectrum->modes) + " modes";
  const std::string how = kind_->spectrum_plan().how;
  if (found_.circle && std::holds_alternative<TwoPolarMotion>(GetParam().motion)) {
    EXPECT_THAT(how, HasSubstr("; on the circle lambda = mu the " + modes));
  } else {
    EXPECT_THAT(how, StartsWith(modes));
  }
  const auto* const spin = std::get_if<AxisRotation>(&GetParam().motion);
  if (spin == nullptr) return;
  const auto at_rest =
      kind_of(GetParam().body, GetParam().potential, AxisRotation{spin->branch, 0.0});
  const Equilibrium rest = at_rest->solve({});
  ASSERT_EQ(rest.status, SolveStatus::solved) << rest.message;
  const auto few = at_rest->spectrum(rest);
  ASSERT_TRUE(few);
  EXPECT_THAT(at_rest->spectrum_plan().how, StartsWith(std::to_string(few->modes) + " modes"));
}

TEST_P(EveryKind, ProvesItsClass) {
  const auto spectrum = kind_->spectrum(found_);
  ASSERT_TRUE(spectrum);
  const Certificate proof = kind_->certify(found_);
  ASSERT_TRUE(proof.proven) << proof.reason;
  expect_enclosed(kind_->enclose(found_, proof, *spectrum), *spectrum);
  EXPECT_THROW((void)kind_->enclose(found_, Certificate(), *spectrum), std::invalid_argument);
}

TEST_P(EveryKind, FindsItAmongAllOfThem) {
  SearchOptions box;
  box.min_stretch = 0.05;
  box.max_stretch = 20.0;
  const SearchResult all = kind_->search(box);
  ASSERT_NE(all.status, SearchStatus::interrupted);
  const auto is_it = [&](const Equilibrium& each) {
    return apart(each.q, found_.q) <= 2.0 * (each.error_bound + found_.error_bound) &&
           std::min((each.nu - found_.nu).norm(), (each.nu + found_.nu).norm()) <=
               1e-12 * found_.nu.norm();  // it may turn either way
  };
  EXPECT_GE(std::ranges::count_if(all.solutions, is_it), 1) << all.message;
}

TEST_P(EveryKind, FollowsWhatItProves) {
  const Posed& posed = GetParam();
  const AnyFamily family = kind_->family({}, {}, found_.q);
  Motion motion = posed.motion;
  const double p = number_in(motion, 0);
  const Followed sheet =
      followed(family, found_.q, p, range(0.8 * p, posed.has_events ? 1.3 * p : 1.1 * p));
  ASSERT_TRUE(sheet.report.failure.empty()) << sheet.report.failure;
  ASSERT_GE(sheet.rows.size(), 4U);
  int events = 0;
  for (const FollowedRow& row : sheet.rows) {
    const Equilibrium at = equilibrium_of(row.member);
    const Motion there = at_number(kind_->motion(), 0, row.member.parameter);
    const auto kind = kind_of(posed.body, posed.potential, there);
    if (const auto event = kind->enclose_event({}, row.event, row.member)) {
      ++events;
      EXPECT_TRUE(event->proven) << name(row.event) << " at " << row.member.parameter << ": "
                                 << event->reason;
      EXPECT_LE(event->error_bound, 1e-11) << name(row.event);
      const double most = posed.potential.may_shear() ? 1e-11 : 1e-13;  // as above
      EXPECT_LE((event->parameter - Interval(row.member.parameter)).magnitude(),
                most * std::abs(row.member.parameter));
    } else if (row.event == EventType::none || row.event == EventType::limit) {
      const Certificate proof = kind->certify(at);
      EXPECT_TRUE(proof.proven) << row.member.parameter << ": " << proof.reason;
    }
  }
  if (posed.has_events) {
    EXPECT_GE(events, 1) << sheet.text();
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryKind, ::testing::ValuesIn(all_kinds()), [](const auto& info) {
  std::string out = info.param.text + std::to_string(info.index);
  std::erase_if(out, [](char c) { return std::isalnum(c) == 0; });
  return out;
});

/// A body at rest has no axis, whatever the branch: V alone tells whether its plane may turn.
TEST(Kinds, AtRestAreProvenToo) {
  const Body plate(1.0, 1.7, 0.6);
  const AnyPlane<> plane{Hencky<>{1.1, 0.8}};
  const AnyThickness<> thickness{ReciprocalQuadratic<>{1.0, 3.0}};
  for (const Potential& V :
       {made_of("neo-hookean"), coupled_model(), held(plane, thickness),
        whole_body(plane, thickness, 1.0, 0.4, plate), whole_body(plane, thickness, {}, 0.4, plate),
        fibred(NeoHookean<>{1.0, 2.0}, 0.4, 25.0)}) {
    const auto kind = kind_of(plate, V, AxisRotation{Branch::iii, 0.0});
    const Equilibrium at = kind->solve({});
    ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
    const Certificate proof = kind->certify(at);
    ASSERT_TRUE(proof.proven) << proof.reason;
    expect_enclosed(kind->enclose(at, proof, *kind->spectrum(at)), *kind->spectrum(at));
  }
}

/// Of a held volume rho follows from the others, and is a stretch that is asked for all the same.
TEST(Kinds, SearchOnlyWhereEveryStretchIsInTheBox) {
  const auto kind = kind_of(Body(1.0, 1.7, 0.6), held_fibre(), ObliqueRotation{0.4, Branch::i});
  SearchOptions box;
  box.min_stretch = 0.7;
  box.max_stretch = 1.3;
  EXPECT_EQ(kind->search(box).solutions.size(), 2U);
  // A box that just leaves one of them out is decided by it all the same.
  const std::vector<Equilibrium> both = kind->search(box).solutions;
  ASSERT_EQ(both.size(), 2U);
  const double least = std::min(both[0].q.rho, both[1].q.rho);
  SearchOptions thick = box;
  thick.box = {Interval(0.7, 1.3), Interval(0.7, 1.3), Interval(least * (1.0 + 1e-9), 1.3)};
  const SearchResult thicker = kind->search(thick);
  EXPECT_EQ(thicker.status, SearchStatus::complete) << thicker.message;
  ASSERT_EQ(thicker.solutions.size(), 1U);
  EXPECT_GT(thicker.solutions[0].q.rho, least);
  box.min_stretch = 0.9;  // rho = 0.77, 0.78; the others are above 1
  const SearchResult none = kind->search(box);
  EXPECT_EQ(none.status, SearchStatus::complete);
  EXPECT_TRUE(none.solutions.empty());
}

/// With J1 = J2 such an axis is in a plane, by the choice of material axes; with W_t > 0 everywhere alpha = 0. Where
/// motions are only not sought nothing is said of whether they exist.
TEST(Kinds, ThatAreNotSoughtAreNotSaidNotToExist) {
  const auto kind = [](const Body& body, const Potential& V) {
    return kind_of(body, V, SpatialRotation{0.8});
  };
  const auto round =
      kind(Body(1.0, 1.0, 0.6),
           held(AnyPlane<>{Hencky<>{1.1, 0.8}}, AnyThickness<>{ReciprocalQuadratic<>{1.0, 3.0}}));
  EXPECT_EQ(round->solve({}).status, SolveStatus::none_exists);
  EXPECT_EQ(round->search({}).status, SearchStatus::complete);
  EXPECT_THAT(round->nonexistence().value_or(""), HasSubstr("plane \"13\""));
  const auto rising = kind(Body(1.0, 1.7, 0.6), made_of("hencky"));
  EXPECT_EQ(rising->solve({}).status, SolveStatus::none_exists);
  EXPECT_THAT(rising->nonexistence().value_or(""), HasSubstr("W_t = 0"));
  const auto fibre = kind(Body(1.0, 1.7, 0.6), fibred(NeoHookean<>{1.0, 2.0}, 0.4, 25.0));
  EXPECT_EQ(fibre->solve({}).status, SolveStatus::not_found);
  EXPECT_EQ(fibre->search({}).status, SearchStatus::undecided);
  EXPECT_FALSE(fibre->nonexistence());
}

/// Sheets followed once, and searches of blocks, lead to what each value has by itself, modes to the bit.
TEST(ManyValues, HaveWhatEachHasByItself) {
  int compared = 0;
  for (const Posed& posed : all_kinds()) {
    const Alternatives kinds = alternatives(posed.body, posed.potential, posed.motion, false);
    if (!together(kinds)) continue;
    const bool two_polar = std::holds_alternative<TwoPolarMotion>(posed.motion);
    for (int number = 0; number < (two_polar ? 2 : 1); ++number) {
      ++compared;
      Motion motion = posed.motion;
      const double own = number_in(motion, number);
      std::vector<double> all;
      std::vector<AtValue> values;
      for (const double factor : {0.2, 0.7, 0.97, 0.999, 1.0, 1.0 + 1e-15, 1.02, 1.4})
        all.push_back(factor * own);
      std::ranges::sort(all);
      for (const double value : all) values.push_back({.value = value});
      const NumberRange range{.values = all, .number = number};
      std::vector<std::size_t> places(values.size());
      first_found_each(kinds, true, {}, range, values, places);
      // Whatever others are asked for.
      std::vector<AtValue> alone_of_range{{.value = values[4].value}};
      std::vector<std::size_t> place(1);
      first_found_each(kinds, true, {}, range, alone_of_range, place);
      EXPECT_EQ(alone_of_range[0].equilibrium.error_bound, values[4].equilibrium.error_bound);
      int solved = 0;
      for (std::size_t k = 0; k < values.size(); ++k) {
        const AtValue& at = values[k];
        const Alternatives there = alternatives(posed.body, posed.potential,
                                                at_number(posed.motion, number, at.value), false);
        const auto [alone, kind] = first_found(there, {});
        const std::string where = posed.text + " at " + std::to_string(at.value);
        ASSERT_EQ(at.solved(), alone.status == SolveStatus::solved) << where << alone.message;
        if (!at.solved()) continue;
        ++solved;
        EXPECT_EQ(there.each[places[k]].kind.get(), kind) << where;
        EXPECT_LE(apart(at.equilibrium.q, alone.q), two_polar ? 0.0 : 0x1p-52) << where;
        EXPECT_LE((at.equilibrium.nu - alone.nu).norm(), 0x1p-51 * alone.nu.norm()) << where;
        EXPECT_EQ(at.equilibrium.circle, alone.circle) << where;
        EXPECT_NEAR(at.equilibrium.error_bound, alone.error_bound, 0.5 * alone.error_bound);
        EXPECT_LE(at.equilibrium.residual, acceptable_residual) << where;
        const auto spectrum = kind->spectrum(at.equilibrium);
        ASSERT_TRUE(at.spectrum && spectrum) << where;
        EXPECT_EQ(at.spectrum->verdict, spectrum->verdict) << where;
        ASSERT_EQ(at.spectrum->modes, spectrum->modes) << where;
        for (std::size_t i = 0; i < static_cast<std::size_t>(spectrum->modes); ++i) {
          EXPECT_EQ(at.spectrum->mode[i].lambda_re, spectrum->mode[i].lambda_re) << where;
          EXPECT_EQ(at.spectrum->mode[i].lambda_im, spectrum->mode[i].lambda_im) << where;
        }
      }
      EXPECT_GE(solved, 3) << posed.text;
    }
  }
  EXPECT_EQ(compared, 21);
}

TEST(ManyValues, OfFamiliesThatLeaveAnAxisOrBeginAboutIt) {
  const Body plate(1.0, 1.7, 0.6);
  // Of an even V the axis leaves 1 at an event, nu = 0.7405, to 0.7670; else it is about one at rest.
  struct Lane {
    double degrees, first, step;
  };
  for (const auto& [degrees, first, step] : {Lane{0.0, 0.73, 0.002}, Lane{25.0, 0.05, 0.05}}) {
    const Potential V = fibred(NeoHookean<>{1.0, 2.0}, 0.4, degrees);
    std::vector<AtValue> values;
    const double all[] = {0.0, 1.0};
    for (int k = 0; k < 20; ++k) values.push_back({.value = first + step * k});
    std::vector<AtValue> searched = values;
    std::vector<std::size_t> places(values.size());
    const Alternatives both = alternatives(plate, V, ObliqueRotation{0.25}, false);
    ASSERT_TRUE(together(both));
    first_found_each(both, false, {}, {.values = all}, values, places);
    const auto kind = kind_of(plate, V, ObliqueRotation{0.25, Branch::i});
    kind->solve_each(false, {}, {.values = all}, searched);
    int followed = 0;
    int alone_found = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      for (const std::size_t place : {std::size_t{0}, std::size_t{1}}) {
        const auto own = kind_of(
            plate, V, ObliqueRotation{values[k].value, place == 0 ? Branch::i : Branch::ii});
        const Equilibrium alone = own->solve({.search = false});
        if (alone.status != SolveStatus::solved) continue;
        ASSERT_TRUE(values[k].solved()) << degrees << " " << values[k].value;
        EXPECT_EQ(places[k], place);
        EXPECT_LE(apart(values[k].equilibrium.q, alone.q), 0x1p-52);
        ++followed;
        break;
      }
      // One family alone, and where it has none a search.
      const Equilibrium alone =
          kind_of(plate, V, ObliqueRotation{values[k].value, Branch::i})->solve({});
      EXPECT_EQ(searched[k].equilibrium.status, alone.status) << degrees << " " << values[k].value;
      if (alone.status != SolveStatus::solved) continue;
      ++alone_found;
      EXPECT_LE(apart(searched[k].equilibrium.q, alone.q), 0x1p-52);
    }
    EXPECT_GE(followed, 10) << degrees;
    EXPECT_GE(alone_found, 10) << degrees;
  }
}

TEST(ManyValues, AreRefusedAndStoppedAsOneIs) {
  const double all[] = {0.0, 1.0};
  const auto tilted =
      kind_of(Body(1.0, 1.7, 0.6), made_of("neo-hookean"), TiltedMotion{TiltPlane::one_three, 1.0});
  for (const double nu : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    std::vector<AtValue> values{{.value = 1.0}, {.value = nu}};
    EXPECT_THROW(tilted->solve_each(true, {}, {.values = all}, values), std::invalid_argument)
        << nu;
  }
  const std::atomic<bool> stop = true;
  std::vector<AtValue> values{{.value = 0.9}, {.value = 1.0}};
  tilted->solve_each(true, {.stop = &stop}, {.values = all}, values);
  for (const AtValue& each : values) EXPECT_FALSE(each.solved());
  // One that has its motion keeps it.
  values[0].equilibrium.status = SolveStatus::solved;
  values[0].equilibrium.q = {0.0, 2.0, 3.0, 4.0};
  tilted->solve_each(false, {}, {.values = all}, values);
  EXPECT_EQ(values[0].equilibrium.q.xi, 2.0);
}

TEST(Alternatives, NameThePlanesAndTheAxes) {
  const Body plate(1.0, 1.7, 0.6);
  const Alternatives planes =
      alternatives(plate, made_of("neo-hookean"), TiltedMotion{{}, 1.0}, false);
  ASSERT_EQ(planes.each.size(), 2U);
  EXPECT_EQ(planes.each[0].label, "1-3 plane");
  EXPECT_EQ(planes.each[1].label, "2-3 plane");
  EXPECT_EQ(planes.any, nullptr);
  const Potential fibre = fibred(NeoHookean<>{1.0, 2.0}, 0.4, 25.0);
  const Alternatives axes = alternatives(plate, fibre, ObliqueRotation{0.3}, false);
  ASSERT_EQ(axes.each.size(), 2U);
  EXPECT_NE(axes.any, nullptr);
  EXPECT_EQ(alternatives(plate, fibre, ObliqueRotation{0.3}, true).each.size(), 1U);
  // A search finds the motions of all families, so that it is left to the one that is of both.
  EXPECT_TRUE(for_each_of(planes, {}).search);
  EXPECT_FALSE(for_each_of(axes, {}).search);
  // What is said of all where none has a motion.
  const auto [found, kind] =
      first_found(alternatives(plate, made_of("neo-hookean"), TiltedMotion{{}, 1e-3}, false), {});
  EXPECT_EQ(found.status, SolveStatus::not_found);
  EXPECT_THAT(found.message, HasSubstr("1-3 plane: "));
  EXPECT_THAT(found.message, HasSubstr("; 2-3 plane: "));
}

TEST(Alternatives, AtRestNoOtherAxisIsOneOfASpin) {
  const Body plate(1.0, 1.7, 0.6);
  for (const Motion& motion :
       {Motion(TiltedMotion{TiltPlane::one_three, 0.0}), Motion(ObliqueRotation{0.0, Branch::i})}) {
    const Equilibrium none = kind_of(plate, made_of("neo-hookean"), motion)->solve({});
    EXPECT_EQ(none.status, SolveStatus::none_exists);
    EXPECT_THAT(none.message, HasSubstr("|nu| > 0"));
  }
}

}  // namespace
}  // namespace stationary
