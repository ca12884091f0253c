// What is found out about a potential: symmetric, isotropic, free of shear, separable, each where
// it is so and where it is not.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/expression/facts.hpp"
#include "lib/potential_derivatives.hpp"
#include "tests/solver/written_potential.hpp"
#include "tests/support/law.hpp"
#include "tests/support/random_states.hpp"

namespace stationary {
namespace {

using namespace support;
using expression::Facts;
using expression::Verdict;

const std::vector<std::string> names{"k", "n"};

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
    const Facts facts = written_facts(known.text, names);
    EXPECT_EQ(facts.is_isotropic(), known.isotropic) << known.text;
    EXPECT_EQ(facts.is_shear_free(), known.shear_free) << known.text;
    EXPECT_EQ(facts.is_separable(), known.separable) << known.text;
  }
}

TEST(ExpressionFacts, SayHowTheyWereEstablished) {
  EXPECT_EQ(written_facts("k*t", names).isotropic, Verdict::term_by_term);
  const Facts facts = written_facts("xi^3 + zeta^3 + 3*alpha^2*(xi + zeta)", names);
  EXPECT_EQ(facts.isotropic, Verdict::at_points);
  EXPECT_EQ(facts.sentences,
            (std::vector<std::string>{
                "made of alpha, xi, zeta",
                "isotropic (a function of t, d and rho): holds at pseudo-random points to 20 "
                "digits",
                "separable (a potential of the plane and one of the thickness): holds term by "
                "term"}));
  EXPECT_EQ(written_facts("k*alpha", names).shear_free, Verdict::refuted);
  // Defined nowhere.
  EXPECT_EQ(written_facts("sqrt(-xi)", names).isotropic, Verdict::undecided);
}

TEST(ExpressionFacts, UnsymmetricFunctionsOfTheStretchesAreRefused) {
  for (const char* text : {"lambda", "lambda^2*mu_", "lambda - mu_", "(lambda - mu_)^3",
                           "k*lambda^n + mu_^n", "atan(lambda/mu_)"}) {
    EXPECT_THROW(written_facts(text, names), expression::Unsuitable) << text;
    EXPECT_THROW(written_plane(text, names, {1.0, 2.0}), expression::Unsuitable) << text;
  }
  EXPECT_THROW(written_plane("xi^2", names, {1.0, 2.0}), expression::Unsuitable);
}

/// An isotropic potential is the same whichever of its two ways it is evaluated.
TEST(ExpressionFacts, IsotropicExpressionsInTheStretchAndInItsInvariants) {
  Random random(431);
  for (const char* text :
       {"xi^3 + zeta^3 + 3*alpha^2*(xi + zeta)", "exp(-(xi - zeta)^2 - 4*alpha^2)*d + log(d*rho)",
        "k*(lambda^n + mu_^n) + rho*t^2", "log(lambda)^2 + log(mu_)^2"}) {
    const auto one = written_anisotropic(text, names, {1.25, 1.75});
    const auto other = written_coupled(text, names, {1.25, 1.75});
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

}  // namespace
}  // namespace stationary
