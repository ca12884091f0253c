#include "solver/program/text/row_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <string_view>

#include "solver/motion/event.hpp"
#include "solver/program/text/named.hpp"
#include "solver/program/text/nearest_name.hpp"

namespace stationary::cli {
namespace {

std::optional<long> whole_number(std::string_view text) {
  long out = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return out;
}

bool is_event(std::string_view text) {
  return !text.empty() && named<EventType>(event_names, text);
}

}  // namespace

Origin place_of_row(const std::string& text) {
  return Origin::of_option("--from " + printable(text));
}

void refuse_row(const std::string& text, const std::string& found, const std::string& expected,
                const std::string& remedy) {
  throw InputError(place_of_row(text), "", found, expected, remedy);
}

RowName row_name(const std::string& text) {
  const std::size_t last = text.rfind(':');
  if (last == std::string::npos || last == 0)
    refuse_row(text, "found no row", "TABLE:N, TABLE:EVENT or TABLE:EVENT:K");
  const std::string end = text.substr(last + 1);
  RowName out{text.substr(0, last), {}, 1};
  if (const auto number = whole_number(end)) {
    out.number = *number;
    const std::size_t before = out.path.rfind(':');
    const std::string event = before == std::string::npos ? "" : out.path.substr(before + 1);
    if (is_event(event)) {
      out.event = event;
      out.path.resize(before);
    }
  } else if (is_event(end)) {
    out.event = end;
  } else {
    const std::span<const std::string_view> names = std::span(event_names).subspan(1);
    refuse_row(text, "found " + in_quotes(end),
               "a row's number, or an event, one of " + listed(names),
               did_you_mean(nearest_name(end, names)));
  }
  if (out.number < 1) refuse_row(text, fmt::format("found row {}", out.number), "rows from 1 on");
  return out;
}

}  // namespace stationary::cli
