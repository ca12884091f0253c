#include "solver/program/explore/page_data.hpp"

#include <nlohmann/json.hpp>

namespace stationary {
namespace {

using Json = nlohmann::ordered_json;

/// null where the text is no metadata: a page is made of the table alone.
Json metadata_json_of(const std::string& text) {
  Json out = Json::parse(text, nullptr, false);
  if (!out.is_object()) return nullptr;
  out.erase("run");
  return out;
}

Json table_json(const PageTable& table) {
  Json columns = Json::array();
  for (const PageColumn& column : table.columns) {
    columns.push_back({{"name", column.name},
                       {"kind", column.is_number ? "number" : "text"},
                       {"cells", column.is_number ? Json(column.numbers) : Json(column.words)}});
  }
  return {{"file", table.file}, {"title", table.title},
          {"rows", table.rows}, {"parameters", table.parameters},
          {"columns", columns}, {"metadata", metadata_json_of(table.metadata)}};
}

}  // namespace

std::string page_data(std::span<const PageTable> tables, std::string_view title,
                      std::string_view version, const std::optional<PageCase>& opened) {
  Json out{{"version", version}, {"title", title}, {"tables", Json::array()}};
  for (const PageTable& table : tables) out["tables"].push_back(table_json(table));
  if (opened) out["case"] = {{"file", opened->file}, {"text", opened->text}};
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace stationary
