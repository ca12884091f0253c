// What is found out about a potential: symmetric, isotropic, free of shear, separable, each where
// it is so and where it is not.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/formula/facts.hpp"
#include "lib/material/models/potential_derivatives.hpp"
#include "tests/support/bodies/random_states.hpp"
#include "tests/support/bodies/written_potential.hpp"
#include "tests/support/numbers/law.hpp"

namespace stationary {
namespace {

using namespace support;
using expression::Facts;
using expression::Verdict;

struct Known {
  const char* text;
  bool isotropic;
  bool shear_free;
  bool separable;
};

TEST(ExpressionFacts, AreFound) {
  const std::vector<Known> all{{"k*t^2 + n*log(d)", true, true, true},
                               {"I1*rho", true, true, false},
                               {"log(d*rho)", true, true, true},
                               {"log(d*rho)^2", true, true, false},
                               {"lambda^n + mu_^n + rho^2", true, true, true},
                               {"(lambda - mu_)^2", true, true, true},
                               {"xi + zeta", true, true, true},
                               {"xi*zeta - alpha^2", true, true, true},
                               {"exp(xi)*exp(zeta)", true, true, true},
                               {"(xi - zeta)^2 + (2*alpha)^2", true, true, true},
                               {"sin(xi + zeta)*cos(xi*zeta - alpha*alpha)", true, true, true},
                               {"xi^3 + zeta^3 + 3*alpha^2*(xi + zeta)", true, true, true},
                               {"xi", false, true, true},
                               {"xi*zeta", false, true, true},
                               {"xi*zeta + alpha^2", false, true, true},
                               {"k*(xi^2 + alpha^2 - 1)^2 + rho", false, true, true},
                               {"alpha*(xi - zeta)", false, false, true},
                               {"(xi*cos(pi/6)^2 + alpha*sin(pi/3))^2*rho", false, false, false},
                               {"alpha^2*rho + d", false, true, false},
                               {"lambda + mu_ + alpha", false, false, true},
                               {"k", true, true, true}};
  for (const Known& known : all) {
    const Facts facts = written_facts(known.text, k_and_n);
    EXPECT_EQ(facts.is_isotropic(), known.isotropic) << known.text;
    EXPECT_EQ(facts.is_shear_free(), known.shear_free) << known.text;
    EXPECT_EQ(facts.is_separable(), known.separable) << known.text;
  }
}

TEST(ExpressionFacts, SayHowTheyWereEstablished) {
  EXPECT_EQ(written_facts("k*t", k_and_n).isotropic, Verdict::term_by_term);
  const Facts facts = written_facts("xi^3 + zeta^3 + 3*alpha^2*(xi + zeta)", k_and_n);
  EXPECT_EQ(facts.isotropic, Verdict::exactly);
  EXPECT_EQ(facts.sentences,
            (std::vector<std::string>{
                "made of alpha, xi, zeta", "isotropic (a function of t, d and rho): holds exactly",
                "separable (a potential of the plane and one of the thickness): holds term by "
                "term"}));
  EXPECT_EQ(written_facts("k*alpha", k_and_n).shear_free, Verdict::refuted);
  // Defined nowhere.
  EXPECT_EQ(written_facts("sqrt(-xi)", k_and_n).isotropic, Verdict::undecided);
}

TEST(ExpressionFacts, UnsymmetricFunctionsOfTheStretchesAreRefused) {
  for (const char* text : {"lambda", "lambda^2*mu_", "lambda - mu_", "(lambda - mu_)^3",
                           "k*lambda^n + mu_^n", "atan(lambda/mu_)"}) {
    EXPECT_THROW(written_facts(text, k_and_n), expression::Unsuitable) << text;
    EXPECT_THROW(written_plane(text, k_and_n, {1.0, 2.0}), expression::Unsuitable) << text;
  }
  EXPECT_THROW(written_plane("xi^2", k_and_n, {1.0, 2.0}), expression::Unsuitable);
}

/// What holds for one half of all parameters, or of all stretches, does not hold. Given values at
/// which it does hold it is undecided, and taken as not holding as well.
TEST(ExpressionFacts, HoldWhateverTheParametersAre) {
  struct Branching {
    const char* text;
    Verdict Facts::*fact;
    double holds;  ///< for such k
  };
  const Branching all[] = {
      {"k*t^2 + n*log(d) + rho^2 + min(k, 0)*log(d)*log(rho)", &Facts::separable, 0.5},
      {"t^2 + n*rho + max(k, 0)*d*rho", &Facts::separable, -0.5},
      {"n*t^2 + min(k, 0)*alpha", &Facts::isotropic, 0.5},
      {"n*t^2 + min(k, 0)*alpha", &Facts::shear_free, 0.5},
      {"n*t^2 + (sqrt(k^2) - k)*alpha", &Facts::isotropic, 0.5},
      {"n*t^2 + ((k^2)^0.5 - k)*alpha", &Facts::isotropic, 0.5},
      {"n*t^2 + ((k^4)^0.25 - k)*alpha", &Facts::isotropic, 0.5},
      {"n*t^2 + (exp(log(k^2)/2) - k)*alpha", &Facts::shear_free, 0.5},
      {"n*t^2 + (atan(k) + atan(1/k) - pi/2)*alpha", &Facts::isotropic, 0.5},
      {"n*t^2 + (abs(k) + k)*xi", &Facts::isotropic, -0.5},
      {"n*xi + (abs(k) - k)*alpha^3", &Facts::even, 0.5}};
  for (const Branching& each : all) {
    const auto verdict = [&](const std::vector<double>& values) {
      const auto parsed = parse_expression(each.text, k_and_n, ExpressionSlot::coupled);
      return expression::facts(parsed.expression, ExpressionSlot::coupled, values).*each.fact;
    };
    EXPECT_EQ(verdict({}), Verdict::refuted) << each.text;
    EXPECT_EQ(verdict({-each.holds, 1.25}), Verdict::refuted) << each.text;
    EXPECT_EQ(verdict({each.holds, 1.25}), Verdict::undecided) << each.text;
  }
  EXPECT_EQ(written_facts("t^2 + alpha*exp(-200*(xi - 0.2))", {}).isotropic, Verdict::refuted);
  EXPECT_EQ(written_facts("t^2 + alpha*exp(-200/xi)", {}).isotropic, Verdict::refuted);
  EXPECT_THROW(written_facts("k*lambda + abs(k)*mu_", k_and_n), expression::Unsuitable);
  EXPECT_THROW(written_facts("lambda + mu_ + min(k, 0)*lambda", k_and_n), expression::Unsuitable);
}

/// Branches that enter as one number do no harm, nor do those that no parameter decides.
TEST(ExpressionFacts, HoldBesideBranches) {
  for (const char* text :
       {"abs(k)*t^2 + max(n, 0)*log(d) + min(k, n)*rho",
        "sqrt(abs(k))*(xi^3 + zeta^3 + 3*alpha^2*t)",
        "min(k, 0)*(xi*zeta - alpha^2) + k*t^2 + n*rho", "lambda^abs(n) + mu_^abs(n) + rho",
        "sqrt(2)*sqrt(2)*(xi^2 + alpha^2) + 2*(zeta^2 + alpha^2)",
        "(k^2)^0.25*(lambda - mu_)^2 + abs(n)*(lambda^k + mu_^k)"}) {
    for (const std::vector<double>& values :
         {std::vector<double>{}, {-1.25, 3.0}, {100.0, -0.25}}) {
      const auto parsed = parse_expression(text, k_and_n, ExpressionSlot::coupled);
      const Facts facts = expression::facts(parsed.expression, ExpressionSlot::coupled, values);
      EXPECT_TRUE(facts.is_isotropic()) << text;
      EXPECT_TRUE(facts.is_separable()) << text;
    }
  }
  const auto parsed = parse_expression("k*alpha + n*xi", k_and_n, ExpressionSlot::coupled);
  const std::vector<double> one{1.0};
  EXPECT_THROW(expression::facts(parsed.expression, ExpressionSlot::coupled, one),
               std::invalid_argument);
}

/// k |lambda - mu_| is symmetric and has a kink, however it is written.
TEST(ExpressionFacts, KinksAtTheCircleAreRefused) {
  for (const char* text :
       {"k*sqrt((lambda - mu_)^2)", "((lambda - mu_)^2)^n", "((lambda^n - mu_^n)^2)^1.5",
        "log((lambda - mu_)^2)", "sqrt(t^2 - 4*d)", "d*sqrt(I1/2 - d)", "1/(t^2 - 4*d)",
        "(lambda^3 - mu_^3)/(lambda - mu_)", "sqrt(log(lambda/mu_)^2)"}) {
    EXPECT_THROW(written_facts(text, k_and_n), expression::Unsuitable) << text;
    EXPECT_THROW(written_plane(text, k_and_n, {1.0, 2.0}), expression::Unsuitable) << text;
    const std::string beside = std::string(text) + " + alpha";
    EXPECT_THROW(written_facts(beside, k_and_n), expression::Unsuitable) << beside;
    EXPECT_THROW(written_anisotropic(beside, k_and_n, {1.0, 2.0}), expression::Unsuitable)
        << beside;
  }
  EXPECT_THROW(written_plane("sqrt((xi - zeta)^2 + 4*alpha^2)", {}, {}), expression::Unsuitable);
  for (const char* text : {"((lambda - mu_)^2)^2.5", "sqrt((lambda - mu_)^2 + d)",
                           "sqrt(1 + log(lambda/mu_)^2)", "log(t/2)/d", "(t - 2*sqrt(d))^2"})
    EXPECT_NO_THROW(written_facts(text, k_and_n)) << text;
}

/// V_alpha of a kink is 0 times infinity at alpha = 0.
TEST(ExpressionFacts, NothingIsKnownOfAKinkAtNoShear) {
  for (const char* text : {"k*sqrt(alpha^2) + xi", "xi*sqrt(alpha^2)", "(alpha^2)^0.5*d + n*xi",
                           "alpha*log(alpha^2) + xi"}) {
    const Facts facts = written_facts(text, k_and_n);
    EXPECT_FALSE(facts.is_shear_free() || facts.is_even()) << text;
  }
  EXPECT_TRUE(written_facts("k*sqrt(1 + alpha^2) + xi", k_and_n).is_even());
}

/// An isotropic potential is the same whichever of its two ways it is evaluated.
TEST(ExpressionFacts, IsotropicExpressionsInTheStretchAndInItsInvariants) {
  Random random(431);
  for (const char* text :
       {"xi^3 + zeta^3 + 3*alpha^2*(xi + zeta)", "exp(-(xi - zeta)^2 - 4*alpha^2)*d + log(d*rho)",
        "k*(lambda^n + mu_^n) + rho*t^2", "log(lambda)^2 + log(mu_)^2"}) {
    const auto one = written_anisotropic(text, k_and_n, {1.25, 1.75});
    const auto other = written_coupled(text, k_and_n, {1.25, 1.75});
    for (int trial = 0; trial < 20; ++trial) {
      const Stretch q = random.stretch();
      const auto a = one.derivatives<2>(q);
      const auto w = other.evaluate<2>(planar_invariants(q), q.rho);
      const auto b = in_stretch<2>(w, q);
      const double size = 1.0 + b.hessian.cwiseAbs().maxCoeff() + b.gradient.cwiseAbs().maxCoeff();
      EXPECT_NEAR(a.value, b.value, 1e-12 * size) << text;
      EXPECT_TRUE(all_agree(at(text, q), Vector4<double>(b.gradient), Vector4<double>(a.gradient),
                            1e-11 * size));
      EXPECT_TRUE(all_agree(at(text, q), Matrix4<double>(b.hessian), Matrix4<double>(a.hessian),
                            1e-11 * size));
    }
  }
}

/// A domain that is not that of the mirror image leaves open whether the potential is.
TEST(ExpressionFacts, EvennessAsksForTheDomainToo) {
  const auto even = [](std::vector<std::string> domain) {
    const Formula formula{{}, std::move(domain), "I1 + rho^2 - 2*log(d*rho) + k*alpha^2"};
    return facts(parse_formula(formula, k_and_n, ExpressionSlot::coupled).expression,
                 ExpressionSlot::coupled, {})
        .even;
  };
  EXPECT_TRUE(Facts::holds(even({})));
  EXPECT_TRUE(Facts::holds(even({"alpha^2 < 0.01", "xi < 3"})));
  EXPECT_EQ(even({"alpha > -0.05"}), Verdict::undecided);
}

}  // namespace
}  // namespace stationary
