#include "solver/atlas/atlas.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "solver/atlas/sheet_arc.hpp"
#include "solver/atlas/sheet_set.hpp"
#include "solver/newton/available_threads.hpp"
#include "solver/newton/thread_arena.hpp"

namespace stationary {
namespace {

void remark(Atlas& out, const SheetKind& of, std::optional<Entry> entry, double nu,
            std::string_view reason) {
  out.remarks.push_back({of, entry, nu, std::string(reason)});
}

/// Whether xi and zeta are sought between the same bounds.
bool is_alike_in_plane(const SearchOptions& box) {
  const Interval xi = box.range(0);
  const Interval zeta = box.range(1);
  return xi.lo == zeta.lo && xi.hi == zeta.hi;
}

/// Of an isotropic body with J1 = J2, which motions stand for their mirror images: axes 1 and 2 exchanged.
struct Exchanged {
  bool spins;  ///< about these axes, where the box is alike in xi and zeta: (ii) is (i) over again
  bool ellipses;  ///< of (iii), of which one of two is told, whatever the box

  bool of(Branch branch) const { return branch == Branch::iii ? ellipses : spins; }
};

/// Also where one is the other's mirror image.
bool at_same_place(const Member& a, const Member& b, bool exchanged) {
  const Stretch mirrored{0.0, b.q.zeta, b.q.xi, b.q.rho};
  const bool alike = distance({a.q}, {b.q}) < same_place ||
                     (exchanged && distance({a.q}, {mirrored}) < same_place);
  return alike && std::abs(a.nu - b.nu) <= 1e-9 * std::abs(b.nu);
}

/// Where on another sheet, one about a material axis, this end lies.
std::optional<Junction> junction(const std::vector<AtlasSheet>& sheets, const AtlasSheet& of,
                                 const AtlasRow& end, const Exchanged& exchanged) {
  const bool same_branch =
      broken_circle(end.event) != Circle::none || end.event == EventType::shear;
  if (!same_branch && end.event != EventType::oblique && end.event != EventType::tilt)
    return std::nullopt;
  for (const AtlasSheet& other : sheets) {
    if (other.plane || other.oblique || other.number == of.number) continue;
    if (same_branch && other.branch != of.branch) continue;
    const auto met = [&](const AtlasRow& row) {
      return row.event == end.event &&
             at_same_place(row.member, end.member, exchanged.of(other.branch));
    };
    if (std::ranges::any_of(other.rows, met))
      return Junction{other.number, end.event, end.member.nu};
  }
  return std::nullopt;
}

void find_junctions(std::vector<AtlasSheet>& sheets, const Exchanged& exchanged) {
  for (AtlasSheet& sheet : sheets) {
    sheet.parent = junction(sheets, sheet, sheet.rows.front(), exchanged);
    sheet.joins = junction(sheets, sheet, sheet.rows.back(), exchanged);
    if (!sheet.parent) std::swap(sheet.parent, sheet.joins);
    // Of a tilted family's two, the one it was entered at.
    const bool both = sheet.parent && sheet.joins;
    if (both &&
        std::abs(sheet.joins->nu - sheet.entry_nu) < std::abs(sheet.parent->nu - sheet.entry_nu))
      std::swap(sheet.parent, sheet.joins);
  }
}

/// Tilted families from the tilts of the sheets known, each once.
void enter_tilted(const Body& body, const Potential& potential, const AtlasOptions& options,
                  const Exchanged& exchanged, Atlas& out) {
  const std::size_t known = out.sheets.size();
  const auto at_end = [&](const AtlasSheet& tilted, const Member& at, Branch of) {
    return at_same_place(tilted.rows.front().member, at, exchanged.of(of)) ||
           at_same_place(tilted.rows.back().member, at, exchanged.of(of));
  };
  const auto met = [&](const Member& at, Branch of) {
    return std::any_of(out.sheets.begin() + static_cast<std::ptrdiff_t>(known), out.sheets.end(),
                       [&](const AtlasSheet& tilted) { return at_end(tilted, at, of); });
  };
  for (std::size_t s = 0; s < known; ++s) {
    for (std::size_t k = 0; k < out.sheets[s].rows.size(); ++k) {
      const AtlasRow row = out.sheets[s].rows[k];
      if (row.event != EventType::tilt || met(row.member, out.sheets[s].branch)) continue;
      // A family cut short does not tell what its other end is.
      if (options.stopped()) return;
      AtlasSheet sheet;
      sheet.branch = out.sheets[s].branch;
      sheet.plane = plane_of_tilt(sheet.branch, body, row.member.q);
      sheet.entry = Entry::tilt;
      sheet.entry_nu = row.member.nu;
      sheet.number = static_cast<int>(out.sheets.size()) + 1;
      const auto not_entered = [&](const std::string& reason) {
        remark(out, {sheet.branch}, Entry::tilt, row.member.nu, reason);
      };
      if (!sheet.plane) {
        not_entered(row.member.q.alpha != 0.0
                        ? "motions about an axis in no plane begin, which an atlas does not follow"
                        : "tilted motions not entered: no plane has two equal locked inertias");
        continue;
      }
      const auto plain =
          std::make_shared<const AnyFamily>(tilted_family(body, potential, *sheet.plane, false));
      const Family<2>& family = *std::get<std::unique_ptr<Family<2>>>(*plain);
      const auto start =
          just_inside(family, row.member.q, row.member.nu, {options.from, options.to});
      if (!start) {
        not_entered(just_inside(family, row.member.q, row.member.nu)
                        ? "tilted motions not entered: they begin beyond the range of nu"
                        : "tilted motions not entered: none was found beside it");
        continue;
      }
      sheet.arc = sheet_arc(plain);
      sheet.report = follow_rows(tilted_family(body, potential, *sheet.plane, options.spectrum),
                                 start->q, start->nu, options, sheet.rows);
      if (!sheet.report.failure.empty()) {
        not_entered(sheet.report.failure);
      } else if (met(sheet.rows.front().member, sheet.branch) &&
                 met(sheet.rows.back().member, sheet.branch) &&
                 !at_end(sheet, row.member, sheet.branch)) {
        // Where tilts of two sheets are next to each other.
        not_entered("tilted motions not entered: those found beside it are of another tilt");
      } else {
        out.sheets.push_back(std::move(sheet));
      }
    }
  }
}

/// Where a tilted family of an anisotropic body would be left for.
void remark_tilts(Atlas& out) {
  for (const AtlasSheet& sheet : out.sheets) {
    for (const AtlasRow& row : sheet.rows) {
      if (row.event != EventType::tilt) continue;
      remark(out, sheet, Entry::tilt, row.member.nu,
             "motions with an axis out of the plane of axes 1 and 2 are not sought "
             "of an anisotropic body");
    }
  }
}

/// Motions about the material axes.
std::vector<std::unique_ptr<SheetSource>> axis_sources(const Body& body, const Potential& potential,
                                                       const AtlasOptions& options, Atlas& out) {
  std::vector<std::unique_ptr<SheetSource>> all;
  const bool has_i = std::ranges::find(options.branches, Branch::i) != options.branches.end();
  for (const Branch branch : options.branches) {
    const Problem problem(body, potential, branch);
    if (potential.is_isotropic()) {
      const bool mirror_image =
          branch == Branch::ii && has_i && body.symmetric() && is_alike_in_plane(options.search);
      if (!mirror_image) all.push_back(axis_sheets(problem));
    } else if (branch != Branch::iii && !potential.anisotropic().shear_free()) {
      const char* known =
          potential.anisotropic().sheared()
              ? "not looked for: V_alpha != 0 at alpha = 0, so that a spin about "
                "this axis is a motion by chance only"
              : "not looked for: V_alpha is not known to vanish at alpha = 0, and "
                "where it does not a spin about this axis is a motion by chance only";
      remark(out, {branch}, std::nullopt, options.from, known);
    } else {
      all.push_back(anisotropic_sheets(problem));
    }
  }
  return all;
}

/// Motions tilted in a plane. With J1 = J2, and a box that has both, those in one plane are mirror images
/// of the other's.
std::vector<std::unique_ptr<SheetSource>> tilted_sources(const Body& body,
                                                         const Potential& potential,
                                                         const AtlasOptions& options) {
  std::vector<std::unique_ptr<SheetSource>> out;
  if (!options.tilted || !potential.is_isotropic()) return out;
  out.push_back(tilted_sheets(body, potential, TiltPlane::one_three));
  if (!body.symmetric() || !is_alike_in_plane(options.search))
    out.push_back(tilted_sheets(body, potential, TiltPlane::two_three));
  return out;
}

/// With J1 = J2 and an isotropic V: axes 1 and 2 exchanged, with the plane.
AtlasSheet mirrored(AtlasSheet sheet) {
  sheet.plane = sheet.plane == TiltPlane::one_three ? TiltPlane::two_three : TiltPlane::one_three;
  for (AtlasRow& row : sheet.rows) {
    std::swap(row.member.q.xi, row.member.q.zeta);
    std::swap(row.member.angular_velocity[0], row.member.angular_velocity[1]);
  }
  return sheet;
}

void add(SheetSet& set, Atlas& out) {
  for (AtlasSheet& sheet : set.found()) {
    sheet.number = static_cast<int>(out.sheets.size()) + 1;
    out.sheets.push_back(std::move(sheet));
  }
  const std::vector<Checkpoint> checkpoints = set.checkpoints();
  out.checkpoints.insert(out.checkpoints.end(), checkpoints.begin(), checkpoints.end());
  if (set.completeness()) out.completeness.push_back(*set.completeness());
  out.remarks.insert(out.remarks.end(), set.remarks().begin(), set.remarks().end());
}

}  // namespace

Atlas atlas(const Body& body, const Potential& potential, const AtlasOptions& options) {
  if (!(options.from >= 0.0 && options.from < options.to && std::isfinite(options.to)))
    throw std::invalid_argument("an atlas needs 0 <= from < to");
  if (options.checkpoints < 1) throw std::invalid_argument("an atlas needs a checkpoint");
  Atlas out;
  std::vector<SheetSet> parts;
  for (std::unique_ptr<SheetSource>& each : axis_sources(body, potential, options, out))
    parts.emplace_back(std::move(each), options);
  const std::size_t about_axes = parts.size();
  if (options.oblique && !potential.is_isotropic())
    parts.emplace_back(oblique_sheets(body, potential), options);
  if (options.oblique && potential.may_shear())
    parts.emplace_back(sheared_sheets(body, potential), options);
  const std::size_t in_plane = parts.size();
  for (std::unique_ptr<SheetSource>& tilted : tilted_sources(body, potential, options))
    parts.emplace_back(std::move(tilted), options);
  const auto each = static_cast<std::size_t>(options.checkpoints);
  const int threads = available_threads(options.threads);
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
  const std::size_t searches = parts.size() * each;
  std::atomic<std::size_t> done = 0;
  std::mutex reporting;
  arena_of(threads).execute([&] {
    tbb::parallel_for(std::size_t{0}, searches, [&](std::size_t k) {
      parts[k / each].search_at(k % each, k);
      const std::size_t so_far = ++done;
      if (!options.progress) return;
      if (const std::unique_lock lock(reporting, std::try_to_lock); lock)
        options.progress(static_cast<double>(so_far) / static_cast<double>(searches));
    });
    if (options.complete) {
      // First what is had soon, so that a proof cut short leaves its rows. Tilted sheets are entered at tilts.
      tbb::parallel_for(std::size_t{0}, in_plane, [&](std::size_t k) { parts[k].follow_proven(); });
      tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t k) { parts[k].complete(); });
    }
    tbb::parallel_for(std::size_t{0}, about_axes, [&](std::size_t k) { parts[k].follow_all(); });
  });
  for (std::size_t k = 0; k < in_plane; ++k) {
    // Oblique sheets leave those about the axes.
    if (k >= about_axes) parts[k].follow_all(out.sheets);
    add(parts[k], out);
  }
  const bool axes_alike = potential.is_isotropic() && body.symmetric();
  const Exchanged exchanged{axes_alike && is_alike_in_plane(options.search), axes_alike};
  if (potential.is_isotropic()) {
    if (options.tilted) enter_tilted(body, potential, options, exchanged, out);
  } else {
    remark_tilts(out);
  }
  for (std::size_t k = in_plane; k < parts.size(); ++k) {
    const bool for_both = parts.size() == in_plane + 1;  // of planes
    for (const AtlasSheet& sheet : out.sheets) {
      if (!sheet.plane) continue;
      if (sheet.plane == parts[k].plane()) {
        parts[k].adopt(sheet);
      } else if (for_both) {
        parts[k].adopt(mirrored(sheet));
      }
    }
    parts[k].follow_all();
    add(parts[k], out);
  }
  for (const Checkpoint& at : out.checkpoints)
    out.interrupted = out.interrupted || at.status == SearchStatus::interrupted;
  for (const AtlasSheet& sheet : out.sheets)
    out.interrupted = out.interrupted || sheet.report.interrupted;
  // A sheet or a cover that was not begun has nothing to say so.
  out.interrupted = out.interrupted || options.stopped();
  find_junctions(out.sheets, exchanged);
  return out;
}

}  // namespace stationary
