// A test of tables as HDF5 begins with NEEDS_HDF5(): it is skipped where the program is built without.
#pragma once

#ifdef STATIONARY_HAS_HDF5
#include <hdf5.h>

#include "solver/program/table/hdf5_handle.hpp"
constexpr bool has_hdf5 = true;
#else
constexpr bool has_hdf5 = false;
#endif

#define NEEDS_HDF5() \
  if (!has_hdf5) GTEST_SKIP() << "built without HDF5"
