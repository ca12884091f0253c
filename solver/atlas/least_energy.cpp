#include "solver/atlas/least_energy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "lib/body/inertia.hpp"

namespace stationary {
namespace {

/// A motion's place in the diagram.
LeastEnergyEnd place_of(const Member& member) {
  if (member.nu == 0.0) return {0.0, member.energy, 0.0};
  const Vector3<double>& nu = member.angular_velocity;
  return {(locked_inertia(member.body, member.q) * nu).norm(), member.energy, nu.norm()};
}

/// E(|pi|) between two rows.
struct EnergyArc {
  int sheet;
  LeastEnergyEnd a;
  LeastEnergyEnd b;  ///< the larger |pi|

  LeastEnergyEnd at(double momentum) const {
    const double h = b.momentum - a.momentum;
    const double u = (momentum - a.momentum) / h;
    const double rise = b.energy - a.energy;
    // Newton's form of the Hermite cubic.
    const double bend = rise - h * a.spin;
    const double twist = h * (a.spin + b.spin) - 2.0 * rise;
    const double energy = a.energy + u * (h * a.spin + u * (bend + (u - 1.0) * twist));
    const double slope = h * a.spin + u * (2.0 * bend + (3.0 * u - 2.0) * twist);
    return {momentum, energy, slope / h};
  }
};

class Envelope {
 public:
  explicit Envelope(std::vector<EnergyArc> arcs) : arcs_(std::move(arcs)) {
    std::ranges::sort(arcs_, {}, [](const EnergyArc& each) { return each.a.momentum; });
  }

  std::vector<LeastEnergyPiece> pieces() {
    std::vector<double> ends;
    for (const EnergyArc& each : arcs_) {
      ends.push_back(each.a.momentum);
      ends.push_back(each.b.momentum);
    }
    std::ranges::sort(ends);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::size_t next = 0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      while (next < arcs_.size() && arcs_[next].a.momentum <= ends[k])
        active_.push_back(&arcs_[next++]);
      std::erase_if(active_, [&](const EnergyArc* each) { return each->b.momentum <= ends[k]; });
      if (active_.empty()) continue;
      // Sheets that meet do so at ends: inside, the least is one of them.
      constexpr double inside = 1e-3;
      const double margin = inside * (ends[k + 1] - ends[k]);
      divide(ends[k], ends[k + 1], least_at(ends[k] + margin), least_at(ends[k + 1] - margin));
    }
    drop_unclear();
    return std::move(out_);
  }

 private:
  const EnergyArc* arc_of(int sheet, double momentum) const {
    const EnergyArc* out = nullptr;
    for (const EnergyArc& each : arcs_)
      if (each.sheet == sheet && each.a.momentum <= momentum && momentum <= each.b.momentum &&
          (out == nullptr || each.at(momentum).energy < out->at(momentum).energy))
        out = &each;
    return out;
  }

  /// Where two sheets come to the same energy, as on the way to one escape, a change of hands by less
  /// than the interpolation is good for is none.
  void drop_unclear() {
    constexpr double unclear = 1e-10;
    std::vector<LeastEnergyPiece> kept;
    for (const LeastEnergyPiece& each : out_) {
      if (!kept.empty() && kept.back().to.momentum == each.from.momentum) {
        LeastEnergyPiece& last = kept.back();
        const double middle = 0.5 * (each.from.momentum + each.to.momentum);
        const EnergyArc* own = arc_of(each.sheet, middle);
        const EnergyArc* other = arc_of(last.sheet, middle);
        const EnergyArc* end = arc_of(last.sheet, each.to.momentum);
        const bool same = own != nullptr && other != nullptr && end != nullptr &&
                          other->at(middle).energy - own->at(middle).energy <=
                              unclear * std::abs(own->at(middle).energy);
        if (same || each.sheet == last.sheet) {
          last.to = same ? end->at(each.to.momentum) : each.to;
          continue;
        }
      }
      kept.push_back(each);
    }
    out_ = std::move(kept);
  }

  /// Of those that rounding cannot tell apart, one of the two given.
  const EnergyArc* least_at(double momentum, const EnergyArc* first = nullptr,
                            const EnergyArc* second = nullptr) const {
    const auto energy = [&](const EnergyArc* each) { return each->at(momentum).energy; };
    const EnergyArc* const out = *std::ranges::min_element(active_, {}, energy);
    const double tie = 1e-14 * std::abs(energy(out));
    for (const EnergyArc* each : {first, second})
      if (each != nullptr && energy(each) <= energy(out) + tie) return each;
    return out;
  }

  /// first, last: the least near the ends.
  void divide(double from, double to, const EnergyArc* first, const EnergyArc* last) {
    constexpr double least_width = 1e-13;
    const double middle = 0.5 * (from + to);
    const EnergyArc* const between = least_at(middle, first, last);
    if (first == last && between == first) return add(first, from, to);
    if (!(to - from > least_width * to)) {
      add(first, from, middle);
      return add(last, middle, to);
    }
    divide(from, middle, first, between);
    divide(middle, to, between, last);
  }

  void add(const EnergyArc* arc, double from, double to) {
    if (!(from < to)) return;
    if (!out_.empty() && out_.back().sheet == arc->sheet && out_.back().to.momentum == from) {
      out_.back().to = arc->at(to);
    } else {
      out_.push_back({arc->sheet, arc->at(from), arc->at(to)});
    }
  }

  std::vector<EnergyArc> arcs_;
  std::vector<const EnergyArc*> active_;
  std::vector<LeastEnergyPiece> out_;
};

}  // namespace

std::vector<LeastEnergyPiece> least_energy(const std::vector<AtlasSheet>& sheets,
                                           const SearchOptions& box) {
  const auto inside = [&](const Member& member) {
    const std::array stretches{member.q.xi, member.q.zeta, member.q.rho};
    for (std::size_t k = 0; k < stretches.size(); ++k)
      if (!(stretches[k] >= box.range(k).lo && stretches[k] <= box.range(k).hi)) return false;
    return true;
  };
  std::vector<EnergyArc> arcs;
  for (const AtlasSheet& sheet : sheets) {
    for (std::size_t k = 1; k < sheet.rows.size(); ++k) {
      if (!inside(sheet.rows[k - 1].member) || !inside(sheet.rows[k].member)) continue;
      LeastEnergyEnd a = place_of(sheet.rows[k - 1].member);
      LeastEnergyEnd b = place_of(sheet.rows[k].member);
      if (!std::isfinite(a.energy + b.energy + a.momentum + b.momentum)) continue;
      if (a.momentum > b.momentum) std::swap(a, b);
      if (a.momentum < b.momentum) arcs.push_back({sheet.number, a, b});
    }
  }
  return Envelope(std::move(arcs)).pieces();
}

}  // namespace stationary
