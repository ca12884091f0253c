#include "solver/tube/tube_set.hpp"

#include <algorithm>

namespace stationary {

template <int N>
bool glued(const CurveEquations<N>& equations, const Tube<N>& a, double face, const Tube<N>& b) {
  return b.holds(a.slice(equations, Interval(face)).y);
}

template <int N>
std::size_t TubeSet<N>::holder(const CurveBox<N>& place, const But& but) const {
  for (std::size_t k = 0; k < tubes_.size(); ++k)
    if (k != but.first && k != but.second && tubes_[k].holds(place)) return k;
  return none;
}

/// The longest tube about y up to h that can be proven, glued to the one before.
template <int N>
std::size_t TubeSet<N>::prove(const TubePoint<N>& y, const TubePoint<N>& tangent, double& h,
                              std::size_t before, double face) {
  constexpr double shorter = 0.6;
  for (; h >= options_.shortest && tubes_.size() < options_.most; h *= shorter) {
    auto tube = Tube<N>::proven(equations_, y, tangent, h);
    if (!tube) continue;
    tube->fatten(equations_);
    if (before != none && !glued(equations_, tubes_[before], face, *tube)) continue;
    tubes_.push_back(*tube);
    return tubes_.size() - 1;
  }
  stuck_.push_back(y);
  return none;
}

template <int N>
bool TubeSet<N>::follow(const TubePoint<N>& start) {
  const auto y = corrected_point(equations_, start);
  if (!y || holds(point_box<N>(*y))) return false;
  const TubePoint<N> tangent = tangent_of<N>(equations_.linearize(point_box<N>(*y)));
  double h = options_.first;
  const std::size_t first = prove(*y, tangent, h, none, 0.0);
  if (first == none) return false;
  follow_from(first, 1.0);
  follow_from(first, -1.0);
  return true;
}

template <int N>
void TubeSet<N>::follow_from(std::size_t first, double side) {
  constexpr double longer = 1.35;
  std::size_t before = none;
  std::size_t last = first;
  double h = tubes_[first].half_length();
  TubePoint<N> ahead = side * tubes_[first].tangent();
  for (;;) {
    const double face =
        last == first ? side * tubes_[last].half_length() : tubes_[last].half_length();
    const CurveBox<N> end = tubes_[last].slice(equations_, Interval(face)).y;
    if (within_region(equations_, region_, end) == Within::none) return;
    if (holder(end, {last, before}) != none) return;
    const TubePoint<N> y = middle_of<N>(end);
    TubePoint<N> tangent = tangent_of<N>(equations_.linearize(point_box<N>(y)));
    if (tangent.dot(ahead) < 0.0) tangent = -tangent;
    h = std::min(longer * h, options_.longest);
    const std::size_t next = prove(y, tangent, h, last, face);
    if (next == none) return;
    before = last;
    last = next;
    ahead = tangent;
  }
}

#define STATIONARY_TUBE_SET(N)                                                              \
  template bool glued<N>(const CurveEquations<N>&, const Tube<N>&, double, const Tube<N>&); \
  template class TubeSet<N>;
STATIONARY_TUBE_SET(1)
STATIONARY_TUBE_SET(2)
STATIONARY_TUBE_SET(3)
STATIONARY_TUBE_SET(4)
#undef STATIONARY_TUBE_SET

}  // namespace stationary
