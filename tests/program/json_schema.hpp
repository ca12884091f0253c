// JSON against a JSON Schema: the keywords the shipped one uses, and a failure for any other.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace stationary::testing {

/// Where a value breaks the schema and how; empty where it does not.
std::string schema_fault(const nlohmann::json& value, const nlohmann::json& schema);

}  // namespace stationary::testing
