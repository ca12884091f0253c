// Identities decided exactly, by residues: what holds by the rules of powers, exp and log, and what
// does not, however small it is where one looks.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/expression/residue.hpp"
#include "lib/formula/expression.hpp"
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
      {"sqrt(7)*(xi^2 - zeta^2)", "(sqrt(7)*xi + sqrt(7)*zeta)*(xi - zeta)"},
      {"sqrt(49*xi)", "7*sqrt(xi)"},
      {"xi^2/sqrt(12)", "xi^2/(2*sqrt(3))"},
      {"(sqrt(2)*xi)^2", "2*xi^2"},
      {"(sqrt(3) - sqrt(2))*(sqrt(3) + sqrt(2))*alpha^2", "alpha^2"},
      {"xi*(sqrt(2) + 1)", "xi/(sqrt(2) - 1)"},
      {"(0.1*xi + 0.2*xi)^1.5", "(0.3*xi)^1.5"},
      {"sqrt(d)*(0.1*rho + 0.2*rho)", "0.3*sqrt(d)*rho"},
      {"log(rho)/log(2)*log(2)", "log(rho)"}};
  for (const auto& [a, b] : all) {
    const auto e = difference(a, b);
    const Verdict found = expression::vanishes(e.graph, e.root, k_and_n.size());
    EXPECT_TRUE(found == Verdict::exactly || found == Verdict::term_by_term) << a << " = " << b;
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
      {"3.14159265358979323846", "3.14159265358979311600"},
      {"tanh(2*xi)", "2*tanh(xi)"}};
  for (const auto& [a, b] : all) {
    const auto e = difference(a, b);
    const Residues found = expression::residues(e.graph, e.root);
    EXPECT_TRUE(found == Residues::not_zero || found == Residues::unclear) << a << " = " << b;
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

/// Modulo a prime a number may be no square though it is positive, the same at every point.
TEST(Vanishing, RootsOfNumbersHaveTheSignsOfRealNumbers) {
  int of_no_square = 0;
  for (const int n : {2, 3, 5, 7, 11, 13, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89}) {
    const std::string number = std::to_string(n);
    const std::string square = std::to_string(n * n);
    for (const auto& [a, b] :
         {std::pair{"sqrt(" + square + ")*alpha^2", "-" + number + "*alpha^2"},
          std::pair{"sqrt(" + square + "*xi)", "-" + number + "*sqrt(xi)"},
          std::pair{square + "^1.5*rho", "-" + number + "^3*rho"},
          std::pair{"sqrt(2*" + square + ")*rho", "-sqrt(2)*" + number + "*rho"}}) {
      const auto e = difference(a, b);
      EXPECT_EQ(expression::vanishes(e.graph, e.root, k_and_n.size()), Verdict::refuted)
          << a << " = " << b;
      of_no_square += expression::residues(e.graph, e.root) == Residues::zero_but_for_signs;
    }
  }
  EXPECT_GE(of_no_square, 8) << "residues alone would have told these apart";
  // Too small for points to show: no proof.
  const auto e =
      difference("sqrt(xi)*sqrt(zeta)*(1 + 2^(-80)*sqrt(2809))", "sqrt(xi*zeta)*(1 - 53*2^(-80))");
  EXPECT_NE(expression::vanishes(e.graph, e.root, k_and_n.size()), Verdict::exactly);
}

/// Of a - b at alpha, xi, zeta, rho.
Verdict equality(const std::string& a, const std::string& b) {
  auto e = difference(a, b);
  const expression::NodeId x = expression::in_stretch(e);
  return expression::vanishes(e.graph, x, k_and_n.size());
}

/// Likewise a number times a square, however it is written, and another root beside it.
TEST(Vanishing, RootsOfSumsHaveTheSignsOfRealNumbers) {
  for (const auto& [a, b] :
       {std::pair{"sqrt((50*(I1 + 2*d)/t^2 + 3)^2)*alpha", "-53*alpha"},
        std::pair{"sqrt((50 + k/n + 3 - k/n)^2)*alpha", "-53*alpha"},
        std::pair{"sqrt((50*(cos(k)^2 + sin(k)^2) + 3)^2)*xi", "-53*xi"},
        std::pair{"sqrt((50*(I1 + 2*d) + 3*t^2)^2)*xi", "-53*t^2*xi"},
        std::pair{"exp(0.5*log((50*(I1 + 2*d)/t^2 + 3)^2))*xi", "-53*xi"},
        std::pair{"((50*(I1 + 2*d)/t^2 + 3)^2)^1.5*xi", "-148877*xi"},
        std::pair{"sqrt(2809*k)*alpha^2", "-53*sqrt(k)*alpha^2"},
        std::pair{"sqrt(2809*pi)*alpha^2", "-53*sqrt(pi)*alpha^2"},
        std::pair{"sqrt(2809*log(3 + rho^2))*xi", "-53*sqrt(log(3 + rho^2))*xi"},
        std::pair{"sqrt((50*(I1 + 2*d) + 3*t^2)^2*rho)*xi", "-53*t^2*sqrt(rho)*xi"}})
    EXPECT_EQ(equality(a, b), Verdict::refuted) << a << " = " << b;
  // What holds with either sign is exact.
  for (const auto& [a, b] :
       {std::pair{"sqrt((xi - zeta)^2 + 4*alpha^2)", "sqrt(t^2 - 4*d)"},
        std::pair{"sqrt(2*(xi + zeta))*alpha^2", "sqrt(2*xi + 2*zeta)*alpha^2"},
        std::pair{"(I1 + 47*d)^1.5", "(I1 + 47*d)*sqrt(I1 + 47*d)"},
        std::pair{"(I1 + d)^(1/3)*(I1 + d)^(2/3)", "I1 + d"}})
    EXPECT_EQ(equality(a, b), Verdict::exactly) << a << " = " << b;
  for (const char* isotropic :
       {"sqrt((xi - zeta)^2 + 4*alpha^2)", "sqrt((53*xi + 53*zeta)^2)", "(I1 + 47*d)^0.5"})
    EXPECT_LE(support::written_facts(isotropic, k_and_n).isotropic, Verdict::exactly) << isotropic;
}

/// Numbers that are equal, but not by the rules of residues.
TEST(Vanishing, NumbersThatAreEqualRefuteNothing) {
  for (const auto& [a, b] :
       {std::pair{"cos(pi/3)*alpha", "alpha/2"}, std::pair{"sin(pi)*alpha", "0"},
        std::pair{"(sin(2*pi/5) + sin(8*pi/5))*alpha", "0"},
        std::pair{"log(1e10)*xi", "10*log(10)*xi"}, std::pair{"(log(6) - log(2) - log(3))*xi", "0"},
        std::pair{"exp(log(2)/2)*xi", "sqrt(2)*xi"},
        std::pair{"(atan(2) + atan(3))*xi", "0.75*pi*xi"}}) {
    const auto e = difference(a, b);
    EXPECT_TRUE(expression::Facts::holds(expression::vanishes(e.graph, e.root, k_and_n.size())))
        << a << " = " << b;
  }
  for (const auto& [a, b] : {std::pair{"cos(pi/3)*alpha", "0.5000000000001*alpha"},
                             std::pair{"log(1e10)*xi", "10.0000000000001*log(10)*xi"},
                             std::pair{"sin(3.14159265358979)*alpha", "0"}}) {
    const auto e = difference(a, b);
    EXPECT_EQ(expression::vanishes(e.graph, e.root, k_and_n.size()), Verdict::refuted)
        << a << " = " << b;
  }
  EXPECT_TRUE(expression::Facts::holds(
      support::written_facts(
          "0.5*((xi^2 + alpha^2) + cos(pi/3)^2*(xi^2 + alpha^2) + sin(pi/3)^2*(zeta^2 + "
          "alpha^2) + 2*cos(pi/3)*sin(pi/3)*alpha*(xi + zeta) + "
          "cos(2*pi/3)^2*(xi^2 + alpha^2) + sin(2*pi/3)^2*(zeta^2 + alpha^2) + "
          "2*cos(2*pi/3)*sin(2*pi/3)*alpha*(xi + zeta)) + 1/d",
          {})
          .isotropic));
}

/// k^n has a value where k < 0 and n is whole: an identity of k > 0 is none of all parameters.
TEST(Vanishing, PowersOfParametersMayBeOfNegativeOnes) {
  for (const auto& [a, b] :
       {std::pair{"sqrt(k^n)*alpha^2", "k^(n/2)*alpha^2"}, std::pair{"(k^2)^n*xi", "k^(2*n)*xi"}}) {
    const auto e = difference(a, b);
    const auto of = [&](std::vector<double> values) {
      return expression::vanishes(e.graph, e.root, k_and_n.size(), values);
    };
    EXPECT_NE(of({}), Verdict::exactly) << a;
    EXPECT_NE(of({2.0, 2.0}), Verdict::exactly) << a;
  }
  for (const char* positive : {"xi", "rho/2", "xi + 2*zeta", "exp(alpha)"}) {
    const std::string x = positive;
    const auto e = difference("sqrt((" + x + ")^n)", "(" + x + ")^(n/2)");
    EXPECT_EQ(expression::vanishes(e.graph, e.root, k_and_n.size()), Verdict::exactly) << x;
  }
  const auto e = difference("sqrt(k^n)*alpha^2", "k^(n/2)*alpha^2");
  EXPECT_EQ(expression::vanishes(e.graph, e.root, 2, std::vector{-2.0, 2.0}), Verdict::refuted);
}

/// Decimal numbers are not the doubles that they round to.
TEST(Vanishing, DecimalsRefuteNothingByTheirRounding) {
  for (const auto& [a, b] :
       {std::pair{"(0.1 + 0.2)*sin(2*xi)*alpha^2", "0.6*sin(xi)*cos(xi)*alpha^2"},
        std::pair{"0.3*sin(2*xi)", "0.6*sin(xi)*cos(xi)"}}) {
    const auto e = difference(a, b);
    EXPECT_NE(expression::vanishes(e.graph, e.root, k_and_n.size()), Verdict::refuted) << a;
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
