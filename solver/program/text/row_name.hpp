// A row of a table by its number or its event:
//
//   TABLE:N          data row N, the first is 1
//   TABLE:EVENT      the first row with this event (TABLE:tilt)
//   TABLE:EVENT:K    the Kth of these
#pragma once

#include <string>

#include "solver/program/text/input_error.hpp"

namespace stationary::cli {

struct RowName {
  std::string path;
  std::string event;  ///< empty: by its number
  long number = 1;    ///< of the row, or among those of the event
};

/// Where a row named so is asked for: the option --from.
Origin place_of_row(const std::string& text);
/// Throws InputError of it.
[[noreturn]] void refuse_row(const std::string& text, const std::string& found,
                             const std::string& expected, const std::string& remedy = {});

/// Throws InputError, of the option --from, where text names no row. Whether there is such a table it does not ask.
RowName row_name(const std::string& text);

}  // namespace stationary::cli
