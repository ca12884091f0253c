// The tables of all atlases of a grid in one HDF5 file, a group a cell by the number of its row from 1, and
// those of the parts of a grid in one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/rows/metadata.hpp"
#include "solver/program/table/atomic_file.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/table/row_pack.hpp"
#include "solver/program/tiles/parts.hpp"

namespace stationary::cli {

class AtlasTables {
 public:
  /// path: as after --tables; empty: nothing is written. Throws InputError for another suffix, or where
  /// it cannot be written.
  AtlasTables(const std::string& path, const std::string& case_path,
              const std::vector<Column>& columns);

  /// The rows of one cell, packed.
  void add(std::size_t cell, const RowPack& pack, std::string_view rows);
  void add(std::size_t cell, const std::vector<TableRow>& rows);
  /// Puts the file in its place. Of the metadata of the grid's table it has its own rows and checksum.
  void commit(Metadata metadata);

 private:
  std::vector<Column> columns_;
  std::optional<AtomicFile> file_;
  std::optional<TablesFile> tables_;
  std::size_t rows_ = 0;
  TableChecksum checksum_;  ///< of the tables' checksums
};

/// Those of the parts' files, which belong to the parts of the grid's table. Throws InputError where they
/// do not, where one is missing, or was changed.
void merge_tables(const std::vector<PartTable>& parts, const std::vector<std::string>& paths,
                  const std::vector<Column>& columns, AtlasTables& out);

}  // namespace stationary::cli
