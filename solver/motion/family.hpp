// A one-parameter family of reduced balances,
//
//   G(x; p) = 0,   x in R^N the stretches left as unknowns (ln x the coordinates), p the parameter,
//
// as continuation sees it: N equations, N + 1 unknowns (ln x, p), and what a point of the curve is
// mechanically (its member). Continuation knows no potential; a family no step.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "lib/balance/balance.hpp"
#include "lib/balance/two_polar.hpp"
#include "lib/body/body.hpp"
#include "lib/body/circle.hpp"
#include "lib/body/stretch.hpp"
#include "lib/material/models/tape_model.hpp"
#include "lib/stability/spectrum.hpp"
#include "solver/motion/equilibrium.hpp"
#include "solver/motion/event_equations.hpp"
#include "solver/newton/refine.hpp"

namespace stationary {

/// The derivatives of G, each row divided by the magnitude of the terms in it.
template <int N>
struct FamilySlopes {
  Eigen::Matrix<double, N, N> jacobian;  ///< dG/d ln x
  ReducedVector<N> slope;                ///< dG/dp
  ReducedVector<N> nu_slope;             ///< dG/dnu; of slope's value where p is nu
};
/// G and its derivatives, rows divided likewise.
template <int N>
struct FamilyLinearization : FamilySlopes<N> {
  ReducedVector<N> g;
};

/// A stationary motion of the family, with everything a table row or an event asks of it.
struct Member {
  double parameter = std::numeric_limits<double>::quiet_NaN();
  Body body{1.0, 1.0, 1.0};
  double nu = std::numeric_limits<double>::quiet_NaN();  ///< along the branch's axis; tilted: |nu|
  /// The vector: nu along the branch's axis, or in the plane of a tilted family (NaN where a square
  /// below is negative).
  Vector3<double> angular_velocity =
      Vector3<double>::Constant(std::numeric_limits<double>::quiet_NaN());
  Stretch q{0.0, 1.0, 1.0, 1.0};
  /// Relative, of xi, zeta, rho at the row's numbers; of an event's row, at the event.
  double error_bound = std::numeric_limits<double>::quiet_NaN();
  double residual = std::numeric_limits<double>::quiet_NaN();
  double compatibility = std::numeric_limits<double>::quiet_NaN();
  double energy = std::numeric_limits<double>::quiet_NaN();
  double pressure = std::numeric_limits<double>::quiet_NaN();         ///< of a held volume
  double shear_stiffness = std::numeric_limits<double>::quiet_NaN();  ///< (iii): K_alpha,alpha
  /// (i), (ii), on a circle: what vanishes where it breaks, of order one.
  double round_stiffness = std::numeric_limits<double>::quiet_NaN();
  /// Anisotropic V, alpha = 0 held: what vanishes where the ellipse or the axis turns away from the
  /// material axes, of order one: K_alpha,alpha in (iii), K_alpha,alpha (I1 - I2) - h^2 omega^2 in
  /// (i), (ii). Of an isotropic V with gravity and J1 != J2 likewise (turning_forces()); tilted, W_t, where
  /// motions leave the plane of the axis.
  double turn = std::numeric_limits<double>::quiet_NaN();
  /// |change of turn| for a relative one of what it is made of, as far as its sign is concerned.
  double turn_condition = 4.0;
  /// Tilted: the shares of nu^2 along the plane's own axis and along axis 3. Negative beyond an end
  /// of the family, where nothing else but q is computed.
  double tilt_in_plane = std::numeric_limits<double>::quiet_NaN();
  double tilt_normal = std::numeric_limits<double>::quiet_NaN();
  std::optional<Spectrum> spectrum;
  std::optional<TwoPolarState> two_polar;

  bool beyond_end() const { return tilt_in_plane < 0.0 || tilt_normal < 0.0; }
};

/// x of a stretch with alpha = 0.
template <int N>
ReducedVector<N> unknowns(const Stretch& q) {
  ReducedVector<N> out;
  out[0] = q.xi;
  out[1] = q.zeta;
  if constexpr (N == 3) out[2] = q.rho;
  return out;
}
/// q with these unknowns instead of its own.
template <int N>
Stretch with_unknowns(Stretch q, const ReducedVector<N>& x) {
  q.xi = x[0];
  q.zeta = x[1];
  if constexpr (N == 3) q.rho = x[2];
  return q;
}

/// An event by its own equations, in extended precision (extended_root.hpp).
template <int N>
struct ExtendedEvent {
  std::array<DoubleDouble, static_cast<std::size_t>(N)> x;
  DoubleDouble parameter;
  double error_bound;      ///< relative, of the stretches
  double parameter_bound;  ///< relative
};
/// A located event as its equations have it; x: the family's unknowns there.
template <int N>
ExtendedVector<event_dimension<N>> event_unknowns(const Member& near, const ReducedVector<N>& x) {
  ExtendedVector<event_dimension<N>> y;
  y.fill(DoubleDouble(1.0));
  y[2] = DoubleDouble(near.q.rho);
  for (int k = 0; k < N; ++k) y[event_place(static_cast<std::size_t>(k))] = DoubleDouble(x[k]);
  y[ExtendedEventEquations<event_dimension<N>>::parameter] = DoubleDouble(near.parameter);
  return y;
}
enum class EventType : std::uint8_t;
struct TestContext;
struct TestValues;

/// What a kind of motion says of its events, beside the functions that all kinds share.
struct KindEvents {
  /// Sets the functions of the inertias, of ellipse and turn, and others that mean something else.
  void (*set)(const Member& member, const TestContext& context, TestValues& out);
  /// Whether Lambdas of a block may leave the real axis; those of others are a symmetric problem's.
  bool (*may_collide)(Block block, const TestContext& context);
  EventType turn;    ///< what a zero of the function `turn` is
  EventType mirror;  ///< where the family meets its own mirror image
  std::string_view mirror_reason;
  /// The event that ends the family, beyond which its members are none (Member::beyond_end()).
  EventType end;
  std::string_view (*end_reason)(const Member& at);
  /// The modes of a circle of the family are those of (iii), on another leaf than its ellipses'.
  bool circle_on_own_leaf;
};
/// Of a spin about a material axis, alpha = 0.
KindEvents axis_events();

/// The locked inertia about the spin's axis and half its derivatives in ln x.
template <int N>
struct SpinInertia {
  double own;
  ReducedVector<N> half_slope;
};

/// How often each thing was evaluated, of each uncoupled system of the balance by itself.
struct EvaluationCounts {
  long jacobians = 0;  ///< of G with dG/d ln x: first and second derivatives of V, in double
  long extended_residuals = 0;  ///< of G, in extended precision
  long sensitivities = 0;       ///< of G to its inputs, for an error bound
  long potentials = 0;          ///< of V beside those
  long second_derivatives = 0;  ///< likewise, with second derivatives
  long spectra = 0;

  EvaluationCounts& operator+=(const EvaluationCounts& other) {
    jacobians += other.jacobians;
    extended_residuals += other.extended_residuals;
    sensitivities += other.sensitivities;
    potentials += other.potentials;
    second_derivatives += other.second_derivatives;
    spectra += other.spectra;
    return *this;
  }
};

/// Members may be asked for by one thread at a time: evaluations are counted.
template <int N>
class Family {
 public:
  static constexpr int dimension = N;

  static constexpr double slopes_agree = 0x1p-40;

  /// Since it was made.
  const EvaluationCounts& evaluations() const { return evaluations_; }

  Family() = default;
  Family(const Family&) = delete;
  Family& operator=(const Family&) = delete;
  virtual ~Family() = default;

  /// The axis whose locked inertia is the spin's; tilted: (iii), of the two that are equal;
  /// two-polar: (iii).
  virtual Branch branch() const = 0;
  /// What there is to say of its events (event.hpp).
  virtual KindEvents events() const { return axis_events(); }
  /// Whether the third row of G is that of a held volume, and no mirror image of another.
  virtual bool volume_row() const { return false; }
  /// The unknown (its place in x) that a reflection of an even V inverts: x and its image are one
  /// motion and its mirror image, and where it is 1 a family with alpha = 0 is met.
  virtual std::optional<int> mirrored() const { return std::nullopt; }
  /// Where the axis has turned far from the middle of its angle's range, the same motion with the
  /// opposite axis: a half turn of the body about axis 3 makes the two one. Nothing elsewhere.
  virtual std::optional<ReducedVector<N>> with_opposite_axis(const ReducedVector<N>&) const {
    return std::nullopt;
  }
  /// The point of the family with alpha = 0, near x and p, that a family with alpha != 0 branches
  /// off; nothing where it is not found.
  virtual std::optional<Member> mirror_point(const ReducedVector<N>&, double) const {
    return std::nullopt;
  }
  /// The circle near x that a sheet of ellipses at given momenta comes to, where these are equal:
  /// nothing where the family has no such end.
  virtual std::optional<Member> circle_point(const ReducedVector<N>&) const { return std::nullopt; }
  /// The motion at p = 0 near x, of a family whose balance is singular there: no spin has an axis.
  virtual std::optional<Member> rest_point(const ReducedVector<N>&) const { return std::nullopt; }
  /// x of a stretch that is a motion of the family at p.
  virtual ReducedVector<N> coordinates(const Stretch& q, double) const {
    if constexpr (N <= 3) {
      return unknowns<N>(q);
    } else {
      throw std::logic_error("a family of this dimension has coordinates of its own");
    }
  }
  /// x of a member, its axis (oblique) as the member has it.
  virtual ReducedVector<N> coordinates_of(const Member& member) const {
    return coordinates(member.q, member.parameter);
  }
  virtual SpinInertia<N> spin_inertia(const Member& member) const {
    const CentrifugalRates<double> I = axis_rates(member.body, branch(), 1.0);
    const Stretch& q = member.q;
    SpinInertia<N> out{0.0, ReducedVector<N>::Zero()};
    const double parts[3] = {I.xi * q.xi * q.xi, I.zeta * q.zeta * q.zeta, I.rho * q.rho * q.rho};
    for (int k = 0; k < 3; ++k) {
      out.own += parts[k];
      if (k < N) out.half_slope[k] = parts[k];
    }
    return out;
  }
  /// Whether p is nu itself (else nu is held).
  virtual bool along_nu() const = 0;
  /// J1 = J2 and isotropic V at every p of the family: circles and mirror images.
  virtual bool material_symmetry() const = 0;

  /// The circle that its figures may be.
  virtual Circle circle() const {
    return branch() == Branch::iii && material_symmetry() ? Circle::xi_zeta : Circle::none;
  }

  /// The conditions under which the potential is defined, and their values; none of built-in
  /// models.
  virtual std::vector<ConditionValue> conditions(const ReducedVector<N>&, double) const {
    return {};
  }

  /// In double. Values outside the domain (J <= 0, ...) give NaN, never an exception.
  virtual FamilyLinearization<N> linearize(const ReducedVector<N>& x, double p) const = 0;
  /// Corrects x at fixed p with extended-precision residuals; tail: of x (refine.hpp).
  virtual Refined refine_at(ReducedVector<N>& x, ReducedVector<N>& tail, double p) const = 0;
  /// The same; slopes: of linearize() at x as it is then, where those before the last correction are
  /// the same to `slopes_agree` (Refined::last_change). Else nothing.
  virtual Refined refine_with_slopes(ReducedVector<N>& x, ReducedVector<N>& tail, double p,
                                     std::optional<FamilySlopes<N>>& slopes) const {
    slopes.reset();
    return refine_at(x, tail, p);
  }
  /// G in extended precision, rows divided as in linearize().
  virtual ReducedVector<N> extended_residual(const ReducedVector<N>& x, double p) const = 0;
  /// |change of G| by half a unit in the last place of every input, rows divided likewise.
  virtual ReducedVector<N> input_perturbation(const ReducedVector<N>& x, double p) const = 0;
  /// Of events of this type near a located member; null where there are none. The family outlives
  /// them.
  virtual std::unique_ptr<ExtendedEventEquations<event_dimension<N>>> event_equations(
      EventType, Circle, const Member&) const {
    return nullptr;
  }
  /// The event near a located member of this type by its own equations. Nothing where there are
  /// none or they are singular.
  virtual std::optional<ExtendedEvent<N>> event_at(EventType type, Circle circle,
                                                   const Member& near) const {
    if (near.parameter == 0.0) return std::nullopt;
    const auto equations = event_equations(type, circle, near);
    if (!equations) return std::nullopt;
    const auto root = equations->root(event_unknowns(near, coordinates_of(near)));
    if (!root) return std::nullopt;
    constexpr std::size_t p = ExtendedEventEquations<event_dimension<N>>::parameter;
    ExtendedEvent<N> out{{}, root->y[p], equations->stretch_error(root->error), root->error[p]};
    for (std::size_t k = 0; k < out.x.size(); ++k) out.x[k] = root->y[event_place(k)];
    return out;
  }
  /// tail: from refine_at; NaN makes the spectrum correct x once more.
  virtual Member member(const ReducedVector<N>& x, const ReducedVector<N>& tail, double p,
                        double error_bound) const = 0;

 protected:
  mutable EvaluationCounts evaluations_;
};

}  // namespace stationary
