#include "solver/family/anisotropic_family.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lib/material/elastic_energy.hpp"
#include "lib/matrix/elementwise.hpp"
#include "lib/number/elementary.hpp"
#include "solver/family/oriented_events.hpp"
#include "solver/motion/oriented_stability.hpp"
#include "solver/newton/newton.hpp"
#include "solver/newton/refine.hpp"

namespace stationary {
namespace {

/// An angle of a line, in (-pi/2, pi/2].
double line_angle(double angle) {
  const double out = std::remainder(angle, std::numbers::pi);
  return out <= -0.5 * std::numbers::pi ? out + std::numbers::pi : out;
}

template <class Layout>
class AnisotropicFamily final : public Family<Layout::dimension> {
 public:
  static constexpr int N = Layout::dimension;
  using EventEquations = ExtendedEventEquations<event_dimension<N>>;

  AnisotropicFamily(const Body& body, const AnisotropicPotential& potential, Branch branch,
                    const AxisFamilyOptions& options)
      : body_(body),
        branch_(branch),
        options_(options),
        even_(potential.even_in_alpha() && keeps_shear_free(potential, options.parameter)),
        models_(std::make_shared<const OrientedModels>(potential)) {}

  Branch branch() const override { return Layout::axis ? Branch::i : branch_; }
  KindEvents events() const override { return oriented_events<Layout>(); }
  bool along_nu() const override { return options_.parameter.kind == Kind::nu; }
  bool material_symmetry() const override { return false; }
  std::optional<int> mirrored() const override {
    if (!Layout::alpha || !even_) return std::nullopt;
    return Layout::alpha_place;
  }

  std::optional<ReducedVector<N>> with_opposite_axis(const ReducedVector<N>& x) const override {
    if constexpr (Layout::axis) {
      constexpr double far = 0.966;  // of the sine of half the angle: beyond 150 degrees
      const double half_sine = hyperbolic(x[Layout::axis_place]).tanh;
      if (std::abs(half_sine) > far) {
        const double angle = 2.0 * asin(half_sine);
        ReducedVector<N> out = x;
        out[Layout::axis_place] = axis_coordinate(angle - std::copysign(std::numbers::pi, angle));
        return out;
      }
    }
    return std::nullopt;
  }

  ReducedVector<N> coordinates(const Stretch& q, double p) const override {
    ReducedVector<N> x = stretch_coordinates(q);
    if constexpr (Layout::axis) {
      const Setting at = setting(p);
      const auto I = in_plane_inertia(Inertia3<double>{at.body.J1, at.body.J2, at.body.J3}, q);
      const double principal = 0.5 * atan2(2.0 * I.product, -I.difference);
      const double near = branch_ == Branch::i ? 0.0 : 0.5 * std::numbers::pi;
      // The balance tells the two axes of inertia apart, but for a slow spin.
      double best = std::numeric_limits<double>::infinity();
      ReducedVector<N> out = x;
      for (const double turned : {0.0, 0.5 * std::numbers::pi}) {
        // Within the half turn that is searched, in whose middle both axes are.
        double angle = line_angle(principal + turned);
        if (angle <= -0.25 * std::numbers::pi) angle += std::numbers::pi;
        x[Layout::axis_place] = axis_coordinate(angle);
        const double residual = largest_magnitude<N>(system(at).linearize(x).g);
        const double apart = std::abs(line_angle(angle - near));
        if (const double rank = std::max(residual, 1e-9) + 1e-12 * apart; rank < best) {
          best = rank;
          out = x;
        }
      }
      return out;
    }
    return x;
  }

  ReducedVector<N> coordinates_of(const Member& member) const override {
    ReducedVector<N> x = stretch_coordinates(member.q);
    if constexpr (Layout::axis)
      x[Layout::axis_place] =
          axis_coordinate(atan2(member.angular_velocity[1], member.angular_velocity[0]));
    return x;
  }

  SpinInertia<N> spin_inertia(const Member& member) const override {
    const Inertia3<double> J{member.body.J1, member.body.J2, member.body.J3};
    const ReducedVector<N> x = coordinates_of(member);
    const auto y = all_coordinates<Layout>(x, 1.0);
    const OrientedSystem<Layout> at{models_.get(), member.body, branch_, 1.0};
    const auto pull = at.inertial(J, y, 1.0);  // -dI/2 of I = q^T C q at |nu| = 1
    SpinInertia<N> out{0.0, ReducedVector<N>::Zero()};
    const Stretch q = at.stretch(y).q;
    out.own = q.vector().dot(centrifugal_matrix(J, at.spin(y, 1.0)) * q.vector());
    for (int i = 0; i < N; ++i)
      if (at.place(i) != oriented::phi) out.half_slope[i] = -pull[at.place(i)];
    return out;
  }

  std::vector<ConditionValue> conditions(const ReducedVector<N>& x, double p) const override {
    const auto y = all_coordinates<Layout>(x, 1.0);
    return setting(p).models->potential.conditions_at(oriented_stretch(y[0], y[1], y[2], y[3]).q);
  }

  FamilyLinearization<N> linearize(const ReducedVector<N>& x, double p) const override {
    const Setting at = setting(p);
    ++this->evaluations_.jacobians;
    const OrientedSystem<Layout> system = this->system(at);
    const auto all = system.linearize(x);
    FamilyLinearization<N> out;
    out.g = all.g;
    out.jacobian = all.jacobian.matrix();
    const auto y = system.coordinates(x);
    const Inertia3<double> J{at.body.J1, at.body.J2, at.body.J3};
    out.nu_slope = rows(system.inertial(J, y, 2.0 * at.nu), all.scale);
    if constexpr (Layout::axis) out.nu_slope[Layout::axis_place] = 0.0;
    out.slope = along_nu() ? out.nu_slope : parameter_slope(at, system, y, all.scale);
    return out;
  }

  Refined refine_at(ReducedVector<N>& x, ReducedVector<N>& tail, double p) const override {
    constexpr int max_corrections = 8;
    const Setting at = setting(p);
    Refined out = refine(system(at), x, max_corrections, &tail);
    out.error_bound *= bound_factor;
    this->evaluations_.extended_residuals += out.steps;
    this->evaluations_.jacobians += out.steps;
    this->evaluations_.sensitivities += out.converged;
    return out;
  }

  ReducedVector<N> extended_residual(const ReducedVector<N>& x, double p) const override {
    const Setting at = setting(p);
    ++this->evaluations_.extended_residuals;
    ++this->evaluations_.jacobians;
    return system(at).extended_residual(x);
  }

  ReducedVector<N> input_perturbation(const ReducedVector<N>& x, double p) const override {
    const Setting at = setting(p);
    ++this->evaluations_.sensitivities;
    ++this->evaluations_.jacobians;
    return 0x1p-53 * system(at).input_sensitivity(x);
  }

  std::optional<Member> rest_point(const ReducedVector<N>& near) const override {
    if constexpr (Layout::axis) {
      if (!along_nu()) return std::nullopt;
      const OrientedSystem<ShearedLayout> system{models_.get(), body_, branch_, 0.0};
      ReducedVector<4> still = near.template head<4>();
      if (!newton(system, still).converged) return std::nullopt;
      ReducedVector<4> still_tail;
      const Refined refined = refine(system, still, 8, &still_tail);
      if (!refined.converged) return std::nullopt;
      ReducedVector<N> x = near;
      ReducedVector<N> tail = ReducedVector<N>::Zero();
      x.template head<4>() = still;
      tail.template head<4>() = still_tail;
      return member(x, tail, 0.0, bound_factor * refined.error_bound);
    } else {
      return std::nullopt;
    }
  }

  std::optional<ExtendedEvent<N>> event_at(EventType type, Circle circle,
                                           const Member& near) const override {
    if (!meets_mirror(type)) return Family<N>::event_at(type, circle, near);
    // Of the family with alpha = 0, if there is one.
    if (near.parameter == 0.0 || !keeps_shear_free(models_->potential, options_.parameter))
      return std::nullopt;
    const ReducedVector<N> x = coordinates_of(near);
    const auto straight = straight_turn(straight_branch(x), x, near.parameter);
    if (!straight) return std::nullopt;
    ExtendedEvent<N> out{{}, straight->parameter, straight->error_bound, straight->parameter_bound};
    for (int i = 0; i < N; ++i) out.x[index(i)] = i < 3 ? straight->x[index(i)] : x[i];
    return out;
  }
  /// None where alpha comes to 0: those are the events of the family that this branches off.
  std::unique_ptr<EventEquations> event_equations(EventType type, Circle,
                                                  const Member& near) const override {
    if (meets_mirror(type)) return nullptr;
    const auto function = vanishing_function<Layout>(type, branch(), along_nu(), near);
    if (!function) return nullptr;
    return equations_of<Layout>(branch_, *function);
  }

  Member member(const ReducedVector<N>& x, const ReducedVector<N>& tail, double p,
                double error_bound) const override {
    const Setting at = setting(p);
    std::array<DoubleDouble, static_cast<std::size_t>(N)> wide;
    if (tail.allFinite()) {
      for (int i = 0; i < N; ++i) wide[index(i)] = DoubleDouble(x[i], tail[i]);
    } else {
      wide = extended_solution(system(at), x);
    }
    const auto y = all_coordinates<Layout>(wide, DoubleDouble(1.0));
    const BasicStretch<DoubleDouble> q = oriented_stretch(y[0], y[1], y[2], y[3]).q;
    Vector3<DoubleDouble> nu = angular_velocity(branch_, DoubleDouble(at.nu));
    // Below the rounding of extended precision a component of nu, or alpha, is zero.
    constexpr double none = 0x1p-80;
    if constexpr (Layout::axis) {
      const AxisAngle<DoubleDouble> axis = axis_angle(y[4]);
      const auto along = [&](const DoubleDouble& part) {
        return std::abs(double(part)) > none ? DoubleDouble(at.nu * part) : DoubleDouble(0.0);
      };
      nu = {along(axis.cosine), along(axis.sine), DoubleDouble(0.0)};
    }
    Member out;
    out.parameter = p;
    out.body = at.body;
    out.nu = at.nu;
    const double alpha = double(q.alpha);
    const bool sheared = std::abs(alpha) > none * std::sqrt(x[0] * x[1]);
    out.q = {sheared ? alpha : 0.0, x[0], x[1], x[2]};
    out.angular_velocity = {double(nu[0]), double(nu[1]), double(nu[2])};
    out.error_bound = error_bound;
    if (options_.errors || options_.energy || !Layout::alpha) add_elastic(at, out);
    if (at.models->potential.body().volume) {
      out.pressure = at.models->potential.pressure(
          out.q, centrifugal_matrix(at.body, out.angular_velocity)(3, 3));
      // Along a held volume V_alpha,alpha has terms in 1/d, which cancel where S is thin.
      if constexpr (!Layout::alpha) set_turn(extended_turn(at, q), out);
    }
    if (options_.spectrum) {
      ++this->evaluations_.spectra;
      out.spectrum =
          oriented_stability({at.body, branch_, !Layout::axis}, *at.models, q, nu, error_bound);
    }
    return out;
  }

  /// By the turn's sign along the family with alpha = 0.
  std::optional<Member> mirror_point(const ReducedVector<N>& x, double p) const override {
    if constexpr (!Layout::alpha) {
      return std::nullopt;
    } else {
      const Branch straight = straight_branch(x);
      ReducedVector<3> guess(x[0], x[1], x[2]);
      const auto point = [&](double at) -> std::optional<StraightPoint> {
        return straight_point(straight, guess, at);
      };
      const auto turn = [&](double at) {
        const auto found = point(at);
        return found ? found->turn : std::numeric_limits<double>::quiet_NaN();
      };
      for (double reach = 1e-6 * (1.0 + std::abs(p)); reach < 0.1 * (1.0 + std::abs(p));
           reach *= 4.0) {
        const double a = turn(p - reach);
        const double b = turn(p + reach);
        if (std::isnan(a) || std::isnan(b)) return std::nullopt;
        if ((a < 0.0) == (b < 0.0)) continue;
        std::uintmax_t evaluations = 80;
        const auto [low, high] = boost::math::tools::toms748_solve(
            turn, p - reach, p + reach, a, b, boost::math::tools::eps_tolerance<double>(52),
            evaluations);
        const auto found = point(0.5 * (low + high));
        const auto ahead = point(p + reach);
        const auto behind = point(p - reach);
        if (!found || !ahead || !behind) return std::nullopt;
        ReducedVector<N> at = x;
        at.template head<3>() = found->x;
        at[Layout::alpha_place] = 1.0;
        if constexpr (Layout::axis) {
          const double angle = straight == Branch::i ? 0.0 : 0.5 * std::numbers::pi;
          at[Layout::axis_place] =
              axis_coordinate(std::copysign(angle, log(x[Layout::axis_place])));
        }
        if (const auto known = straight_turn(straight, found->x, 0.5 * (low + high))) {
          ReducedVector<N> tail = ReducedVector<N>::Zero();
          for (int i = 0; i < 3; ++i) {
            at[i] = double(known->x[index(i)]);
            tail[i] = double(known->x[index(i)] - at[i]);
          }
          return member(at, tail, double(known->parameter), known->error_bound + 0x1p-53);
        }
        // What the turn's own rounding leaves open of p, along the family.
        constexpr double noise = 64.0 * 0x1p-53;
        const double moved_by = logarithms(ahead->x.array() / behind->x.array()).abs().maxCoeff();
        const double along = noise * moved_by / std::abs(b - a);
        return member(at, ReducedVector<N>::Zero(), 0.5 * (low + high),
                      2.0 * found->error_bound + along);
      }
      return std::nullopt;
    }
  }

 private:
  /// All unknowns but the axis.
  static ReducedVector<N> stretch_coordinates(const Stretch& q) {
    ReducedVector<N> x = ones<N>();
    x[0] = q.xi;
    x[1] = q.zeta;
    x[Layout::thickness_place] = q.rho;
    if constexpr (Layout::alpha) x[Layout::alpha_place] = shear_coordinate(q);
    return x;
  }
  using Kind = FamilyParameter::Kind;
  static constexpr double bound_factor = Layout::bound_factor;

  struct Setting {
    Body body;
    std::shared_ptr<const OrientedModels> models;
    double nu;
  };
  struct StraightPoint {
    ReducedVector<3> x;
    double turn;
    double error_bound;
  };

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  /// Of V at the member's q, as far as it is asked for.
  void add_elastic(const Setting& at, Member& out) const {
    ++this->evaluations_.second_derivatives;
    const auto V = potential_derivatives<2>(at.models->plain, out.q);
    if (options_.errors) {
      const BalanceCheck check = check_balance(at.body, V, out.q, out.angular_velocity,
                                               at.models->plain.body.volume.has_value());
      out.residual = check.residual;
      out.compatibility = check.compatibility;
    }
    if (options_.energy) {
      out.energy =
          energy(at.body, elastic_energy(at.models->extended, out.q), out.q, out.angular_velocity);
    }
    if constexpr (!Layout::alpha) set_turn(turn_at(at, branch_, V.hessian(0, 0), out.q), out);
  }

  static bool meets_mirror(EventType type) {
    return Layout::alpha && (type == EventType::shear || type == EventType::oblique);
  }

  /// In a layout: this family's own, or that of the one with alpha = 0 that it branches off.
  template <class Its>
  std::unique_ptr<ExtendedEventEquations<event_dimension<Its::dimension>>> equations_of(
      Branch branch, std::size_t function) const {
    using System = OrientedEventSystem<Its>;
    std::array<std::size_t, Its::dimension + 1> places;
    for (std::size_t k = 0; k < Its::dimension; ++k) places[k] = event_place(k);
    places.back() = EventEquations::parameter;
    return std::make_unique<SystemEventEquations<event_dimension<Its::dimension>, System>>(
        System(VariedSpin(models_->potential, body_, options_.nu, options_.parameter,
                          coefficient_place()),
               branch, function),
        places, false, StretchErrorRule{.factor = bound_factor});
  }
  /// Where the family with alpha = 0 turns away from the material axes.
  std::optional<ExtendedEvent<3>> straight_turn(Branch branch, const auto& x, double p) const {
    const auto equations = equations_of<StraightLayout>(branch, TestValues::turn);
    const auto root = equations->root({DoubleDouble(x[0]), DoubleDouble(x[1]), DoubleDouble(x[2]),
                                       DoubleDouble(p), DoubleDouble(1.0)});
    if (!root) return std::nullopt;
    return ExtendedEvent<3>{{root->y[0], root->y[1], root->y[2]},
                            root->y[EventEquations::parameter],
                            equations->stretch_error(root->error),
                            root->error[EventEquations::parameter]};
  }

  Setting setting(double p) const {
    Setting out{body_, models_, options_.nu};
    const int k = options_.parameter.index;
    switch (options_.parameter.kind) {
      case Kind::nu:
        out.nu = p;
        break;
      case Kind::inertia:
        (k == 0 ? out.body.J1 : k == 1 ? out.body.J2 : out.body.J3) = p;
        break;
      default:
        break;
    }
    if (const int place = coefficient_place(); place >= 0) {
      if (!varied_ || varied_at_ != p)
        varied_ =
            std::make_shared<const OrientedModels>(models_->potential.with_coefficient(place, p));
      varied_at_ = p;
      out.models = varied_;
    }
    return out;
  }
  /// Of the parameter, as far as it is one of the potential: of J that of gravity.
  int coefficient_place() const {
    return stationary::coefficient_place(models_->potential, options_.parameter);
  }

  OrientedSystem<Layout> system(const Setting& at) const {
    return {at.models.get(), at.body, branch_, at.nu};
  }

  template <class Parts>
  static ReducedVector<N> rows(const Parts& parts, const ReducedVector<N>& scale) {
    ReducedVector<N> out;
    for (int i = 0; i < N; ++i) {
      const std::size_t row = Layout::places[index(i)];
      out[i] = row < parts.size() ? parts[row] * scale[i] : 0.0;
    }
    return out;
  }

  ReducedVector<N> parameter_slope(const Setting& at, const OrientedSystem<Layout>& system,
                                   const std::array<double, 5>& y,
                                   const ReducedVector<N>& scale) const {
    std::array<double, 5> out{};
    if (options_.parameter.kind == Kind::inertia) {
      const int k = options_.parameter.index;
      Inertia3<double> one{0.0, 0.0, 0.0};
      (k == 0 ? one.J1 : k == 1 ? one.J2 : one.J3) = 1.0;
      out = system.inertial(one, y, at.nu * at.nu);
    }
    const int place = coefficient_place();
    if (place < 0) return rows(out, scale);
    const Inertia3<double> J{at.body.J1, at.body.J2, at.body.J3};
    const auto slopes =
        coefficient_slopes(at.models->potential.model(CoefficientDuals{place, false}), J,
                           system.stretch(y), system.spin(y, at.nu * at.nu));
    for (std::size_t i = 0; i < 4; ++i) out[i] += slopes[i].slope[0];
    return rows(out, scale);
  }

  Branch straight_branch(const ReducedVector<N>& x) const {
    if constexpr (Layout::axis) {
      return std::abs(axis_angle(x[Layout::axis_place]).cosine) > std::numbers::sqrt2 / 2.0
                 ? Branch::i
                 : Branch::ii;
    } else {
      return branch_;
    }
  }

  std::optional<StraightPoint> straight_point(Branch branch, ReducedVector<3>& guess,
                                              double p) const {
    const Setting at = setting(p);
    const OrientedSystem<StraightLayout> system{at.models.get(), at.body, branch, at.nu};
    ReducedVector<3> x = guess;
    if (!newton(system, x).converged) return std::nullopt;
    const Refined refined = refine(system, x);
    if (!refined.converged) return std::nullopt;
    const Stretch q{0.0, x[0], x[1], x[2]};
    const double V_aa = potential_derivatives<2>(at.models->plain, q).hessian(0, 0);
    return StraightPoint{x, turn_at(at, branch, V_aa, q).value, refined.error_bound};
  }
  static void set_turn(const Turn& turn, Member& out) {
    out.turn = turn.value;
    out.turn_condition = turn.condition;
  }
  static Turn turn_at(const Setting& at, Branch branch, double V_aa, const Stretch& q) {
    const double stiffness = shear_stiffness(V_aa, at.models->plain.body.volume.has_value(), branch,
                                             at.body.J3, at.nu * at.nu, q);
    return turn_of(at.body, branch, stiffness, q, at.nu);
  }

  Turn extended_turn(const Setting& at, const BasicStretch<DoubleDouble>& q) const {
    const DoubleDouble V_aa = potential_derivatives<2>(at.models->extended, q).hessian(0, 0);
    const DoubleDouble stiffness = shear_stiffness(V_aa, true, branch_, DoubleDouble(at.body.J3),
                                                   two_product(at.nu, at.nu), q);
    return turn_of(at.body, branch_, double(stiffness),
                   {0.0, double(q.xi), double(q.zeta), double(q.rho)}, at.nu);
  }

  Body body_;
  Branch branch_;
  AxisFamilyOptions options_;
  bool even_;  ///< V in alpha, all along the family
  std::shared_ptr<const OrientedModels> models_;
  /// Where a coefficient is followed, those of its last value.
  mutable std::shared_ptr<const OrientedModels> varied_;
  mutable double varied_at_ = 0.0;
};

}  // namespace

bool keeps_shear_free(const AnisotropicPotential& potential, const FamilyParameter& parameter) {
  return potential.keeps_shear_free(coefficient_place(potential, parameter));
}

AnyFamily anisotropic_family(const Body& body, const AnisotropicPotential& potential, Branch branch,
                             bool alpha_free, const AxisFamilyOptions& options) {
  const bool shear_free = keeps_shear_free(potential, options.parameter);
  const bool even = shear_free && potential.even_in_alpha();
  if (branch == Branch::iii && (alpha_free || !even))
    return std::make_unique<AnisotropicFamily<ShearedLayout>>(body, potential, branch, options);
  if (!shear_free)
    throw std::invalid_argument("V_alpha = 0 at alpha = 0, for a family about axis 1 or 2");
  return std::make_unique<AnisotropicFamily<StraightLayout>>(body, potential, branch, options);
}

std::unique_ptr<Family<5>> oblique_family(const Body& body, const AnisotropicPotential& potential,
                                          const AxisFamilyOptions& options, Branch near) {
  return std::make_unique<AnisotropicFamily<ObliqueLayout>>(body, potential, near, options);
}

}  // namespace stationary
