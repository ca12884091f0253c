// Where a formula is defined: which conditions it implies, what is left of them, and that nothing
// is evaluated beyond them.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lib/expression/domain.hpp"
#include "solver/program/text/expression_parser.hpp"
#include "tests/support/bodies/written_potential.hpp"

namespace stationary {
namespace {

using namespace support;

std::vector<std::string> conditions(const std::string& text) {
  std::vector<std::string> out;
  for (const auto& each :
       parse_expression(text, k_and_n, ExpressionSlot::coupled).expression.conditions)
    out.push_back(each.text);
  return out;
}

using Texts = std::vector<std::string>;

TEST(ExpressionDomain, ConditionsThatAlwaysHoldAreNone) {
  for (const char* text :
       {"k*log(d) + n*log(rho)", "1/d + 1/rho^2", "sqrt(t)*I1^n", "log(d*rho)^2", "1/(1 + d)",
        "log(1 + rho^2 + exp(k))", "lambda^n + mu_^n", "log(I2) + 1/I3", "(t + 2*d)^-3",
        "1/tanh(rho)", "sqrt(exp(alpha))", "1/(alpha^2 + xi^2)", "(d^2)^0.5", "xi^2 - zeta^3",
        "log(xi*zeta - alpha^2)", "log(rho*(xi*zeta - alpha^2)^3)", "2/(alpha^2 - zeta*xi)",
        "(3*xi*zeta - 3*alpha^2)^n"})
    EXPECT_EQ(conditions(text), Texts()) << text;
}

TEST(ExpressionDomain, TheOthersAreFoundInTheWordsOfTheFormula) {
  EXPECT_EQ(conditions("-log(1 - (I1 + rho^2 - 3)/k)"),
            (Texts{"k != 0", "1 - (I1 + rho^2 - 3)/k > 0"}));
  EXPECT_EQ(conditions("ln(2 - d)"), Texts{"2 - d > 0"});
  EXPECT_EQ(conditions("sqrt(alpha)"), Texts{"alpha > 0"});
  EXPECT_EQ(conditions("(d - 2)^0.5*(rho - 1)^n"), (Texts{"(d - 2) > 0", "(rho - 1) > 0"}));
  EXPECT_EQ(conditions("(d - 2)^2*(rho - 1)^-2"), Texts{"(rho - 1) != 0"});
  EXPECT_EQ(conditions("pow(d - 2, k)"), Texts{"d - 2 > 0"});
  EXPECT_EQ(conditions("1/(d - 1)^2"), Texts{"(d - 1)^2 != 0"});
  EXPECT_EQ(conditions("tan(rho)"), Texts{"cos(rho) != 0"});
  EXPECT_EQ(conditions("1/(xi - zeta)*(xi - zeta)"), Texts{"(xi - zeta) != 0"});
  EXPECT_EQ(conditions("exp(log(1 - d))"), Texts{"1 - d > 0"});
  EXPECT_EQ(conditions("log(-d)"), Texts{"-d > 0"});
  EXPECT_EQ(conditions("log(alpha^2 - xi*zeta)"), Texts{"alpha^2 - xi*zeta > 0"});
  EXPECT_EQ(conditions("log(xi*zeta - 2*alpha^2)"), Texts{"xi*zeta - 2*alpha^2 > 0"});
  // A parameter may be varied.
  EXPECT_EQ(conditions("log(k*d) + d/n"), (Texts{"k*d > 0", "n != 0"}));
  // One and the same.
  EXPECT_EQ(conditions("log(2 - d) + 1/(2 - d) + log(2 - d)^2").size(), 2U);
}

/// A power or a root of coefficients alone needs no condition, and has no sign for that reason: k may be negative, or 0.
TEST(ExpressionDomain, PowersOfParametersHaveNoSign) {
  EXPECT_EQ(conditions("1/(d + k^n)"), Texts{"(d + k^n) != 0"});
  EXPECT_EQ(conditions("log(8*d + k^n)"), Texts{"8*d + k^n > 0"});
  EXPECT_EQ(conditions("log(sqrt(k)*d)"), Texts{"sqrt(k)*d > 0"});
  EXPECT_EQ(conditions("log(d + sqrt(k))"), Texts());
  EXPECT_EQ(conditions("log(d + exp(k)^n + sqrt(2))"), Texts());
}

TEST(ExpressionDomain, OfPartsAndOfTheUser) {
  const Formula formula{
      {{"J", "d*rho"}, {"A", "1 - J/k"}}, {"I1 + rho^2 < 3*k", "J >= 0.1"}, "-n*log(A) + I1"};
  const auto parsed = parse_formula(formula, k_and_n, ExpressionSlot::coupled);
  Texts found;
  for (const auto& each : parsed.expression.conditions) found.push_back(each.text);
  EXPECT_EQ(found, (Texts{"k != 0", "I1 + rho^2 < 3*k", "J >= 0.1", "A > 0"}));
  EXPECT_TRUE(parsed.unused.empty());
  EXPECT_TRUE(parsed.unused_parts.empty());
}

/// No number where a condition does not hold, in any number type.
TEST(ExpressionDomain, NothingIsEvaluatedOutside) {
  const CoupledExpression<> gent =
      written_coupled("-k*log(1 - (I1 + rho^2 - 3)/n) - k*log(d*rho)", k_and_n, {0.5, 5.0});
  const auto at = [&](double xi) {
    const auto w = gent.evaluate<2>(planar_invariants(xi, 1.0), 1.0);
    const auto b = gent.log_balance(xi, 1.0, 1.0, 0.1, 0.2, 0.3);
    return std::array{w.plane.w, w.plane.w_t, w.w_rr, b.g_xi, b.vw};
  };
  for (const double value : at(2.2)) EXPECT_TRUE(std::isfinite(value));
  for (const double value : at(2.5)) EXPECT_TRUE(std::isnan(value));
  const auto wide =
      gent.evaluate<1>(planar_invariants(DoubleDouble(2.5), DoubleDouble(1.0)), DoubleDouble(1.0));
  EXPECT_TRUE(std::isnan(double(wide.plane.w_t)));
  const auto over = [](double lo, double hi) { return Interval(lo, hi); };
  const auto model =
      with_indexed_coefficients(gent, [](double c, std::size_t) { return Interval(c); });
  const Interval one(1.0);
  const Interval none(0.0);
  EXPECT_TRUE(model.log_balance(over(2.0, 2.1), one, one, none, none, none).g_xi.bounded());
  EXPECT_FALSE(model.log_balance(over(2.4, 2.5), one, one, none, none, none).g_xi.bounded());
  EXPECT_FALSE(model.log_balance(over(2.5, 2.6), one, one, none, none, none).g_xi.bounded());
  EXPECT_FALSE(model.outside_in(over(2.4, 2.5), one, one));
  EXPECT_TRUE(model.outside_in(over(2.5, 2.6), one, one));
  // The derivatives of a logarithm have numbers beyond it, which mean nothing.
  const auto unrestricted =
      written_coupled("k*(I1 + rho^2)/(3 + n - I1 - rho^2)", k_and_n, {0.5, 5.0});
  EXPECT_TRUE(std::isfinite(unrestricted.evaluate<1>(planar_invariants(2.5, 1.0), 1.0).plane.w_t));
}

TEST(ExpressionDomain, ADenominatorPartsIt) {
  const PlanarExpression<> pole = written_plane("I1 + k/(d - n)", k_and_n, {0.1, 2.0});
  const Stretch below{0.0, 1.0, 1.0, 1.0};
  const Stretch above{0.0, 2.0, 2.0, 1.0};
  const auto value = [](const PlanarExpression<>& model, const Stretch& q) {
    return model.evaluate<0>(planar_invariants(q)).w;
  };
  EXPECT_TRUE(std::isfinite(value(pole, below)));
  EXPECT_TRUE(std::isfinite(value(pole, above)));
  EXPECT_TRUE(std::isfinite(value(pole.on_part_of(below), below)));
  EXPECT_TRUE(std::isnan(value(pole.on_part_of(below), above)));
  EXPECT_TRUE(std::isnan(value(pole.on_part_of(above), below)));
  // Other coefficients keep to the part.
  const auto wide = with_indexed_coefficients(pole.on_part_of(below),
                                              [](double c, std::size_t) { return Interval(c); });
  EXPECT_TRUE(wide.evaluate<0>(planar_invariants(Interval(1.0), Interval(1.0))).w.bounded());
  EXPECT_FALSE(wide.evaluate<0>(planar_invariants(Interval(2.0), Interval(2.0))).w.bounded());
}

TEST(ExpressionDomain, ConditionsOnTheLargerStretchKnowWhichItIs) {
  const PlanarExpression<> model =
      written_plane("I1 + k/d - n*log(3 - lambda) - n*log(3 - mu_)", k_and_n, {1.0, 0.1});
  EXPECT_TRUE(model.conditions_at({0.0, 1.0, 2.5, 1.0})[0].holds());
  EXPECT_FALSE(model.conditions_at({0.0, 1.0, 3.5, 1.0})[0].holds());
  EXPECT_FALSE(model.conditions_at({0.0, 3.5, 1.0, 1.0})[0].holds());
  EXPECT_TRUE(std::isnan(model.evaluate<1>(planar_invariants(1.0, 3.5)).w_t));
  EXPECT_TRUE(std::isnan(model.log_balance(3.5, 1.0, 0.0, 0.0).g_xi));
  EXPECT_TRUE(std::isfinite(model.log_balance(2.5, 1.0, 0.0, 0.0).g_xi));
}

}  // namespace
}  // namespace stationary
