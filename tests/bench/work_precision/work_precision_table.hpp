// The table of a run, what is to be known of the run, and what the table says in short.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/bench/measurement.hpp"

namespace stationary::bench {

/// Columns: what, method, model, branch, tolerance (empty: none to choose), seconds, seconds_min,
/// seconds_max (processor time an item: median, least and most of the repeats), error_worst,
/// error_median, count (items of a pass), failed.
std::string table_csv(const std::vector<Measured>& results);

struct Run {
  int repeats;
  double seconds;
  std::size_t rows;
  std::map<std::string, std::string> scipy;  ///< versions; empty: not there
  std::string auto_version;                  ///< of AUTO-07p; empty: not there,
  std::string auto_missing;                  ///< and why
};

/// JSON: machine, compiler, flags, versions, date.
std::string table_metadata(const Run& run);

/// For every peer of a sweep, by how much it is slower (least and most of the cases) than the
/// library's fastest setting of equal or smaller worst error, and than the corrected sweep, each
/// peer in its fastest setting within a factor of two of its least error. A table in Markdown.
std::string comparison(const std::vector<Measured>& results);

/// Of every method that follows a curve: points a second, the errors of its rows, and by how much it
/// is slower (least and most of the cases) than the library's, a point, and a curve whose rows,
/// interpolated, have an equal or smaller worst error. A table in Markdown.
std::string comparison_of_curves(const std::vector<Measured>& results);

}  // namespace stationary::bench
