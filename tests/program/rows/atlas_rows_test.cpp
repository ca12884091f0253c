// An interruption while the sheets of an atlas are written: what is left is neither written nor proven,
// and the records of all sheets are there for the summary.
#include "solver/program/rows/atlas_rows.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "solver/program/case/case_atlas.hpp"
#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

/// Takes rows, and asks for the end after some.
class Interrupting final : public RowSink {
 public:
  Interrupting(std::atomic<bool>& stop, std::size_t after)
      : RowSink(equilibrium_columns({.certificate = true}), 0), stop_(stop), after_(after) {}

 private:
  void put(const TableRow&, TableChecksum&) override { stop_ = stop_ || rows() >= after_; }

  std::atomic<bool>& stop_;
  std::size_t after_;
};

TEST(AtlasRows, EndWithTheSheetThatIsInterrupted) {
  const Case input = read_case(shipped("fold.toml"));
  AtlasOptions how = atlas_options(input, 4, false);
  Atlas found = atlas(input.body, input.potential, how);
  ASSERT_GE(found.sheets.size(), 2U);
  const auto first = found.sheets.front().rows.size();

  std::atomic<bool> stop{false};
  Interrupting sink(stop, 3);
  std::vector<SheetRecord> records;
  const CurveProofs proofs =
      write_sheets({input.body, input.potential, true, {}, &stop}, found, &sink, records);
  EXPECT_TRUE(found.interrupted);
  EXPECT_EQ(sink.rows(), first);
  EXPECT_EQ(records.size(), found.sheets.size());
  EXPECT_GT(proofs.proven, 0);
  EXPECT_LE(proofs.rows, static_cast<long>(first));

  found.interrupted = false;
  stop = false;
  Interrupting all(stop, 1'000'000);
  records.clear();
  write_sheets({input.body, input.potential, false, {}, &stop}, found, &all, records);
  EXPECT_FALSE(found.interrupted);
  EXPECT_GT(all.rows(), first);

  // Interrupted before: what it has found is written whole.
  found.interrupted = true;
  stop = true;
  Interrupting found_so_far(stop, 1'000'000);
  records.clear();
  write_sheets({input.body, input.potential, false, {}, &stop}, found, &found_so_far, records);
  EXPECT_EQ(found_so_far.rows(), all.rows());
}

}  // namespace
}  // namespace stationary::testing
