#include "solver/program/table/column_file.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/program/table/hdf5_handle.hpp"
#include "solver/program/table/hdf5_write.hpp"

namespace stationary {
namespace {

Handle enumeration(const std::vector<std::string_view>& of) {
  Handle type = require_hdf5(Handle(H5Tenum_create(H5T_STD_U8LE), H5Tclose), "an enumeration");
  for (std::size_t k = 0; k < of.size(); ++k) {
    const auto value = static_cast<std::uint8_t>(k);
    // HDF5 has no empty names.
    const std::string word(of[k].empty() ? " " : of[k]);
    require_hdf5(H5Tenum_insert(type.id(), word.c_str(), &value), "an enumeration");
  }
  return type;
}

/// Names one after the other, a line each: h5py gives them back by splitlines().
std::string lines(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& each : names) out += each + '\n';
  if (!out.empty()) out.pop_back();
  return out;
}

/// One column on its way into the file.
struct Dataset {
  std::string name;
  CellKind kind;
  Column column{};     ///< where it is no parameter
  int parameter = -1;  ///< 0, 1
  std::vector<std::string_view> words{};
  Handle type;
  Handle set;
  std::vector<double> numbers{};
  std::vector<std::int32_t> counts{};
  std::vector<std::uint8_t> codes{};

  void take(const TableRow& row) {
    if (parameter >= 0) {
      numbers.push_back(parameter == 0 ? row.parameter : row.second_parameter);
    } else if (kind == CellKind::number) {
      numbers.push_back(row[column]);
    } else if (kind == CellKind::count) {
      const double value = row[column];
      counts.push_back(std::isnan(value) ? missing_count : static_cast<std::int32_t>(value));
    } else {
      const auto at = std::ranges::find(words, text_of(row, column));
      codes.push_back(static_cast<std::uint8_t>(at == words.end() ? 0 : at - words.begin()));
    }
  }
  const void* values() const {
    if (kind == CellKind::number) return numbers.data();
    if (kind == CellKind::count) return counts.data();
    return codes.data();
  }
  hid_t file_type() const {
    if (kind == CellKind::text) return type.id();
    return kind == CellKind::count ? H5T_STD_I32LE : H5T_IEEE_F64LE;
  }
  hid_t memory_type() const {
    if (kind == CellKind::number) return H5T_NATIVE_DOUBLE;
    return kind == CellKind::count ? H5T_NATIVE_INT32 : type.id();
  }
  void clear() {
    numbers.clear();
    counts.clear();
    codes.clear();
  }
};

constexpr hsize_t longest_block = 32768;  // rows

}  // namespace

struct ColumnFileWriter::Data {
  Handle file;  ///< or a group of one
  hsize_t block = longest_block;
  std::vector<Dataset> columns{};
  hsize_t written = 0;
  hsize_t waiting = 0;
  bool created = false;

  /// The datasets, of so many rows as far as is known.
  void create(std::size_t rows) {
    const hsize_t blocks = std::max<hsize_t>(1, (rows + longest_block - 1) / longest_block);
    block = std::max<hsize_t>(1, (rows + blocks - 1) / blocks);
    for (Dataset& each : columns) {
      each.set = create(each.name, each.file_type());
      if (each.kind == CellKind::count) write_hdf5_missing_count(each.set.id());
    }
    created = true;
  }
  Handle create(const std::string& name, hid_t type) const {
    const hsize_t none = 0;
    const hsize_t unlimited = H5S_UNLIMITED;
    const Handle space =
        require_hdf5(Handle(H5Screate_simple(1, &none, &unlimited), H5Sclose), name);
    const Handle layout = require_hdf5(Handle(H5Pcreate(H5P_DATASET_CREATE), H5Pclose), name);
    require_hdf5(H5Pset_chunk(layout.id(), 1, &block), name);
    require_hdf5(H5Pset_obj_track_times(layout.id(), false), name);
    create_hdf5_groups_of(file.id(), name);
    return require_hdf5(Handle(H5Dcreate2(file.id(), name.c_str(), type, space.id(), H5P_DEFAULT,
                                          layout.id(), H5P_DEFAULT),
                               H5Dclose),
                        name);
  }
  void flush() {
    silence_hdf5();
    if (!created) create(waiting);
    if (waiting == 0) return;
    const hsize_t total = written + waiting;
    for (Dataset& each : columns) {
      require_hdf5(H5Dset_extent(each.set.id(), &total), each.name);
      const Handle space = require_hdf5(Handle(H5Dget_space(each.set.id()), H5Sclose), each.name);
      require_hdf5(
          H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &written, nullptr, &waiting, nullptr),
          each.name);
      const Handle memory =
          require_hdf5(Handle(H5Screate_simple(1, &waiting, nullptr), H5Sclose), each.name);
      require_hdf5(H5Dwrite(each.set.id(), each.memory_type(), memory.id(), space.id(), H5P_DEFAULT,
                            each.values()),
                   each.name);
      each.clear();
    }
    written = total;
    waiting = 0;
  }
};

ColumnFileWriter::ColumnFileWriter(const std::string& path, const std::vector<Column>& columns,
                                   const std::vector<std::string>& parameters,
                                   std::optional<std::size_t> rows)
    : ColumnFileWriter(Data{create_hdf5(path)}, columns, parameters, rows) {}

ColumnFileWriter::ColumnFileWriter(Data data, const std::vector<Column>& columns,
                                   const std::vector<std::string>& parameters,
                                   std::optional<std::size_t> rows)
    : RowSink(columns, parameters.size()), data_(std::make_unique<Data>(std::move(data))) {
  std::vector<std::string> names;
  const auto add = [&](Dataset each) {
    names.push_back(each.name);
    data_->columns.push_back(std::move(each));
  };
  const auto none = [](Handle::Close close) { return Handle(H5I_INVALID_HID, close); };
  for (const Column c : columns) {
    Dataset each{.name = std::string(stationary::name(c)),
                 .kind = cell_kind(c),
                 .column = c,
                 .type = none(H5Tclose),
                 .set = none(H5Dclose)};
    if (each.kind == CellKind::text) {
      each.words = column_words(c);
      each.type = enumeration(each.words);
    }
    add(std::move(each));
  }
  for (const std::string& parameter : parameters) {
    add({.name = parameter,
         .kind = CellKind::number,
         .parameter = static_cast<int>(&parameter - parameters.data()),
         .type = none(H5Tclose),
         .set = none(H5Dclose)});
  }
  if (rows) data_->create(*rows);
  write_hdf5_attribute(data_->file.id(), "columns", lines(names));
}

ColumnFileWriter::~ColumnFileWriter() { silence_hdf5(); }

void ColumnFileWriter::put(const TableRow& row, TableChecksum& sum) {
  add_cells(row, sum);
  for (Dataset& each : data_->columns) each.take(row);
  if (++data_->waiting == data_->block) data_->flush();
}

void ColumnFileWriter::finish(const std::string& metadata) {
  data_->flush();
  write_hdf5_attribute(data_->file.id(), "metadata", metadata);
  for (Dataset& each : data_->columns)
    if (!each.set.close() || !each.type.close()) hdf5_failed(each.name);
  if (!data_->file.close()) hdf5_failed("the end of the file");
}

struct TablesFile::Data {
  Handle file;
};

TablesFile::TablesFile(const std::string& path)
    : data_(std::make_unique<Data>(Data{create_hdf5(path)})) {}

TablesFile::~TablesFile() { silence_hdf5(); }

std::unique_ptr<ColumnFileWriter> TablesFile::table(const std::string& name,
                                                    const std::vector<Column>& columns,
                                                    std::size_t rows) {
  Handle group = create_hdf5_group(data_->file.id(), name);
  return std::unique_ptr<ColumnFileWriter>(
      new ColumnFileWriter(ColumnFileWriter::Data{std::move(group)}, columns, {}, rows));
}

void TablesFile::finish(const std::string& metadata) {
  silence_hdf5();
  write_hdf5_attribute(data_->file.id(), "metadata", metadata);
  if (!data_->file.close()) hdf5_failed("the end of the file");
}

}  // namespace stationary
