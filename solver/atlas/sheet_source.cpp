#include "solver/atlas/sheet_source.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/balance/anisotropic_balance.hpp"
#include "solver/continuation/curve.hpp"
#include "solver/proof/event_enclosure.hpp"

namespace stationary {
namespace {

constexpr double pi = std::numbers::pi;

class AxisSheets final : public SheetSource {
 public:
  explicit AxisSheets(const Problem& problem) : problem_(problem) {}

  Branch branch() const override { return problem_.branch(); }

  SearchResult search(double nu, const SearchOptions& options) const override {
    return stationary::search(problem_, nu, options);
  }

  std::optional<KindCover> cover(double from, double to,
                                 const SearchOptions& options) const override {
    return cover_axis(problem_, from, to, options);
  }

  std::vector<Place> at_rest(const SolveOptions& options) const override {
    const Equilibrium rest = solve(problem_, 0.0, options);
    if (rest.status != SolveStatus::solved) return {};
    return {Place{rest.q}};
  }

  AnyFamily family(int, bool spectrum) const override {
    return axis_family(problem_, {.nu = 0.0, .parameter = {}, .spectrum = spectrum});
  }

  /// Of an ellipse and the same turned by a right angle that which is drawn out along axis 1.
  Place canonical(const Place& at) const override {
    if (!has_mirror_images()) return at;
    Place out = at;
    if (is_circle(at.q)) {
      out.q.xi = out.q.zeta = std::sqrt(at.q.xi * at.q.zeta);
    } else if (at.q.xi < at.q.zeta) {
      std::swap(out.q.xi, out.q.zeta);
    }
    return out;
  }

  EventType leaves_by() const override {
    return has_mirror_images() ? EventType::ellipse : EventType::none;
  }
  bool leaves_at(const Member& at) const override { return is_circle(at.q); }
  std::optional<Interval> proven_parting(const Member& at, Inputs inputs) const override {
    const EventEnclosure event =
        enclose_event(problem_, {}, /*circle=*/true, leaves_by(), at, inputs);
    if (!event.proven) return std::nullopt;
    return event.parameter;
  }

  DepartureResult departure(Branch, const Member& at, double range) const override {
    const AnyFamily family = this->family(0, false);
    return std::visit([&](const auto& f) { return leave_circle(*f, at, range); }, family);
  }

 private:
  bool has_mirror_images() const {
    return problem_.branch() == Branch::iii && problem_.body().symmetric();
  }
  static bool is_circle(const Stretch& q) { return std::abs(std::log(q.xi / q.zeta)) < same_place; }

  template <int N>
  static DepartureResult leave_circle(const Family<N>& family, const Member& at, double range) {
    if constexpr (N > 3) {
      return "no family of an isotropic potential";
    } else {
      const Curve<N> curve(family, range, /*circle=*/false);
      ArcVector<N> aside = ArcVector<N>::Zero();
      aside[0] = 1.0 / std::numbers::sqrt2;
      aside[1] = -aside[0];
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
};

}  // namespace

double distance(const Place& a, const Place& b) {
  return std::max({std::abs(std::log(a.q.xi / b.q.xi)), std::abs(std::log(a.q.zeta / b.q.zeta)),
                   std::abs(std::log(a.q.rho / b.q.rho)),
                   std::abs(std::log(shear_coordinate(a.q) / shear_coordinate(b.q))),
                   std::abs(std::remainder(a.axis - b.axis, pi))});
}

Place SheetSource::place(const Stretch& q, const Vector3<double>& nu) const {
  return {q, oblique() ? std::remainder(std::atan2(nu[1], nu[0]), pi) : 0.0};
}

std::unique_ptr<SheetSource> axis_sheets(const Problem& problem) {
  return std::make_unique<AxisSheets>(problem);
}

}  // namespace stationary
