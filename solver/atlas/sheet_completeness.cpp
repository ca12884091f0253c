// What is proven of a kind of motion for every nu of the range (SheetSet::complete()).
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "solver/atlas/sheet_arc.hpp"
#include "solver/atlas/sheet_set.hpp"
#include "solver/tube/curve_equations.hpp"

namespace stationary {
namespace {

constexpr std::string_view interrupted = "interrupted";
constexpr std::string_view parts = "ellipses part from circles";
constexpr std::string_view parts_once = "ellipses part from circles: one event, proven";
constexpr std::string_view folds = "two sheets meet at a fold";
constexpr std::string_view leaves = "a sheet leaves the box";
constexpr std::string_view tilts = "a sheet ends in a tilt";
constexpr std::string_view part_leaves =
    "one stretch leaves the box, with no motion on either side for want of the others";
constexpr std::string_view part_folds =
    "one stretch folds, with no motion on either side for want of the others";

std::string_view reason_of(const NuGap& gap) {
  if (gap.undecided) return "boxes are left undecided";
  if (gap.mirrors) return parts;
  if (gap.turns) return folds;
  return gap.crosses ? leaves : tilts;
}

/// A sheet on its way to an escape hardly changes nu any more where it leaves the box, so that it may as well
/// turn there. Two sheets that meet are two fewer, on one side of where they do; where the number proven
/// on both sides differs by an odd one a sheet has left, or has ended.
void tell_box_from_folds(std::vector<CompleteInterval>& all, const std::vector<NuGap>& gaps) {
  for (std::size_t k = 1; k + 1 < all.size(); ++k) {
    if (!all[k - 1].proven || !all[k + 1].proven) continue;
    if (all[k - 1].sheets == 0 && all[k + 1].sheets == 0) {
      if (all[k].reason == leaves) all[k].reason = part_leaves;
      if (all[k].reason == folds) all[k].reason = part_folds;
    }
    if (all[k].reason != folds) continue;
    const auto is_it = [&](const NuGap& gap) { return gap.nu.lo == all[k].from; };
    const auto gap = std::ranges::find_if(gaps, is_it);
    const bool odd = (all[k + 1].sheets - all[k - 1].sheets) % 2 != 0;
    if (gap != gaps.end() && odd && (gap->crosses || gap->ends))
      all[k].reason = gap->crosses ? leaves : tilts;
  }
}

/// Neighbours without a proof as one, by the reason of the first: a fold's own gap, and those of the
/// classes beside it.
void join_open_classes(std::vector<ClassInterval>& all) {
  std::vector<ClassInterval> out;
  for (ClassInterval& each : all) {
    const bool joins = !out.empty() && !each.proven && !out.back().proven;
    if (!joins) {
      out.push_back(std::move(each));
    } else {
      out.back().to = each.to;
      out.back().beyond = std::max(out.back().beyond, each.beyond);
    }
  }
  all = std::move(out);
}

bool is_listed(std::span<const Interval> listed, const Interval& nu) {
  return std::ranges::any_of(listed, [&](const Interval& each) { return !each.apart_from(nu); });
}

/// What is known without a proof that there is nothing.
Beyond by_rows(Beyond known, std::span<const Interval> listed, const Interval& nu) {
  return is_listed(listed, nu) ? std::max(known, Beyond::sheet_listed) : known;
}

/// A sheet that leaves the box is counted on one side of where it does: on the other it is outside.
OpenEnds open_ends(std::span<const CompleteInterval> all, std::size_t k) {
  const auto is_outside = [&](const CompleteInterval& gap, const CompleteInterval& other) {
    return all[k].proven && gap.leaves_box() && other.proven && other.sheets > all[k].sheets;
  };
  return {k >= 2 && is_outside(all[k - 1], all[k - 2]),
          k + 2 < all.size() && is_outside(all[k + 1], all[k + 2])};
}

}  // namespace

/// The number of motions between two nu where it is constant, by one search between them.
void SheetSet::add_interval(double from, double to, std::span<const Interval> class_gaps) {
  const double middle = from + 0.5 * (to - from);
  if (!(from < middle && middle < to)) return;
  CompleteInterval& out = completeness_->intervals.emplace_back();
  out.from = from;
  out.to = to;
  const std::size_t checkpoint = checkpoints_.size();
  add_checkpoint(middle);
  const SearchResult found = source_->search(middle, options_.search);
  keep_found(checkpoint, found);
  const Checkpoint& at = checkpoints_[checkpoint];
  out.proven = at.status == SearchStatus::complete;
  if (out.proven) {
    out.sheets = at.proven;
  } else {
    out.reason = "the number of motions is constant, but the search at its middle is undecided";
  }
  if (options_.spectrum) add_classes(from, to, class_gaps, middle, found);
}

/// Likewise their classes; found: at one nu between.
void SheetSet::add_classes(double from, double to, std::span<const Interval> class_gaps,
                           double searched, const SearchResult& found) {
  const auto constant = [&](double begin, double end) {
    const double middle = begin + 0.5 * (end - begin);
    if (!(begin < middle && middle < end)) return;
    const bool known = begin <= searched && searched <= end;
    completeness_->classes.push_back(
        classes_between(begin, end, known ? found : source_->search(middle, options_.search)));
  };
  double begin = from;
  for (const Interval& gap : class_gaps) {
    if (options_.stopped()) {
      completeness_->classes.push_back({begin, to, false, {}, interrupted});
      return;
    }
    if (gap.hi <= from || gap.lo >= to) continue;
    constant(begin, gap.lo);
    ClassInterval& open = completeness_->classes.emplace_back();
    open.from = std::max(gap.lo, from);
    open.to = std::min(gap.hi, to);
    open.reason = gap.lo <= 0.0 ? "at rest the classes are those of another leaf"
                                : "the class of a motion may change";
    begin = open.to;
  }
  constant(begin, to);
}

ClassInterval SheetSet::classes_between(double from, double to, const SearchResult& found) const {
  ClassInterval out;
  out.from = from;
  out.to = to;
  out.proven = found.status == SearchStatus::complete;
  if (!out.proven) out.reason = "classes are constant, but the search between is undecided";
  for (const Equilibrium* each : one_of_each_pair(found.solutions)) {
    if (!out.proven) break;
    const auto verdict = source_->proven_class(*each, options_.search.inputs);
    out.proven = verdict.has_value();
    if (verdict)
      ++out.sheets[static_cast<std::size_t>(*verdict)];
    else
      out.reason = "classes are constant, but one between is not proven";
  }
  return out;
}

void SheetSet::complete() {
  Completeness& out = completeness_.emplace();
  static_cast<SheetKind&>(out) = source_->kind();
  const double from = options_.from;
  const double to = options_.to;
  const auto cover = source_->cover(from, to, options_.search, options_.spectrum);
  if (!cover || cover->interrupted) {
    const std::string_view reason =
        cover ? interrupted : "no curves of this kind are covered; its checkpoints are proven";
    out.intervals.push_back({from, to, false, 0, reason});
    if (options_.spectrum) out.classes.push_back({from, to, false, {}, reason});
    return;
  }
  out.boxes = cover->boxes;
  out.class_arcs = cover->class_arcs;
  out.tubes = cover->tubes;
  const std::vector<Interval> class_gaps = cover->class_gaps.value_or(std::vector<Interval>{});
  double begin = from;
  for (const NuGap& gap : cover->gaps) {
    if (options_.stopped()) break;
    add_interval(begin, gap.nu.lo, class_gaps);
    const std::string_view reason = reason_of(gap);
    out.intervals.push_back({gap.nu.lo, gap.nu.hi, false, 0, reason});
    if (options_.spectrum) out.classes.push_back({gap.nu.lo, gap.nu.hi, false, {}, reason});
    begin = gap.nu.hi;
  }
  if (options_.stopped() && begin < to) {
    out.intervals.push_back({begin, to, false, 0, interrupted});
    if (options_.spectrum) out.classes.push_back({begin, to, false, {}, interrupted});
  } else {
    add_interval(begin, to, class_gaps);
  }
  tell_box_from_folds(out.intervals, cover->gaps);
  for (CompleteInterval& each : out.intervals) {
    if (each.reason != leaves) continue;
    each.beyond = Beyond::sheet_leaves_box;
  }
  for (const CompleteInterval& each : out.intervals) {
    for (ClassInterval& open : out.classes) {
      if (each.proven || open.proven || open.from != each.from || open.to != each.to) continue;
      open.reason = each.reason;
      open.beyond = each.beyond;
    }
  }
  join_open_classes(out.classes);
}

/// The nu at which rows of the sheets followed are outside the box.
std::vector<Interval> SheetSet::listed_outside() const {
  std::vector<Interval> out;
  for (const AtlasSheet& sheet : sheets_) {
    for (std::size_t k = 1; k < sheet.rows.size(); ++k) {
      const Member& a = sheet.rows[k - 1].member;
      const Member& b = sheet.rows[k].member;
      const bool has_a = !in_box(a.q, options_.search, sheet.mirror);
      const bool has_b = !in_box(b.q, options_.search, sheet.mirror);
      if (!has_a && !has_b) continue;
      // Where one of the two is inside, of the way between them nothing is said.
      const auto [low, high] =
          std::minmax({std::abs((has_a ? a : b).nu), std::abs((has_b ? b : a).nu)});
      out.emplace_back(low, high);
    }
  }
  return out;
}

bool SheetSet::excludes_outside(const Interval& nu, std::span<const Interval> listed) const {
  return !is_listed(listed, nu) && source_->none_outside(nu.lo, nu.hi, options_.search);
}

/// Of an interval all but its open ends, each as small as the proof allows: no motion is outside at these
/// nu. Nothing where there is no proof for most of the interval.
std::optional<Interval> SheetSet::excluded_between(const CompleteInterval& of, const OpenEnds& ends,
                                                   std::span<const Interval> listed) const {
  // Of an end, relative to nu. How far a sheet goes on before it escapes depends on its potential.
  constexpr std::array sizes{1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9,
                             1e-8,  1e-7,  1e-6,  1e-5,  1e-4,  1e-3};
  const auto between = [&](std::size_t k) {
    return Interval(ends.low ? of.from * (1.0 + sizes[k]) : of.from,
                    ends.high ? of.to * (1.0 - sizes[k]) : of.to);
  };
  const auto excluded = [&](std::size_t k) { return excludes_outside(between(k), listed); };
  const auto is_small = [&](double size) { return size * of.to < 0.1 * (of.to - of.from); };
  auto proven = static_cast<std::size_t>(std::ranges::count_if(sizes, is_small));
  // The largest first: where it fails, smaller ones would.
  if (proven == 0 || !excluded(--proven)) return std::nullopt;
  for (std::size_t least = 0; least < proven;) {
    const std::size_t k = (least + proven) / 2;
    if (excluded(k))
      proven = k;
    else
      least = k + 1;
  }
  return between(proven);
}

/// The parts of an interval, ascending, with no motion outside, by halves: what is left about a point
/// or two, as where a pull equals a stiffness and a stretch may be any, is as small as rounding lets it be.
std::vector<Interval> SheetSet::excluded_parts(const CompleteInterval& of,
                                               std::span<const Interval> listed) const {
  constexpr int levels = 44;
  constexpr int hopeless = 3;        // nothing by then: nothing after
  constexpr std::size_t points = 4;  // about so many are left
  // Of nu: what is shorter lies at events, where no half has a proof.
  constexpr double worth = 1e-3;
  std::vector<Interval> out;
  if (of.to - of.from < worth * of.to) return out;
  std::vector<Interval> open{{of.from, of.to}};
  for (int level = 1; level <= levels && !open.empty() && !options_.stopped(); ++level) {
    std::vector<Interval> left;
    for (const Interval& each : open) {
      const double middle = 0.5 * (each.lo + each.hi);
      for (const Interval& half : {Interval(each.lo, middle), Interval(middle, each.hi)})
        (excludes_outside(half, listed) ? out : left).push_back(half);
    }
    open = std::move(left);
    const bool hangs_on_points = open.size() <= 2 * points;
    if (level >= hopeless && (out.empty() || !hangs_on_points)) break;
  }
  return merged(std::move(out));
}

/// By the rows of the sheets followed, and where there are none outside the box, by a proof that there is
/// nothing. A sheet that leaves the box often escapes soon after: the interval is cut then, so that
/// nothing is left open but a small end of it.
void SheetSet::name_beyond() {
  if (!completeness_) return;
  const std::vector<Interval> listed = listed_outside();
  const std::vector<CompleteInterval> all = std::move(completeness_->intervals);
  std::vector<CompleteInterval>& out = completeness_->intervals;
  out.clear();
  const auto add = [&](CompleteInterval part, double from, double to, bool excluded) {
    part.from = from;
    part.to = to;
    part.beyond = excluded ? Beyond::excluded : by_rows(part.beyond, listed, {from, to});
    out.push_back(part);
  };
  for (std::size_t k = 0; k < all.size(); ++k) {
    const CompleteInterval& each = all[k];
    const bool excluded = !each.leaves_box() && excludes_outside({each.from, each.to}, listed);
    const OpenEnds ends = excluded ? OpenEnds() : open_ends(all, k);
    const auto between =
        ends.low || ends.high ? excluded_between(each, ends, listed) : std::nullopt;
    if (!between) {
      double done = each.from;
      if (!excluded && !each.leaves_box()) {
        for (const Interval& part : excluded_parts(each, listed)) {
          if (part.lo > done) add(each, done, part.lo, false);
          add(each, part.lo, part.hi, true);
          done = part.hi;
        }
      }
      if (done < each.to) add(each, done, each.to, excluded);
      continue;
    }
    if (ends.low) add(each, each.from, between->lo, false);
    add(each, between->lo, between->hi, true);
    if (ends.high) add(each, between->hi, each.to, false);
  }
  for (ClassInterval& each : completeness_->classes) {
    const auto leaves_room = [&](const CompleteInterval& other) {
      const bool meets = other.from < each.to && each.from < other.to;
      return meets && other.beyond != Beyond::excluded;
    };
    each.beyond = by_rows(each.beyond, listed, {each.from, each.to});
    if (each.beyond == Beyond::not_examined && std::ranges::none_of(out, leaves_room))
      each.beyond = Beyond::excluded;
  }
}

/// By the event's own equations, where its tube has told that they part.
void SheetSet::prove_partings() {
  if (!completeness_) return;
  std::vector<Parting> partings;
  add_partings(sheets_, partings);
  for (const Parting& each : partings) {
    const auto meets = [&](const CompleteInterval& interval) {
      constexpr double near = 1e-9;
      return interval.reason == parts && interval.from <= each.at.nu * (1.0 + near) &&
             interval.to >= each.at.nu * (1.0 - near);
    };
    const auto interval = std::ranges::find_if(completeness_->intervals, meets);
    if (interval == completeness_->intervals.end()) continue;
    const auto nu = source_->proven_parting(each.at, options_.search.inputs);
    if (nu && !nu->apart_from({interval->from, interval->to})) interval->reason = parts_once;
  }
}

/// What the sheets' events say of the parts in which no class is proven.
void SheetSet::name_class_events() {
  if (!completeness_) return;
  for (const AtlasSheet& sheet : sheets_) {
    for (const EventRecord& event : sheet.report.events) {
      if (event.status == EventStatus::unresolved || std::isnan(event.parameter)) continue;
      for (ClassInterval& each : completeness_->classes) {
        constexpr double near = 1e-9;
        const double nu = std::abs(event.parameter);
        if (each.proven || nu < each.from * (1.0 - near) || nu > each.to * (1.0 + near)) continue;
        if (std::ranges::find(each.events, event.type) == each.events.end())
          each.events.push_back(event.type);
      }
    }
  }
}

}  // namespace stationary
