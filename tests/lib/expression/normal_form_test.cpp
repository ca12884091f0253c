// The normal form of a formula: every spelling of a material is the same sum of terms, the sum is
// the balance itself, and what it cuts off a box holds no solution.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "lib/formula/term_table.hpp"
#include "solver/program/text/expression_parser.hpp"
#include "solver/proof/term_bounds.hpp"
#include "tests/support/bodies/published_materials.hpp"
#include "tests/support/bodies/random_states.hpp"
#include "tests/support/bodies/written_potential.hpp"

namespace stationary {
namespace {

using namespace support;
using expression::TermTable;

constexpr std::array coordinates{0, 1, 2};

std::vector<Interval> intervals(const std::vector<double>& values) {
  std::vector<Interval> out;
  for (const double each : values) out.push_back(Interval::decimal(each));
  return out;
}

std::shared_ptr<const TermTable> table_of(const std::string& text,
                                          const std::vector<std::string>& parameters,
                                          const std::vector<double>& values) {
  const auto parsed = parse_expression(text, parameters, ExpressionSlot::coupled);
  return expression::term_table(parsed.expression, coordinates, intervals(values));
}

TEST(NormalForm, EverySpellingHasTheSameTerms) {
  int compared = 0;
  for (const PublishedMaterial& material : published_materials()) {
    std::vector<std::size_t> first;
    for (const std::string& text : material.spellings) {
      const auto table = table_of(text, material.parameters, material.values);
      ASSERT_NE(table, nullptr) << text;
      std::vector<std::size_t> counts;
      for (const auto& row : table->force) counts.push_back(row.size());
      if (first.empty()) first = counts;
      EXPECT_EQ(counts, first) << material.name << ": " << text;
      ++compared;
    }
  }
  EXPECT_GE(compared, 48);
}

/// Of a box that holds a point: the rates are chosen so that the point solves the balance.
TEST(NormalForm, NoSolutionIsCutOff) {
  Random random(1207);
  int kept = 0;
  int narrowed = 0;
  for (const PublishedMaterial& material : published_materials()) {
    for (const std::string& text : material.spellings) {
      const auto table = table_of(text, material.parameters, material.values);
      const CoupledExpression<> model = written_coupled(text, material.parameters, material.values);
      for (int trial = 0; trial < 30; ++trial) {
        std::array<double, 3> x;
        for (double& each : x) each = random.log_uniform(0.4, 2.5);
        const auto b = model.log_balance(x[0], x[1], x[2], 0.0, 0.0, 0.0);
        const std::array g{b.g_xi, b.g_zeta, b.g_rho};
        if (!std::isfinite(g[0])) continue;
        std::array<Interval, 3> rates;
        for (std::size_t i = 0; i < 3; ++i) {
          const double rate = g[i] / (x[i] * x[i]);
          const double error = 1e-12 * (std::abs(rate) + 1.0);
          rates[i] = Interval(rate - error, rate + error);
        }
        std::array<Interval, 3> box;
        for (std::size_t i = 0; i < 3; ++i)
          box[i] = Interval(x[i] / random.log_uniform(1.001, 400.0),
                            x[i] * random.log_uniform(1.001, 400.0));
        const auto before = box;
        ASSERT_TRUE(TermBounds<3>(table, rates).contract(box)) << text << " trial " << trial;
        for (std::size_t i = 0; i < 3; ++i) {
          ASSERT_TRUE(box[i].lo <= x[i] && x[i] <= box[i].hi) << text << " trial " << trial;
          narrowed += box[i].hi - box[i].lo < 0.9 * (before[i].hi - before[i].lo);
        }
        ++kept;
      }
    }
  }
  EXPECT_GE(kept, 1000);
  EXPECT_GE(narrowed, 500);
}

TEST(NormalForm, PolesOfEitherSign) {
  const std::vector<std::string> names{"k"};
  Random random(1208);
  int compared = 0;
  int narrowed = 0;
  for (const char* text :
       {"I1 + rho^2 + 1/(d*rho) + k/(d - 2)", "I1 + rho^2 + 1/(d*rho) + k/(d - 2)^2",
        "I1 + 1/d + rho^2 + 1/rho + k/((rho - 2)*(d - 1.5))", "I1 + rho^2 - log(d*rho) + k*tan(d)",
        "I1 + rho^2 - log(d*rho) + k*sin(d*rho)*tanh(t)*atan(rho)",
        "I1 + rho^2 - log(d*rho) + k/((rho - 2)*(d - 1.5)*(d*rho - 1))",
        "I1 + rho^2 - log(d*rho) + k*log(d + rho)*t",
        "I1 + rho^2 - log(d*rho) + k*log(d + rho)*sqrt(d + rho)*tan(d)"}) {
    const auto table = table_of(text, names, {0.3});
    ASSERT_NE(table, nullptr) << text;
    const CoupledExpression<> model = written_coupled(text, names, {0.3});
    for (int trial = 0; trial < 200; ++trial) {
      std::array<double, 3> x;
      for (double& each : x) each = random.log_uniform(0.4, 3.0);
      const auto b = model.log_balance(x[0], x[1], x[2], 0.0, 0.0, 0.0);
      const std::array g{b.g_xi, b.g_zeta, b.g_rho};
      std::array<Interval, 3> rates;
      std::array<Interval, 3> box;
      for (std::size_t i = 0; i < 3; ++i) {
        const double rate = g[i] / (x[i] * x[i]);
        const double error = 1e-9 * (std::abs(rate) + 1.0);
        rates[i] = Interval(rate - error, rate + error);
        box[i] = Interval(x[i] / random.log_uniform(1.001, 100.0),
                          x[i] * random.log_uniform(1.001, 100.0));
      }
      const auto before = box;
      ASSERT_TRUE(TermBounds<3>(table, rates).contract(box)) << text << " trial " << trial;
      for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_TRUE(box[i].lo <= x[i] && x[i] <= box[i].hi) << text << " trial " << trial;
        narrowed += box[i].hi - box[i].lo < 0.9 * (before[i].hi - before[i].lo);
      }
      ++compared;
    }
  }
  EXPECT_EQ(compared, 1600);
  EXPECT_GE(narrowed, 550);
}

}  // namespace
}  // namespace stationary
