// Which changes of the counts of a curve's spectra its events account for.
#include "solver/continuation/count_changes.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace stationary {
namespace {

/// Of two modes, so many directions negative and so many Lambda real and positive; the verdict as given.
Spectrum counted(int negative, int growing = 0, StabilityClass verdict = StabilityClass::elliptic) {
  Spectrum out;
  out.modes = 2;
  out.negative = negative;
  out.verdict = verdict;
  for (int k = 0; k < 2; ++k) {
    out.mode[static_cast<std::size_t>(k)].lambda_re = k < growing ? 1.0 : 0.0;
    out.mode[static_cast<std::size_t>(k)].lambda_im = k < growing ? 0.0 : 1.0 + k;
  }
  return out;
}

Member at(double p, std::optional<Spectrum> spectrum) {
  Member out;
  out.parameter = out.nu = p;
  out.spectrum = spectrum;
  return out;
}

std::vector<FoundEvent> events(const std::vector<EventType>& types) {
  std::vector<FoundEvent> out;
  for (const EventType type : types) {
    out.push_back({});
    out.back().event.type = type;
  }
  return out;
}

/// A curve of (iii) at p = 1, 2, ...; what each step leaves unexplained.
class Counts {
 public:
  explicit Counts(const Spectrum& start) : here_(at(1.0, start)) {
    context_.branch = Branch::iii;
    counts_.start(here_, false);
  }
  /// The change of the negative directions that a step with these events leaves.
  std::optional<UnexplainedChange> negative(std::optional<Spectrum> next,
                                            const std::vector<EventType>& found = {}) {
    const auto step = enter(std::move(next));
    const auto out = counts_.negative(step, events(found));
    settle();
    return out;
  }
  std::optional<UnexplainedChange> growing(std::optional<Spectrum> next, bool explained) {
    const auto out = counts_.growing(enter(std::move(next)), explained);
    settle();
    return out;
  }
  std::optional<UnexplainedChange> definite(std::optional<Spectrum> next, bool explained) {
    const auto out = counts_.definite(enter(std::move(next)), explained);
    settle();
    return out;
  }
  TestContext& context() { return context_; }

 private:
  CountChanges::Step enter(std::optional<Spectrum> next) {
    next_ = at(here_.parameter + 1.0, std::move(next));
    const CountChanges::Step step{here_, next_, context_, false, false};
    counts_.enter(step);
    return step;
  }
  void settle() {
    counts_.widen_remembered([this](ParameterRange& since) { since.add(next_.parameter); });
    counts_.settle();
    here_ = next_;
  }

  TestContext context_{};
  CountChanges counts_;
  Member here_;
  Member next_;
};

TEST(CountChanges, NegativeDirectionsAsTheEventsAllow) {
  const std::vector<EventType> tilt{EventType::tilt};
  EXPECT_FALSE(Counts(counted(0)).negative(counted(0)));
  EXPECT_FALSE(Counts(counted(0)).negative(counted(1), tilt));
  EXPECT_TRUE(Counts(counted(0)).negative(counted(1))) << "no event";
  EXPECT_TRUE(Counts(counted(0)).negative(counted(2), tilt)) << "one changes it by one";
  EXPECT_TRUE(Counts(counted(1)).negative(counted(1), tilt)) << "and by no less";
  EXPECT_FALSE(Counts(counted(1)).negative(counted(1), {EventType::tilt, EventType::shear}));
  EXPECT_FALSE(Counts(counted(2)).negative(counted(0), {EventType::zero_momentum}));
  EXPECT_FALSE(Counts(counted(1)).negative(counted(1), {EventType::zero_momentum}));
  EXPECT_TRUE(Counts(counted(1)).negative(counted(2), {EventType::zero_momentum}))
      << "both directions of a pair at once";
}

TEST(CountChanges, NegativeDirectionsOfAMaterialSymmetryWhereItsInertiasAreEqual) {
  Counts counts(counted(0));
  EXPECT_TRUE(Counts(counted(0)).negative(counted(1), {EventType::inertia_exchange}));
  counts.context().material_symmetry = true;
  EXPECT_FALSE(counts.negative(counted(1), {EventType::inertia_exchange}));
}

TEST(CountChanges, TellWhetherTheCountWasKnownAtTheBeginningOfTheStep) {
  Spectrum open = counted(0);
  open.mode[0].lambda_im = 0.0;  // it may be zero
  ASSERT_FALSE(open.away_from_zero());
  Counts counts(counted(0));
  EXPECT_FALSE(counts.negative(open, {EventType::tilt})) << "nothing is known there";
  const auto late = counts.negative(counted(2));
  ASSERT_TRUE(late);
  EXPECT_FALSE(late->in_step);
  EXPECT_EQ(late->before, 0);
  EXPECT_EQ(late->since.least, 1.0);
  EXPECT_EQ(late->since.most, 2.0);
  const auto now = counts.negative(counted(1));
  ASSERT_TRUE(now);
  EXPECT_TRUE(now->in_step);
  EXPECT_EQ(now->before, 2);
  EXPECT_EQ(now->count(counted(1)), 1);
}

TEST(CountChanges, AnEventIsRememberedWhileNothingIsKnown) {
  Spectrum open = counted(0);
  open.mode[0].lambda_im = 0.0;
  Counts counts(counted(0));
  EXPECT_FALSE(counts.negative(open, {EventType::tilt}));
  EXPECT_FALSE(counts.negative(counted(1)));
}

TEST(CountChanges, ForgottenWhereThereIsNoSpectrum) {
  Counts counts(counted(0));
  EXPECT_FALSE(counts.negative(std::nullopt));
  EXPECT_FALSE(counts.negative(counted(1)));
}

TEST(CountChanges, OfGrowingModesAnyEventAccounts) {
  EXPECT_TRUE(Counts(counted(0, 1)).growing(counted(0, 2), false));
  EXPECT_FALSE(Counts(counted(0, 1)).growing(counted(0, 2), true));
  EXPECT_FALSE(Counts(counted(0, 1)).growing(counted(0, 1), false));
}

TEST(CountChanges, OfWhatIsDefinite) {
  constexpr auto stable = StabilityClass::stable;
  constexpr auto oscillatory = StabilityClass::oscillatory;
  const auto change = Counts(counted(0, 0, stable)).definite(counted(0), false);
  ASSERT_TRUE(change);
  EXPECT_EQ(change->before, 1);
  EXPECT_FALSE(Counts(counted(0, 0, stable)).definite(counted(0), true));
  EXPECT_FALSE(Counts(counted(0, 0, stable)).definite(counted(0, 0, oscillatory), false))
      << "what grows is neither";
}

}  // namespace
}  // namespace stationary
