// Identities decided exactly, by residues: what holds by the rules of powers, exp and log, and what
// does not, however small it is where one looks.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/expression/residue.hpp"
#include "lib/formula/vanishing.hpp"
#include "solver/program/text/expression_parser.hpp"
#include "tests/support/bodies/written_potential.hpp"

namespace stationary {
namespace {

using expression::Residues;
using expression::Verdict;
using support::k_and_n;

expression::Expression difference(const std::string& a, const std::string& b) {
  return parse_expression("(" + a + ") - (" + b + ")", k_and_n, ExpressionSlot::coupled).expression;
}

TEST(Residues, ProveWhatHoldsByTheRules) {
  const std::vector<std::pair<const char*, const char*>> all{
      {"(xi + zeta)^3", "xi^3 + 3*xi^2*zeta + 3*xi*zeta^2 + zeta^3"},
      {"(rho^2 - 1)/(rho - 1)", "rho + 1"},
      {"0.1*xi + 0.2*xi", "0.3*xi"},
      {"1.5e-3*rho", "0.0015*rho"},
      {"sqrt(xi)*sqrt(zeta)", "sqrt(xi*zeta)"},
      {"sqrt(xi)^2", "xi"},
      {"xi^n*zeta^n", "(xi*zeta)^n"},
      {"rho^n*rho^(2 - n)", "rho^2"},
      {"(rho^n)^k", "rho^(n*k)"},
      {"exp(xi)*exp(k*zeta)", "exp(xi + k*zeta)"},
      {"exp(xi)^2", "exp(2*xi)"},
      {"exp(n*log(rho))", "rho^n"},
      {"log(xi^2*zeta)", "2*log(xi) + log(zeta)"},
      {"log(xi/rho^n)", "log(xi) - n*log(rho)"},
      {"log(k*xi + k*zeta)", "log(k) + log(xi + zeta)"},
      {"tanh(xi)", "(exp(2*xi) - 1)/(exp(2*xi) + 1)"},
      {"sin(xi)^2 + cos(xi)^2", "1"},
      {"tan(rho)", "sin(rho)/cos(rho)"},
      {"sin(-xi)", "-sin(xi)"},
      {"e^rho", "exp(rho)"},
      {"log(rho)/log(2)*log(2)", "log(rho)"}};
  for (const auto& [a, b] : all) {
    const auto e = difference(a, b);
    EXPECT_EQ(expression::residues(e.graph, e.root), Residues::zero) << a << " = " << b;
  }
}

TEST(Residues, RefuteWhatDoesNot) {
  const std::vector<std::pair<const char*, const char*>> all{
      {"(xi + zeta)^2", "xi^2 + zeta^2"},
      {"exp(-1e8*(rho - 0.72966738)^2)*alpha", "0"},
      {"1e-300*xi", "0"},
      {"exp(xi*zeta)", "exp(xi)*exp(zeta)"},
      {"log(xi + zeta)", "log(xi) + log(zeta)"},
      {"rho^n", "rho^k"},
      {"0.1", "0.1000000000000000055511151231257827"},
      {"tanh(2*xi)", "2*tanh(xi)"}};
  for (const auto& [a, b] : all) {
    const auto e = difference(a, b);
    EXPECT_NE(expression::residues(e.graph, e.root), Residues::zero) << a << " = " << b;
  }
}

/// The sign of a root is that of what is under it only where that is positive.
TEST(Residues, DoNotTakeARootForItsArgument) {
  for (const char* base : {"rho - 1", "xi - zeta", "k"}) {
    const std::string square = std::string("(") + base + ")^2";
    const auto e = difference("sqrt(" + square + ")", base);
    EXPECT_EQ(expression::residues(e.graph, e.root), Residues::unclear) << base;
  }
}

TEST(Vanishing, AsksPointsOnlyWhereResiduesCannotTell) {
  const auto verdict = [](const std::string& a, const std::string& b) {
    const auto e = difference(a, b);
    return expression::vanishes(e.graph, e.root, k_and_n.size());
  };
  EXPECT_EQ(verdict("xi", "xi"), Verdict::term_by_term);
  EXPECT_EQ(verdict("(xi + rho)^2", "xi^2 + 2*xi*rho + rho^2"), Verdict::exactly);
  EXPECT_EQ(verdict("sin(2*xi)", "2*sin(xi)*cos(xi)"), Verdict::at_points);
  EXPECT_EQ(verdict("atan(xi) + atan(1/xi)", "pi/2"), Verdict::at_points);
  EXPECT_EQ(verdict("(xi + rho)^2", "xi^2 + xi*rho + rho^2"), Verdict::refuted);
  // Small at every point that is looked at, and no identity.
  EXPECT_EQ(verdict("exp(-1e8*(xi*zeta - 0.72966738)^2)*alpha", "0"), Verdict::undecided);
}

}  // namespace
}  // namespace stationary
