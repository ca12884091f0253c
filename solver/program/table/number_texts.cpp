#include "solver/program/table/number_texts.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

namespace stationary {

char* append_number(double value, char* at) {
  if (value == 0.0) {
    *at++ = '0';
    return at;
  }
  return fmt::format_to(at, FMT_COMPILE("{}"), value);
}

}  // namespace stationary
