#include "solver/program/table/parallel_table.hpp"

#include <tbb/task_group.h>

#include <utility>

#include "solver/newton/available_threads.hpp"
#include "solver/newton/thread_arena.hpp"

namespace stationary {
namespace {

constexpr std::size_t batch_rows = 128;

}  // namespace

struct ParallelTableWriter::Batch {
  std::vector<TableRow> rows;
  std::unique_ptr<char[]> text =
      std::make_unique_for_overwrite<char[]>(batch_rows * RowFormat::longest_line);
  std::size_t size = 0;
  tbb::task_group group;
};

ParallelTableWriter::ParallelTableWriter(ByteSink& sink, std::vector<Column> columns,
                                         const std::optional<std::string>& parameter,
                                         const std::optional<std::string>& second, int threads)
    : RowSink(std::move(columns),
              std::size_t{parameter.has_value()} + std::size_t{second.has_value()}),
      sink_(&sink),
      format_(column_list(), parameter, second),
      arena_(arena_of(available_threads(threads))),
      most_(2 * static_cast<std::size_t>(threads)) {}

/// Of rows that are not wanted any more: nothing may still be at work on them.
ParallelTableWriter::~ParallelTableWriter() {
  for (const auto& batch : started_) arena_.execute([&] { batch->group.wait(); });
}

void ParallelTableWriter::put(const TableRow& row, TableChecksum& sum) {
  add_cells(row, sum);
  rows_.push_back(row);
  if (rows_.size() == batch_rows) start_batch();
}

void ParallelTableWriter::start_batch() {
  if (started_.size() == most_) write_oldest();
  std::unique_ptr<Batch> batch = spare_ ? std::move(spare_) : std::make_unique<Batch>();
  batch->rows.swap(rows_);
  rows_.clear();
  Batch* const own = batch.get();
  started_.push_back(std::move(batch));
  arena_.execute([&] {
    own->group.run([this, own] {
      char* at = own->text.get();
      RowTexts texts;
      for (const TableRow& row : own->rows) at = format_.line(row, texts, at);
      own->size = static_cast<std::size_t>(at - own->text.get());
    });
  });
}

void ParallelTableWriter::write_oldest() {
  write_header();
  Batch& batch = *started_.front();
  arena_.execute([&] { batch.group.wait(); });
  sink_->write({batch.text.get(), batch.size});
  spare_ = std::move(started_.front());
  started_.pop_front();
}

void ParallelTableWriter::write_header() {
  if (std::exchange(has_header_, true)) return;
  sink_->write(format_.header());
}

void ParallelTableWriter::flush() {
  if (!rows_.empty()) start_batch();
  while (!started_.empty()) write_oldest();
  write_header();
}

}  // namespace stationary
