#include "solver/atlas.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "lib/inertia.hpp"

namespace stationary {
namespace {

/// Nearer than this in every ln of a stretch two points are the same: sheets of one branch meet
/// only at branch points.
constexpr double same = 1e-6;

double distance(const Stretch& a, const Stretch& b) {
  return std::max({std::abs(std::log(a.xi / b.xi)), std::abs(std::log(a.zeta / b.zeta)),
                   std::abs(std::log(a.rho / b.rho))});
}

class Keep final : public CurveSink {
 public:
  explicit Keep(std::vector<AtlasRow>& rows) : rows_(&rows) {}
  void row(const Member& member, EventType event) override { rows_->push_back({member, event}); }

 private:
  std::vector<AtlasRow>* rows_;
};

FollowOptions follow_options(const AtlasOptions& options) {
  FollowOptions out;
  out.continuation.from = options.from;
  out.continuation.to = options.to;
  out.continuation.step = options.step;
  out.max_points = options.max_points;
  out.stop = options.stop;
  return out;
}

/// The sheets of one branch.
class BranchAtlas {
 public:
  BranchAtlas(const Body& body, const Potential& potential, Branch branch,
              const AtlasOptions& options)
      : problem_(body, potential, branch),
        options_(options),
        family_(axis_family(problem_, {.nu = 0.0, .parameter = {}, .spectrum = options.spectrum})) {
    const double part = (options.to - options.from) / options.checkpoints;
    for (int k = 0; k < options.checkpoints; ++k)
      checkpoints_.push_back({.branch = branch, .nu = options.from + (k + 0.5) * part});
    solutions_.resize(checkpoints_.size());
    on_sheets_.resize(checkpoints_.size());
  }

  /// All solutions at one checkpoint; checkpoints are independent of one another.
  void search_at(std::size_t k) {
    SearchResult result = search(problem_, checkpoints_[k].nu, options_.search);
    checkpoints_[k].status = result.status;
    // Of two mirror images the one drawn out along axis 1.
    std::erase_if(result.solutions, [&](const Equilibrium& s) {
      return has_mirror_images() && s.q.xi < s.q.zeta && !is_circle(s.q);
    });
    checkpoints_[k].proven = static_cast<int>(result.solutions.size());
    for (const Equilibrium& each : result.solutions) {
      Stretch q = each.q;
      if (has_mirror_images() && is_circle(q)) q.xi = q.zeta = std::sqrt(q.xi * q.zeta);
      solutions_[k].push_back(q);
    }
  }

  void follow_all() {
    if (options_.from == 0.0) follow_rest();
    for (std::size_t k = 0; k < checkpoints_.size(); ++k) {
      for (const Stretch& q : solutions_[k]) {
        if (stopped()) return;
        if (!on_a_sheet(q, k)) enter(q, checkpoints_[k].nu, Entry::search);
      }
    }
    if (has_mirror_images()) enter_ellipses();
    for (std::size_t k = 0; k < checkpoints_.size(); ++k) count(k);
  }

  const std::vector<Checkpoint>& checkpoints() const { return checkpoints_; }
  std::vector<AtlasSheet>& sheets() { return sheets_; }
  const std::vector<Remark>& remarks() const { return remarks_; }

 private:
  bool has_mirror_images() const {
    return problem_.branch() == Branch::iii && problem_.body().symmetric();
  }
  static bool is_circle(const Stretch& q) { return std::abs(std::log(q.xi / q.zeta)) < same; }
  bool stopped() const {
    return options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed);
  }

  void follow_rest() {
    SolveOptions how;
    how.stop = options_.stop;
    const Equilibrium rest = solve(problem_, 0.0, how);
    if (rest.status == SolveStatus::solved) enter(rest.q, 0.0, Entry::rest);
  }

  /// Follows the sheet through a solution and keeps it, unless it is one already kept.
  void enter(const Stretch& q, double nu, Entry entry) {
    AtlasSheet sheet;
    sheet.branch = problem_.branch();
    sheet.entry = entry;
    sheet.entry_nu = nu;
    Keep rows(sheet.rows);
    sheet.report = follow(family_, q, nu, follow_options(options_), rows);
    if (!sheet.report.failure.empty()) {
      remark(entry, nu, sheet.report.failure);
      return;
    }
    const auto is_it = [&](const AtlasSheet& other) { return same_ends(sheet, other); };
    if (std::ranges::any_of(sheets_, is_it)) return;
    for (std::size_t k = 0; k < checkpoints_.size(); ++k)
      add_crossings(sheet, checkpoints_[k].nu, on_sheets_[k]);
    sheets_.push_back(std::move(sheet));
  }

  void remark(Entry entry, double nu, std::string reason) {
    remarks_.push_back({problem_.branch(), entry, nu, std::move(reason)});
  }

  static bool same_ends(const AtlasSheet& a, const AtlasSheet& b) {
    const auto same_row = [](const AtlasRow& x, const AtlasRow& y) {
      // At an escape or a collapse the last steps differ.
      const double near = x.event == EventType::limit ? same : 0.5;
      return x.event == y.event && distance(x.member.q, y.member.q) < near &&
             std::abs(x.member.nu - y.member.nu) <= 1e-3 * near * std::abs(y.member.nu);
    };
    const auto all_same = [&](const AtlasRow& x0, const AtlasRow& x1) {
      return same_row(x0, b.rows.front()) && same_row(x1, b.rows.back());
    };
    return all_same(a.rows.front(), a.rows.back()) || all_same(a.rows.back(), a.rows.front());
  }

  /// Adds the points of a sheet at nu, corrected.
  void add_crossings(const AtlasSheet& sheet, double nu, std::vector<Stretch>& out) const {
    for (std::size_t k = 1; k < sheet.rows.size(); ++k) {
      const Member& a = sheet.rows[k - 1].member;
      const Member& b = sheet.rows[k].member;
      if ((a.nu < nu) == (b.nu < nu)) continue;
      const double u = (nu - a.nu) / (b.nu - a.nu);
      const auto between = [&](double x, double y) { return x * std::pow(y / x, u); };
      Stretch q{0.0, between(a.q.xi, b.q.xi), between(a.q.zeta, b.q.zeta),
                between(a.q.rho, b.q.rho)};
      if (std::visit([&](const auto& f) { return correct(*f, q, nu); }, family_)) out.push_back(q);
    }
  }

  template <int N>
  static bool correct(const Family<N>& family, Stretch& q, double nu) {
    ReducedVector<N> x = unknowns<N>(q);
    ReducedVector<N> tail;
    if (!family.refine_at(x, tail, nu).converged) return false;
    q = with_unknowns<N>(q, x);
    return true;
  }

  bool on_a_sheet(const Stretch& q, std::size_t checkpoint) const {
    return std::ranges::any_of(on_sheets_[checkpoint],
                               [&](const Stretch& p) { return distance(p, q) < same; });
  }

  void count(std::size_t k) {
    Checkpoint& at = checkpoints_[k];
    std::vector<bool> met(solutions_[k].size(), false);
    for (const Stretch& p : on_sheets_[k]) {
      const auto same_as_p = [&](const Stretch& q) { return distance(p, q) < same; };
      const auto found = std::ranges::find_if(solutions_[k], same_as_p);
      if (found != solutions_[k].end()) {
        met[static_cast<std::size_t>(found - solutions_[k].begin())] = true;
      } else if (in_box(p)) {
        ++at.beyond;
      }
    }
    at.on_sheets = static_cast<int>(std::ranges::count(met, true));
  }

  bool in_box(const Stretch& q) const {
    return std::min({q.xi, q.zeta, q.rho}) > options_.search.min_stretch &&
           std::max({q.xi, q.zeta, q.rho}) < options_.search.max_stretch;
  }

  // Circle to ellipse.

  void enter_ellipses() {
    const std::size_t known = sheets_.size();  // those entered below are ellipses
    for (std::size_t s = 0; s < known; ++s) {
      for (std::size_t k = 0; k < sheets_[s].rows.size(); ++k) {
        const AtlasRow row = sheets_[s].rows[k];
        if (row.event != EventType::ellipse || !is_circle(row.member.q)) continue;
        const bool is_end = k == 0 || k + 1 == sheets_[s].rows.size();
        if (is_end || has_child(row.member.nu)) continue;
        std::visit([&](const auto& f) { leave_circle(*f, row.member); }, family_);
      }
    }
  }

  bool has_child(double nu) const {
    const auto ends_here = [&](const AtlasRow& row) {
      return row.event == EventType::ellipse && std::abs(row.member.nu - nu) <= 1e-9 * nu;
    };
    return std::ranges::any_of(sheets_, [&](const AtlasSheet& sheet) {
      return ends_here(sheet.rows.front()) || ends_here(sheet.rows.back());
    });
  }

  template <int N>
  void leave_circle(const Family<N>& family, const Member& at) {
    const Curve<N> curve(family, options_.to - options_.from, /*circle=*/false);
    ArcVector<N> aside = ArcVector<N>::Zero();
    aside[0] = 1.0 / std::numbers::sqrt2;
    aside[1] = -aside[0];
    constexpr double gap = 1e-3;
    const ReducedVector<N> x = moved<N>(unknowns<N>(at.q), gap * aside.template head<N>());
    const Corrected<N> off = curve.corrector().correct_freely(x, at.nu, aside, 0.5 * gap);
    if (off.status != CorrectorStatus::converged) {
      remark(Entry::ellipse, at.nu, "ellipses not entered: " + std::string(name(off.status)));
    } else {
      // Of a vertical branch the event's nu, not one that differs by the rounding of a correction.
      const bool same_nu = std::abs(off.point.p - at.nu) <= 1e-12 * at.nu;
      enter(with_unknowns<N>(at.q, off.point.x), same_nu ? at.nu : off.point.p, Entry::ellipse);
    }
  }

  Problem problem_;
  AtlasOptions options_;
  AnyFamily family_;
  std::vector<Checkpoint> checkpoints_;
  std::vector<std::vector<Stretch>> solutions_;  ///< proven at each checkpoint
  std::vector<std::vector<Stretch>> on_sheets_;  ///< points there of the sheets so far
  std::vector<AtlasSheet> sheets_;
  std::vector<Remark> remarks_;
};

/// Also where one is the other's mirror image.
bool at_same_place(const Member& a, const Member& b) {
  const Stretch mirrored{0.0, b.q.zeta, b.q.xi, b.q.rho};
  const bool alike =
      distance(a.q, b.q) < same || (b.body.symmetric() && distance(a.q, mirrored) < same);
  return alike && std::abs(a.nu - b.nu) <= 1e-9 * std::abs(b.nu);
}

/// Where on another sheet, not a tilted one, this end lies.
std::optional<Junction> junction(const std::vector<AtlasSheet>& sheets, const AtlasSheet& of,
                                 const AtlasRow& end) {
  if (end.event != EventType::ellipse && end.event != EventType::tilt) return std::nullopt;
  for (const AtlasSheet& other : sheets) {
    if (other.plane || other.number == of.number) continue;
    const bool ellipses = end.event == EventType::ellipse;
    if (ellipses && other.branch != of.branch) continue;
    const auto met = [&](const AtlasRow& row) {
      return row.event == end.event && at_same_place(row.member, end.member);
    };
    if (std::ranges::any_of(other.rows, met))
      return Junction{other.number, end.event, end.member.nu};
  }
  return std::nullopt;
}

void find_junctions(std::vector<AtlasSheet>& sheets) {
  for (AtlasSheet& sheet : sheets) {
    sheet.parent = junction(sheets, sheet, sheet.rows.front());
    sheet.joins = junction(sheets, sheet, sheet.rows.back());
    if (!sheet.parent) std::swap(sheet.parent, sheet.joins);
    // Of a tilted family's two, the one it was entered at.
    const bool both = sheet.parent && sheet.joins;
    if (both &&
        std::abs(sheet.joins->nu - sheet.entry_nu) < std::abs(sheet.parent->nu - sheet.entry_nu))
      std::swap(sheet.parent, sheet.joins);
  }
}

/// The plane a branch's axis tilts in at such an event.
std::optional<TiltPlane> plane_of(Branch branch, const Member& at) {
  const auto equal = [](double a, double b) { return std::abs(a - b) <= 1e-6 * (a + b); };
  const Vector3<double> m = second_moments(at.body, at.q);
  if (branch != Branch::ii && equal(m[0], m[2])) return TiltPlane::one_three;
  if (branch != Branch::i && equal(m[1], m[2])) return TiltPlane::two_three;
  return std::nullopt;
}

/// Tilted families from the tilts of the sheets known, each once.
void enter_tilted(const Body& body, const Potential& potential, const AtlasOptions& options,
                  Atlas& out) {
  const std::size_t known = out.sheets.size();
  const auto met = [&](const Member& at) {
    return std::any_of(out.sheets.begin() + static_cast<std::ptrdiff_t>(known), out.sheets.end(),
                       [&](const AtlasSheet& tilted) {
                         return at_same_place(tilted.rows.front().member, at) ||
                                at_same_place(tilted.rows.back().member, at);
                       });
  };
  for (std::size_t s = 0; s < known; ++s) {
    for (std::size_t k = 0; k < out.sheets[s].rows.size(); ++k) {
      const AtlasRow row = out.sheets[s].rows[k];
      if (row.event != EventType::tilt || met(row.member)) continue;
      AtlasSheet sheet;
      sheet.branch = out.sheets[s].branch;
      sheet.plane = plane_of(sheet.branch, row.member);
      sheet.entry = Entry::tilt;
      sheet.entry_nu = row.member.nu;
      sheet.number = static_cast<int>(out.sheets.size()) + 1;
      const auto remark = [&](const std::string& reason) {
        out.remarks.push_back({sheet.branch, Entry::tilt, row.member.nu, reason});
      };
      if (!sheet.plane) {
        remark("tilted motions not entered: no plane has two equal locked inertias");
        continue;
      }
      const auto start = just_inside(*tilted_family(body, potential, *sheet.plane, false),
                                     row.member.q, row.member.nu);
      if (!start) {
        remark("tilted motions not entered: none was found beside it");
        continue;
      }
      Keep rows(sheet.rows);
      sheet.report = follow(tilted_family(body, potential, *sheet.plane, options.spectrum),
                            start->q, start->nu, follow_options(options), rows);
      if (sheet.report.failure.empty()) {
        out.sheets.push_back(std::move(sheet));
      } else {
        remark(sheet.report.failure);
      }
    }
  }
}

}  // namespace

Atlas atlas(const Body& body, const Potential& potential, const AtlasOptions& options) {
  if (!(options.from >= 0.0 && options.from < options.to && std::isfinite(options.to)))
    throw std::invalid_argument("an atlas needs 0 <= from < to");
  if (options.checkpoints < 1) throw std::invalid_argument("an atlas needs a checkpoint");
  const bool has_i = std::ranges::find(options.branches, Branch::i) != options.branches.end();
  std::vector<BranchAtlas> parts;
  for (const Branch branch : options.branches) {
    const bool mirror_image = branch == Branch::ii && has_i && body.symmetric();
    if (!mirror_image) parts.emplace_back(body, potential, branch, options);
  }
  const auto each = static_cast<std::size_t>(options.checkpoints);
  const int threads = std::max(1, options.threads);
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, parts.size() * each,
                      [&](std::size_t k) { parts[k / each].search_at(k % each); });
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t k) { parts[k].follow_all(); });
  });
  Atlas out;
  for (BranchAtlas& part : parts) {
    for (AtlasSheet& sheet : part.sheets()) {
      sheet.number = static_cast<int>(out.sheets.size()) + 1;
      out.sheets.push_back(std::move(sheet));
    }
    out.checkpoints.insert(out.checkpoints.end(), part.checkpoints().begin(),
                           part.checkpoints().end());
    out.remarks.insert(out.remarks.end(), part.remarks().begin(), part.remarks().end());
  }
  for (const Checkpoint& at : out.checkpoints)
    out.interrupted = out.interrupted || at.status == SearchStatus::interrupted;
  enter_tilted(body, potential, options, out);
  for (const AtlasSheet& sheet : out.sheets)
    out.interrupted = out.interrupted || sheet.report.interrupted;
  find_junctions(out.sheets);
  return out;
}

}  // namespace stationary
