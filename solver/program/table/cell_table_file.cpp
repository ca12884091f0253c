// cell_table.hpp, its rows as an HDF5 file.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <sstream>

#include "solver/program/table/cell_table.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/table/hdf5_handle.hpp"
#include "solver/program/table/hdf5_write.hpp"
#include "solver/program/table/table_reader.hpp"

namespace stationary {
namespace {

/// As this program writes it.
std::string number_text(double number) {
  return number == number ? fmt::format("{}", number) : std::string();
}

/// The cells of one column.
struct Cells {
  std::vector<double> numbers;
  std::vector<std::string> texts;  ///< of numbers too, once one is not spelled as number_text()
  bool spelled = false;

  void add_text(std::string_view text) { texts.emplace_back(text); }
  void add_number(double number, std::string_view text) {
    if (!spelled && text != number_text(number)) {
      spelled = true;
      for (const double each : numbers) texts.push_back(number_text(each));
    }
    numbers.push_back(number);
    if (spelled) texts.emplace_back(text);
  }
};

/// One column of cells, written at once.
void write_column(hid_t file, const CellColumn& column, const Cells& cells) {
  const std::vector<std::string>& texts = cells.texts;
  const std::vector<double>& numbers = cells.numbers;
  const std::string& name = column.name;
  const hsize_t count = column.kind == CellKind::text ? texts.size() : numbers.size();
  const Handle space = require_hdf5(Handle(H5Screate_simple(1, &count, nullptr), H5Sclose), name);
  const Handle layout = require_hdf5(Handle(H5Pcreate(H5P_DATASET_CREATE), H5Pclose), name);
  require_hdf5(H5Pset_obj_track_times(layout.id(), false), name);
  create_hdf5_groups_of(file, name);
  const auto put = [&](hid_t file_type, hid_t memory_type, const void* values) {
    const Handle set = require_hdf5(Handle(H5Dcreate2(file, name.c_str(), file_type, space.id(),
                                                      H5P_DEFAULT, layout.id(), H5P_DEFAULT),
                                           H5Dclose),
                                    name);
    if (column.kind == CellKind::count) write_hdf5_missing_count(set.id());
    if (count == 0) return;
    require_hdf5(H5Dwrite(set.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), name);
    if (cells.spelled)
      write_hdf5_attribute(set.id(), spelling_attribute, fmt::format("{}", fmt::join(texts, "\n")));
  };
  if (column.kind == CellKind::number)
    return put(H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, numbers.data());
  if (column.kind == CellKind::count) {
    std::vector<std::int32_t> counts;
    for (const double each : numbers)
      counts.push_back(each == each ? static_cast<std::int32_t>(each) : missing_count);
    return put(H5T_STD_I32LE, H5T_NATIVE_INT32, counts.data());
  }
  std::size_t longest = 1;
  for (const std::string& each : texts) longest = std::max(longest, each.size());
  std::string all;
  for (std::string each : texts) {
    each.resize(longest, '\0');
    all += each;
  }
  const Handle type = hdf5_string_type(longest);
  put(type.id(), type.id(), all.data());
}

}  // namespace

void CellTable::finish(const std::string& path, const std::string& metadata) const {
  TableReader reader(std::make_unique<std::istringstream>(kept_), path);
  std::vector<Cells> cells(columns_.size());
  while (reader.next()) {
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (columns_[k].kind == CellKind::text) {
        cells[k].add_text(reader.text(k));
      } else {
        cells[k].add_number(reader.number(k), reader.text(k));
      }
    }
  }
  Handle file = create_hdf5(path);
  std::string names;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    write_column(file.id(), columns_[k], cells[k]);
    if (k > 0) names += '\n';
    names += columns_[k].name;
  }
  write_hdf5_attribute(file.id(), "columns", names);
  write_hdf5_attribute(file.id(), "metadata", metadata);
  if (!file.close()) hdf5_failed("the end of the file");
}

}  // namespace stationary
