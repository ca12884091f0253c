#include "solver/program/rows/metadata_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "solver/program/text/named.hpp"

namespace stationary {
namespace {

using Json = nlohmann::ordered_json;

/// Discarded where it is no JSON, or nests too deep.
Json parsed(std::string_view metadata) {
  if (nests_too_deep(metadata)) return Json::value_t::discarded;
  return Json::parse(metadata, nullptr, /*allow_exceptions=*/false);
}

std::string text_of_case(const Json& metadata) {
  return metadata.at("command").dump() + metadata.at("case").dump() +
         metadata.at("overrides").dump();
}

}  // namespace

bool nests_too_deep(std::string_view json) {
  constexpr int most = 64;  // of objects and arrays in one another
  int depth = 0;
  bool quoted = false;
  for (std::size_t k = 0; k < json.size(); ++k) {
    const char c = json[k];
    if (quoted) {
      if (c == '\\') ++k;
      quoted = c != '"';
    } else if (c == '"') {
      quoted = true;
    } else if (c == '[' || c == '{') {
      if (++depth > most) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

bool is_metadata(std::string_view metadata) {
  const Json found = parsed(metadata);
  return found.is_object() && found.contains("schema") && found.contains("case");
}

std::string other_program(std::string_view metadata, std::string_view version) {
  const Json found = parsed(metadata);
  if (!found.is_object() || !found.contains("schema") || !found.contains("version")) return {};
  const Json schema = found["schema"];
  if (schema != metadata_schema)
    return fmt::format("metadata of schema {}; this program's are of schema {}", schema.dump(),
                       metadata_schema);
  const Json made_by = found["version"];
  if (made_by != version)
    return fmt::format("what version {} wrote; this is version {}", made_by.dump(), version);
  return {};
}

bool is_to_be_gone_on_with(std::string_view metadata) {
  const Json found = parsed(metadata);
  if (!found.is_object()) return false;
  const Json status = found.value("status", Json());
  return status == "interrupted" || status == "stopped at max_points";
}

std::optional<CurveRecord> curve_record(std::string_view metadata) {
  try {
    const Json found = parsed(metadata);
    CurveRecord out;
    out.rows = found.at("rows").get<std::size_t>();
    out.checksum = found.at("checksum").get<std::string>();
    for (const Json& event : found.at("events")) {
      const auto type = named<EventType>(event_names, event.at("event").get<std::string>());
      const auto status =
          named<EventStatus>(event_status_names, event.at("status").get<std::string>());
      if (!type || !status) return std::nullopt;
      out.events.push_back({*type, event.at("parameter").get<double>(),
                            event.at("bracket").at(0).get<double>(),
                            event.at("bracket").at(1).get<double>(), *status});
      if (const auto proven = event.find("enclosure"); proven != event.end()) {
        out.events.back().enclosure =
            Interval(proven->at(0).get<double>(), proven->at(1).get<double>());
      }
      if (const auto error = event.find("criticality_error"); error != event.end())
        out.events.back().criticality_error = error->get<double>();
    }
    for (const Json& segment : found.at("segments")) {
      RecordedSegment& each = out.segments.emplace_back();
      each.first_point = segment.at("first_point").get<long>();
      each.last_point = segment.at("last_point").get<long>();
      if (segment.at("class").is_null()) continue;
      each.verdict = named<StabilityClass>(stability_names, segment.at("class").get<std::string>());
      if (!each.verdict) return std::nullopt;
    }
    for (const Json& end : found.at("ends")) {
      const bool first = end.at("side") == "first";
      (first ? out.first_reason : out.last_reason) = end.at("reason").get<std::string>();
      if (!first) out.last_is_open = end.at("event") == "";
    }
    return out;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

bool is_of_table(std::string_view metadata, std::size_t rows) {
  const Json found = parsed(metadata);
  return found.is_object() && (!found.contains("rows") || found["rows"] == Json(rows));
}

std::string case_title(std::string_view metadata) {
  const Json found = parsed(metadata);
  const Json::json_pointer place("/case/title");
  return found.contains(place) && found[place].is_string() ? found[place].get<std::string>()
                                                           : std::string();
}

std::optional<PartMetadata> part_metadata(std::string_view metadata) {
  try {
    const Json found = parsed(metadata);
    const Json& part = found.at("part");
    PartMetadata out;
    out.part = {part.at("number").get<std::size_t>(), part.at("of").get<std::size_t>(),
                part.at("first_row").get<std::size_t>() - 1, part.at("work").get<std::string>()};
    out.command = found.at("command").get<std::string>();
    out.status = found.at("status").get<std::string>();
    out.rows = found.at("rows").get<std::size_t>();
    out.checksum = found.at("checksum").get<std::string>();
    out.case_file = found.at("case_file").get<std::string>();
    out.case_text = text_of_case(found);
    out.instructions = found.value(Json::json_pointer("/run/instructions"), std::string());
    for (const auto& [name, count] : found.at("counts").items())
      out.counts.emplace_back(name, count.get<long>());
    if (const auto study = found.find("study"); study != found.end())
      out.study =
          StudyRecord{study->at("over").get<std::string>(), study->at("do").get<std::string>(),
                      study->at("rows").get<std::size_t>()};
    if (out.command == "study" && !out.study) return std::nullopt;
    if (const Json& of = found.at("case"); of.is_object())
      out.certificate = of.at("output").at("certificate").get<bool>();
    return out;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::string case_text(const Metadata& metadata) {
  return text_of_case(Json::parse(metadata_json(metadata)));
}

}  // namespace stationary
