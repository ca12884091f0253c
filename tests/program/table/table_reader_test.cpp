// The table reader alone: what it accepts of CSV, and where it says a file is wrong.
#include "solver/program/table/table_reader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "solver/program/table/table.hpp"
#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

using ::testing::ElementsAre;

TableReader reader(const std::string& csv) {
  return {std::make_unique<std::istringstream>(csv), "x.csv"};
}

/// All cells, row by row.
std::vector<std::vector<std::string>> all_cells(const std::string& csv) {
  TableReader table = reader(csv);
  std::vector<std::vector<std::string>> out;
  while (table.next()) {
    out.emplace_back();
    for (std::size_t k = 0; k < table.columns().size(); ++k) out.back().emplace_back(table.text(k));
  }
  return out;
}

/// The message with which a text is refused.
std::string refusal(const std::string& csv) {
  try {
    TableReader table = reader(csv);
    while (table.next())
      for (std::size_t k = 0; k < table.columns().size(); ++k) (void)table.number(k);
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

TEST(TableReader, RowsByColumn) {
  TableReader table = reader("branch,xi,zeta\ni,1.5,\nii,-2e-300,0.1\n");
  EXPECT_THAT(table.columns(), ElementsAre("branch", "xi", "zeta"));
  EXPECT_EQ(table.column("zeta"), 2U);
  EXPECT_FALSE(table.column("rho"));
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.text(0), "i");
  EXPECT_EQ(table.number(1), 1.5);
  EXPECT_TRUE(std::isnan(table.number(2)));
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.text(0), "ii");
  EXPECT_EQ(table.number(1), -2e-300);
  EXPECT_EQ(table.number(2), 0.1);
  EXPECT_FALSE(table.next());
}

TEST(TableReader, EndsOfLines) {
  const auto expected = ElementsAre(ElementsAre("1", "2"), ElementsAre("3", ""));
  EXPECT_THAT(all_cells("a,b\n1,2\n3,\n"), expected);
  EXPECT_THAT(all_cells("a,b\r\n1,2\r\n3,\r\n"), expected);
  EXPECT_THAT(all_cells("a,b\n1,2\n3,"), expected);
  EXPECT_THAT(all_cells("\xEF\xBB\xBF"
                        "a,b\n1,2\n3,\n"),
              expected);
}

TEST(TableReader, Quotes) {
  EXPECT_THAT(all_cells("a,\"b\"\n\"x,\"\"y\"\"\",\"\"\n\"two\nlines\",\"\"\"\"\n"),
              ElementsAre(ElementsAre("x,\"y\"", ""), ElementsAre("two\nlines", "\"")));
}

TEST(TableReader, ReadsWhatTheWriterWrites) {
  struct Text : ByteSink {
    void write(std::string_view bytes) override { text += bytes; }
    std::string text;
  } sink;
  TableWriter writer(sink, {Column::event, Column::xi}, "body.J.0");
  TableRow row;
  row.event = "a,\"b\"";
  row[Column::xi] = std::numeric_limits<double>::denorm_min();
  row.parameter = 0.1;
  writer.write(row);
  writer.flush();
  TableReader table = reader(sink.text);
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.text(0), "a,\"b\"");
  EXPECT_EQ(table.number(1), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(table.number(2), 0.1);
}

TEST(TableReader, SaysWhereAFileIsWrong) {
  EXPECT_EQ(refusal(""), "x.csv: found an empty file; expected a table with a header");
  EXPECT_EQ(refusal("a,b\n1,2\n3\n"), "x.csv:3:1: found 1 cell; expected 2, as in the header");
  EXPECT_EQ(refusal("a,b\n1,2,3\n"), "x.csv:2:1: found 3 cells; expected 2, as in the header");
  EXPECT_EQ(refusal("a,b\n\n"), "x.csv:2:1: found 1 cell; expected 2, as in the header");
  EXPECT_EQ(refusal("a,b\n1,2x\n"),
            "x.csv:2:3: b: found \"2x\"; expected a number or an empty cell");
  EXPECT_EQ(refusal("a,b\n\"1\n\",2\n").substr(0, 12), "x.csv:2:1: a");
  // Lines are counted, also those within a cell.
  EXPECT_EQ(refusal("\"a\n\",b\n1,2\nx,2\n").substr(0, 9), "x.csv:4:1");
  EXPECT_EQ(refusal("a\n1,5\n").substr(0, 9), "x.csv:2:1");
  EXPECT_EQ(refusal("a,a\n"), "x.csv:1:3: found the column \"a\" twice; expected each once");
  EXPECT_EQ(refusal("a,,b\n"), "x.csv:1:3: found a column without a name; expected a header");
  EXPECT_EQ(refusal("a\n\"1\n2\n"),
            "x.csv:2:1: found a quoted cell without its end; expected a closing quote");
  EXPECT_EQ(refusal("a\n\"1\"2\n"),
            "x.csv:2:4: found text after a quoted cell; expected a comma or the end of the line");
  EXPECT_EQ(refusal("a\n1\"2\"\n"),
            "x.csv:2:2: found a quote within a cell; expected the whole cell in quotes");
  EXPECT_EQ(refusal("a\n1e999\n").substr(0, 9), "x.csv:2:1");
}

TEST(TableReader, FilesThatCannotBeRead) {
  const TemporaryDirectory directory;
  EXPECT_THROW(TableReader{directory.path()}, InputError);
  EXPECT_THROW(TableReader{directory / "none"}, InputError);
}

}  // namespace
}  // namespace stationary::testing
