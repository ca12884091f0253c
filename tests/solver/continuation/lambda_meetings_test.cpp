// What is certain of two points tells that Lambdas met between them, and that they need not have.
#include "solver/continuation/lambda_meetings.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string_view>

namespace stationary {
namespace {

/// One block: the signatures of the negative Lambdas, ascending, '?' for one that is not certain; besides so
/// many that may be zero, and positive ones.
TestValues block_of(std::string_view signatures, int zeros = 0, int positive = 0) {
  TestValues out{};
  const auto negative = static_cast<std::uint8_t>(signatures.size());
  out.composition[1] = {static_cast<std::uint8_t>(negative + zeros + positive), negative};
  out.zeros[1] = static_cast<std::uint8_t>(zeros);
  if (signatures.find('?') == std::string_view::npos) out.signed_blocks = 2;
  for (std::size_t k = 0; k < signatures.size(); ++k)
    if (signatures[k] == '+') out.signatures[1] |= static_cast<std::uint8_t>(1U << k);
  return out;
}

bool changed(const TestValues& from, const TestValues& to) {
  EXPECT_EQ(order_changed(from, to), order_changed(to, from));
  return order_changed(from, to);
}

TEST(OrderChanged, WhereTheSameSignaturesStandInAnotherOrder) {
  EXPECT_TRUE(changed(block_of("-+"), block_of("+-")));
  EXPECT_TRUE(changed(block_of("++-"), block_of("-++")));
  EXPECT_FALSE(changed(block_of("-+"), block_of("-+")));
  EXPECT_FALSE(changed(block_of("++"), block_of("++")));
}

TEST(OrderChanged, NotWhereASignatureIsAnother) {
  EXPECT_FALSE(changed(block_of("-+"), block_of("++"))) << "one has touched zero";
  EXPECT_FALSE(changed(block_of("-+"), block_of("--")));
}

TEST(OrderChanged, OfThoseThatHaveNotComeToZero) {
  EXPECT_FALSE(changed(block_of("-+"), block_of("-", 1)));
  EXPECT_TRUE(changed(block_of("-+"), block_of("+", 1))) << "the one below came to zero";
  EXPECT_FALSE(changed(block_of("-+"), block_of("+", 0, 1)))
      << "where none is zero nothing is told";
}

TEST(OrderChanged, NotWhereOneIsOpenOrComplex) {
  EXPECT_FALSE(changed(block_of("-?"), block_of("+-")));
  EXPECT_FALSE(changed(block_of("-+-"), block_of("+")));
}

TEST(SamePairs, ByTheNumbersOfRealOnes) {
  EXPECT_TRUE(same_pairs(block_of("-+"), block_of("+-")));
  EXPECT_TRUE(same_pairs(block_of("-+"), block_of("-", 1)));
  EXPECT_FALSE(same_pairs(block_of("-+"), block_of("")));
}

TEST(PairsChangedSides, WhereTwoAreNotNegativeAnyMoreOrFourAreComplex) {
  EXPECT_TRUE(pairs_changed_sides(block_of("-+"), block_of("", 0, 2)));
  EXPECT_TRUE(pairs_changed_sides(block_of("-+-+"), block_of("")));
  EXPECT_FALSE(pairs_changed_sides(block_of("-+"), block_of("-", 0, 1))) << "one passed zero";
  EXPECT_FALSE(pairs_changed_sides(block_of("-+"), block_of(""))) << "the sign of collision tells";
}

TEST(MetBetween, ByWhatIsComplexOnOneSide) {
  EXPECT_EQ(met_between(block_of("-+"), block_of("")), EventType::hamiltonian_hopf);
  EXPECT_EQ(met_between(block_of("", 0, 2), block_of("")), EventType::real_collision);
  EXPECT_EQ(met_between(block_of("-+"), block_of("+-")), std::nullopt);
}

}  // namespace
}  // namespace stationary
