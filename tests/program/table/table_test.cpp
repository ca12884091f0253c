// The table writer alone: header, order, empty cells, round trip, quoting.
#include "solver/program/table/table.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>

#include "solver/program/table/parallel_table.hpp"

namespace stationary {
namespace {

class Text : public ByteSink {
 public:
  void write(std::string_view bytes) override { text += bytes; }
  std::string text;
};

TEST(Table, ColumnNamesAreTheContract) {
  EXPECT_EQ(name(Column::stability), "class");
  EXPECT_EQ(name(mode_column(0, ModePart::re)), "re1");
  EXPECT_EQ(name(mode_column(4, ModePart::krein)), "krein5");
  for (const std::string_view each : column_names) EXPECT_EQ(name(*find_column(each)), each);
  EXPECT_FALSE(find_column("stability"));
}

TEST(Table, OrderIsTheContractsWhateverWasAsked) {
  const Column computed[] = {Column::energy, Column::branch, Column::xi};
  const std::string asked[] = {"xi", "growth", "branch"};
  EXPECT_THAT(select_columns(computed, asked), ::testing::ElementsAre(Column::branch, Column::xi));
  EXPECT_THAT(select_columns(computed, {}),
              ::testing::ElementsAre(Column::branch, Column::xi, Column::energy));
}

TEST(Table, AllColumnsAndTheParameter) {
  std::vector<Column> all;
  for (std::size_t k = 0; k < column_count; ++k) all.push_back(static_cast<Column>(k));
  Text sink;
  TableWriter table(sink, all, "body.J.0");
  TableRow row;
  table.write(row);
  row.branch = "iii";
  row.event = "fold-nu";
  row.stability = "stable";
  row.status = "solved";
  row.certified = "yes";
  row.class_certified = "no";
  row[Column::sheet] = 12;
  row[Column::point] = 4500000;
  row[Column::negative] = 0;
  row[mode_column(1, ModePart::krein)] = -1;
  row[Column::xi] = 0.1;
  row.parameter = 1e300;
  table.write(row);
  table.flush();
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_EQ(sink.text,
            "branch,sheet,point,event,nu1,nu2,nu3,alpha,xi,zeta,rho,lambda,mu,angle,pi1,pi2,pi3,"
            "energy,residual,compatibility,error_bound,class,growth,negative,re1,im1,krein1,re2,"
            "im2,krein2,re3,im3,krein3,re4,im4,krein4,re5,im5,krein5,omega,theta_dot,s3,p_theta,"
            "status,certified,class_certified,segment,criticality,side,pressure,body.J.0\n" +
                std::string(50, ',') +
                "\niii,12,4500000,fold-nu,,,,,0.1,,,,,,,,,,,,,stable,,0,,,,,,-1,,,,,,,,,,,,,,"
                "solved,yes,no,,,,,"
                "1e+300\n");
}

/// Names of a formula's numbers, and ratios of two, may be as long as they like.
TEST(Table, LongNamesOfParametersAreWhole) {
  for (const std::size_t length : {200U, 100'000U}) {
    const std::string name = "potential.coupled." + std::string(length, 'k');
    Text sink;
    TableWriter table(sink, {Column::xi}, name + "/" + name, name);
    table.write(TableRow());
    table.flush();
    EXPECT_EQ(sink.text, "xi," + name + "/" + name + "," + name + "\n,,\n");
  }
}

TEST(Table, EveryDoubleReadsBack) {
  std::mt19937_64 random(1);
  std::vector<double> values{0.1,  1.0, -2.5, 1e22, 1e23, 5e-324, 1.7976931348623157e308,
                             1e15, 1e16};
  for (int k = 0; k < 20000; ++k) {
    const double x = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
    if (std::isfinite(x)) values.push_back(x);
  }
  Text sink;
  TableWriter table(sink, {Column::xi});
  for (const double x : values) {
    TableRow row;
    row[Column::xi] = x;
    table.write(row);
  }
  table.flush();
  const char* at = sink.text.data() + sink.text.find('\n') + 1;
  const char* end = sink.text.data() + sink.text.size();
  for (const double x : values) {
    double back = 0.0;
    at = std::from_chars(at, end, back).ptr;
    EXPECT_EQ(back, x);
    ASSERT_EQ(*at++, '\n');
  }
  EXPECT_EQ(at, end);
}

TEST(Table, ZeroHasNoSign) {
  Text sink;
  TableWriter table(sink, {Column::alpha, Column::xi});
  TableRow row;
  row[Column::alpha] = -0.0;
  row[Column::xi] = 0.0;
  table.write(row);
  table.flush();
  EXPECT_EQ(sink.text, "alpha,xi\n0,0\n");
}

TEST(Table, TextsAreQuotedWhereTheyMustBe) {
  Text sink;
  TableWriter table(sink, {Column::event});
  TableRow row;
  row.event = "a,\"b\"";
  table.write(row);
  table.flush();
  EXPECT_EQ(sink.text, "event\n\"a,\"\"b\"\"\"\n");
}

/// Rows whose cells are of every length.
std::vector<TableRow> random_rows(std::size_t count) {
  std::mt19937_64 random(7);
  std::vector<TableRow> out(count);
  for (TableRow& row : out) {
    row.branch = random() % 2 == 0 ? "i" : "iii";
    for (double& number : row.numbers) {
      number = std::bit_cast<double>(random());
      if (random() % 4 == 0) number = std::numeric_limits<double>::quiet_NaN();
    }
    for (std::size_t k = 0; k < column_count; ++k)
      if (cell_kind(static_cast<Column>(k)) == CellKind::count)
        row.numbers[k] = static_cast<double>(random() % 1000);
    row.parameter = static_cast<double>(random() % 100);
  }
  return out;
}

std::vector<Column> every_column() {
  std::vector<Column> out;
  for (std::size_t k = 0; k < column_count; ++k) out.push_back(static_cast<Column>(k));
  return out;
}

TEST(RowTexts, ANumberThatWasWrittenBeforeHasTheTextOfItsOwn) {
  const RowFormat format(every_column(), "p", "q");
  std::mt19937_64 random(11);
  std::vector<TableRow> rows = random_rows(400);
  long repeated = 0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    TableRow& row = rows[k];
    for (std::size_t c = 0; c < column_count; ++c) {
      if (cell_kind(static_cast<Column>(c)) != CellKind::number || random() % 2 == 0) continue;
      row.numbers[c] = random() % 2 == 0 ? rows[k - 1].numbers[c] : row[Column::xi];
      if (random() % 8 == 0) row.numbers[c] = -row.numbers[c];
      ++repeated;
    }
    row.second_parameter = row[Column::nu2];
  }
  EXPECT_GT(repeated, 4000);
  RowTexts texts;
  std::vector<char> line(RowFormat::longest_line);
  const auto text = [](double value) {
    return std::isnan(value) ? std::string() : value == 0.0 ? "0" : fmt::format("{}", value);
  };
  for (const TableRow& row : rows) {
    std::string expected;
    for (const Column c : every_column()) {
      if (cell_kind(c) == CellKind::text) expected += text_of(row, c);
      if (cell_kind(c) == CellKind::count) expected += fmt::format("{}", static_cast<long>(row[c]));
      if (cell_kind(c) == CellKind::number) expected += text(row[c]);
      expected += ',';
    }
    expected += text(row.parameter) + ',' + text(row.second_parameter) + '\n';
    const char* const end = format.line(row, texts, line.data());
    EXPECT_EQ(std::string_view(line.data(), end), expected);
  }
}

TEST(ParallelTable, BytesAreThoseOfOneThread) {
  for (const std::size_t count : {0U, 1U, 127U, 128U, 129U, 5000U}) {
    const std::vector<TableRow> rows = random_rows(count);
    Text alone;
    TableWriter writer(alone, every_column(), "p");
    for (const TableRow& row : rows) writer.write(row);
    writer.flush();
    for (const int threads : {1, 2, 5}) {
      Text together;
      ParallelTableWriter parallel(together, every_column(), "p", std::nullopt, threads);
      for (const TableRow& row : rows) parallel.write(row);
      EXPECT_TRUE(count < 5000 || !together.text.empty());  // what is done is written on the way
      parallel.flush();
      EXPECT_TRUE(together.text == alone.text) << count << " rows, " << threads << " threads";
      EXPECT_EQ(parallel.rows(), count);
      EXPECT_EQ(parallel.checksum().text(), writer.checksum().text());
    }
  }
}

/// A disk that becomes full.
class Full : public ByteSink {
 public:
  void write(std::string_view bytes) override {
    written += bytes.size();
    if (written > 200'000) throw std::runtime_error("no space left");
  }
  std::size_t written = 0;
};

TEST(ParallelTable, WhatTheSinkThrowsIsThrown) {
  Full sink;
  ParallelTableWriter table(sink, every_column(), std::nullopt, std::nullopt, 2);
  EXPECT_THROW(
      {
        for (const TableRow& row : random_rows(5000)) table.write(row);
        table.flush();
      },
      std::runtime_error);
}

TEST(ParallelTable, OneThatIsNotWantedAnyMoreWritesNothing) {
  Text sink;
  {
    ParallelTableWriter table(sink, every_column(), std::nullopt, std::nullopt, 2);
    for (const TableRow& row : random_rows(400)) table.write(row);
  }
  EXPECT_EQ(sink.text, "");
}

}  // namespace
}  // namespace stationary
