#include "solver/atlas/sheet_set.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "lib/matrix/elementwise.hpp"
#include "lib/number/elementary.hpp"
#include "solver/atlas/sheet_arc.hpp"

namespace stationary {
namespace {

class Keep final : public CurveSink {
 public:
  explicit Keep(std::vector<AtlasRow>& rows) : rows_(&rows) {}
  void row(const Member& member, EventType event) override {
    rows_->push_back({member, event, std::exchange(before_, std::nullopt)});
  }
  void between(StabilityClass verdict) override { before_ = verdict; }

 private:
  std::optional<StabilityClass> before_;
  std::vector<AtlasRow>* rows_;
};

Entry entry_at(EventType event) {
  switch (event) {
    case EventType::shear:
      return Entry::shear;
    case EventType::oblique:
      return Entry::oblique;
    default:
      return Entry::ellipse;
  }
}

/// The motion of a family at nu between two of its rows.
template <int N>
std::optional<Member> between(const Family<N>& family, Member a, Member b, double nu) {
  align_axes(a, b);
  const double u = (nu - a.nu) / (b.nu - a.nu);
  const ReducedVector<N> from = family.coordinates_of(a);
  ReducedVector<N> x = from.array() * powers(family.coordinates_of(b).array() / from.array(), u);
  ReducedVector<N> tail;
  const Refined refined = family.refine_at(x, tail, nu);
  if (!refined.converged) return std::nullopt;
  return family.member(x, tail, nu, refined.error_bound);
}

/// ln (xi/zeta), which orders the motions of a vertical sheet.
double eccentricity(const Stretch& q) { return log(q.xi / q.zeta); }

/// Between two of its motions at an eccentricity, along a straight line of logarithms; nothing where
/// they are not on either side of it.
std::optional<Place> on_chord(const Stretch& a, const Stretch& b, double at) {
  const double from = eccentricity(a);
  const double to = eccentricity(b);
  if (from == to || (at < from) == (at < to)) return std::nullopt;
  const double u = (at - from) / (to - from);
  const auto between = [u](double x, double y) { return x * exp(u * log(y / x)); };
  return Place{{0.0, between(a.xi, b.xi), between(a.zeta, b.zeta), between(a.rho, b.rho)}};
}

FollowOptions follow_options(const AtlasOptions& options) {
  FollowOptions out;
  out.continuation.from = options.from;
  out.continuation.to = options.to;
  out.continuation.step = options.step;
  out.continuation.unit = options.unit;
  out.max_points = options.max_points;
  out.stop = options.stop;
  return out;
}

}  // namespace

FollowReport follow_rows(const AnyFamily& family, const Stretch& q, double nu,
                         const AtlasOptions& options, std::vector<AtlasRow>& rows) {
  Keep keep(rows);
  return follow(family, q, nu, follow_options(options), keep);
}

SheetSet::SheetSet(std::unique_ptr<SheetSource> source, const AtlasOptions& options)
    : options_(options), source_(std::move(source)) {
  for (int k = 0; k < source_->families(); ++k) {
    families_.push_back(source_->family(k, options.spectrum));
    plain_.push_back(std::make_shared<const AnyFamily>(source_->family(k, false)));
  }
  const double part = (options.to - options.from) / options.checkpoints;
  for (int k = 0; k < options.checkpoints; ++k) add_checkpoint(options.from + (k + 0.5) * part);
}

void SheetSet::add_checkpoint(double nu) {
  checkpoints_.push_back({source_->kind(), nu});
  solutions_.emplace_back();
  unproven_.emplace_back();
  std::vector<Place>& crossed = on_sheets_.emplace_back();
  for (std::size_t k = 0; k < sheets_.size(); ++k)
    add_crossings(sheets_[k], families_of_sheets_[k], nu, crossed);
}

std::vector<Checkpoint> SheetSet::checkpoints() const {
  std::vector<Checkpoint> out = checkpoints_;
  std::ranges::stable_sort(out, {}, &Checkpoint::nu);
  return out;
}

void SheetSet::search_at(std::size_t checkpoint, std::size_t number) {
  Checkpoint& at = checkpoints_[checkpoint];
  if (options_.stopped()) {
    at.status = SearchStatus::interrupted;
    return;
  }
  const auto known = options_.known_search ? options_.known_search(number) : std::nullopt;
  const SearchResult result = known ? *known : source_->search(at.nu, options_.search);
  if (!known && options_.searched) options_.searched(number, result);
  keep_found(checkpoint, result);
}

void SheetSet::keep_found(std::size_t checkpoint, const SearchResult& result) {
  Checkpoint& at = checkpoints_[checkpoint];
  at.status = result.status;
  const auto places = [this](const std::vector<Equilibrium>& found, std::vector<Place>& out) {
    for (const Equilibrium* each : one_of_each_pair(found)) out.push_back(canonical_place(*each));
    return static_cast<int>(out.size());
  };
  at.proven = places(result.solutions, solutions_[checkpoint]);
  at.unproven = places(result.unproven, unproven_[checkpoint]);
}

Place SheetSet::canonical_place(const Equilibrium& at) const {
  return source_->canonical(source_->place(at.q, at.nu));
}

/// Of a box that does not hold both mirror images, the one that it holds.
std::vector<const Equilibrium*> SheetSet::one_of_each_pair(
    const std::vector<Equilibrium>& found) const {
  std::vector<const Equilibrium*> out;
  for (const bool is_canonical : {true, false}) {
    for (const Equilibrium& each : found) {
      const Place place = canonical_place(each);
      const bool canonical = distance(source_->place(each.q, each.nu), place) < same_place;
      const auto same = [&](const Equilibrium* other) {
        return distance(place, canonical_place(*other)) < same_place;
      };
      if (canonical == is_canonical && (canonical || std::ranges::none_of(out, same)))
        out.push_back(&each);
    }
  }
  return out;
}

void SheetSet::follow_proven() {
  if (options_.from == 0.0 && !std::exchange(from_rest_, true)) follow_rest();
  enter_all(solutions_, Entry::search, std::exchange(entered_, checkpoints_.size()));
}

void SheetSet::follow_all(std::span<const AtlasSheet> others) {
  follow_others(others);
  for (std::size_t k = 0; k < checkpoints_.size(); ++k) count(k);
  if (options_.stopped()) return;
  prove_partings();
  name_class_events();
  name_beyond();
}

void SheetSet::enter_all(const std::vector<std::vector<Place>>& found, Entry entry,
                         std::size_t first) {
  for (std::size_t k = first; k < checkpoints_.size(); ++k) {
    for (const Place& at : found[k]) {
      if (options_.stopped()) return;
      if (!on_a_sheet(at, k)) enter(at, checkpoints_[k].nu, entry, checkpoints_[k].nu);
    }
  }
}

void SheetSet::follow_others(std::span<const AtlasSheet> others) {
  follow_proven();
  enter_all(unproven_, Entry::numerical, 0);
  if (source_->leaves_by() != EventType::none) {
    std::vector<Parting> partings;
    add_partings(sheets_, partings);
    add_partings(others, partings);
    for (const Parting& each : partings) {
      if (options_.stopped()) return;
      if (!has_child(each, partings)) leave(each);
    }
  }
}

void SheetSet::follow_rest() {
  SolveOptions how;
  how.stop = options_.stop;
  for (const Place& each : source_->at_rest(how)) enter(each, 0.0, Entry::rest, 0.0);
}

void SheetSet::adopt(const AtlasSheet& sheet) {
  for (std::size_t k = 0; k < checkpoints_.size(); ++k)
    add_crossings(sheet, 0, checkpoints_[k].nu, on_sheets_[k]);
  sheets_.push_back(sheet);
  families_of_sheets_.push_back(0);
  ++adopted_;
}

std::span<AtlasSheet> SheetSet::found() { return std::span(sheets_).subspan(adopted_); }

/// Follows the sheet through a motion and keeps it, unless it is one already kept.
void SheetSet::enter(const Place& from, double nu, Entry entry, double entry_nu) {
  AtlasSheet sheet;
  static_cast<SheetKind&>(sheet) = source_->kind();
  sheet.entry = entry;
  sheet.entry_nu = entry_nu;
  sheet.mirror = source_->mirror();
  const int family = source_->family_of(from);
  sheet.report =
      follow_rows(families_[static_cast<std::size_t>(family)], from.q, nu, options_, sheet.rows);
  if (!sheet.report.failure.empty()) {
    remark(entry, entry_nu, sheet.report.failure);
    return;
  }
  for (std::size_t k = 0; k < sheets_.size(); ++k)
    if (is_part_of(sheet, from, nu, sheets_[k], families_of_sheets_[k])) return;
  for (std::size_t k = 0; k < checkpoints_.size(); ++k)
    add_crossings(sheet, family, checkpoints_[k].nu, on_sheets_[k]);
  sheet.arc = sheet_arc(plain_[static_cast<std::size_t>(family)]);
  sheets_.push_back(std::move(sheet));
  families_of_sheets_.push_back(family);
}

void SheetSet::remark(Entry entry, double nu, std::string reason) {
  remarks_.push_back({source_->kind(), entry, nu, std::move(reason)});
}

Place SheetSet::place(const Member& member) const {
  return source_->canonical(source_->place(member.q, member.angular_velocity));
}

/// Whether a motion is one of a vertical sheet's, all of which are at one nu: as near to a chord of two
/// rows as a row is to that of its neighbours, which is four times as far as between rows.
bool SheetSet::lies_on_vertical(const AtlasSheet& sheet, const Place& at, double nu) const {
  const std::vector<AtlasRow>& rows = sheet.rows;
  if (std::abs(rows.front().member.nu - nu) > 1e-9 * nu) return false;
  const auto stretch = [&](std::size_t k) { return place(rows[k].member).q; };
  const auto bulge = [&](std::size_t k) {
    if (k == 0 || k + 1 == rows.size()) return 0.0;
    const auto chord = on_chord(stretch(k - 1), stretch(k + 1), eccentricity(stretch(k)));
    return chord ? distance(*chord, {stretch(k)}) : 0.0;
  };
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const auto chord = on_chord(stretch(k - 1), stretch(k), eccentricity(at.q));
    if (chord && distance(*chord, at) < same_place + std::max(bulge(k - 1), bulge(k))) return true;
  }
  return false;
}

/// Whether a motion is one of a sheet's.
bool SheetSet::lies_on(const AtlasSheet& sheet, int family, const Place& at, double nu) const {
  if (sheet.report.vertical) return lies_on_vertical(sheet, at, nu);
  std::vector<Place> there;
  add_crossings(sheet, family, nu, there);
  return std::ranges::any_of(there, [&](const Place& p) { return distance(p, at) < same_place; });
}

/// Whether a sheet followed from a place is all on another: each of its motions asked for is, or some
/// are and its ends are the other's. Ends alone do not tell: where V is a plane's and a thickness', one curve in the plane
/// goes with every rho that is balanced.
bool SheetSet::is_part_of(const AtlasSheet& sheet, const Place& from, double nu,
                          const AtlasSheet& other, int family) const {
  int on = lies_on(other, family, from, nu) ? 1 : 0;
  int asked = 1;
  for (const std::size_t quarter : {1U, 2U, 3U}) {
    const AtlasRow& row = sheet.rows[quarter * (sheet.rows.size() - 1) / 4];
    if (row.event != EventType::none) continue;
    ++asked;
    if (lies_on(other, family, place(row.member), row.member.nu)) ++on;
  }
  return on == asked || (on > 0 && same_ends(sheet, other));
}

bool SheetSet::same_ends(const AtlasSheet& a, const AtlasSheet& b) const {
  const auto same_row = [this](const AtlasRow& x, const AtlasRow& y) {
    // At an escape or a collapse the last steps differ.
    const double near = x.event == EventType::limit ? same_place : 0.5;
    return x.event == y.event && distance(place(x.member), place(y.member)) < near &&
           std::abs(x.member.nu - y.member.nu) <= 1e-3 * near * std::abs(y.member.nu);
  };
  const auto all_same = [&](const AtlasRow& x0, const AtlasRow& x1) {
    return same_row(x0, b.rows.front()) && same_row(x1, b.rows.back());
  };
  return all_same(a.rows.front(), a.rows.back()) || all_same(a.rows.back(), a.rows.front());
}

/// Adds the points of a sheet at nu, corrected.
void SheetSet::add_crossings(const AtlasSheet& sheet, int family, double nu,
                             std::vector<Place>& out) const {
  for (std::size_t k = 1; k < sheet.rows.size(); ++k) {
    const Member& a = sheet.rows[k - 1].member;
    const Member& b = sheet.rows[k].member;
    if ((a.nu < nu) == (b.nu < nu)) continue;
    const std::optional<Member> found =
        std::visit([&](const auto& f) { return between(*f, a, b, nu); },
                   *plain_[static_cast<std::size_t>(family)]);
    if (found) out.push_back(place(*found));
  }
}

bool SheetSet::on_a_sheet(const Place& at, std::size_t checkpoint) const {
  return std::ranges::any_of(on_sheets_[checkpoint],
                             [&](const Place& p) { return distance(p, at) < same_place; });
}

void SheetSet::count(std::size_t checkpoint) {
  Checkpoint& at = checkpoints_[checkpoint];
  const std::vector<Place>& proven = solutions_[checkpoint];
  std::vector<bool> met(proven.size(), false);
  for (const Place& p : on_sheets_[checkpoint]) {
    const auto same_as_p = [&](const Place& q) { return distance(p, q) < same_place; };
    const auto found = std::ranges::find_if(proven, same_as_p);
    if (found != proven.end()) {
      met[static_cast<std::size_t>(found - proven.begin())] = true;
    } else if (in_box(p.q, options_.search, source_->mirror())) {
      ++at.beyond;
    }
  }
  at.on_sheets = static_cast<int>(std::ranges::count(met, true));
}

/// The places on sheets, but for their ends, where sheets of this kind begin.
void SheetSet::add_partings(std::span<const AtlasSheet> sheets, std::vector<Parting>& out) const {
  for (const AtlasSheet& sheet : sheets) {
    for (std::size_t k = 1; k + 1 < sheet.rows.size(); ++k) {
      const AtlasRow& row = sheet.rows[k];
      if (row.event == source_->leaves_by() && source_->leaves_at(row.member))
        out.push_back({sheet.branch, row.member});
    }
  }
}

Place SheetSet::place(const Parting& parting) const {
  return source_->canonical(
      source_->place(parting.at.q, angular_velocity(parting.branch, parting.at.nu)));
}

/// Whether a sheet ends at a parting, and no other parting is nearer to where it does.
bool SheetSet::has_child(const Parting& parting, std::span<const Parting> all) const {
  constexpr double near = 1e-3;
  const auto apart = [this](const AtlasRow& row, const Parting& from) {
    const bool same_nu = std::abs(row.member.nu - from.at.nu) <= 1e-9 * from.at.nu;
    return same_nu ? distance(place(row.member), place(from)) : near;
  };
  const auto ends_here = [&](const AtlasRow& row) {
    if (row.event != source_->leaves_by()) return false;
    const double own = apart(row, parting);
    return own < near &&
           std::ranges::none_of(all, [&](const Parting& other) { return apart(row, other) < own; });
  };
  return std::ranges::any_of(sheets_, [&](const AtlasSheet& sheet) {
    return ends_here(sheet.rows.front()) || ends_here(sheet.rows.back());
  });
}

void SheetSet::leave(const Parting& parting) {
  const Entry entry = entry_at(source_->leaves_by());
  const DepartureResult found =
      source_->departure(parting.branch, parting.at, options_.to - options_.from);
  const auto* start = std::get_if<Departure>(&found);
  if (start != nullptr && !(options_.from <= start->nu && start->nu <= options_.to)) {
    remark(entry, parting.at.nu, "not entered: beside it these motions are beyond the range of nu");
  } else if (start != nullptr) {
    enter(start->at, start->nu, entry, parting.at.nu);
  } else {
    remark(entry, parting.at.nu, "not entered: " + std::get<std::string>(found));
  }
}

}  // namespace stationary
