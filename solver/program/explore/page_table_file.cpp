// read_page_table() of a file, CSV or HDF5, with what is beside it. Apart from the rest, for pages, which have no files.
#include <fstream>
#include <iterator>
#include <utility>

#include "solver/program/explore/page_table.hpp"
#include "solver/program/rows/metadata.hpp"
#include "solver/program/table/atomic_file.hpp"
#include "solver/program/table/column_file.hpp"

namespace stationary {
namespace {

std::string metadata_of(const std::string& path) {
  std::ifstream file(metadata_path(path), std::ios::binary);
  std::string out{std::istreambuf_iterator<char>(file), {}};
  if (out.empty() && is_column_file(path)) out = column_file_metadata(path);
  return out;
}

}  // namespace

PageTable read_page_table(const std::string& path, const std::optional<std::string>& title) {
  TableReader table =
      is_column_file(path) ? TableReader(column_file_table(path, {}), path) : TableReader(path);
  PageTable out = read_page_table(table);
  out.metadata = metadata_of(path);
  if (const std::string of_case = case_title(out.metadata); !of_case.empty()) out.title = of_case;
  if (title) out.title = *title;
  return out;
}

}  // namespace stationary
