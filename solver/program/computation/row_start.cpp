#include "solver/program/computation/row_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "solver/kind/kind.hpp"
#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/table/table_reader.hpp"
#include "solver/program/text/named.hpp"
#include "solver/program/text/row_name.hpp"
#include "solver/program/tiles/study_source.hpp"

namespace stationary::cli {
namespace {

/// A row as the text it was written in, by column.
using Cells = std::map<std::string, std::string, std::less<>>;

Cells cells_of(const TableReader& table) {
  Cells out;
  for (std::size_t k = 0; k < table.columns().size(); ++k)
    out.emplace(table.columns()[k], table.text(k));
  return out;
}

/// NaN where there is no such cell, or it is no number.
double number_in(const Cells& row, std::string_view column) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto at = row.find(column);
  if (at == row.end()) return none;
  const char* const end = at->second.data() + at->second.size();
  double out = none;
  const auto [read, error] = std::from_chars(at->second.data(), end, out);
  return error == std::errc() && read == end ? out : none;
}

/// Whether a row of this event is no place to start from along its own sheet: a fold, where the parameter
/// names no point of its own, an end at unbounded or vanishing stretches, or where sheets of one branch
/// meet, which S does not tell apart there. The row beside it is.
bool is_no_start(std::string_view event, std::string_view branch) {
  for (const EventType each :
       {EventType::fold_nu, EventType::fold_parameter, EventType::escape, EventType::collapse,
        EventType::ellipse, EventType::ellipse_23, EventType::ellipse_13, EventType::shear})
    if (event == name(each)) return true;
  // The end of a family whose axis has come to a material one.
  const bool ends = event == name(EventType::tilt) || event == name(EventType::oblique);
  return ends && !branch_from_name(branch);
}

/// Whether a double of the parameter tells the row from its neighbours, which on the way to unbounded or
/// vanishing stretches it does no more; a table without error bounds does not say.
bool is_resolved(const Cells& row) {
  constexpr double resolved = 1e-9;
  return !(number_in(row, "error_bound") > resolved);
}

/// The row; to go on along the sheets of a branch, the nearest on the same sheet that is a place to start from.
/// Beside a row of a curve of events is another body's.
Cells row_of(const std::string& text, const std::optional<std::string>& along) {
  const RowName wanted = row_name(text);
  TableReader table = open_table(wanted.path);
  const auto event = table.column("event");
  const bool of_sheets = event && table.column("sheet");
  if (!wanted.event.empty() && !event)
    refuse_row(text, "found no column event", "a table of continue or atlas");
  long number = 0;
  long rows = 0;
  Cells before;
  Cells resolved;
  std::optional<Cells> skipped;
  const auto on_sheet_of = [](const Cells& row, const Cells& other) {
    return !row.empty() && row.at("sheet") == other.at("sheet");
  };
  bool unbounded = false;
  while (table.next()) {
    ++rows;
    Cells here = cells_of(table);
    // Nothing was before it.
    if (skipped && on_sheet_of(*skipped, here) && (!unbounded || is_resolved(here))) return here;
    const bool counts = wanted.event.empty() || table.text(*event) == wanted.event;
    if (counts && ++number == wanted.number) {
      if (!along || !of_sheets || here["branch"] != *along ||
          !is_no_start(table.text(*event), *along))
        return here;
      unbounded = table.text(*event) == name(EventType::escape) ||
                  table.text(*event) == name(EventType::collapse);
      const Cells& beside = unbounded ? resolved : before;
      if (on_sheet_of(beside, here)) return beside;
      skipped = std::move(here);
      continue;
    }
    if (along && is_resolved(here) && !(event && is_no_start(table.text(*event), *along)))
      resolved = here;
    before = std::move(here);
  }
  refuse_row(text,
             wanted.event.empty() ? fmt::format("found {} row{}", rows, rows == 1 ? "" : "s")
                                  : fmt::format("found {} row{} of {}", number,
                                                number == 1 ? "" : "s", wanted.event),
             fmt::format("a row {}", wanted.number));
}

class FromRow {
 public:
  FromRow(const Case& given, const std::string& text, bool to_start_from)
      : given_(given),
        text_(text),
        row_(row_of(text, to_start_from ? std::optional<std::string>(given.branch_name())
                                        : std::nullopt)) {}

  RowStart run() {
    Case input = with_numbers_of_the_row();
    if (!input.continuation)
      refuse_row(text_, "found no [continuation] in the case", "a case to be continued");
    const Stretch q = stretch(input);
    const std::string own = text("branch");
    const std::string wanted(input.branch_name());
    if (own != wanted) return beginning(std::move(input), q, own);
    return finished(std::move(input), q);
  }

  EventRow event(EventType type) {
    if (!row_.contains("event"))
      refuse_row(text_, "found no column event", "a table that names its rows' events");
    const auto is_one = [&](EventType each) { return row_.at("event") == name(each); };
    const bool folds = is_fold(type) &&
                       (is_one(EventType::fold_nu) || is_one(EventType::fold_parameter));
    if (!is_one(type) && !folds)
      refuse_row(text_, "found " + in_quotes(row_.at("event")),
                 "a row of " + in_quotes(name(type)));
    if (text("branch") != given_.branch_name())
      refuse_row(text_, "found a row of branch " + in_quotes(text("branch")),
                 "a row of branch " + in_quotes(given_.branch_name()));
    EventRow out{with_numbers_of_the_row(), {}};
    const Case& input = out.input;
    out.q = stretch(input);
    for (std::size_t k = 0; k < input.curve->parameters.size(); ++k)
      require_between(input, input.curve->parameters[k], input.curve->from[k], input.curve->to[k]);
    return out;
  }

 private:
  /// S, in the coordinates of the row's own body.
  Stretch stretch(const Case& input) const {
    const bool sheared = may_have_alpha(input.motion, input.potential);
    const Stretch q{sheared ? value("alpha") : value_or("alpha", 0.0), value("xi"), value("zeta"),
                    value("rho")};
    if (const char* inequality = violated_inequality(q))
      refuse_row(text_, "found no positive definite S in the row", inequality);
    return input.coordinates.computed(q);
  }
  std::string text(std::string_view column) const {
    const auto at = row_.find(column);
    if (at == row_.end() || at->second.empty())
      refuse_row(text_, fmt::format("found no {} in the row", column),
                 "a row of solve, continue, atlas or map");
    return at->second;
  }
  double value(std::string_view column) const {
    const std::string cell = text(column);
    const double out = number_in(row_, column);
    if (std::isnan(out))
      refuse_row(text_, fmt::format("found {} in the column {}", in_quotes(cell), column),
                 "a number");
    return out;
  }
  /// Where the row has none.
  double value_or(std::string_view column, double otherwise) const {
    const auto at = row_.find(column);
    return at == row_.end() || at->second.empty() ? otherwise : value(column);
  }
  /// About a material axis the others are 0; a two-polar row has none.
  Vector3<double> nu() const {
    constexpr std::string_view names[] = {"nu1", "nu2", "nu3"};
    const std::string branch = text("branch");
    const auto about = branch_from_name(branch);
    Vector3<double> out;
    for (int k = 0; k < 3; ++k) {
      const bool needed = about ? axis(*about) == k : !has_rates(branch);
      out[k] = needed ? value(names[k]) : value_or(names[k], 0.0);
    }
    return out;
  }

  static constexpr std::string_view gravity = "gravity.";

  /// A number of the row in the case's place. Gravity is given by one of two: the other is left out.
  Override set(const std::string& key, const std::string& cell) const {
    return {key.starts_with(gravity) ? "gravity={" + key.substr(gravity.size()) + "=" + cell + "}"
                                     : key + "=" + cell,
            place_of_row(text_)};
  }

  /// The case with the row's motion and what its trailing columns set of the body.
  Case with_numbers_of_the_row() const {
    std::vector<Override> all;
    Motion motion = given_.motion;
    for (const MotionNumber& each : motion_numbers(motion)) {
      const std::string key(each.parameter == "nu" ? "motion.nu" : each.parameter);
      if (each.parameter != "nu") {
        all.push_back(set(key, text(key.substr(key.find('.') + 1))));
        continue;
      }
      const auto branch = branch_from_name(given_.branch_name());
      const double spin = branch ? nu()[axis(*branch)] : nu().norm();
      all.push_back(set(key, fmt::format("{}", spin)));
    }
    // In their order a whole J comes before one of its numbers.
    for (const auto& [key, cell] : row_)
      if (!cell.empty() && may_be_set(key) &&
          (key.starts_with("body.") || key.starts_with("potential.") || key.starts_with(gravity)))
        all.push_back(set(key, toml_value(key, cell)));
    if (has_rates(given_.motion) && text("branch") != given_.branch_name())
      refuse_row(text_, "found a row of branch " + in_quotes(text("branch")),
                 "a row of branch " + in_quotes(given_.branch_name()),
                 "rates and momenta are not in the row");
    Case out = with_ratios(make_case(given_.source, all));
    out.output.certificate = given_.output.certificate;
    if (text("branch") == given_.branch_name() && !may_have_axis(out.motion, nu()))
      refuse_row(text_, "found a row whose axis lies in another plane",
                 "a row in the plane of motion.plane");
    out.motion = decided(out.motion, nu()[1] != 0.0);
    return out;
  }

  /// The case with the numbers that columns of ratios vary.
  Case with_ratios(Case out) const {
    const std::vector<std::string> numbers = case_parameters(out.motion, out.models);
    const auto known = [&](std::string_view key) {
      return std::ranges::find(numbers, key) != numbers.end();
    };
    std::vector<std::string> left;
    for (const auto& [column, cell] : row_) {
      const auto [first, second] = parts_of(column);
      if (!second.empty() && !cell.empty() && known(first) && known(second)) left.push_back(column);
    }
    // Where one number is divided by the other, that one comes first.
    const auto waits = [&](const std::string& column) {
      return std::ranges::any_of(left, [&](const std::string& other) {
        return parts_of(other).first == parts_of(column).second;
      });
    };
    while (!left.empty()) {
      auto next = std::ranges::find_if_not(left, waits);
      if (next == left.end()) next = left.begin();
      const auto [first, second] = parts_of(*next);
      const double unit = parameter_value({out.own_body, out.models, out.motion}, second);
      const Override varied = set(first == "nu" ? "motion.nu" : std::string(first),
                                  fmt::format("{}", value(*next) * unit));
      left.erase(next);
      out = make_case(out.source, {&varied, 1});
    }
    return out;
  }

  /// The row's own value of the parameter, which must be in the range followed; an end of a curve of events
  /// is there but for rounding.
  double require_between(const Case& input, const std::string& parameter, double from,
                         double to) const {
    const double p = parameter_value(own_numbers(input), parameter);
    const double rounding = 0x1p-50 * std::max(std::abs(from), std::abs(to));
    if (!(p >= from - rounding && p <= to + rounding))
      refuse_row(text_, fmt::format("found a row at {} = {}", parameter, p),
                 fmt::format("a row in the range followed, [{}, {}]", from, to));
    return std::clamp(p, from, to);
  }

  RowStart finished(Case input, const Stretch& q) const {
    const Case::Continuation& range = *input.continuation;
    const double p = require_between(input, range.parameter, range.from, range.to);
    Start start{own_numbers(input), p, {}};
    start.found.status = SolveStatus::solved;
    start.found.message = "row " + printable(text_);
    start.found.connection = Connection::given_start;
    start.found.q = q;
    start.is_event = named_event() != EventType::none && !is_end(named_event());
    input.solve.start = q;
    input.own_solve.start = input.coordinates.told(q);
    return {std::move(input), std::move(start)};
  }

  EventType named_event() const {
    const auto event = row_.find("event");
    if (event == row_.end()) return EventType::none;
    return named<EventType>(event_names, event->second).value_or(EventType::none);
  }

  /// The case's family where it begins at the row's event.
  RowStart beginning(Case input, const Stretch& q, const std::string& own) const {
    const std::string event = row_.contains("event") ? row_.at("event") : "";
    Member member;
    member.body = input.body;
    member.q = q;
    member.angular_velocity = nu();
    member.nu = member.parameter = nu().norm();
    const Case::Continuation& range = *input.continuation;
    const Alternatives kinds = alternatives(input.body, input.potential, given_.motion, true);
    for (const auto& [label, kind] : kinds.each) {
      const auto begun =
          kind->beginning(named_event(), member, branch_from_name(own), {range.from, range.to});
      if (!begun) continue;
      input.motion = begun->motion;
      RowStart out = finished(std::move(input), begun->q);
      out.start.is_event = out.start.is_event && begun->at_event;
      return out;
    }
    refuse_row(text_,
               fmt::format("found a row of branch {}{}", in_quotes(own),
                           event.empty() ? "" : " at the event " + event),
               fmt::format("a row of branch {}, or an event where that family begins",
                           in_quotes(input.branch_name())));
  }

  const Case& given_;
  const std::string& text_;
  Cells row_;
};

}  // namespace

RowStart start_from_row(const Case& given, const std::string& row) {
  return FromRow(given, row, true).run();
}

EventRow event_of_row(const Case& given, const std::string& row, EventType type) {
  return FromRow(given, row, false).event(type);
}

std::string table_of_row(const std::string& row) { return row_name(row).path; }

}  // namespace stationary::cli
