#include "solver/program/rows/part_metadata.hpp"

#include <nlohmann/json.hpp>

namespace stationary {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of_case(const Json& metadata) {
  return metadata.at("command").dump() + metadata.at("case").dump() +
         metadata.at("overrides").dump();
}

}  // namespace

std::optional<PartMetadata> part_metadata(std::string_view metadata) {
  try {
    const Json found = Json::parse(metadata);
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
    out.instructions = found.value("instructions", std::string());
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
