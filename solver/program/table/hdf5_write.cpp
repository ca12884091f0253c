#include "solver/program/table/hdf5_write.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "solver/program/table/column_file.hpp"

namespace stationary {

void hdf5_failed(std::string_view what) {
  throw std::runtime_error(fmt::format("HDF5 could not write {}", what));
}

Handle require_hdf5(Handle handle, std::string_view what) {
  if (!handle.valid()) hdf5_failed(what);
  return handle;
}

void require_hdf5(herr_t result, std::string_view what) {
  if (result < 0) hdf5_failed(what);
}

Handle create_hdf5(const std::string& path) {
  silence_hdf5();
  const Handle creation = require_hdf5(Handle(H5Pcreate(H5P_FILE_CREATE), H5Pclose), path);
  require_hdf5(
      H5Pset_link_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED),
      path);
  require_hdf5(H5Pset_obj_track_times(creation.id(), false), path);
  // The format of 1.8: metadata may be longer than the 64 KiB of an attribute before.
  const Handle access = require_hdf5(Handle(H5Pcreate(H5P_FILE_ACCESS), H5Pclose), path);
  require_hdf5(H5Pset_libver_bounds(access.id(), H5F_LIBVER_V18, H5F_LIBVER_LATEST), path);
#if H5_VERSION_GE(1, 12, 1) || (H5_VERS_MINOR == 10 && H5_VERS_RELEASE >= 7)
  // Who opened the file before has its lock (atomic_file.hpp), and on NFS HDF5's would be refused for it.
  require_hdf5(H5Pset_file_locking(access.id(), false, true), path);
#endif
  return require_hdf5(
      Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose), path);
}

Handle create_hdf5_group(hid_t location, const std::string& name) {
  silence_hdf5();
  const Handle creation = require_hdf5(Handle(H5Pcreate(H5P_GROUP_CREATE), H5Pclose), name);
  require_hdf5(
      H5Pset_link_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED),
      name);
  require_hdf5(H5Pset_obj_track_times(creation.id(), false), name);
  return require_hdf5(
      Handle(H5Gcreate2(location, name.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Gclose),
      name);
}

void create_hdf5_groups_of(hid_t location, const std::string& name) {
  for (std::size_t at = name.find('/'); at != std::string::npos; at = name.find('/', at + 1)) {
    const std::string group = name.substr(0, at);
    if (H5Lexists(location, group.c_str(), H5P_DEFAULT) <= 0)
      (void)create_hdf5_group(location, group);
  }
}

Handle hdf5_string_type(std::size_t length) {
  Handle type = require_hdf5(Handle(H5Tcopy(H5T_C_S1), H5Tclose), "a type of strings");
  require_hdf5(H5Tset_size(type.id(), std::max<std::size_t>(length, 1)), "a type of strings");
  require_hdf5(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "a type of strings");
  require_hdf5(H5Tset_cset(type.id(), H5T_CSET_UTF8), "a type of strings");
  return type;
}

void write_hdf5_attribute(hid_t file, const char* what, const std::string& text) {
  const Handle type = hdf5_string_type(text.size());
  const Handle space = require_hdf5(Handle(H5Screate(H5S_SCALAR), H5Sclose), what);
  const Handle attribute = require_hdf5(
      Handle(H5Acreate2(file, what, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose),
      what);
  require_hdf5(H5Awrite(attribute.id(), type.id(), text.c_str()), what);
}

void write_hdf5_missing_count(hid_t set) {
  constexpr const char* what = "_FillValue";
  const Handle space = require_hdf5(Handle(H5Screate(H5S_SCALAR), H5Sclose), what);
  const Handle attribute = require_hdf5(
      Handle(H5Acreate2(set, what, H5T_STD_I32LE, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose),
      what);
  require_hdf5(H5Awrite(attribute.id(), H5T_NATIVE_INT32, &missing_count), what);
}

}  // namespace stationary
