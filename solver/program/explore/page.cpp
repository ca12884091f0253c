#include "solver/program/explore/page.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "solver/program/explore/page_template.hpp"
#include "solver/program/explore/page_text.hpp"

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
                      std::string_view version) {
  Json out{{"version", version}, {"title", title}, {"tables", Json::array()}};
  for (const PageTable& table : tables) out["tables"].push_back(table_json(table));
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string page(std::span<const std::string_view> pieces, std::string_view title,
                 std::string_view data) {
  std::string form;
  for (const std::string_view piece : pieces) form += piece;
  std::string out;
  std::size_t at = 0;
  while (true) {
    const std::size_t to_title = form.find(title_place, at);
    const std::size_t to_data = form.find(data_place, at);
    const std::size_t next = std::min(to_title, to_data);
    out += std::string_view(form).substr(at, next - at);
    if (next == std::string::npos) return out;
    out += next == to_title ? html_text(title) : packed(data);
    at = next + (next == to_title ? title_place : data_place).size();
  }
}

}  // namespace stationary
