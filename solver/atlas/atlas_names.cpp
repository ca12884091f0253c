// What is said of an atlas, apart from how it is made.
#include <algorithm>

#include "solver/atlas/atlas.hpp"

namespace stationary {

namespace {

EventType end_event(const FollowReport& report, const SheetEnd& end, EventType row) {
  const bool stopped = report.interrupted || report.out_of_points;
  return stopped && end.event == EventType::none ? EventType::none : row;
}

}  // namespace

Motion SheetKind::motion(double nu) const {
  if (plane) return TiltedMotion{plane, nu};
  if (oblique) return ObliqueRotation{nu};
  return AxisRotation{branch, nu};
}

EventType AtlasSheet::first_event() const {
  return end_event(report, report.backward, rows.front().event);
}
EventType AtlasSheet::last_event() const {
  return end_event(report, report.forward, rows.back().event);
}

namespace {

template <class Parts>
double unproven_length_of(const Parts& parts) {
  double out = 0.0;
  for (const auto& each : parts)
    if (!each.proven) out += each.to - each.from;
  return out;
}

}  // namespace

std::vector<CompleteInterval> Completeness::joined() const {
  std::vector<CompleteInterval> out;
  for (const CompleteInterval& each : intervals) {
    if (out.empty() || !out.back().proven || !each.proven || out.back().sheets != each.sheets) {
      out.push_back(each);
    } else {
      out.back().to = each.to;
      out.back().beyond = std::max(out.back().beyond, each.beyond);
    }
  }
  return out;
}

double Completeness::unproven_length() const { return unproven_length_of(intervals); }

double Completeness::unproven_class_length() const { return unproven_length_of(classes); }

std::string_view kind_name(const SheetKind& kind) { return name(kind.motion(0.0)); }

std::string kind_text(const SheetKind& kind) {
  std::string out(kind_name(kind));
  if (kind.plane) out += ", plane " + std::string(name(*kind.plane));
  return out;
}

}  // namespace stationary
