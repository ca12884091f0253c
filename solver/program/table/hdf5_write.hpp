// What writing a table as HDF5 takes of the library, failures thrown as std::runtime_error.
#pragma once

#include <string>
#include <string_view>

#include "solver/program/table/hdf5_handle.hpp"

namespace stationary {

[[noreturn]] void hdf5_failed(std::string_view what);
Handle require_hdf5(Handle handle, std::string_view what);
void require_hdf5(herr_t result, std::string_view what);

/// An empty file that remembers the order of its datasets and no times.
Handle create_hdf5(const std::string& path);
/// A group that remembers the same.
Handle create_hdf5_group(hid_t location, const std::string& name);
/// Those that a dataset of this name is to stand in: of a name with a slash, as a ratio's.
void create_hdf5_groups_of(hid_t location, const std::string& name);
Handle hdf5_string_type(std::size_t length);
void write_hdf5_attribute(hid_t file, const char* what, const std::string& text);
/// Of a dataset of counts: missing_count as its attribute _FillValue, where netCDF's readers look for it.
void write_hdf5_missing_count(hid_t set);

}  // namespace stationary
