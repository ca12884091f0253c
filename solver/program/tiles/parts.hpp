// The parts of a run that was shared out by hand, for --merge: tables with their metadata. They are to be
// of one case, disjoint, complete and as they were written; which they are not is refused by name.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/rows/metadata_reading.hpp"
#include "solver/program/table/table.hpp"
#include "solver/program/table/table_reader.hpp"

namespace stationary::cli {

struct PartTable {
  std::string path;
  PartMetadata metadata;
};

/// Parts of a command, "map", in their order. Throws InputError about --merge.
std::vector<PartTable> read_parts(const std::vector<std::string>& paths, std::string_view command);

/// Throws where the parts are of another case, or of one with other overrides, than the metadata say.
void require_case(const std::vector<PartTable>& parts, const Metadata& whole);

/// Throws where a part has not the work's hash: something else that decides the rows is another.
void require_work(const std::vector<PartTable>& parts, const std::string& hash);

/// All counts of the parts' metadata by their names, added up.
std::vector<std::pair<std::string, long>> added_counts(const std::vector<PartTable>& parts);

/// Throws InputError where a part has not so many rows as its metadata say, or others.
void require_whole(const PartTable& part, std::size_t rows, const TableChecksum& checksum);

/// Every row of a part's table; parameters: headers of the trailing columns. Throws InputError where it
/// has other columns than these.
void read_table(TableReader& table, const std::vector<Column>& columns,
                const std::vector<std::string>& parameters,
                const std::function<void(const TableRow&)>& take);

/// Every row of all parts, in order. Throws InputError as those two do.
void read_rows(const std::vector<PartTable>& parts, const std::vector<Column>& columns,
               const std::vector<std::string>& parameters,
               const std::function<void(const TableRow&)>& take);

/// The header and every line of tables whose columns are known by name only (cell_table.hpp), their ends
/// included. Throws InputError where a part has other columns than the first, or was changed.
struct PartLines {
  std::string header;
  std::string lines;
};
PartLines read_lines(const std::vector<PartTable>& parts);

}  // namespace stationary::cli
