// column_file.hpp, the reading of it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <utility>

#include "solver/program/table/cell_table.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/table/hdf5_handle.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary {
namespace {

[[noreturn]] void refuse(const std::string& path, std::string found) {
  throw InputError(Origin::in_file(path), "", std::move(found), "an HDF5 file of this program's");
}

/// Empty where there is none.
std::string text_attribute(hid_t file, const char* what) {
  const Handle attribute(H5Aopen(file, what, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid()) return {};
  const Handle type(H5Aget_type(attribute.id()), H5Tclose);
  if (!type.valid() || H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0)
    return {};
  std::string out(H5Tget_size(type.id()), '\0');
  if (H5Aget_storage_size(attribute.id()) != out.size() ||
      H5Aread(attribute.id(), type.id(), out.data()) < 0)
    return {};
  return out;
}

/// The lines of a text; none where it is empty, or has not so many.
std::vector<std::string> lines_of(const std::string& text, std::size_t count) {
  if (text.empty()) return {};
  std::vector<std::string> out{std::string()};
  for (const char c : text) {
    if (c == '\n') {
      out.emplace_back();
    } else {
      out.back() += c;
    }
  }
  if (out.size() != count) out.clear();
  return out;
}

/// A column read back, as the text of its cells.
class ReadColumn {
 public:
  ReadColumn(const std::string& path, hid_t file, const std::string& column) {
    const Handle set(H5Dopen2(file, column.c_str(), H5P_DEFAULT), H5Dclose);
    if (!set.valid()) refuse(path, "found no dataset " + in_quotes(column));
    const Handle type(H5Dget_type(set.id()), H5Tclose);
    const Handle space(H5Dget_space(set.id()), H5Sclose);
    const hssize_t count = H5Sget_simple_extent_npoints(space.id());
    if (count < 0) refuse(path, "found a broken dataset " + in_quotes(column));
    rows_ = static_cast<std::size_t>(count);
    herr_t result = 0;
    switch (H5Tget_class(type.id())) {
      case H5T_ENUM: {
        codes_.resize(rows_);
        for (int k = 0; k < H5Tget_nmembers(type.id()); ++k) {
          char* word = H5Tget_member_name(type.id(), static_cast<unsigned>(k));
          words_.emplace_back(word == nullptr || *word == ' ' ? "" : word);
          H5free_memory(word);
        }
        result = H5Tget_size(type.id()) == 1
                     ? H5Dread(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, codes_.data())
                     : -1;
        break;
      }
      case H5T_INTEGER:
        counts_.resize(rows_);
        result = H5Dread(set.id(), H5T_NATIVE_INT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, counts_.data());
        break;
      case H5T_FLOAT:
        numbers_.resize(rows_);
        result =
            H5Dread(set.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers_.data());
        texts_ = lines_of(text_attribute(set.id(), spelling_attribute), rows_);
        break;
      case H5T_STRING: {
        const std::size_t length = H5Tget_size(type.id());
        std::string all(rows_ * length, '\0');
        result = H5Tis_variable_str(type.id()) == 0
                     ? H5Dread(set.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data())
                     : -1;
        for (std::size_t row = 0; row < rows_; ++row) {
          const std::string cell = all.substr(row * length, length);
          texts_.push_back(csv_cell(cell.substr(0, cell.find('\0'))));
        }
        break;
      }
      default:
        result = -1;
    }
    if (result < 0) refuse(path, "found an unreadable dataset " + in_quotes(column));
  }

  std::size_t rows() const { return rows_; }
  void append(std::size_t row, std::string& to) const {
    if (!texts_.empty()) {
      to += texts_[row];
    } else if (!numbers_.empty()) {
      if (!std::isnan(numbers_[row])) fmt::format_to(std::back_inserter(to), "{}", numbers_[row]);
    } else if (!counts_.empty()) {
      if (counts_[row] != missing_count) fmt::format_to(std::back_inserter(to), "{}", counts_[row]);
    } else if (codes_[row] < words_.size()) {
      to += words_[codes_[row]];
    }
  }

 private:
  std::size_t rows_ = 0;
  std::vector<std::string> texts_;
  std::vector<double> numbers_;
  std::vector<std::int32_t> counts_;
  std::vector<std::uint8_t> codes_;
  std::vector<std::string> words_;
};

Handle open_to_read(const std::string& path) {
  silence_hdf5();
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose};
}

/// The table of a file or of a group of one; name: what messages call it.
std::unique_ptr<std::istream> table_in(const std::string& name, hid_t location,
                                       std::span<const std::string> wanted) {
  std::istringstream names(text_attribute(location, "columns"));
  std::string header;
  std::vector<ReadColumn> columns;
  for (std::string column; std::getline(names, column);) {
    if (!wanted.empty() && std::ranges::find(wanted, column) == wanted.end()) continue;
    if (!header.empty()) header += ',';
    header += csv_cell(column);
    columns.emplace_back(name, location, column);
    if (columns.back().rows() != columns.front().rows())
      refuse(name, "found datasets of different lengths");
  }
  if (columns.empty()) refuse(name, "found none of a table's columns");
  std::string text = header + '\n';
  for (std::size_t row = 0; row < columns.front().rows(); ++row) {
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (k > 0) text += ',';
      columns[k].append(row, text);
    }
    text += '\n';
  }
  return std::make_unique<std::istringstream>(std::move(text));
}

}  // namespace

std::string hdf5_version() {
  silence_hdf5();
  unsigned major = 0;
  unsigned minor = 0;
  unsigned patch = 0;
  H5get_libversion(&major, &minor, &patch);
  return fmt::format("{}.{}.{}", major, minor, patch);
}

std::unique_ptr<std::istream> column_file_table(const std::string& path,
                                                std::span<const std::string> wanted) {
  const Handle file = open_to_read(path);
  if (!file.valid()) refuse(path, "no readable HDF5 file");
  return table_in(path, file.id(), wanted);
}

bool is_tables_file(const std::string& path) {
  if (!is_column_file(path)) return false;
  const Handle file = open_to_read(path);
  return file.valid() && H5Aexists(file.id(), "metadata") > 0 &&
         H5Aexists(file.id(), "columns") == 0;
}

struct TablesReader::Data {
  std::string path;
  Handle file;
};

TablesReader::TablesReader(const std::string& path)
    : data_(std::make_unique<Data>(Data{path, open_to_read(path)})) {
  if (!data_->file.valid()) refuse(path, "no readable HDF5 file");
}

TablesReader::~TablesReader() = default;

std::unique_ptr<std::istream> TablesReader::table(const std::string& name) const {
  const Handle group(H5Gopen2(data_->file.id(), name.c_str(), H5P_DEFAULT), H5Gclose);
  if (!group.valid()) refuse(data_->path, "found no group " + in_quotes(name));
  return table_in(data_->path, group.id(), {});
}

std::string column_file_metadata(const std::string& path) {
  const Handle file = open_to_read(path);
  return file.valid() ? text_attribute(file.id(), "metadata") : std::string();
}

}  // namespace stationary
