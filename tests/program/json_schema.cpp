#include "tests/program/json_schema.hpp"

#include <algorithm>

namespace stationary::testing {
namespace {

using Json = nlohmann::json;

bool is_of_type(const Json& value, const std::string& type) {
  if (type == "null") return value.is_null();
  if (type == "boolean") return value.is_boolean();
  if (type == "string") return value.is_string();
  if (type == "array") return value.is_array();
  if (type == "object") return value.is_object();
  if (type == "integer") return value.is_number_integer();
  return type == "number" && value.is_number();
}

class Validator {
 public:
  explicit Validator(const Json& root) : root_(root) {}

  std::string fault(const Json& value, const Json& schema, const std::string& place) const {
    for (const auto& [keyword, of] : schema.items()) {
      const std::string found = keyword_fault(value, schema, keyword, of, place);
      if (!found.empty()) return found;
    }
    return {};
  }

 private:
  std::string keyword_fault(const Json& value, const Json& schema, const std::string& keyword,
                            const Json& of, const std::string& place) const {
    const auto fails = [&] { return place + ": " + keyword + " " + of.dump(); };
    if (keyword == "$ref") {
      return fault(value, root_.at(Json::json_pointer(of.get<std::string>().substr(1))), place);
    }
    if (keyword == "type") {
      const Json types = of.is_array() ? of : Json::array({of});
      const bool fits = std::any_of(types.begin(), types.end(), [&](const Json& type) {
        return is_of_type(value, type.get<std::string>());
      });
      return fits ? std::string() : fails();
    }
    if (keyword == "const") return value == of ? std::string() : fails();
    if (keyword == "enum")
      return std::find(of.begin(), of.end(), value) != of.end() ? std::string() : fails();
    if (keyword == "minimum")
      return !value.is_number() || value.get<double>() >= of ? std::string() : fails();
    if (keyword == "minItems")
      return !value.is_array() || value.size() >= of ? std::string() : fails();
    if (keyword == "maxItems")
      return !value.is_array() || value.size() <= of ? std::string() : fails();
    if (keyword == "required") {
      for (const Json& key : of)
        if (value.is_object() && !value.contains(key.get<std::string>()))
          return place + ": no key " + key.dump();
      return {};
    }
    if (keyword == "items") return items_fault(value, of, place);
    if (keyword == "properties" || keyword == "additionalProperties") {
      return properties_fault(value, schema, place);
    }
    for (const char* silent : {"$schema", "$defs", "title", "description"})
      if (keyword == silent) return {};
    return "the schema's keyword " + keyword + " is not known here";
  }

  std::string items_fault(const Json& value, const Json& of, const std::string& place) const {
    if (!value.is_array()) return {};
    for (std::size_t k = 0; k < value.size(); ++k) {
      const std::string found = fault(value[k], of, place + "/" + std::to_string(k));
      if (!found.empty()) return found;
    }
    return {};
  }

  std::string properties_fault(const Json& value, const Json& schema,
                               const std::string& place) const {
    if (!value.is_object()) return {};
    const Json properties = schema.value("properties", Json::object());
    for (const auto& [key, each] : value.items()) {
      if (!properties.contains(key)) {
        if (schema.value("additionalProperties", true)) continue;
        return place + ": the key " + key + " has no place there";
      }
      const std::string found = fault(each, properties[key], place + "/" + key);
      if (!found.empty()) return found;
    }
    return {};
  }

  const Json& root_;
};

}  // namespace

std::string schema_fault(const nlohmann::json& value, const nlohmann::json& schema) {
  return Validator(schema).fault(value, schema, "");
}

}  // namespace stationary::testing
