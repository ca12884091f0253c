// A decimal number of a formula, "12.5e3": the nearest double, and whether it is that double; and a double as a
// table tells it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lib/expression/graph.hpp"

namespace stationary {

struct WrittenNumber {
  double value = 0.0;
  bool is_double = true;             ///< the text is the double itself, not only near it
  expression::Decimal decimal = {};  ///< the text, where it has at most 18 digits
};

/// digits [. digits] [e [sign] digits]; nothing where a double cannot hold it.
std::optional<WrittenNumber> written_number(std::string_view text);

/// The shortest decimals that are this double; a zero's sign says nothing and is left out.
std::string number_text(double value);

}  // namespace stationary
