// The proof of an event from its equations (event_enclosure.hpp), whatever kind of motion they are
// of: Newton's method in double from the located event, Krawczyk's test there, and that what is
// proven is the event located and not another.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/matrix/elementwise.hpp"
#include "lib/number/dual.hpp"
#include "solver/proof/event_enclosure.hpp"
#include "solver/proof/krawczyk.hpp"

namespace stationary {

/// Equations (over_boxes(unknowns, inputs), in BoxNumber, duals with at least as many slopes as there
/// are unknowns) over a box of the unknowns, slopes in their logarithms.
template <class Equations>
class EventBoxes {
 public:
  static constexpr int dimension = Equations::dimension;
  using T = typename Equations::BoxNumber;

  EventBoxes(const Equations& equations, Inputs inputs) : equations_(&equations), inputs_(inputs) {}

  GeneralBoxLinearized<dimension> linearize(const Box<dimension>& box) const {
    std::array<T, static_cast<std::size_t>(dimension)> y;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = T::logarithmic(box[i], i);
    const auto values = equations_->over_boxes(y, inputs_);
    GeneralBoxLinearized<dimension> out;
    for (std::size_t i = 0; i < y.size(); ++i) {
      out.g[i] = values[i].value;
      std::copy_n(values[i].slope.begin(), y.size(), out.slope[i].begin());
    }
    return out;
  }

 private:
  const Equations* equations_;
  Inputs inputs_;
};

/// Newton in double from the located event: its own accuracy is that of a bracket.
template <class System>
bool polish_event(const System& system, ReducedVector<System::dimension>& y) {
  constexpr int N = System::dimension;
  constexpr int most = 12;
  double before = std::numeric_limits<double>::infinity();
  for (int k = 0; k < most; ++k) {
    Box<N> point;
    for (int i = 0; i < N; ++i) point[static_cast<std::size_t>(i)] = y[i];
    const auto at = system.linearize(point);
    ReducedVector<N> g;
    for (int i = 0; i < N; ++i) g[i] = at.g[static_cast<std::size_t>(i)].mid();
    const ReducedVector<N> step = -(at.middle().inverse().entries * g);
    const double size = step.cwiseAbs().maxCoeff();
    if (!std::isfinite(size) || size > 0.1) return false;
    if (size >= before) return true;  // at rounding
    y = (y.array() * exponentials(step.array())).matrix();
    if (size < 1e-15) return true;
    before = size < 1e-10 ? size : std::numeric_limits<double>::infinity();
  }
  return true;
}

/// y: the unknowns at the located event, the parameter number p among them; stretches(box): xi,
/// zeta, rho in a box of the unknowns.
template <class System, class Stretches>
EventEnclosure enclosed_event(const System& system, ReducedVector<System::dimension> y, int p,
                              const Member& member, const Stretches& stretches) {
  EventEnclosure out;
  if (member.parameter == 0.0 || !polish_event(system, y)) {
    out.reason = "the event's equations are singular here, or have no solution near by";
    return out;
  }
  const auto proof = Krawczyk(system, y).prove();
  if (!proof.proven) {
    out.reason = "the event's equations are too near to singular for a proof";
    return out;
  }
  // Of |x/y - 1| over all y in Y.
  const auto distance = [](double x, const Interval& Y) {
    return (x / Y - Interval(1.0)).magnitude();
  };
  out.q = stretches(proof.solution);
  out.parameter = proof.solution[static_cast<std::size_t>(p)];
  const double bound =
      std::max({distance(member.q.xi, out.q.xi), distance(member.q.zeta, out.q.zeta),
                distance(member.q.rho, out.q.rho)});
  constexpr double near = 1e-4;
  if (!(bound < near) || !(distance(member.parameter, out.parameter) < near)) {
    out.reason = "the event proven near by is not the one located";
    return out;
  }
  out.proven = true;
  out.error_bound = bound;
  return out;
}

}  // namespace stationary
