// A table as the explorer's page holds it: column by column, each cell with the text it has in the file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "solver/program/table/table_reader.hpp"

namespace stationary {

/// Numbers are one text, apart by commas; words are a list.
struct PageColumn {
  std::string name;
  bool is_number = true;
  std::string numbers;
  std::vector<std::string> words;
};

struct PageTable {
  std::string file;  ///< without its folder
  std::string title;
  std::string metadata;      ///< JSON text; empty: there is none
  std::string warning = {};  ///< why those beside the table are left out; empty: they are not
  std::vector<std::string>
      parameters;  ///< what is varied: columns under dotted keys, or a map's nu
  std::vector<PageColumn> columns;
  std::size_t rows = 0;
};

/// Throws InputError: a cell of the program's own columns that it would not have written, no rows.
PageTable read_page_table(TableReader& table);

/// The same of a file, CSV or HDF5, with its metadata where they can be read and are of its rows. title:
/// instead of the case's.
PageTable read_page_table(const std::string& path, const std::optional<std::string>& title);

}  // namespace stationary
