// What a terminal may show and a file may not: bold headings, red alarms.
#pragma once

#include <string>
#include <string_view>

namespace stationary {

/// Whether colours may go to a file descriptor: to a terminal that knows them (TERM is not "dumb"),
/// and only where NO_COLOR is not in the environment, whatever its value.
bool has_colours(int descriptor);

/// The text in bold, with what ends it.
std::string heading(std::string_view text);

/// The text in bold red, with what ends it.
std::string alarm(std::string_view text);

/// About how long, for a person: "40 s", "3 min", "5 h".
std::string rough_duration(double seconds);

}  // namespace stationary
