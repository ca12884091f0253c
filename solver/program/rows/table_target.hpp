// Where a computation's table goes, with its metadata: a file, or somebody's memory.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "solver/program/rows/metadata.hpp"
#include "solver/program/table/cell_table.hpp"
#include "solver/program/table/table.hpp"

namespace stationary {

class TableTarget {
 public:
  TableTarget() = default;
  TableTarget(const TableTarget&) = delete;
  TableTarget& operator=(const TableTarget&) = delete;
  virtual ~TableTarget() = default;

  /// Before anything is computed and after the case was found right: throws InputError where no
  /// table can be put.
  virtual void prepare() = 0;
  /// What its rows go to. parameters: headers of the trailing columns; rows: how many are expected,
  /// where that is known.
  virtual RowSink& open(const std::vector<Column>& columns,
                        const std::vector<std::string>& parameters = {},
                        std::optional<std::size_t> rows = std::nullopt) = 0;
  /// The same of a table with columns of any name.
  virtual CellTable& open(std::vector<CellColumn> columns) = 0;
  /// The table is complete. rows and checksum of the metadata are the table's.
  virtual void commit(Metadata metadata) = 0;
  /// After prepare(): whether it stays as a file with its metadata, which --resume can go on with.
  virtual bool can_be_resumed() const { return false; }
};

}  // namespace stationary
