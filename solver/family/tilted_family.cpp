#include "solver/family/tilted_family.hpp"

#include <algorithm>
#include <cmath>

#include "lib/body/inertia.hpp"
#include "lib/material/elastic_energy.hpp"
#include "lib/material/models/first_order_bound_model.hpp"
#include "lib/stability/general_spectrum.hpp"
#include "solver/continuation/curve_start.hpp"
#include "solver/family/sheared_family.hpp"
#include "solver/family/tilted_events.hpp"
#include "solver/motion/tilted_system.hpp"
#include "solver/motion/varied_balance.hpp"

namespace stationary {
namespace {

template <class Model>
class TiltedFamily final : public Family<2> {
 public:
  TiltedFamily(const Body& body, const Potential& potential, const Model& model, TiltPlane plane,
               bool spectrum)
      : body_(body),
        potential_(potential),
        model_(model),
        plane_(plane),
        spectrum_(spectrum),
        may_leave_plane_(!no_sheared_motion(body, potential, ShearedAxis::in_no_plane)) {}

  Branch branch() const override { return Branch::iii; }
  KindEvents events() const override { return tilted_events(); }
  bool along_nu() const override { return true; }
  /// No member is a circle or its own mirror image, also where J1 = J2.
  bool material_symmetry() const override { return false; }

  std::vector<ConditionValue> conditions(const ReducedVector<2>& x, double) const override {
    return model_conditions(model_, {0.0, x[0], x[1], tilted_thickness(body_, plane_, x[0], x[1])});
  }

  FamilyLinearization<2> linearize(const ReducedVector<2>& x, double p) const override {
    ++evaluations_.jacobians;
    const Linearized<2> at = system(p).linearize(x);
    const double scale = 1.0 / at.magnitude;
    FamilyLinearization<2> out;
    out.g = scale * at.g;
    out.jacobian = scale * at.jacobian.matrix();
    const auto pull =
        tilted_pull(model_, plane_, x[0], x[1], tilted_thickness(body_, plane_, x[0], x[1]),
                    axis_rates(body_, Branch::iii, 2.0 * p));
    out.slope = -scale * ReducedVector<2>(pull[0], pull[1]);
    out.nu_slope = out.slope;
    return out;
  }

  Refined refine_at(ReducedVector<2>& x, ReducedVector<2>& tail, double p) const override {
    const Refined out = refine(system(p), x, most_corrections, &tail);
    evaluations_.extended_residuals += out.steps;
    evaluations_.jacobians += out.steps;
    evaluations_.sensitivities += out.converged;
    return out;
  }

  ReducedVector<2> extended_residual(const ReducedVector<2>& x, double p) const override {
    const TiltedSystem<Model> at = system(p);
    ++evaluations_.extended_residuals;
    ++evaluations_.jacobians;
    return at.extended_residual(x) / at.linearize(x).magnitude;
  }

  ReducedVector<2> input_perturbation(const ReducedVector<2>& x, double p) const override {
    const TiltedSystem<Model> at = system(p);
    ++evaluations_.sensitivities;
    ++evaluations_.jacobians;
    return 0x1p-53 * at.input_sensitivity(x) / at.linearize(x).magnitude;
  }

  std::unique_ptr<ExtendedEventEquations<5>> event_equations(EventType type, Circle,
                                                             const Member& near) const override {
    const auto kind = vanishing_at(type, near);
    if (!kind) return nullptr;
    // rho has its own error of the J that tie it.
    return std::make_unique<SystemEventEquations<5, TiltedEventSystem>>(
        TiltedEventSystem(body_, potential_, plane_, *kind), std::array<std::size_t, 3>{0, 1, 3},
        false, StretchErrorRule{.rounding = 0x1p-53});
  }

  Member member(const ReducedVector<2>& x, const ReducedVector<2>& tail, double p,
                double error_bound) const override {
    const auto wide = tail.allFinite()
                          ? std::array{DoubleDouble(x[0], tail[0]), DoubleDouble(x[1], tail[1])}
                          : extended_solution(system(p), x);
    const BasicStretch<DoubleDouble> q{0.0, wide[0], wide[1],
                                       tilted_thickness(body_, plane_, wide[0], wide[1])};
    const TiltSquares<DoubleDouble> squares = squares_at(q, p);
    Member out;
    out.parameter = out.nu = p;
    out.body = body_;
    out.q = {0.0, x[0], x[1], double(q.rho)};
    // rho follows from the others by a ratio of two of J, and is rounded.
    const double of_rho = holds_volume(model_) ? 0.0 : 0x1p-52;
    out.error_bound = error_bound + of_rho;
    set_shares(squares, p, error_bound, out);
    if (out.beyond_end()) return out;
    if (may_leave_plane_) {
      const PlaneForces<double> at = plane_forces<double>(model_, x[0], x[1], out.q.rho);
      const double size = std::abs(at.trace) + std::abs(at.area);
      if (size > 0.0) out.turn = at.trace / size;
    }
    const DoubleDouble along[2] = {root(squares.in_plane, out.tilt_in_plane),
                                   root(squares.normal, out.tilt_normal)};
    out.angular_velocity = angular_velocity(plane_, double(along[0]), double(along[1]));
    ++evaluations_.second_derivatives;
    const auto v = potential_derivatives<2>(model_, out.q);
    const BalanceCheck check =
        check_balance(body_, v, out.q, out.angular_velocity, holds_volume(model_));
    out.residual = check.residual;
    out.compatibility = check.compatibility;
    if (potential_.holds_volume())
      out.pressure = pressure(body_, potential_, out.q, out.angular_velocity);
    out.energy = energy(body_, elastic_energy(model_, out.q), out.q, out.angular_velocity);
    if (spectrum_) {
      ++evaluations_.spectra;
      out.spectrum =
          general_spectrum(body_, potential_, q, angular_velocity(plane_, along[0], along[1]),
                           stretch_uncertainty(error_bound));
    }
    return out;
  }

 private:
  TiltSquares<DoubleDouble> squares_at(const BasicStretch<DoubleDouble>& q, double p) const {
    return squares_of(model_, body_, q, two_product(p, p));
  }
  template <class Own, class Inertias, class S>
  TiltSquares<S> squares_of(const Own& model, const Inertias& J, const BasicStretch<S>& q,
                            const S& square_nu) const {
    if constexpr (is_body_model<Model>) {
      return tilt_squares_of(model, J, plane_, q.xi, q.zeta, q.rho, square_nu);
    } else {
      const auto w = forces<1>(model, planar_invariants(q.xi, q.zeta), q.rho);
      const CentrifugalRates<S> at_rest{S(0.0), S(0.0), S(0.0)};
      return tilt_squares(J, plane_, coupled_log_balance<1>(w, q.xi, q.zeta, q.rho, at_rest), q.xi,
                          q.zeta, q.rho);
    }
  }

  /// Far along an escape a share falls with the stretches, and is known as well as they are: what is
  /// small is held against what the inputs do to it.
  void set_shares(const TiltSquares<DoubleDouble>& squares, double p, double error_bound,
                  Member& out) const {
    const auto in_plane = double(squares.in_plane);
    const auto normal = double(squares.normal);
    out.tilt_in_plane = tilt_share(in_plane, p, error_bound);
    out.tilt_normal = tilt_share(normal, p, error_bound);
    if (out.tilt_in_plane != 0.0 && out.tilt_normal != 0.0) return;
    const auto input = Conditioned::input;
    const TiltSquares<Conditioned> known =
        squares_of(conditioned_model(model_),
                   Inertia3<Conditioned>{input(body_.J1), input(body_.J2), input(body_.J3)},
                   BasicStretch<Conditioned>{Conditioned(0.0), input(out.q.xi), input(out.q.zeta),
                                             input(out.q.rho)},
                   Conditioned(p * p));
    out.tilt_in_plane = tilt_share(in_plane, p, error_bound, known.in_plane.condition / (p * p));
    out.tilt_normal = tilt_share(normal, p, error_bound, known.normal.condition / (p * p));
  }

  TiltedSystem<Model> system(double p) const {
    return {model_, body_, plane_, axis_rates(body_, Branch::iii, two_product(p, p))};
  }

  static DoubleDouble root(const DoubleDouble& square, double share) {
    return share > 0.0 ? sqrt(square) : DoubleDouble(0.0);
  }

  Body body_;
  Potential potential_;
  Model model_;
  TiltPlane plane_;
  bool spectrum_;
  bool may_leave_plane_;
};

template <class Model>
std::unique_ptr<Family<2>> family_of(const Body& body, const Potential& potential,
                                     const Model& model, TiltPlane plane, bool spectrum) {
  return std::make_unique<TiltedFamily<Model>>(body, potential, model, plane, spectrum);
}

}  // namespace

std::unique_ptr<Family<2>> tilted_family(const Body& body, const Potential& potential,
                                         TiltPlane plane, bool spectrum) {
  return potential.visit_parts(
      [&](const auto& model) { return family_of(body, potential, model, plane, spectrum); });
}

std::optional<TiltPlane> plane_of_tilt(Branch branch, const Body& body, const Stretch& q) {
  const Vector3<double> m = second_moments(body, q);
  const auto equal = [](double a, double b) { return std::abs(a - b) <= 1e-6 * (a + b); };
  if (branch != Branch::ii && equal(m[0], m[2])) return TiltPlane::one_three;
  if (branch != Branch::i && equal(m[1], m[2])) return TiltPlane::two_three;
  return std::nullopt;
}

double tilt_share(double square, double p, double error_bound, double condition) {
  constexpr double most = 1e-11;  // at a turn of p the bound is not that of the curve
  const double rounding = std::min(16.0 * error_bound, most) * std::min(condition, 1.0);
  const double out = square / (p * p);
  return std::abs(out) <= rounding ? 0.0 : out;
}

std::optional<Member> just_inside(const Family<2>& family, const Stretch& q, double nu,
                                  const Interval& within) {
  const Curve<2> curve(family, nu, Circle::none);
  const Corrected<2> at = start_of(curve, unknowns<2>(q), nu);
  if (at.status != CorrectorStatus::converged) return std::nullopt;
  for (const double step : {1e-3, -1e-3, 1e-5, -1e-5, 1e-7, -1e-7}) {
    const ArcVector<2> y = step * at.point.tangent;
    const Corrected<2> inside = curve.corrector().correct(
        moved<2>(at.point.x, ReducedVector<2>(y.head<2>())),
        at.point.p + curve.corrector().scale() * y[2], at.point.tangent, std::abs(step));
    if (inside.status != CorrectorStatus::converged) continue;
    const Member member = curve.complete(inside.point).member;
    if (!member.beyond_end() && within.may_be(member.nu)) return member;
  }
  return std::nullopt;
}

}  // namespace stationary
