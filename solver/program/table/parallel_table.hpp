// A table of CSV by several threads: rows are made into text in batches, many at once, and written in
// their order. The bytes are TableWriter's; a number takes its thread some 30 ns to be written out, a
// row of forty about as long as it takes to be computed, or longer.
#pragma once

#include <tbb/task_arena.h>

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "solver/program/table/table.hpp"

namespace stationary {

class ParallelTableWriter final : public RowSink {
 public:
  /// As of RowFormat; threads >= 1.
  ParallelTableWriter(ByteSink& sink, std::vector<Column> columns,
                      const std::optional<std::string>& parameter,
                      const std::optional<std::string>& second, int threads);
  ~ParallelTableWriter() override;

  /// Hands the rest to the sink. Without it the last rows are lost.
  void flush();

 private:
  struct Batch;

  void put(const TableRow& row, TableChecksum& sum) override;
  void start_batch();
  void write_oldest();
  void write_header();

  ByteSink* sink_;
  RowFormat format_;
  tbb::task_arena& arena_;
  std::size_t most_;                            ///< batches not yet written
  std::vector<TableRow> rows_;                  ///< of the batch to come
  std::deque<std::unique_ptr<Batch>> started_;  ///< the oldest first
  std::unique_ptr<Batch> spare_;                ///< written, its memory to be used again
  bool has_header_ = false;
};

}  // namespace stationary
