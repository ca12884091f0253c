// In the place of what goes on from tables on the disk: a page has none.
#include "solver/program/computation/row_start.hpp"
#include "solver/program/session/resume.hpp"

namespace stationary::cli {
namespace {

[[noreturn]] void refuse(const std::string& row) {
  throw InputError(Origin::of_option("continuation.start_row"), "", "found " + in_quotes(row),
                   "no such key in a page, which has no tables beside it",
                   "start from the row itself: solve.start");
}

}  // namespace

RowStart start_from_row(const Case&, const std::string& row) { refuse(row); }

std::vector<std::string_view> lacking_to_resume(const Case&, const std::vector<Column>&) {
  return {};
}

ResumedTable resumed_table(const Case&, const std::string& path, const std::vector<Column>&,
                           const std::optional<std::string>&) {
  refuse(path);
}

FollowReport follow_on(const AnyFamily&, const ResumedTable&, double, FollowOptions, CurveTable&) {
  refuse("a table to go on with");
}

}  // namespace stationary::cli
