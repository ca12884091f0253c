// What of column_file.hpp needs no HDF5.
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "lib/body/motion.hpp"
#include "lib/stability/spectrum.hpp"
#include "solver/motion/event.hpp"
#include "solver/normal_form/normal_form.hpp"
#include "solver/program/table/atomic_file.hpp"
#include "solver/program/table/column_file.hpp"

namespace stationary {

std::vector<std::string_view> column_words(Column c) {
  std::vector<std::string_view> out{""};
  const auto add = [&](const auto& names) {
    for (const std::string_view each : names)
      if (!each.empty()) out.push_back(each);
  };
  switch (c) {
    case Column::branch:
      add(std::array{name(Branch::i), name(Branch::ii), name(Branch::iii), tilted_name,
                     oblique_name, two_polar_name});
      break;
    case Column::event:
      add(event_names);
      break;
    case Column::stability:
      add(stability_names);
      break;
    case Column::status:
      add(cell_status_names);
      break;
    case Column::certified:
    case Column::class_certified:
      add(proof_words);
      break;
    case Column::side:
      add(event_side_names);
      break;
    default:
      throw std::invalid_argument(std::string(name(c)) + " has no words of its own");
  }
  return out;
}

bool is_column_file_extension(std::string_view extension) {
  return extension == ".h5" || extension == ".hdf5";
}

// Not by HDF5 itself: a table of CSV needs none of it, nor the memory that it takes.
bool is_column_file(const std::string& path) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) return false;
  constexpr std::array<char, 8> signature{'\x89', 'H', 'D', 'F', '\r', '\n', '\x1a', '\n'};
  std::ifstream file(path, std::ios::binary);
  std::array<char, 8> begin{};
  return file.read(begin.data(), begin.size()) && begin == signature;
}

TableReader open_table(const std::string& path) {
  return is_column_file(path) ? TableReader(column_file_table(path, {}), path) : TableReader(path);
}

std::string table_metadata(const std::string& path) {
  // One file may stand beside both x.csv and x.h5.
  if (is_column_file(path))
    if (std::string own = column_file_metadata(path); !own.empty()) return own;
  return bytes_of_file(metadata_path(path)).value_or(std::string());
}

}  // namespace stationary
