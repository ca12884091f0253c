// The equations of an event (event_enclosure.hpp) in all its unknowns,
//
//   y = (xi, zeta, rho, p[, Lambda]),  on the circle xi = zeta once; on the others the equation
//                                      of one of the equal two is that they are equal,
//
// in any number type: extended precision for the event itself, numbers with their conditioning for
// the size of its terms, dual numbers over intervals for a proof. The stiffnesses the polynomials
// need come from the reduced balance, F = V - (c_xi xi^2 + ...)/2:  F_xx = (F_uu - F_u)/xi^2 ...,
// W_d = (V_xi - V_zeta)/(zeta - xi), V_xz - V_xx on the circle.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "lib/balance/sheared_balance.hpp"
#include "lib/body/circle.hpp"
#include "lib/body/inertia.hpp"
#include "lib/number/dual.hpp"
#include "solver/motion/event_functions.hpp"
#include "solver/motion/family_parameter.hpp"
#include "solver/motion/problem.hpp"
#include "solver/motion/varied_balance.hpp"
#include "solver/proof/box_balance.hpp"

namespace stationary {

/// What vanishes at the event beside the balance.
struct EventFunction {
  enum class Kind {
    fold,      ///< det dG/d ln x
    momentum,  ///< det of that bordered by dG/d ln nu and d ln (I_a nu)
    inertia,   ///< J_a x_a^2 - J_b x_b^2
    ellipse,   ///< the circle's dG along the difference of its two stretches
    turn,      ///< of isotropic V, what K_aa (I1 - I2) = h^2 omega^2 and K_aa = 0 come to: J1 - J2,
               ///< with gravity times the difference of turning_forces() over that of xi and zeta
    collision,  ///< P and P' of `first`
    crossing    ///< P of `first` and of `second`
  };
  Kind kind = Kind::fold;
  int a = 0;  ///< of `inertia`: 0, 1, 2 are xi, zeta, rho
  int b = 0;
  Block first = Block::even;
  Block second = Block::odd;

  bool spectral() const { return kind == Kind::collision || kind == Kind::crossing; }
  MeetingModes meeting() const { return {kind == Kind::collision, first, second}; }
};

/// A family, at whose numbers the equations are taken.
struct EventSetting {
  /// Another value of one of the numbers than the problem's own.
  struct Held {
    FamilyParameter number;
    double value;
  };

  Body body;
  Potential potential;
  Branch branch;
  double nu;
  FamilyParameter parameter;
  Circle circle;
  Inputs inputs;
  std::optional<Held> held{};

  /// The number of J: the two of a circle are equal, whatever decimals they are.
  int inertia_index(int index) const {
    return circle != Circle::none && index == places(circle).second ? places(circle).first : index;
  }
};

/// circle: 2 stretches instead of 3; spectral: Lambda among the unknowns. Input: what a number of
/// the problem (its value, kind and place) is in T.
template <bool circle, bool spectral, class T>
class EventEquations {
 public:
  static constexpr int stretches = circle ? 2 : 3;
  static constexpr int dimension = stretches + 1 + (spectral ? 1 : 0);
  using Unknowns = std::array<T, dimension>;

  EventEquations(const EventSetting& setting, const EventFunction& function)
      : setting_(&setting), function_(function), body_(setting.potential.body_model()) {}

  template <class Input>
  Unknowns values(const Unknowns& y, const Input& input) const {
    const State s = state(y, input);
    Unknowns out;
    std::size_t k = 0;
    out[k++] = s.balance.g_xi;
    if constexpr (!circle) out[k++] = s.balance.g_zeta;
    out[k++] = s.balance.g_rho;
    if constexpr (!circle) {
      if (setting_->circle == Circle::zeta_rho) out[1] = s.zeta - s.rho;
      if (setting_->circle == Circle::xi_rho) out[0] = s.xi - s.rho;
    }
    if constexpr (spectral) {
      const SpinBlocks blocks{setting_->branch, !setting_->potential.is_separable(), held()};
      const auto meeting =
          meeting_equations<circle>(function_.meeting(), blocks, straight(s), y[dimension - 1]);
      out[k++] = meeting[0];
      out[k++] = meeting[1];
    } else {
      out[k++] = function(s);
    }
    return out;
  }

 private:
  using Kind = FamilyParameter::Kind;

  struct State {
    Inertia3<T> J;
    T nu;
    T xi, zeta, rho;
    CentrifugalRates<T> rates;
    LogBalance<T> balance;
    T g = T(0.0);  ///< of a body with gravity
  };

  template <class Input>
  State state(const Unknowns& y, const Input& number) const {
    const EventSetting& at = *setting_;
    const auto input = [&](double value, Kind kind, int index) {
      const InputPlace place = input_place(at.potential, kind, index);
      kind = place.kind;
      index = kind == Kind::inertia ? at.inertia_index(place.index) : place.index;
      if (varies(at.parameter, kind, index)) return y[stretches];
      const bool held = at.held && varies(at.held->number, kind, index);
      return number(held ? at.held->value : value, kind, index);
    };
    const double J[3] = {at.body.J1, at.body.J2, at.body.J3};
    State s;
    const auto inertia = [&](int k) {
      const int own = at.inertia_index(k);
      return input(J[own], Kind::inertia, own);
    };
    s.J = {inertia(0), inertia(1), inertia(2)};
    s.nu = input(at.nu, Kind::nu, 0);
    s.xi = y[0];
    s.zeta = circle ? s.xi : y[1];
    s.rho = y[stretches - 1];
    s.rates = axis_rates(s.J, at.branch, s.nu * s.nu);
    s.balance = varied_balance(at.potential, s.xi, s.zeta, s.rho, s.rates, input);
    if (body_ != nullptr && body_->gravitates)
      s.g = input(body_->g, Kind::plane, static_cast<int>(BodyModel<>::g_place));
    return s;
  }
  bool held() const { return body_ != nullptr && body_->volume; }

  // The functions of x and p alone.

  static T moment(const State& s, int k) {
    const T& x = k == 0 ? s.xi : k == 1 ? s.zeta : s.rho;
    return inertia_of(s.J, k) * (x * x);
  }

  T function(const State& s) const {
    switch (function_.kind) {
      case EventFunction::Kind::inertia:
        return moment(s, function_.a) - moment(s, function_.b);
      case EventFunction::Kind::ellipse:
        return across_circle(s.balance);
      case EventFunction::Kind::turn:
        return turning(s);
      case EventFunction::Kind::momentum:
        return turning_momentum(s);
      default:
        return determinant(stiffness(s));
    }
  }

  T turning(const State& s) const {
    const T difference = s.J.J1 - s.J.J2;
    if (body_ == nullptr || !body_->gravitates) return difference;
    const TurningForces<T> turns = turning_forces<T>(setting_->branch, s.J, s.xi, s.zeta,
                                                     s.nu * s.nu, -(s.g * gravity_slope(s)));
    return difference * (turns.spin - turns.gravity) / (s.xi - s.zeta);
  }
  /// F_T (self_energy.hpp).
  static T gravity_slope(const State& s) {
    const T y1 = s.J.J1 * (s.xi * s.xi);
    const T y2 = s.J.J2 * (s.zeta * s.zeta);
    return ellipsoid_integral<1>(T(y1 + y2), T(y1 * y2), T(s.J.J3 * (s.rho * s.rho)))
        .derivative({1, 0, 0});
  }

  T across_circle(const LogBalance<T>& b) const {
    switch (setting_->circle) {
      case Circle::zeta_rho:
        return b.vv - 2.0 * b.vw + b.ww;
      case Circle::xi_rho:
        return b.uu - 2.0 * b.uw + b.ww;
      default:
        return b.uu - b.uv;
    }
  }

  /// dG/d ln x, on the circle along (1, 1).
  static SquareArray<T, stretches> stiffness(const State& s) {
    const LogBalance<T>& b = s.balance;
    if constexpr (circle) {
      return {{{b.uu + b.uv, b.uw}, {2.0 * b.uw, b.ww}}};
    } else {
      return {{{b.uu, b.uv, b.uw}, {b.uv, b.vv, b.vw}, {b.uw, b.vw, b.ww}}};
    }
  }

  T turning_momentum(const State& s) const {
    const CentrifugalRates<T> part = axis_rates(s.J, setting_->branch, T(1.0));
    const T xi2 = s.xi * s.xi;
    const T zeta2 = s.zeta * s.zeta;
    const T rho2 = s.rho * s.rho;
    const T own = part.xi * xi2 + part.zeta * zeta2 + part.rho * rho2;
    // dG_i/d ln nu = -2 c_i x_i^2;  dI_a/d ln x_i = 2 I_i x_i^2.
    std::array<T, stretches> column;
    std::array<T, stretches> row;
    // Along a held volume rho's pull is one on xi and zeta.
    const T thick = held() ? T(s.rates.rho * rho2) : T(0.0);
    column[0] = -2.0 * (s.rates.xi * xi2 - thick);
    if constexpr (!circle) column[1] = -2.0 * (s.rates.zeta * zeta2 - thick);
    column[stretches - 1] = held() ? T(0.0) : T(-2.0 * (s.rates.rho * rho2));
    row[0] = 2.0 * (circle ? part.xi * xi2 + part.zeta * zeta2 : part.xi * xi2);
    if constexpr (!circle) row[1] = 2.0 * (part.zeta * zeta2);
    row[stretches - 1] = 2.0 * (part.rho * rho2);
    return momentum_turn(stiffness(s), column, row, own);
  }

  StraightState<T> straight(const State& s) const {
    const LogBalance<T>& b = s.balance;
    if (held()) return with_rotated_gravity(s, held_state(s));
    const T xi2 = s.xi * s.xi;
    const T zeta2 = s.zeta * s.zeta;
    const T rho2 = s.rho * s.rho;
    StraightState<T> out{s.J, s.xi, s.zeta, s.rho, s.nu, {}, {}, {}, {}, {}, {}, {}};
    out.V_xx = (b.uu - b.g_xi) / xi2 + s.rates.xi;
    out.V_zz = (b.vv - b.g_zeta) / zeta2 + s.rates.zeta;
    out.V_rr = (b.ww - b.g_rho) / rho2 + s.rates.rho;
    out.V_xz = b.uv / (s.xi * s.zeta);
    out.V_xr = b.uw / (s.xi * s.rho);
    out.V_zr = b.vw / (s.zeta * s.rho);
    out.V_aa = turning(s, out);
    return with_rotated_gravity(s, out);
  }
  /// Second derivatives along the held volume, the pull of rho among them already: G_xi = xi V_xi -
  /// c_xi xi^2 + c_rho rho^2 and its slopes, less those of the volume's equation, which are all ww.
  StraightState<T> held_state(const State& s) const {
    const LogBalance<T>& b = s.balance;
    StraightState<T> out{s.J, s.xi, s.zeta, s.rho, s.nu, {}, {}, {}, {}, {}, {}, {}};
    out.V_xx = (b.uu - b.ww - b.g_xi) / (s.xi * s.xi) + s.rates.xi;
    out.V_zz = (b.vv - b.ww - b.g_zeta) / (s.zeta * s.zeta) + s.rates.zeta;
    out.V_xz = (b.uv - b.ww) / (s.xi * s.zeta);
    out.V_xr = out.V_zr = out.V_rr = T(0.0);
    out.V_aa = turning(s, out);
    return out;
  }
  /// V_aa of an isotropic potential with these forces; on the circle from its own derivatives.
  T turning(const State& s, const StraightState<T>& of) const {
    if constexpr (circle) {
      return 2.0 * (of.V_xx - of.V_xz);
    } else {
      const T F_xi = s.balance.g_xi / s.xi + s.rates.xi * s.xi;
      const T F_zeta = s.balance.g_zeta / s.zeta + s.rates.zeta * s.zeta;
      return 2.0 * ((F_xi - F_zeta) / (s.xi - s.zeta));
    }
  }
  /// What V_aa of gravity is beside that of an isotropic potential with the same forces:
  /// -2 g F_T (J1 - J2) (xi + zeta)/(zeta - xi).
  StraightState<T> with_rotated_gravity(const State& s, StraightState<T> out) const {
    if constexpr (!circle) {
      if (body_ == nullptr || !body_->gravitates) return out;
      const T of_turn = (s.J.J1 - s.J.J2) * (s.xi + s.zeta) / (s.xi - s.zeta);
      out.V_aa = out.V_aa + 2.0 * (s.g * gravity_slope(s)) * of_turn;
    }
    return out;
  }

  const EventSetting* setting_;
  EventFunction function_;
  const BodyModel<>* body_;
};

/// Over a box of the unknowns, slopes in their logarithms.
template <bool circle, bool spectral>
class EventSystem {
 public:
  static constexpr int stretches = circle ? 2 : 3;
  static constexpr int dimension = stretches + 1 + (spectral ? 1 : 0);

  EventSystem(const EventSetting& setting, const EventFunction& function)
      : inputs_(setting.inputs), equations_(setting, function) {}

  GeneralBoxLinearized<dimension> linearize(const Box<dimension>& box) const {
    std::array<T, dimension> y;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = T::logarithmic(box[i], i);
    const auto equations = equations_.values(
        y, [&](double value, FamilyParameter::Kind, int) { return T(as_input(value, inputs_)); });
    GeneralBoxLinearized<dimension> out;
    for (std::size_t i = 0; i < y.size(); ++i) {
      out.g[i] = equations[i].value;
      out.slope[i] = equations[i].slope;
    }
    return out;
  }

 private:
  using T = Dual<Interval, dimension>;
  Inputs inputs_;
  EventEquations<circle, spectral, T> equations_;
};

/// At a point in extended precision (extended_root.hpp).
template <bool circle, bool spectral>
class ExtendedEventSystem {
 public:
  static constexpr int stretches = circle ? 2 : 3;
  static constexpr int dimension = stretches + 1 + (spectral ? 1 : 0);

  ExtendedEventSystem(const EventSetting& setting, const EventFunction& function)
      : extended_(setting, function),
        conditioned_(setting, function),
        inputs_(coefficient_inputs(setting.potential, setting.parameter)),
        has_decimals_(stationary::has_decimals(setting.potential)) {
    using Kind = FamilyParameter::Kind;
    const auto add = [&](Kind kind, int index) {
      if (!varies(setting.parameter, kind, index)) inputs_.push_back({kind, index});
    };
    for (const int k : {0, 1, 2})
      if (setting.inertia_index(k) == k) add(Kind::inertia, k);
    add(Kind::nu, 0);
  }

  std::size_t inputs() const { return inputs_.size(); }
  bool has_decimals() const { return has_decimals_; }

  ExtendedVector<dimension> values(const ExtendedVector<dimension>& y,
                                   const InputChange& change) const {
    return extended_.values(y, [&](double value, FamilyParameter::Kind kind, int index) {
      const auto place = std::ranges::find_if(inputs_, [&](const CoefficientInput& each) {
        return each.kind == kind && each.index == index;
      });
      return change(value, static_cast<std::size_t>(place - inputs_.begin()));
    });
  }
  std::array<Conditioned, dimension> conditioned(const std::array<Conditioned, dimension>& y,
                                                 bool exact) const {
    return conditioned_.values(y, [&](double value, FamilyParameter::Kind, int) {
      return exact ? Conditioned(value) : Conditioned::input(value);
    });
  }

 private:
  EventEquations<circle, spectral, DoubleDouble> extended_;
  EventEquations<circle, spectral, Conditioned> conditioned_;
  std::vector<CoefficientInput> inputs_;
  bool has_decimals_;
};

}  // namespace stationary
