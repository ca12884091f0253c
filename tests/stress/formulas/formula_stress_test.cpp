// A share of random formulas: nothing untrue is claimed of them, and the tester would see it.
#include <gtest/gtest.h>

#include "tests/stress/formulas/formula_judge.hpp"

namespace stationary::stress {
namespace {

#ifdef NDEBUG
constexpr long count = 24;
#else
constexpr long count = 8;  // the sanitizers take their time
#endif
constexpr long enough = 12;  ///< of which some show what the next two drop
constexpr std::uint64_t seed = 2026;

TEST(RandomFormulas, NothingUntrueIsClaimed) {
  const FormulaTally tally = judged_formulas(count, seed);
  for (const std::string& fault : tally.faults) ADD_FAILURE() << fault;
  RecordProperty("counts", text_of(tally));
  EXPECT_EQ(tally.cases, count);
  EXPECT_GE(10 * tally.anisotropic, 2 * tally.cases);
  EXPECT_GE(10 * tally.poles, tally.cases);
  EXPECT_GE(4 * (tally.proven + tally.none), tally.cases);
  EXPECT_GE(10 * tally.domain_ends, tally.cases);
  EXPECT_LE(10 * tally.refused, tally.cases);
}

TEST(RandomFormulas, ABoundThatIsTooSmallIsSeen) {
  EXPECT_FALSE(judged_formulas(enough, seed, {.bounds = 0.01}).faults.empty());
}

TEST(RandomFormulas, ADroppedConditionIsSeen) {
  EXPECT_FALSE(judged_formulas(enough, seed, {.without_domain = true}).faults.empty());
}

}  // namespace
}  // namespace stationary::stress
