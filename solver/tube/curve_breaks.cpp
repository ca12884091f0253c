#include "solver/tube/curve_breaks.hpp"

#include <algorithm>

namespace stationary {
namespace {

template <int N>
class Breaks {
 public:
  Breaks(const CurveEquations<N>& equations, const CurveRegion<N>& region,
         const std::atomic<bool>* stop)
      : equations_(equations), region_(region), stop_(stop) {}

  void add(const Tube<N>& tube) {
    tube_ = &tube;
    halve({-tube.half_length(), tube.half_length()});
  }

  std::vector<CurveBreak> merged() {
    std::ranges::sort(found_, {}, [](const CurveBreak& each) { return each.q.lo; });
    // Enclosures of one point by two tubes touch, or nearly so.
    constexpr double nearly = 1e-12;
    std::vector<CurveBreak> out;
    for (const CurveBreak& each : found_) {
      if (out.empty() || each.q.lo > out.back().q.hi + nearly) {
        out.push_back(each);
        continue;
      }
      CurveBreak& last = out.back();
      last.q.hi = std::max(last.q.hi, each.q.hi);
      last.turns = last.turns || each.turns;
      last.crosses = last.crosses || each.crosses;
      last.ends = last.ends || each.ends;
      last.mirrors = last.mirrors || each.mirrors;
      last.undecided = last.undecided || each.undecided;
    }
    return out;
  }

 private:
  static constexpr long many = 10'000;
  static constexpr long most = 30'000;

  /// Of q, at which a slice is left as it is. On its way to an escape a curve is nearly one of a single
  /// q, and the sign of dq/ds asks for ever shorter slices.
  double narrow() const { return slices_ <= many ? 1e-13 : 1e-9; }

  /// Of conditions, from one to another: whether the sign of any is open.
  bool open(const CurveBox<N>& y, std::size_t first, std::size_t last) const {
    const std::vector<Interval> all = equations_.conditions(y);
    bool out = false;
    for (std::size_t k = first; k < std::min(last, all.size()); ++k)
      out = out || !all[k].positive();
    return out;
  }
  bool ends(const CurveBox<N>& y) const { return open(y, 0, equations_.ends()); }
  bool crosses(const CurveBox<N>& y) const {
    bool out = open(y, equations_.ends(), static_cast<std::size_t>(-1));
    for (std::size_t i = 0; i < std::size_t(N); ++i)
      out = out || !(y[i] - region_.lower[i]).positive() || !(region_.upper[i] - y[i]).positive();
    return out;
  }

  void halve(const Interval& s) {
    constexpr double shortest = 0x1p-40;
    if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) return;
    ++slices_;
    const auto slice = tube_->slice(equations_, s);
    const Within within = within_region(equations_, region_, slice.y);
    if (within == Within::none) return;
    const Interval& q = slice.y[std::size_t(N)];
    const bool turns = slice.velocity[std::size_t(N)].may_be(0.0);
    if (!turns && within == Within::all) return;
    const bool meets_mirror = region_.mirror && slice.y[*region_.mirror].may_be(0.0);
    const bool once = meets_mirror && !slice.velocity[*region_.mirror].may_be(0.0);
    const double middle = s.mid();
    const auto no_narrower_at_a_point = [&] {
      const Interval at = tube_->slice(equations_, Interval(middle)).y[std::size_t(N)];
      return q.hi - q.lo <= 2.0 * (at.hi - at.lo);
    };
    const double width = q.hi - q.lo;
    const bool found = meets_mirror == once && (width <= narrow() || no_narrower_at_a_point());
    if (found || slices_ > most || s.hi - s.lo <= shortest * tube_->half_length()) {
      found_.push_back({q, turns, crosses(slice.y), ends(slice.y), once, slices_ > most});
      return;
    }
    halve({s.lo, middle});
    halve({middle, s.hi});
  }

  const CurveEquations<N>& equations_;
  const CurveRegion<N>& region_;
  const std::atomic<bool>* stop_;
  const Tube<N>* tube_ = nullptr;
  long slices_ = 0;
  std::vector<CurveBreak> found_;
};

}  // namespace

template <int N>
std::vector<CurveBreak> curve_breaks(const CurveEquations<N>& equations,
                                     const CurveRegion<N>& region, const TubeSet<N>& tubes,
                                     const std::atomic<bool>* stop) {
  Breaks<N> out(equations, region, stop);
  for (const Tube<N>& tube : tubes.tubes()) out.add(tube);
  return out.merged();
}

template std::vector<CurveBreak> curve_breaks<1>(const CurveEquations<1>&, const CurveRegion<1>&,
                                                 const TubeSet<1>&, const std::atomic<bool>*);
template std::vector<CurveBreak> curve_breaks<2>(const CurveEquations<2>&, const CurveRegion<2>&,
                                                 const TubeSet<2>&, const std::atomic<bool>*);
template std::vector<CurveBreak> curve_breaks<3>(const CurveEquations<3>&, const CurveRegion<3>&,
                                                 const TubeSet<3>&, const std::atomic<bool>*);
template std::vector<CurveBreak> curve_breaks<4>(const CurveEquations<4>&, const CurveRegion<4>&,
                                                 const TubeSet<4>&, const std::atomic<bool>*);

}  // namespace stationary
