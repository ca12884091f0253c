#include "solver/program/diagram/event_lines.hpp"

#include <algorithm>
#include <array>

#include "solver/program/diagram/row_parameter.hpp"
#include "solver/program/text/named.hpp"

namespace stationary {

std::vector<std::string> curve_parameters(const std::vector<std::string>& columns) {
  for (const std::string_view needed : {"event", "curve"})
    if (std::ranges::find(columns, needed) == columns.end()) return {};
  std::vector<std::string> out = parameters_among(columns);
  if (out.size() != 2) out.clear();
  return out;
}

std::vector<EventLine> read_event_lines(TableReader& table, std::string_view x,
                                        std::string_view y) {
  const std::vector<std::string> own = curve_parameters(table.columns());
  if (own.empty() || std::ranges::find(own, x) == own.end() ||
      std::ranges::find(own, y) == own.end()) {
    throw InputError(Origin::in_file(table.name()), "",
                     own.empty()
                         ? std::string("found no table of curve")
                         : "found curves in " + printable(own[0]) + " and " + printable(own[1]),
                     "a table of curve in " + printable(x) + " and " + printable(y));
  }
  const std::size_t at_x = table.column(x).value();
  const std::size_t at_y = table.column(y).value();
  const std::size_t event = table.column("event").value();
  const std::size_t curve = table.column("curve").value();
  const auto special = table.column("special");
  std::vector<EventLine> out;
  std::string last;
  while (table.next()) {
    if (out.empty() || table.text(curve) != last) {
      last = table.text(curve);
      out.push_back({std::string(table.text(event)), {}, {}});
    }
    const std::array<double, 2> at{table.number(at_x), table.number(at_y)};
    out.back().points.push_back(at);
    const std::string_view word = special ? table.text(*special) : std::string_view();
    if (word.empty()) continue;
    const auto type = named<SpecialPoint>(special_point_names, word);
    if (!type) throw table.fault(*special, "empty, or a special point");
    out.back().special.push_back({*type, at});
  }
  return out;
}

}  // namespace stationary
