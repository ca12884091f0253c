// A row has what its columns need, as a row of all columns has it, and nothing else was computed.
#include "solver/program/rows/equilibrium_row.hpp"

#include <gtest/gtest.h>

namespace stationary {
namespace {

constexpr double plane[] = {1.0, 2.0};
constexpr double thickness[] = {1.0, 3.0};
const Problem disc(Body(1.0, 1.7, 0.6),
                   Potential(Potential::planar("reciprocal-determinant", plane),
                             Potential::thickness("reciprocal-quadratic", thickness)),
                   Branch::i);

TableRow row_with(const ColumnSet& wanted) {
  TableRow row;
  fill_row("i", disc.body(), disc.potential(), solve(disc, 0.5), wanted, row);
  return row;
}

struct Part {
  std::vector<Column> columns;
};
const Part parts[] = {{{Column::lambda, Column::mu, Column::angle}},
                      {{Column::pi1, Column::pi2, Column::pi3}},
                      {{Column::energy}}};

TEST(EquilibriumRow, WhatNoColumnNeedsIsNotComputed) {
  const TableRow bare = row_with({});
  for (const Part& part : parts)
    for (const Column c : part.columns) EXPECT_TRUE(std::isnan(bare[c])) << name(c);
  EXPECT_FALSE(std::isnan(bare[Column::xi]));
}

TEST(EquilibriumRow, OneColumnBringsItsPartAlone) {
  const TableRow all = row_with(ColumnSet::all());
  for (const Part& wanted : parts) {
    for (const Column one : wanted.columns) {
      const TableRow row = row_with(ColumnSet({&one, 1}));
      for (const Part& part : parts) {
        for (const Column c : part.columns) {
          if (&part == &wanted) {
            EXPECT_EQ(row[c], all[c]) << name(c) << " for " << name(one);
          } else {
            EXPECT_TRUE(std::isnan(row[c])) << name(c) << " for " << name(one);
          }
        }
      }
    }
  }
  EXPECT_NE(all[Column::pi1], 0.0);
}

TEST(ColumnSet, HasWhatItIsMadeOf) {
  const std::vector<Column> two{Column::branch, Column::class_certified};
  const ColumnSet set(two);
  for (std::size_t k = 0; k < column_count; ++k) {
    const auto c = static_cast<Column>(k);
    EXPECT_EQ(set.has(c), c == two[0] || c == two[1]) << name(c);
    EXPECT_TRUE(ColumnSet::all().has(c));
    EXPECT_FALSE(ColumnSet().has(c));
  }
  EXPECT_TRUE(set.has_any(Column::branch, Column::xi));
  EXPECT_TRUE(set.has_any(Column::certified, Column::class_certified));
  EXPECT_FALSE(set.has_any(Column::sheet, Column::certified));
}

}  // namespace
}  // namespace stationary
