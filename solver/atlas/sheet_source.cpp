#include "solver/atlas/sheet_source.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/balance/anisotropic_balance.hpp"
#include "lib/number/elementary.hpp"
#include "solver/continuation/curve.hpp"
#include "solver/family/branch_switch.hpp"
#include "solver/motion/body_circle.hpp"
#include "solver/proof/event_enclosure.hpp"

namespace stationary {
namespace {

constexpr double pi = std::numbers::pi;

class AxisSheets final : public SheetSource {
 public:
  explicit AxisSheets(const Problem& problem)
      : problem_(problem),
        circle_(circle_of(problem)),
        bends_(branch() == Branch::iii && problem_.potential().may_shear()) {}

  Branch branch() const override { return problem_.branch(); }

  SearchResult search(double nu, const SearchOptions& options) const override {
    if (bends_) return at(nu)->search(options);
    return stationary::search(problem_, nu, options);
  }

  std::optional<KindCover> cover(double from, double to, const SearchOptions& options,
                                 bool classes) const override {
    if (bends_) return std::nullopt;
    return cover_axis(problem_, from, to, options, classes);
  }
  bool none_outside(double from, double to, const SearchOptions& options) const override {
    return stationary::none_outside(problem_, from, to, options);
  }
  std::optional<StabilityClass> proven_class(const Equilibrium& at, Inputs inputs) const override {
    if (at.q.alpha != 0.0) return proven_class_of(*this->at(at.nu[2]), at);
    return proven_class_of(problem_, at, inputs);
  }

  std::vector<Place> at_rest(const SolveOptions& options) const override {
    return places_at_rest(problem_, options);
  }

  /// In (iii), where some may have alpha != 0, these are the second.
  int families() const override { return bends_ ? 2 : 1; }
  int family_of(const Place& at) const override { return bends_ && at.q.alpha != 0.0 ? 1 : 0; }
  AnyFamily family(int which, bool spectrum) const override {
    if (which == 1) {
      constexpr Stretch any{0.1, 1.0, 1.0, 1.0};
      return at(1.0)->family({}, {.spectrum = spectrum}, any);
    }
    return axis_family(problem_, {.nu = 0.0, .parameter = {}, .spectrum = spectrum});
  }

  /// Of an ellipse and the same turned by a right angle that which is drawn out along the first of
  /// its two axes.
  Place canonical(const Place& at) const override {
    if (bends_) return mirrored_upwards(at);
    if (mirror() == Circle::none) return at;
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

  Circle mirror() const override { return bends_ ? Circle::none : circle_; }

  EventType leaves_by() const override {
    if (bends_) return EventType::shear;
    return circle_ == Circle::none ? EventType::none : ellipse_event(circle_);
  }
  bool leaves_at(const Member& at) const override {
    return bends_ ? at.q.alpha == 0.0 : is_circle(at.q);
  }
  std::optional<Interval> proven_parting(const Member& at, Inputs inputs) const override {
    const EventEnclosure event = enclose_event(problem_, {}, circle_, leaves_by(), at, inputs);
    if (!event.proven) return std::nullopt;
    return event.parameter;
  }

  DepartureResult departure(Branch, const Member& at, double range) const override {
    if (bends_) return leave_mirror(this->family(1, false), at, branch());
    const AnyFamily family = this->family(0, false);
    return std::visit([&](const auto& f) { return leave_circle(*f, at, range); }, family);
  }

 private:
  std::unique_ptr<Kind> at(double nu) const {
    return kind_of(problem_.body(), problem_.potential(), AxisRotation{branch(), nu});
  }
  bool is_circle(const Stretch& q) const { return is_on(circle_, q, same_place); }

  template <int N>
  DepartureResult leave_circle(const Family<N>& family, const Member& at, double range) const {
    if constexpr (N > 3) {
      return "no family with circles";
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
  bool bends_;  ///< some may have alpha != 0
};

}  // namespace

Place mirrored_upwards(const Place& at) {
  const double a = log(shear_coordinate(at.q));
  Place out = at;
  if (std::abs(a) < same_place) {
    out.q.alpha = 0.0;
    out.axis = std::abs(at.axis);
  } else if (a < 0.0) {
    out.q.alpha = -at.q.alpha;
    out.axis = -at.axis;
  }
  return out;
}

double distance(const Place& a, const Place& b) {
  return std::max({std::abs(log(a.q.xi / b.q.xi)), std::abs(log(a.q.zeta / b.q.zeta)),
                   std::abs(log(a.q.rho / b.q.rho)),
                   std::abs(log(shear_coordinate(a.q) / shear_coordinate(b.q))),
                   std::abs(std::remainder(a.axis - b.axis, pi))});
}

std::vector<Place> places_at_rest(const Problem& problem, const SolveOptions& options) {
  const Equilibrium rest = solve(problem, 0.0, options);
  if (rest.status != SolveStatus::solved) return {};
  return {Place{rest.q}};
}

std::optional<StabilityClass> proven_class_of(const Problem& problem, const Equilibrium& at,
                                              Inputs inputs) {
  const Certificate proof = certify(problem, at, inputs);
  if (!proof.proven) return std::nullopt;
  return enclose_spectrum(problem, at, proof, {}, inputs).verdict;
}

std::optional<StabilityClass> proven_class_of(const Kind& kind, const Equilibrium& at) {
  const Certificate proof = kind.certify(at);
  if (!proof.proven) return std::nullopt;
  return kind.enclose(at, proof, {}).verdict;
}

DepartureResult SheetSource::leave_mirror(const AnyFamily& family, const Member& at,
                                          Branch parent) const {
  const auto found = leave_straight(family, at, parent);
  if (!found) return "none was found beside it";
  return Departure{place(found->q, found->angular_velocity), found->parameter};
}

Place SheetSource::place(const Stretch& q, const Vector3<double>& nu) const {
  return {q, oblique() ? std::remainder(atan2(nu[1], nu[0]), pi) : 0.0};
}

std::unique_ptr<SheetSource> axis_sheets(const Problem& problem) {
  return std::make_unique<AxisSheets>(problem);
}

}  // namespace stationary
