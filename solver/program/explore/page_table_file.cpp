// read_page_table() of a file, CSV or HDF5, with what is beside it. Apart from the rest, for pages, which have no files.
#include <utility>

#include "solver/program/explore/page_table.hpp"
#include "solver/program/rows/metadata.hpp"
#include "solver/program/table/column_file.hpp"

namespace stationary {

PageTable read_page_table(const std::string& path, const std::optional<std::string>& title) {
  TableReader table = open_table(path);
  PageTable out = read_page_table(table);
  out.metadata = table_metadata(path);
  if (!is_of_table(out.metadata, out.rows)) out.metadata.clear();
  if (const std::string of_case = case_title(out.metadata); !of_case.empty()) out.title = of_case;
  if (title) out.title = *title;
  return out;
}

}  // namespace stationary
