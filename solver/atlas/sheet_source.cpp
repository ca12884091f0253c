#include "solver/atlas/sheet_source.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/balance/anisotropic_balance.hpp"
#include "lib/number/elementary.hpp"
#include "solver/continuation/curve.hpp"
#include "solver/motion/body_circle.hpp"
#include "solver/proof/event_enclosure.hpp"

namespace stationary {
namespace {

constexpr double pi = std::numbers::pi;

class AxisSheets final : public SheetSource {
 public:
  explicit AxisSheets(const Problem& problem) : problem_(problem), circle_(circle_of(problem)) {}

  Branch branch() const override { return problem_.branch(); }

  SearchResult search(double nu, const SearchOptions& options) const override {
    return stationary::search(problem_, nu, options);
  }

  std::optional<KindCover> cover(double from, double to, const SearchOptions& options,
                                 bool classes) const override {
    return cover_axis(problem_, from, to, options, classes);
  }
  bool none_outside(double from, double to, const SearchOptions& options) const override {
    return stationary::none_outside(problem_, from, to, options);
  }
  std::optional<StabilityClass> proven_class(const Equilibrium& at, Inputs inputs) const override {
    const Certificate proof = certify(problem_, at, inputs);
    if (!proof.proven) return std::nullopt;
    return enclose_spectrum(problem_, at, proof, {}, inputs).verdict;
  }

  std::vector<Place> at_rest(const SolveOptions& options) const override {
    const Equilibrium rest = solve(problem_, 0.0, options);
    if (rest.status != SolveStatus::solved) return {};
    return {Place{rest.q}};
  }

  AnyFamily family(int, bool spectrum) const override {
    return axis_family(problem_, {.nu = 0.0, .parameter = {}, .spectrum = spectrum});
  }

  /// Of an ellipse and the same turned by a right angle that which is drawn out along the first of
  /// its two axes.
  Place canonical(const Place& at) const override {
    if (circle_ == Circle::none) return at;
    Place out = at;
    double* const x[3] = {&out.q.xi, &out.q.zeta, &out.q.rho};
    const auto [a, b, other] = places(circle_);
    if (is_circle(at.q)) {
      *x[a] = *x[b] = std::sqrt(*x[a] * *x[b]);
    } else if (*x[a] < *x[b]) {
      std::swap(*x[a], *x[b]);
    }
    return out;
  }

  EventType leaves_by() const override {
    return circle_ == Circle::none ? EventType::none : ellipse_event(circle_);
  }
  bool leaves_at(const Member& at) const override { return is_circle(at.q); }
  std::optional<Interval> proven_parting(const Member& at, Inputs inputs) const override {
    const EventEnclosure event = enclose_event(problem_, {}, circle_, leaves_by(), at, inputs);
    if (!event.proven) return std::nullopt;
    return event.parameter;
  }

  DepartureResult departure(Branch, const Member& at, double range) const override {
    const AnyFamily family = this->family(0, false);
    return std::visit([&](const auto& f) { return leave_circle(*f, at, range); }, family);
  }

 private:
  bool is_circle(const Stretch& q) const { return is_on(circle_, q, same_place); }

  template <int N>
  DepartureResult leave_circle(const Family<N>& family, const Member& at, double range) const {
    if constexpr (N > 3) {
      return "no family of an isotropic potential";
    } else {
      const Curve<N> curve(family, range, Circle::none);
      const auto [a, b, other] = places(circle_);
      ArcVector<N> aside = ArcVector<N>::Zero();
      aside[a] = 1.0 / std::numbers::sqrt2;
      aside[b] = -aside[a];
      constexpr double gap = 1e-3;
      const ReducedVector<N> x =
          moved<N>(unknowns<N>(at.q), ReducedVector<N>(gap * aside.template head<N>()));
      const Corrected<N> off = curve.corrector().correct_freely(x, at.nu, aside, 0.5 * gap);
      if (off.status != CorrectorStatus::converged) return std::string(name(off.status));
      // Of a vertical branch the event's nu, not one that differs by the rounding of a correction.
      const bool same_nu = std::abs(off.point.p - at.nu) <= 1e-12 * at.nu;
      return Departure{{with_unknowns<N>(at.q, off.point.x)}, same_nu ? at.nu : off.point.p};
    }
  }

  Problem problem_;
  Circle circle_;
};

}  // namespace

double distance(const Place& a, const Place& b) {
  return std::max({std::abs(log(a.q.xi / b.q.xi)), std::abs(log(a.q.zeta / b.q.zeta)),
                   std::abs(log(a.q.rho / b.q.rho)),
                   std::abs(log(shear_coordinate(a.q) / shear_coordinate(b.q))),
                   std::abs(std::remainder(a.axis - b.axis, pi))});
}

Place SheetSource::place(const Stretch& q, const Vector3<double>& nu) const {
  return {q, oblique() ? std::remainder(atan2(nu[1], nu[0]), pi) : 0.0};
}

std::unique_ptr<SheetSource> axis_sheets(const Problem& problem) {
  return std::make_unique<AxisSheets>(problem);
}

}  // namespace stationary
