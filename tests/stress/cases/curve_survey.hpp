// Random families of every kind followed, and what their tables say of stability held against
// themselves and against a finer sweep: wherever `negative` or the class is another than at the row
// before, an event is there that says so; and a sweep in steps many times finer finds the same
// events.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/bodies/random_states.hpp"

namespace stationary::stress {

inline constexpr std::array<std::string_view, 6> surveyed_kinds{
    "in the plane", "about axis 3", "J1 = J2", "tilted", "two-polar", "anisotropic"};

struct CurveSurvey {
  long tried = 0;
  long followed = 0;  ///< of them; the others have no motion to begin with
  std::array<long, surveyed_kinds.size()> of_kind{};
  long rows = 0;
  long changes = 0;     ///< of `negative` or of the class, between rows
  long events = 0;      ///< located
  long unresolved = 0;  ///< known, and not located
  std::vector<std::string> faults;
};

/// Families number first ... first + count - 1 of the survey.
CurveSurvey survey_curves(long first, long count);

}  // namespace stationary::stress
