#include "solver/program/session/resume.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/rows/metadata_reading.hpp"
#include "solver/program/session/computation_plan.hpp"
#include "solver/program/table/atomic_file.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/text/named.hpp"

namespace stationary::cli {
namespace {

/// Compares what is written to it with a file from its beginning on.
class SameBytes final : public ByteSink {
 public:
  explicit SameBytes(const std::string& path) : file_(path, std::ios::binary) {}
  void write(std::string_view bytes) override {
    std::string own(bytes.size(), '\0');
    file_.read(own.data(), static_cast<std::streamsize>(own.size()));
    same_ = same_ && file_ && own == bytes;
  }
  bool whole() { return same_ && file_.peek() == std::ifstream::traits_type::eof(); }

 private:
  std::ifstream file_;
  bool same_ = true;
};

/// Whether a table has these rows in this program's own spelling.
bool is_as_written(const std::string& path, const std::vector<TableRow>& rows,
                   const std::vector<Column>& columns,
                   const std::optional<std::string>& parameter) {
  if (is_column_file(path)) return true;
  SameBytes file(path);
  TableWriter writer(file, columns, parameter);
  for (const TableRow& row : rows) writer.write(row);
  writer.flush();
  return file.whole();
}

/// How a table that is not gone on with there ended.
SheetEnd old_end(const TableRow& row, const std::string& reason) {
  return {named<EventType>(event_names, row.event).value(), reason};
}

}  // namespace

std::vector<std::string_view> lacking_to_resume(const Case& input,
                                                const std::vector<Column>& columns) {
  std::vector<Column> needed;
  if (may_have_alpha(input.motion, input.potential)) needed.push_back(Column::alpha);
  if (input.output.certificate) needed.push_back(Column::certified);
  if (input.output.certificate && wants_spectrum(input, /*to_table=*/true))
    needed.push_back(Column::class_certified);
  std::vector<std::string_view> out;
  for (const Column c : needed)
    if (std::ranges::find(columns, c) == columns.end()) out.push_back(name(c));
  return out;
}

ResumedTable resumed_table(const Case& input, const std::string& path,
                           const std::vector<Column>& columns,
                           const std::optional<std::string>& parameter) {
  const auto refuse = [&](const std::string& found) {
    throw InputError(Origin::of_option("--resume"), "", found,
                     "-o FILE, a table of this case that `continue` was interrupted in",
                     "its .meta.json beside it says which case it is of");
  };
  if (path.empty() || path == "-") refuse("found no file");
  const std::string metadata = metadata_path(path).string();
  const std::optional<std::string> read = bytes_of_file(metadata);
  if (!read) refuse("cannot read " + printable(metadata));
  const std::string& text = *read;
  if (const std::string other = other_program(text, STATIONARY_VERSION); !other.empty())
    refuse(fmt::format("found {} to be {}", printable(metadata), other));
  if (!is_metadata(text)) refuse(printable(metadata) + " is no metadata of this program");
  if (!is_of_case(text, input))
    refuse(printable(metadata) + " is of another case, or of one that another row was given to");
  std::optional<CurveRecord> record = curve_record(text);
  if (!record) refuse(printable(metadata) + " does not say what rows and events the table has");
  for (const std::string_view each : lacking_to_resume(input, columns))
    refuse(fmt::format("found no column {}", each));
  ResumedTable out =
      read_resumed(path, columns, parameter, input.branch_name(), record->last_is_open);
  if (out.rows.size() != record->rows) {
    refuse(fmt::format("{} has {} rows, {} by its metadata", printable(path), out.rows.size(),
                       record->rows));
  }
  TableChecksum checksum;
  for (const TableRow& row : out.rows) checksum.add(row, columns, parameter.has_value());
  if (checksum.text() != record->checksum || !is_as_written(path, out.rows, columns, parameter))
    refuse(printable(path) + " was changed since it was written (its checksum is in the metadata)");
  for (auto* end : {&out.first, &out.last}) {
    if (!*end) continue;
    (*end)->at.q = input.coordinates.computed((*end)->at.q);
    if ((*end)->neighbour) (*end)->neighbour->q = input.coordinates.computed((*end)->neighbour->q);
  }
  out.events = std::move(record->events);
  out.segments = std::move(record->segments);
  out.first_reason = std::move(record->first_reason);
  out.last_reason = std::move(record->last_reason);
  Motion held = input.motion;
  out.at_rest = std::ranges::any_of(motion_numbers(held), [](const MotionNumber& each) {
    return each.parameter == "nu" && *each.value == 0.0;
  });
  return out;
}

FollowReport follow_on(const AnyFamily& family, const ResumedTable& old, double unit,
                       FollowOptions options, CurveTable& table) {
  FollowReport out;
  options.max_points -= static_cast<long>(old.rows.size());
  // Ends of the table in the family's own parameter.
  const auto in_family = [&](OpenEnd end) {
    end.at.p *= unit;
    if (end.neighbour) end.neighbour->p *= unit;
    return end;
  };
  const auto add = [&](FollowReport& part) {
    table.convert(part);
    out.counts += part.counts;
    out.points += part.points;
    out.interrupted = out.interrupted || part.interrupted;
    out.out_of_points = out.out_of_points || part.out_of_points;
    options.max_points -= part.points;
    if (out.failure.empty()) out.failure = part.failure;
  };
  if (old.first) {
    HeldBack held;
    FollowReport before = resume(family, in_family(*old.first), options, held);
    add(before);
    held.give(table);
    out.backward = before.forward;
    out.events.assign(before.events.rbegin(), before.events.rend());
  } else {
    out.backward = old_end(old.rows.front(), old.first_reason);
  }
  out.events.insert(out.events.end(), old.events.begin(), old.events.end());
  long point = 0;
  for (const TableRow& row : old.rows) {
    const auto its = std::ranges::find_if(old.segments, [&](const RecordedSegment& each) {
      return each.first_point <= point && point <= each.last_point;
    });
    table.again(row, its == old.segments.end() ? std::nullopt : its->verdict, old.at_rest);
    ++point;
  }
  out.points += static_cast<long>(old.rows.size());
  if (old.last && !out.interrupted) {
    FollowReport after = resume(family, in_family(*old.last), options, table);
    add(after);
    out.forward = after.forward;
    out.events.insert(out.events.end(), after.events.begin(), after.events.end());
  } else if (old.last) {
    out.forward.reason = "interrupted";
  } else {
    out.forward = old_end(old.rows.back(), old.last_reason);
  }
  return out;
}

}  // namespace stationary::cli
