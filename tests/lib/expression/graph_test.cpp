// What the graph of an expression promises: one node for equal subexpressions, nothing folded that
// would round, derivatives whose structure is what their header says.
#include "lib/expression/graph.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "lib/expression/differentiate.hpp"
#include "lib/expression/principal_pairs.hpp"
#include "lib/formula/expression.hpp"

namespace stationary::expression {
namespace {

class GraphTest : public ::testing::Test {
 protected:
  Graph g;
  NodeId t = g.variable(Variable::t);
  NodeId d = g.variable(Variable::d);
  NodeId mu = g.parameter(0);
  NodeId number(double x) { return g.number(x); }
};

TEST_F(GraphTest, EqualExpressionsAreOneNode) {
  EXPECT_EQ(g.add({t, d}), g.add({d, t}));
  EXPECT_EQ(g.multiply({g.add({t, d}), mu}), g.multiply({mu, g.add({d, t})}));
  EXPECT_EQ(g.apply(Function::log, g.multiply({t, d})), g.apply(Function::log, g.multiply({d, t})));
  EXPECT_EQ(g.power(g.power(t, 2), 3), g.power(t, 6));
  EXPECT_NE(g.subtract({t, d}), g.subtract({d, t}));
}

TEST_F(GraphTest, WhatCancelsIsGone) {
  EXPECT_TRUE(g.is_zero(g.subtract({g.add({t, d}), g.add({d, t})})));
  EXPECT_TRUE(g.is_literal(g.divide({t, t}), 1.0));
  EXPECT_EQ(g.divide({g.multiply({t, d}), d}), t);
  EXPECT_TRUE(g.is_zero(g.subtract({g.multiply({mu, t}), g.multiply({t, mu})})));
  EXPECT_EQ(g.multiply({number(2.0), g.divide({g.multiply({mu, t}), number(2.0)})}),
            g.multiply({mu, t}));
}

/// 0 times what is infinite or no number is no 0.
TEST_F(GraphTest, NothingTimesInfinityStays) {
  const NodeId zero = g.zero();
  const NodeId infinite = g.divide({g.one(), zero});
  const NodeId power = g.power(zero, mu);
  for (const NodeId x :
       {infinite, g.apply(Function::log, zero), power, g.number(INFINITY), g.power(zero, -2),
        g.add({infinite, mu}), g.multiply({infinite, mu}), g.multiply({t, infinite}),
        g.apply(Function::exp, g.multiply({t, infinite})), g.subtract({infinite, infinite})}) {
    EXPECT_FALSE(g.is_zero(g.multiply({zero, x})));
    EXPECT_FALSE(g.is_zero(g.multiply({x, zero})));
    EXPECT_FALSE(g.is_zero(g.subtract({x, x})));
  }
  EXPECT_TRUE(g.is_zero(g.multiply({zero, g.divide({g.one(), mu})})));
  EXPECT_TRUE(g.is_zero(g.multiply({zero, g.power(zero, number(1.5))})));
  EXPECT_TRUE(g.is_zero(g.multiply({zero, g.power(t, -1)})));
}

TEST_F(GraphTest, LiteralsAreCombinedOnlyWhereThatIsExact) {
  EXPECT_EQ(g.add({number(0.25), number(1.5)}), number(1.75));
  EXPECT_EQ(g[g.add({number(0.1), number(0.2)})].kind, Kind::coefficient_sum);
  EXPECT_EQ(g[g.multiply({number(0.1), number(0.1)})].kind, Kind::coefficient_product);
  EXPECT_EQ(g.divide({number(3.0), number(4.0)}), number(0.75));
  EXPECT_EQ(g[g.divide({number(1.0), number(3.0)})].kind, Kind::coefficient_quotient);
  // What only rounds to a double is no double.
  const NodeId tenth = g.rounded_number(0.1, Decimal());
  EXPECT_NE(tenth, number(0.1));
  EXPECT_NE(g[g.add({tenth, g.rounded_number(0.1, Decimal())})].kind, Kind::literal);
}

TEST_F(GraphTest, DerivativeOfTheLogarithmOfTheDeterminantIsOne) {
  Differentiation by_l(g, Coordinate::log_d);
  EXPECT_TRUE(g.is_literal(by_l(g.apply(Function::log, d)), 1.0));
  EXPECT_TRUE(g.is_literal(by_l(g.apply(Function::log, g.power(d, -2))), -2.0));
  EXPECT_EQ(by_l(d), d);
  EXPECT_EQ(by_l(g.power(d, 3)), g.multiply({number(3.0), g.power(d, 3)}));
  EXPECT_EQ(by_l(g.apply(Function::sqrt, d)),
            g.multiply({number(0.5), g.apply(Function::sqrt, d)}));
  EXPECT_TRUE(g.is_zero(by_l(t)));
}

TEST_F(GraphTest, DerivativesOfFunctions) {
  Differentiation by_t(g, Coordinate::t);
  EXPECT_EQ(by_t(g.apply(Function::exp, t)), g.apply(Function::exp, t));
  EXPECT_EQ(by_t(g.apply(Function::sin, t)), g.apply(Function::cos, t));
  EXPECT_EQ(by_t(g.apply(Function::log, t)), g.power(t, -1));
  EXPECT_EQ(by_t(g.power(t, -1)), g.negate(g.power(t, -2)));
  EXPECT_EQ(by_t(g.power(t, mu)), g.multiply({mu, g.power(t, g.subtract({mu, g.one()}))}));
}

TEST_F(GraphTest, NonSmoothFunctionsAreOfCoefficientsOnly) {
  EXPECT_NO_THROW(g.apply(Function::abs, mu));
  EXPECT_NO_THROW(g.minimum({mu, number(1.0)}));
  EXPECT_THROW(g.apply(Function::abs, t), NotSmooth);
  EXPECT_THROW(g.minimum({t, mu}), NotSmooth);
  EXPECT_THROW(g.maximum({mu, d}), NotSmooth);
}

TEST_F(GraphTest, ExponentsAreBounded) {
  EXPECT_NO_THROW(g.power(t, 4096));
  EXPECT_THROW(g.power(t, 4097), TooLarge);
  EXPECT_THROW(g.multiply({g.power(t, 4000), g.power(t, 4000)}), TooLarge);
}

/// lambda = t/2 + s, mu = t/2 - s: symmetric functions have no odd part.
TEST_F(GraphTest, SymmetricFunctionsOfTheStretchesAreEven) {
  const NodeId lambda = g.variable(Variable::lambda);
  const NodeId small = g.variable(Variable::mu);
  EXPECT_EQ(split_at_circle(g, g.add({lambda, small})).even, t);
  EXPECT_EQ(split_at_circle(g, g.multiply({lambda, small})).even, d);
  EXPECT_EQ(split_at_circle(g, g.power(g.subtract({lambda, small}), 2)).even,
            g.variable(Variable::discriminant));
  const auto log_squared = [&](NodeId x) { return g.power(g.apply(Function::log, x), 2); };
  EXPECT_TRUE(g.is_zero(split_at_circle(g, g.add({log_squared(lambda), log_squared(small)})).odd));
  EXPECT_TRUE(g.is_zero(split_at_circle(g, g.add({g.power(lambda, mu), g.power(small, mu)})).odd));
  EXPECT_FALSE(g.is_zero(split_at_circle(g, lambda).odd));
}

TEST_F(GraphTest, BoundsOfATapeAreErrors) {
  Expression e;
  NodeId sum = e.graph.zero();
  const NodeId x = e.graph.variable(Variable::t);
  for (int k = 1; k < 300; ++k)
    sum =
        e.graph.add({sum, e.graph.apply(Function::sin, e.graph.multiply({e.graph.number(k), x}))});
  e.root = sum;
  EXPECT_THROW(planar_tape(e), TooLarge);
}

}  // namespace
}  // namespace stationary::expression
