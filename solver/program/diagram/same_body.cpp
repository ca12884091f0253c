#include "solver/program/diagram/same_body.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "solver/program/rows/metadata_reading.hpp"

namespace stationary {
namespace {

using BodyJson = nlohmann::json;  // its order of keys is one of its own

/// Null where the metadata do not say.
BodyJson body_of(std::string_view metadata, const std::vector<std::string>& varied) {
  if (nests_too_deep(metadata)) return {};
  const BodyJson found = BodyJson::parse(metadata, nullptr, /*allow_exceptions=*/false);
  if (!found.is_object() || !found.contains("case") || !found["case"].is_object()) return {};
  BodyJson out;
  for (const char* const part : {"body", "potential", "gravity"})
    if (found["case"].contains(part)) out[part] = found["case"][part];
  for (const std::string& each : varied) {
    std::istringstream keys(each);
    for (std::string key; std::getline(keys, key, '/');) {
      std::ranges::replace(key, '.', '/');
      const BodyJson::json_pointer place('/' + key);
      if (out.contains(place)) out[place] = nullptr;
    }
  }
  return out;
}

}  // namespace

bool of_one_body(std::string_view metadata, std::string_view other,
                 const std::vector<std::string>& varied) {
  const BodyJson one = body_of(metadata, varied);
  const BodyJson two = body_of(other, varied);
  return one.is_null() || two.is_null() || one == two;
}

}  // namespace stationary
