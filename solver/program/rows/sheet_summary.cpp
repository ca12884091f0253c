#include "solver/program/rows/sheet_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/program/text/written_number.hpp"

namespace stationary {
namespace {

constexpr auto first_type = static_cast<std::size_t>(EventType::none) + 1;
constexpr auto last_type = static_cast<std::size_t>(EventType::unexplained);

/// The least of some, and how many.
struct Least {
  long count = 0;
  double value = std::numeric_limits<double>::infinity();

  void add(double at) {
    ++count;
    value = std::min(value, at);
  }
  std::string text() const {
    if (count == 0) return {};
    return number_text(value);
  }
};

bool is_calm(const Segment& segment) {
  return segment.verdict == StabilityClass::stable || segment.verdict == StabilityClass::elliptic;
}
bool is_unstable(const Segment& segment) {
  return segment.verdict == StabilityClass::unstable ||
         segment.verdict == StabilityClass::oscillatory;
}

}  // namespace

std::vector<CellColumn> sheet_summary_columns() {
  std::vector<CellColumn> out{{"sheets", CellKind::count},
                              {"events", CellKind::count},
                              {"first_instability", CellKind::number},
                              {"first_event", CellKind::number},
                              {"complete_fraction", CellKind::number}};
  for (std::size_t type = first_type; type <= last_type; ++type) {
    out.push_back({std::string(event_names[type]) + "_count", CellKind::count});
    out.push_back({std::string(event_names[type]) + "_first", CellKind::number});
  }
  return out;
}

std::string sheet_summary(std::span<const SheetRecord> sheets,
                          std::optional<double> complete_fraction) {
  Least instability;
  Least any;
  std::vector<Least> of_type(last_type + 1);
  for (const SheetRecord& sheet : sheets) {
    for (std::size_t k = 1; k < sheet.segments.size(); ++k) {
      const Segment& before = sheet.segments[k - 1];
      const Segment& after = sheet.segments[k];
      if (is_calm(before) && is_unstable(after)) instability.add(before.to.parameter);
      if (is_unstable(before) && is_calm(after)) instability.add(after.from.parameter);
    }
    for (const EventRecord& event : sheet.events) {
      any.add(event.parameter);
      of_type[static_cast<std::size_t>(event.type)].add(event.parameter);
    }
  }
  std::string out =
      fmt::format("{},{},{},{},", sheets.size(), any.count, instability.text(), any.text());
  if (complete_fraction) out += fmt::format("{}", *complete_fraction);
  for (std::size_t type = first_type; type <= last_type; ++type)
    out += fmt::format(",{},{}", of_type[type].count, of_type[type].text());
  return out;
}

}  // namespace stationary
