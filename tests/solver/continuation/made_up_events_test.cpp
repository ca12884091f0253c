// The events of a step, on lines that are made up: two zeros in one step, signs that are open, what
// no event explains.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/bodies/made_up_families.hpp"
#include "tests/support/followed.hpp"

namespace stationary {
namespace {

using namespace testing;

/// Rows, and of the stretches between two events what is told of them.
class Told final : public CurveSink {
 public:
  void row(const Member& member, EventType event) override { kept.row(member, event); }
  void between(StabilityClass verdict) override { classes.push_back(verdict); }
  Kept kept;
  std::vector<StabilityClass> classes;
};

struct Found {
  Followed sheet;
  std::vector<StabilityClass> between;
};

Found follow_line(const Line& line, FollowOptions options = range(0.0, 1.0)) {
  const LineFamily family(line);
  const double from = options.continuation.from;
  const Stretch start{0.0, std::exp(from), std::exp(from), 1.0};
  Told told;
  Found out;
  out.sheet.report = follow_family<2>(family, start, from, options, told);
  out.sheet.rows = std::move(told.kept.rows);
  out.between = std::move(told.classes);
  return out;
}

/// Two imaginary pairs, definite, far from zero and from each other.
Spectrum elliptic(int negative) {
  Spectrum out;
  out.modes = 2;
  out.negative = negative;
  for (std::size_t k = 0; k < 2; ++k) {
    Mode& mode = out.mode[k];
    mode.lambda_re = k == 0 ? -9.0 : -4.0;
    mode.lambda_im = 0.0;
    mode.lambda_error = 1e-14;
    mode.im = std::sqrt(-mode.lambda_re);
    mode.krein = -1;
  }
  out.verdict = StabilityClass::elliptic;
  return out;
}

/// The axis turns in the plane at both zeros of (p - at)^2 - apart^2, which no step ends between: of
/// steps that grow, and of steps all alike.
TEST(MadeUpEvents, TwoZerosInOneStepAreFound) {
  for (const double at : {0.31, 0.472, 0.593, 0.688, 0.741}) {
    for (const double apart : {1e-3, 1e-5}) {
      for (const double longest : {0.5, 0.1, -0.1}) {
        const double sign = std::copysign(1.0, longest);
        Line line;
        line.turn = [&](double p) { return sign * ((p - at) * (p - at) - apart * apart); };
        FollowOptions options = range(0.0, 1.0);
        options.continuation.step.max = std::abs(longest);
        const Found found = follow_line(line, options);
        const auto events = found.sheet.events({EventType::shear});
        ASSERT_EQ(events.size(), 2U) << at << " " << apart << " " << found.sheet.text();
        EXPECT_NEAR(events[0].member.parameter, at - apart, 1e-9);
        EXPECT_NEAR(events[1].member.parameter, at + apart, 1e-9);
      }
    }
  }
}

/// Of the curve between them the class is told where there is a spectrum, and else nothing.
TEST(MadeUpEvents, BetweenTwoEventsTheClassIsToldWhereItIsKnown) {
  const double at = 0.472;
  const double apart = 1e-3;
  Line line;
  line.turn = [&](double p) { return (p - at) * (p - at) - apart * apart; };
  line.spectrum = [&](double p) {
    return std::optional(elliptic(std::abs(p - at) < apart ? 1 : 2));
  };
  EXPECT_EQ(follow_line(line).between, std::vector{StabilityClass::elliptic});
  line.spectrum = [&](double p) {
    return std::abs(p - at) < 0.5 * apart ? std::nullopt : std::optional(elliptic(2));
  };
  EXPECT_TRUE(follow_line(line).between.empty());
}

/// So it is of what lies between rest and an event of the first step, and between one of the last step and
/// the end.
TEST(MadeUpEvents, BesideRestAndTheEndTheClassIsTold) {
  Line line;
  line.turn = [](double p) { return (p - 1e-5) * (p - 0.99); };
  line.spectrum = [](double p) {
    Spectrum out = elliptic(p > 1e-5 && p < 0.99 ? 1 : 2);
    if (p > 0.99) out.verdict = StabilityClass::unstable;
    if (p < 1e-5) out.verdict = StabilityClass::oscillatory;
    return std::optional(out);
  };
  const Found found = follow_line(line);
  ASSERT_EQ(found.sheet.events({EventType::shear}).size(), 2U) << found.sheet.text();
  EXPECT_EQ(found.between, (std::vector{StabilityClass::oscillatory, StabilityClass::unstable}));
}

/// The order of two inertias is open around the event, whose own equations have its place: it is
/// one event, in whatever step.
TEST(MadeUpEvents, AnEventAmidOpenSignsIsFoundOnce) {
  for (const double longest : {0.007, 0.01, 0.02, 0.033, 0.05}) {
    constexpr double tilt = 0.5;
    Line line;
    line.tilt = tilt;
    line.error_bound = [](double) { return 1e-6; };
    FollowOptions options = range(tilt - 1e-5, tilt + 1e-5);
    options.continuation.step.first = options.continuation.step.max = longest;
    const Found found = follow_line(line, options);
    ASSERT_EQ(found.sheet.report.events.size(), 1U) << longest << " " << found.sheet.text();
    const EventRecord& event = found.sheet.report.events[0];
    EXPECT_EQ(event.type, EventType::tilt);
    EXPECT_EQ(event.status, EventStatus::located);
    EXPECT_NEAR(event.before, tilt, 1e-14);
    EXPECT_NEAR(event.after, tilt, 1e-14);
  }
}

/// A count of negative directions that changes where nothing else happens.
TEST(MadeUpEvents, AChangeOfTheCountThatNoEventExplainsIsReported) {
  for (const double at : {0.3, 0.5, 0.77}) {
    for (const int after : {1, 0}) {
      Line line;
      line.spectrum = [&](double p) { return std::optional(elliptic(p < at ? 2 : after)); };
      const Found found = follow_line(line);
      const auto& events = found.sheet.report.events;
      const auto unexplained =
          std::ranges::count(events, EventType::unexplained, &EventRecord::type);
      ASSERT_EQ(unexplained, 1) << at << " " << found.sheet.text();
      const auto& event = *std::ranges::find(events, EventType::unexplained, &EventRecord::type);
      EXPECT_EQ(event.status, EventStatus::bracketed);
      EXPECT_LE(event.before, at);
      EXPECT_GE(event.after, at);
      EXPECT_LE(event.after - event.before, 1e-12);
    }
  }
}

/// Pairs that appear or vanish make others take their places among the numbers that are compared:
/// no two of them have passed each other.
TEST(MadeUpEvents, NothingPassesWhereTheNumberOfPairsChanges) {
  for (const double at : {0.3, 0.5, 0.77}) {
    Line line;
    line.spectrum = [&](double p) {
      Spectrum out = elliptic(2);
      out.mode[0].lambda_re = -2.0;
      out.mode[1].lambda_re = -4.0;
      out.mode[1].block = Block::odd;
      out.mode[1].krein = 1;
      if (p > at) {
        out.modes = 3;
        out.mode[2] = out.mode[0];
        out.mode[2].lambda_re = -9.0;
      }
      return std::optional(out);
    };
    const Found found = follow_line(line);
    EXPECT_EQ(
        std::ranges::count(found.sheet.report.events, EventType::krein_pass, &EventRecord::type), 0)
        << found.sheet.text();
  }
}

/// Two Lambda = mean -+ sqrt(square) of opposite signatures, that of the lower one given, and others of +1.
Spectrum meeting(double mean, double square, int lower, const std::vector<double>& others) {
  Spectrum out;
  out.modes = 2 + static_cast<int>(others.size());
  out.negative = 2;
  const double half = std::sqrt(std::abs(square));
  for (std::size_t k = 0; k < 2 + others.size(); ++k) {
    Mode& mode = out.mode[k];
    mode.lambda_re = k >= 2 ? others[k - 2] : mean;
    mode.krein = 1;
    if (k < 2 && square < 0.0) {
      mode.lambda_im = half;
      mode.krein = 0;
    } else if (k < 2) {
      mode.lambda_re += k == 0 ? -half : half;
      mode.krein = k == 0 ? lower : -lower;
    }
    mode.lambda_error = 1e-15;
    mode.im = std::sqrt(-mode.lambda_re);
  }
  out.verdict = square < 0.0 ? StabilityClass::oscillatory : StabilityClass::elliptic;
  return out;
}

/// They meet at p = at -+ apart and go on in another order; or, of a sign -1 under the root, are imaginary between
/// the two. Beside them two of one signature that are nearer each other.
Spectrum exchanging(double p, double at, double apart, double sign = 1.0) {
  return meeting(-4.0, sign * (p - at - apart) * (p - at + apart), p < at ? 1 : -1,
                 {-9.0001, -9.0});
}

/// One of signature -1 comes from below two of +1, at -4.6 and -4.4, and meets and parts from each of them.
Spectrum passing_two(double p, double at, double apart) {
  const double moving = std::min(-4.5 + 10.0 * (p - at), -1.0);
  const double met = moving < -4.5 ? -4.6 : -4.4;
  const double half = 0.5 * (moving - met);
  return meeting(0.5 * (moving + met), half * half - 25.0 * apart * apart, moving < met ? -1 : 1,
                 {-9.0 - met});
}

void expect_meetings(const Line& line, double longest, const std::vector<double>& places) {
  FollowOptions options = range(0.0, 1.0);
  options.continuation.step.max = longest;
  const Found found = follow_line(line, options);
  const auto events = found.sheet.events({EventType::hamiltonian_hopf});
  ASSERT_EQ(events.size(), places.size()) << found.sheet.text();
  for (std::size_t k = 0; k < places.size(); ++k)
    EXPECT_NEAR(events[k].member.parameter, places[k], 1e-9) << k;
  EXPECT_EQ(found.sheet.report.events.size(), places.size()) << found.sheet.text();
}

TEST(MadeUpEvents, PairsThatChangedTheirOrderHaveMet) {
  for (const double at : {0.31, 0.472, 0.593, 0.688, 0.741}) {
    for (const double apart : {1e-2, 1e-4, 1e-7}) {
      for (const double longest : {0.5, 0.1}) {
        Line line;
        line.spectrum = [&](double p) { return std::optional(exchanging(p, at, apart)); };
        SCOPED_TRACE(at);
        expect_meetings(line, longest, {at - apart, at + apart});
      }
    }
  }
}

TEST(MadeUpEvents, OneThatPassedTwoMetBoth) {
  for (const double at : {0.31, 0.472, 0.593, 0.688, 0.741}) {
    for (const double apart : {1e-3, 1e-5}) {
      Line line;
      line.spectrum = [&](double p) { return std::optional(passing_two(p, at, apart)); };
      SCOPED_TRACE(at);
      const double first = at - 0.01;
      const double second = at + 0.01;
      expect_meetings(line, 0.2, {first - apart, first + apart, second - apart, second + apart});
    }
  }
}

TEST(MadeUpEvents, PairsThatAreImaginaryForABitAreSeen) {
  for (const double at : {0.31, 0.472, 0.593, 0.688, 0.741}) {
    for (const double apart : {1e-2, 1e-4}) {
      Line line;
      line.spectrum = [&](double p) { return std::optional(exchanging(p, at, apart, -1.0)); };
      SCOPED_TRACE(at);
      expect_meetings(line, 0.1, {at - apart, at + apart});
    }
  }
}

/// That they met is told where no place is seen between the two.
TEST(MadeUpEvents, PairsThatPassEachOtherWithoutLeavingTheAxisAreTold) {
  for (const double at : {0.31, 0.472, 0.593}) {
    Line line;
    line.spectrum = [&](double p) { return std::optional(exchanging(p, at, 0.0)); };
    const Found found = follow_line(line);
    ASSERT_EQ(found.sheet.report.events.size(), 1U) << at << " " << found.sheet.text();
    const EventRecord& event = found.sheet.report.events[0];
    EXPECT_EQ(event.type, EventType::hamiltonian_hopf);
    EXPECT_EQ(event.status, EventStatus::unresolved);
    EXPECT_LE(event.before, at);
    EXPECT_GE(event.after, at);
  }
}

}  // namespace
}  // namespace stationary
