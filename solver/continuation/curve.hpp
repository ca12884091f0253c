// A point of a family's curve with all that is known there, and how one is made: corrected, its
// member computed, the event functions evaluated.
#pragma once

#include "lib/number/elementary.hpp"
#include "solver/continuation/corrector.hpp"
#include "solver/motion/event.hpp"

namespace stationary {

template <int N>
struct CurvePoint {
  ArcPoint<N> arc;
  Member member;
  TestValues tests;
};

/// An event by its own equations, and what its parameter lies between for every value the inputs
/// may have (extended_root.hpp).
struct KnownEvent {
  Member member;
  double before;
  double after;
};

/// [p - error, p + error], outward.
inline std::array<double, 2> bracket_of(double p, double error) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {std::nextafter(p - error, -infinity), std::nextafter(p + error, infinity)};
}

template <int N>
class Curve {
 public:
  /// scale: of p in y. circle, pinned: see Corrector. asked: the events wanted.
  Curve(const Family<N>& family, double scale, Circle circle,
        std::optional<double> pinned = std::nullopt, EventSet asked = {})
      : family_(&family),
        corrector_(family, scale, circle, pinned),
        context_{.branch = family.branch(),
                 .material_symmetry = family.material_symmetry(),
                 .circle = circle,
                 .kind = family.events(),
                 .sought = TestContext::sought_for(asked),
                 .along_nu = family.along_nu()} {}

  const Family<N>& family() const { return *family_; }
  const Corrector<N>& corrector() const { return corrector_; }
  const TestContext& context() const { return context_; }

  /// Member and event functions of a corrected point.
  CurvePoint<N> complete(const ArcPoint<N>& arc) const {
    CurvePoint<N> out;
    out.arc = arc;
    out.member = family_->member(arc.x, arc.tail, arc.p, arc.error_bound);
    const auto [fold, momentum, per_parameter] = turns(arc, out.member);
    // A vertical curve turns nowhere: p is one and the same.
    const double turn = corrector_.vertical() ? std::numeric_limits<double>::quiet_NaN() : fold;
    // At a turn of p the bound is of x at the row's p; on the curve x is far better known.
    const double error = arc.at_turn || std::isnan(arc.error_bound) ? 0.0 : arc.error_bound;
    out.tests = test_values(out.member, context_, turn, momentum, error);
    // Where p has an asymptote the tangent's share of it is rounding: no sign is certain by that.
    constexpr double small = 1e-4;
    if (out.tests.value[TestValues::momentum] == momentum && std::abs(momentum) < small &&
        !(std::abs(momentum) >
          per_parameter * (corrector_.correction_rounding(arc) + arc.slopes_error)))
      out.tests.uncertain |= 1U << static_cast<unsigned>(TestValues::momentum);
    return out;
  }

  /// The event of this type near a located member, within a distance in y; nothing where its own
  /// equations do not lead there.
  std::optional<KnownEvent> event_at(EventType type, const Member& near, double distance) const {
    const auto found = family_->event_at(type, context_.circle, near);
    // Of a bound this coarse it is known no better than by its function's sign.
    constexpr double coarse = 1e-3;
    if (!found || !(found->error_bound < coarse)) return std::nullopt;
    const double p = double(found->parameter);
    const ReducedVector<N> from = family_->coordinates_of(near);
    ReducedVector<N> x;
    ReducedVector<N> tail;
    double moved = std::abs(p - near.parameter) / corrector_.scale();
    for (int i = 0; i < N; ++i) {
      const DoubleDouble& exact = found->x[static_cast<std::size_t>(i)];
      x[i] = double(exact);
      tail[i] = double(exact - x[i]);
      moved = std::max(moved, std::abs(log(x[i] / from[i])));
    }
    if (!(moved <= distance)) return std::nullopt;
    const double rounding = 0x1p-53;
    KnownEvent out{family_->member(x, tail, p, found->error_bound + rounding), 0.0, 0.0};
    const auto ends = bracket_of(p, (found->parameter_bound + rounding) * std::abs(p));
    out.before = ends[0];
    out.after = ends[1];
    return out;
  }

  /// The point at a fraction u of the arc from a point, corrected.
  Corrected<N> at(const ArcPoint<N>& from, const Arc<N>& arc, double u) const {
    const ArcVector<N> y = arc.at(u);
    return corrector_.correct(moved<N>(from.x, ReducedVector<N>(y.template head<N>())),
                              from.p + corrector_.scale() * y[N], arc.direction(u), arc.length);
  }

 private:
  struct Turns {
    double fold;
    double momentum;
    double per_parameter;  ///< what a change of the tangent's last component in y does to both
  };

  /// Kernel of [dG/d ln x  dG/dnu].
  static ArcVector<N> kernel(const FamilySlopes<N>& at) {
    Eigen::Matrix<double, N, N + 1> A;
    A.template leftCols<N>() = at.jacobian;
    A.col(N) = at.nu_slope;
    return kernel_by_cofactors<N>(A);
  }

  /// c_nu and d(I_a nu)/I_a along c, with |c| = 1.
  Turns turns(const ArcPoint<N>& arc, const Member& member) const {
    ArcVector<N> c;
    if (family_->along_nu()) {
      c = arc.tangent;
      c[N] *= corrector_.scale();
    } else {
      c = kernel(arc.slopes);
    }
    const double per_parameter = (family_->along_nu() ? corrector_.scale() : 0.0) / c.norm();
    c.normalize();
    const SpinInertia<N> I = family_->spin_inertia(member);
    const double change = I.half_slope.dot(c.template head<N>());
    return {c[N], c[N] + 2.0 * member.nu * change / I.own, per_parameter};
  }

  const Family<N>* family_;
  Corrector<N> corrector_;
  TestContext context_;
};

}  // namespace stationary
