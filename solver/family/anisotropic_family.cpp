#include "solver/family/anisotropic_family.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lib/body/inertia.hpp"
#include "lib/material/elastic_energy.hpp"
#include "lib/matrix/elementwise.hpp"
#include "lib/number/elementary.hpp"
#include "solver/family/oriented_events.hpp"
#include "solver/family/shear_free_family.hpp"
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
      : settings_(body, potential, options),
        branch_(branch),
        options_(options),
        even_(potential.even_in_alpha() && keeps_shear_free(potential, options.parameter)) {}

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
      const OrientedSetting at = settings_.at(p);
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
    const OrientedSystem<Layout> at{&settings_.models(), member.body, branch_, 1.0};
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
    return settings_.at(p).models->potential.conditions_at(
        oriented_stretch(y[0], y[1], y[2], y[3]).q);
  }

  FamilyLinearization<N> linearize(const ReducedVector<N>& x, double p) const override {
    const OrientedSetting at = settings_.at(p);
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
    const OrientedSetting at = settings_.at(p);
    Refined out = refine(system(at), x, most_corrections, &tail);
    out.error_bound *= bound_factor;
    this->evaluations_.extended_residuals += out.steps;
    this->evaluations_.jacobians += out.steps;
    this->evaluations_.sensitivities += out.converged;
    return out;
  }

  ReducedVector<N> extended_residual(const ReducedVector<N>& x, double p) const override {
    const OrientedSetting at = settings_.at(p);
    ++this->evaluations_.extended_residuals;
    ++this->evaluations_.jacobians;
    return system(at).extended_residual(x);
  }

  ReducedVector<N> input_perturbation(const ReducedVector<N>& x, double p) const override {
    const OrientedSetting at = settings_.at(p);
    ++this->evaluations_.sensitivities;
    ++this->evaluations_.jacobians;
    return 0x1p-53 * system(at).input_sensitivity(x);
  }

  std::optional<Member> rest_point(const ReducedVector<N>& near) const override {
    if constexpr (Layout::axis) {
      if (!along_nu()) return std::nullopt;
      const OrientedSystem<ShearedLayout> system{&settings_.models(), settings_.body(), branch_,
                                                 0.0};
      ReducedVector<4> still = near.template head<4>();
      if (!newton(system, still).converged) return std::nullopt;
      ReducedVector<4> still_tail;
      const Refined refined = refine(system, still, most_corrections, &still_tail);
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
    if (near.parameter == 0.0 ||
        !keeps_shear_free(settings_.models().potential, options_.parameter))
      return std::nullopt;
    const ReducedVector<N> x = coordinates_of(near);
    const auto straight = ShearFreeFamily(settings_, straight_branch(x))
                              .located(x.template head<3>(), near.parameter);
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
    return oriented_event_equations<Layout>(settings_.varied(), branch_, *function);
  }

  Member member(const ReducedVector<N>& x, const ReducedVector<N>& tail, double p,
                double error_bound) const override {
    const OrientedSetting at = settings_.at(p);
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

  std::optional<Member> mirror_point(const ReducedVector<N>& x, double p) const override {
    if constexpr (!Layout::alpha) {
      return std::nullopt;
    } else {
      const ShearFreeFamily straight(settings_, straight_branch(x));
      const auto turning = straight.turning_point(x.template head<3>(), p);
      if (!turning) return std::nullopt;
      ReducedVector<N> at = x;
      ReducedVector<N> tail = ReducedVector<N>::Zero();
      at.template head<3>() = turning->x;
      tail.template head<3>() = turning->tail;
      at[Layout::alpha_place] = 1.0;
      if constexpr (Layout::axis) {
        const double angle = straight.branch() == Branch::i ? 0.0 : 0.5 * std::numbers::pi;
        at[Layout::axis_place] = axis_coordinate(std::copysign(angle, log(x[Layout::axis_place])));
      }
      return member(at, tail, turning->parameter, turning->error_bound);
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

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  /// Of V at the member's q, as far as it is asked for.
  void add_elastic(const OrientedSetting& at, Member& out) const {
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

  OrientedSystem<Layout> system(const OrientedSetting& at) const {
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

  ReducedVector<N> parameter_slope(const OrientedSetting& at, const OrientedSystem<Layout>& system,
                                   const std::array<double, 5>& y,
                                   const ReducedVector<N>& scale) const {
    std::array<double, 5> out{};
    if (options_.parameter.kind == Kind::inertia) {
      const int k = options_.parameter.index;
      Inertia3<double> one{0.0, 0.0, 0.0};
      inertia_of(one, k) = 1.0;
      out = system.inertial(one, y, at.nu * at.nu);
    }
    const int place = settings_.coefficient_place();
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

  static void set_turn(const Turn& turn, Member& out) {
    out.turn = turn.value;
    out.turn_condition = turn.condition;
  }
  Turn extended_turn(const OrientedSetting& at, const BasicStretch<DoubleDouble>& q) const {
    const DoubleDouble V_aa = potential_derivatives<2>(at.models->extended, q).hessian(0, 0);
    const DoubleDouble stiffness = shear_stiffness(V_aa, true, branch_, DoubleDouble(at.body.J3),
                                                   two_product(at.nu, at.nu), q);
    return turn_of(at.body, branch_, double(stiffness),
                   {0.0, double(q.xi), double(q.zeta), double(q.rho)}, at.nu);
  }

  OrientedSettings settings_;
  Branch branch_;
  AxisFamilyOptions options_;
  bool even_;  ///< V in alpha, all along the family
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
