// Whether two tables are of one body, by the metadata beside them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stationary {

/// Whether body, potential and gravity of two cases are the same but for the numbers at the keys
/// `varied`, such as body.J.1 or a ratio of two. True where the metadata do not say.
bool of_one_body(std::string_view metadata, std::string_view other,
                 const std::vector<std::string>& varied);

}  // namespace stationary
