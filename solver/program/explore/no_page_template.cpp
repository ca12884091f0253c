// In the place of the page where it cannot be built.
#include "solver/program/explore/page_template.hpp"

namespace stationary {

std::span<const std::string_view> page_template() { return {}; }

}  // namespace stationary
