#include "solver/atlas/least_energy.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "lib/body/inertia.hpp"
#include "solver/atlas/sheet_arc.hpp"

namespace stationary {
namespace {

/// A motion's place in the diagram.
LeastEnergyEnd place_of(const Member& member) {
  if (member.nu == 0.0) return {0.0, member.energy, 0.0};
  const Vector3<double>& nu = member.angular_velocity;
  return {(locked_inertia(member.body, member.q) * nu).norm(), member.energy, nu.norm()};
}

bool is_finite(const LeastEnergyEnd& at) {
  return std::isfinite(at.energy + at.momentum + at.spin);
}

/// E(|pi|) between two rows.
struct EnergyArc {
  const AtlasSheet* sheet;
  std::size_t run;  ///< a part of a sheet along which |pi| does not turn
  LeastEnergyEnd a;
  LeastEnergyEnd b;     ///< the larger |pi|
  const Member* row_a;  ///< the rows, in the order of a and b
  const Member* row_b;

  bool has(double momentum) const { return a.momentum <= momentum && momentum <= b.momentum; }

  /// Near a turn of |pi| E bends as |pi|^(3/2), near one of nu E - |nu| |pi| does so in |nu|: cubic in
  /// what changes more.
  LeastEnergyEnd at(double momentum) const {
    if (std::abs(b.spin - a.spin) * b.momentum > (b.momentum - a.momentum) * b.spin)
      if (const auto out = by_spin(momentum)) return *out;
    return by_momentum(momentum);
  }
  /// How far the energy there may be off: by how much the two cubics differ.
  double doubt(double momentum) const {
    const auto other = by_spin(momentum);
    return other ? std::abs(other->energy - by_momentum(momentum).energy) : 0.0;
  }

 private:
  LeastEnergyEnd by_momentum(double momentum) const {
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

  /// L(nu) = E - nu |pi|, dL = -|pi| dnu, likewise; then |pi|(nu) is a quadratic.
  std::optional<LeastEnergyEnd> by_spin(double momentum) const {
    const double k = b.spin - a.spin;
    const double first = a.energy - a.spin * a.momentum;
    const double rise = b.energy - b.spin * b.momentum - first;
    const double bend = rise + k * a.momentum;
    const double twist = -k * (a.momentum + b.momentum) - 2.0 * rise;
    const double A = 3.0 * twist;
    const double B = 2.0 * (bend - twist);
    const double C = k * (momentum - a.momentum);
    const double root = std::sqrt(std::max(0.0, B * B - 4.0 * A * C));
    const double sum = -0.5 * (B + std::copysign(root, B));
    for (const double u : {C / sum, sum / A}) {
      if (!(u >= 0.0 && u <= 1.0)) continue;
      const double spin = a.spin + u * k;
      const double L = first + u * (-k * a.momentum + u * (bend + (u - 1.0) * twist));
      return LeastEnergyEnd{momentum, L + spin * momentum, spin};
    }
    return std::nullopt;
  }
};

/// The motion of an arc at this |pi|, from the balance itself; nothing where it is not found.
std::optional<LeastEnergyEnd> solved_at(const EnergyArc& arc, double momentum) {
  if (!arc.sheet->arc) return std::nullopt;
  double low = 0.0;
  double high = 1.0;
  double slope = 1.0 / (arc.b.momentum - arc.a.momentum);  // du/d|pi|
  double u = (momentum - arc.a.momentum) * slope;
  const double bend = std::abs(arc.b.spin - arc.a.spin) * slope;  // d|nu|/d|pi|
  std::optional<std::pair<double, double>> last;
  constexpr int most = 60;
  for (int k = 0; k < most; ++k) {
    const auto member = arc.sheet->arc(*arc.row_a, *arc.row_b, u);
    if (!member) return std::nullopt;
    const LeastEnergyEnd at = place_of(*member);
    if (!is_finite(at)) return std::nullopt;
    const double left = momentum - at.momentum;
    // dE = |nu| d|pi|, to the square of what is left: more than rounding only where |nu| bends. Near an
    // escape a double's worth of nu is many of |pi|.
    const double size = std::abs(at.energy) + momentum * at.spin;
    if (std::abs(left) <= 1e-12 * momentum || left * left * bend <= 1e-16 * size)
      return LeastEnergyEnd{momentum, at.energy + at.spin * left, at.spin};
    (left > 0.0 ? low : high) = u;
    if (last && last->second != at.momentum)
      slope = (u - last->first) / (at.momentum - last->second);
    last = {u, at.momentum};
    const double next = u + slope * left;
    u = low < next && next < high && k % 4 != 3 ? next : 0.5 * (low + high);
  }
  return std::nullopt;
}

class Envelope {
 public:
  /// stop: becomes true, no pieces.
  Envelope(std::vector<EnergyArc> arcs, const std::atomic<bool>* stop)
      : arcs_(std::move(arcs)), stop_(stop) {
    std::ranges::sort(arcs_, {}, [](const EnergyArc& each) { return each.a.momentum; });
    for (const EnergyArc& each : arcs_) {
      if (each.run >= runs_.size()) runs_.resize(each.run + 1);
      runs_[each.run].push_back(&each);
    }
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
    for (std::size_t k = 0; k + 1 < ends.size() && !stopped(); ++k) {
      while (next < arcs_.size() && arcs_[next].a.momentum <= ends[k])
        active_.push_back(&arcs_[next++]);
      std::erase_if(active_, [&](const EnergyArc* each) { return each->b.momentum <= ends[k]; });
      if (active_.empty()) continue;
      // Sheets that meet do so at ends: inside, the least is one of them.
      constexpr double inside = 1e-3;
      const double margin = inside * (ends[k + 1] - ends[k]);
      divide(ends[k], ends[k + 1], least_at(ends[k] + margin), least_at(ends[k + 1] - margin));
    }
    decide_unclear();
    for (std::size_t k = 1; k < out_.size() && !stopped(); ++k) refine(out_[k - 1], out_[k]);
    std::vector<LeastEnergyPiece> all;
    if (stopped()) return all;
    for (const Piece& each : out_) all.push_back({each.sheet, each.from, each.to});
    return all;
  }

 private:
  struct Piece {
    int sheet;
    std::size_t run;
    LeastEnergyEnd from;
    LeastEnergyEnd to;
  };

  bool stopped() const { return stop_ != nullptr && *stop_; }

  /// Of two that have it, the one below.
  const EnergyArc* arc_of(std::size_t run, double momentum) const {
    const auto& arcs = runs_[run];
    const auto begins_below = [&](const EnergyArc* each) { return each->a.momentum <= momentum; };
    auto found = std::ranges::partition_point(arcs, begins_below);
    const EnergyArc* out = nullptr;
    while (found != arcs.begin() && (*--found)->has(momentum)) out = *found;
    return out;
  }

  /// The |pi| that a run has.
  std::pair<double, double> momenta(std::size_t run) const {
    return {runs_[run].front()->a.momentum, runs_[run].back()->b.momentum};
  }

  /// A motion of a run, solved for, or between its rows.
  std::optional<LeastEnergyEnd> motion(std::size_t run, double momentum) const {
    const EnergyArc* const arc = arc_of(run, momentum);
    if (arc == nullptr) return std::nullopt;
    if (const auto solved = solved_at(*arc, momentum)) return solved;
    return arc->at(momentum);
  }

  /// Of energies that are told apart by less than the interpolation is good for, as of sheets on the way to
  /// one escape, motions that are solved for decide; of those that rounding cannot tell apart, the piece
  /// before.
  void decide_unclear() {
    constexpr double unclear = 1e-5;
    constexpr double doubts = 4.0;
    constexpr double rounding = 1e-14;
    std::vector<Piece> kept;
    std::vector<const EnergyArc*> others;
    for (Piece each : out_) {
      if (stopped()) return;
      const double middle = 0.5 * (each.from.momentum + each.to.momentum);
      const EnergyArc* const here = arc_of(each.run, middle);
      const double coarse = here->at(middle).energy;
      const auto own = motion(each.run, middle);
      const double size = std::abs(coarse) + own->momentum * own->spin;
      const bool adjoins = !kept.empty() && kept.back().to.momentum == each.from.momentum;
      double least = own->energy;
      others.clear();
      for (std::size_t run = 0; run < runs_.size(); ++run)
        if (const EnergyArc* const arc = arc_of(run, middle)) others.push_back(arc);
      std::ranges::sort(others);
      for (const EnergyArc* const other : others) {
        if (other->run == each.run) continue;
        const double doubt = doubts * (here->doubt(middle) + other->doubt(middle));
        if (!(other->at(middle).energy - coarse <= std::max(unclear * size, doubt))) continue;
        if (!arc_of(other->run, each.from.momentum) || !arc_of(other->run, each.to.momentum))
          continue;
        if (stopped()) return;
        const double energy = motion(other->run, middle)->energy;
        const bool before = adjoins && other->run == kept.back().run;
        if (!(energy < least - rounding * size || (before && energy <= least + rounding * size)))
          continue;
        least = energy;
        each.run = other->run;
        each.sheet = other->sheet->number;
      }
      each.from = arc_of(each.run, each.from.momentum)->at(each.from.momentum);
      each.to = arc_of(each.run, each.to.momentum)->at(each.to.momentum);
      if (adjoins && kept.back().run == each.run) {
        kept.back().to = each.to;
      } else {
        kept.push_back(each);
      }
    }
    out_ = std::move(kept);
  }

  /// The |pi| at which two motions have one energy, by Newton's method with motions solved for, between the
  /// middles of their pieces as far as both are there: or where one sheet leaves the other.
  void refine(Piece& last, Piece& next) const {
    if (last.to.momentum != next.from.momentum) return;
    double low = std::max(0.5 * (last.from.momentum + last.to.momentum), momenta(next.run).first);
    double high = std::min(0.5 * (next.from.momentum + next.to.momentum), momenta(last.run).second);
    if (!(low <= high)) return;
    const auto hand_over = [&](const LeastEnergyEnd& a, const LeastEnergyEnd& b) {
      last.to = a;
      next.from = b;
    };
    const auto a_low = motion(last.run, low);
    const auto b_low = motion(next.run, low);
    const auto a_high = motion(last.run, high);
    const auto b_high = motion(next.run, high);
    if (!a_low || !b_low || !a_high || !b_high) return;
    const double at_low = b_low->energy - a_low->energy;
    const double at_high = b_high->energy - a_high->energy;
    constexpr double meet = 1e-12;
    const double size = meet * (std::abs(a_low->energy) + a_low->momentum * a_low->spin);
    if (low == momenta(next.run).first && std::abs(at_low) <= size && at_high < 0.0)
      return hand_over(*a_low, *b_low);
    if (high == momenta(last.run).second && std::abs(at_high) <= size && at_low > 0.0)
      return hand_over(*a_high, *b_high);
    if (!(at_low > 0.0) || !(at_high < 0.0)) return;
    double momentum = next.from.momentum;
    constexpr int most = 100;
    for (int k = 0; k < most; ++k) {
      const auto a = motion(last.run, momentum);
      const auto b = motion(next.run, momentum);
      if (!a || !b) return;
      const double ahead = b->energy - a->energy;
      (ahead > 0.0 ? low : high) = momentum;
      const double step = ahead / (a->spin - b->spin);
      if (std::abs(step) <= 0x1p-48 * momentum || high - low <= 0x1p-48 * momentum ||
          k + 1 == most) {
        return hand_over(*a, *b);
      }
      const double newton = momentum + step;
      momentum = low < newton && newton < high ? newton : 0.5 * (low + high);
    }
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
    if (!out_.empty() && out_.back().run == arc->run && out_.back().to.momentum == from) {
      out_.back().to = arc->at(to);
    } else {
      out_.push_back({arc->sheet->number, arc->run, arc->at(from), arc->at(to)});
    }
  }

  std::vector<EnergyArc> arcs_;
  const std::atomic<bool>* stop_;
  std::vector<std::vector<const EnergyArc*>> runs_;  ///< the arcs of each, ascending in |pi|
  std::vector<const EnergyArc*> active_;
  std::vector<Piece> out_;
};

/// The arcs of the sheets in the box, and which of them belong together.
class EnergyArcs {
 public:
  explicit EnergyArcs(const SearchOptions& box) : box_(box) {}

  void add(const AtlasSheet& sheet) {
    ++run_;
    direction_ = 0;
    for (std::size_t k = 1; k < sheet.rows.size(); ++k)
      add(sheet, sheet.rows[k - 1].member, sheet.rows[k].member);
  }
  std::vector<EnergyArc> taken() { return std::move(arcs_); }

 private:
  bool inside(const AtlasSheet& sheet, const Member& member) const {
    return in_box(member.q, box_, sheet.mirror);
  }

  void add(const AtlasSheet& sheet, const Member& first, const Member& second) {
    LeastEnergyEnd a = place_of(first);
    LeastEnergyEnd b = place_of(second);
    const bool has_a = inside(sheet, first);
    const bool has_b = inside(sheet, second);
    if (has_a != has_b) {
      const auto side = side_of_box(sheet, first, second, has_a);
      if (side) (has_a ? b : a) = *side;
      if (!side) return end_run();
    }
    if (!(has_a || has_b) || !is_finite(a) || !is_finite(b)) return end_run();
    if (a.momentum == b.momentum) return;
    const bool rises = a.momentum < b.momentum;
    const int direction = rises ? 1 : -1;
    if (direction_ == -direction) ++run_;
    direction_ = direction;
    arcs_.push_back(rises ? EnergyArc{&sheet, run_, a, b, &first, &second}
                          : EnergyArc{&sheet, run_, b, a, &second, &first});
    if (!has_b) end_run();
  }
  void end_run() {
    ++run_;
    direction_ = 0;
  }

  /// Where the sheet leaves the box between two rows; starts_inside: whether the first is in it.
  std::optional<LeastEnergyEnd> side_of_box(const AtlasSheet& sheet, const Member& first,
                                            const Member& second, bool starts_inside) const {
    if (!sheet.arc) return std::nullopt;
    double in = starts_inside ? 0.0 : 1.0;
    double out = 1.0 - in;
    std::optional<LeastEnergyEnd> at;
    constexpr int halvings = 44;
    for (int k = 0; k < halvings; ++k) {
      const double middle = 0.5 * (in + out);
      const auto member = sheet.arc(first, second, middle);
      if (!member) return std::nullopt;
      const bool is_in = inside(sheet, *member);
      (is_in ? in : out) = middle;
      if (is_in) at = place_of(*member);
    }
    return at;
  }

  const SearchOptions& box_;
  std::size_t run_ = 0;
  int direction_ = 0;  ///< of |pi| on the run so far: 1 rising, -1 falling, 0 not known
  std::vector<EnergyArc> arcs_;
};

}  // namespace

std::vector<LeastEnergyPiece> least_energy(const std::vector<AtlasSheet>& sheets,
                                           const SearchOptions& box) {
  EnergyArcs arcs(box);
  for (const AtlasSheet& sheet : sheets) arcs.add(sheet);
  return Envelope(arcs.taken(), box.stop).pieces();
}

}  // namespace stationary
