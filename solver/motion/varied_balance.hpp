// The balance of an isotropic potential whose numbers may be of any type and are given one by one:
// the parameter of a family an unknown, an input changed by a little, each with its conditioning.
#pragma once

#include <cstddef>
#include <vector>

#include "lib/balance/tilted_balance.hpp"
#include "lib/body/inertia.hpp"
#include "lib/material/models/model_coefficients.hpp"
#include "lib/number/double_double_functions.hpp"
#include "lib/number/first_order_bound_functions.hpp"
#include "solver/motion/family_parameter.hpp"
#include "solver/motion/problem.hpp"
#include "solver/newton/extended_root.hpp"

namespace stationary {

/// Whether the number of this kind and place is the parameter.
constexpr bool varies(const FamilyParameter& parameter, FamilyParameter::Kind kind, int index) {
  using Kind = FamilyParameter::Kind;
  const bool in_part = kind == Kind::plane || kind == Kind::thickness;
  return (parameter.kind == kind || (in_part && parameter.kind == Kind::shared)) &&
         parameter.index == index;
}

/// Where a number of a body with gravity stands: its own J are those of the body.
struct InputPlace {
  FamilyParameter::Kind kind;
  int index;
};
inline InputPlace input_place(const Potential& potential, FamilyParameter::Kind kind, int index) {
  constexpr int inertia = static_cast<int>(BodyModel<>::inertia_place);
  const bool own =
      kind == FamilyParameter::Kind::plane && index >= inertia && potential.body_model() != nullptr;
  return own ? InputPlace{FamilyParameter::Kind::inertia, index - inertia}
             : InputPlace{kind, index};
}

/// use(model), its coefficients number(value, kind, index).
template <class Number, class Use>
auto with_numbers(const Potential& potential, const Number& number, const Use& use) {
  using Kind = FamilyParameter::Kind;
  const auto convert = [&](const auto& model, Kind kind) {
    return with_indexed_coefficients(
        model, [&](double c, std::size_t k) { return number(c, kind, static_cast<int>(k)); });
  };
  return potential.visit_parts([&](const auto& model) {
    if constexpr (requires { model.plane; }) {
      const auto plane = convert(model.plane, Kind::plane);
      const auto thickness = convert(model.thickness, Kind::thickness);
      return use(
          Separable<std::remove_cv_t<decltype(plane)>, std::remove_cv_t<decltype(thickness)>>{
              plane, thickness});
    } else {
      return use(convert(model, Kind::plane));
    }
  });
}

/// G and dG/d ln x of all three stretches; number(value, kind, index): a coefficient in T.
template <class T, class Number>
LogBalance<T> varied_balance(const Potential& potential, const T& xi, const T& zeta, const T& rho,
                             const CentrifugalRates<T>& rates, const Number& number) {
  return with_numbers(potential, number, [&](const auto& model) -> LogBalance<T> {
    return model.log_balance(xi, zeta, rho, rates.xi, rates.zeta, rates.rho);
  });
}

/// t W_t and d W_d of the elastic energy at alpha = 0; of a held volume at rho = volume/d.
template <class T>
struct PlaneForces {
  T trace;
  T area;
};
template <class T, class Model>
PlaneForces<T> plane_forces(const Model& model, const T& xi, const T& zeta, const T& rho) {
  const auto forces = [&](const auto& of, const T& thickness) -> PlaneForces<T> {
    const auto W = of.template evaluate<1>(planar_invariants(xi, zeta), thickness);
    return {(xi + zeta) * W.plane.w_t, W.plane.w_l};
  };
  if constexpr (is_body_model<Model>) {
    return forces(model.elastic, model.thickness(xi, zeta, rho));
  } else {
    return forces(model, rho);
  }
}

/// The balance of a tilted axis at (xi, zeta) and |nu|^2, and what its events are told by.
template <class T>
struct TiltedParts {
  LogBalance<T> balance;  ///< tilted_balance()
  std::array<T, 2> pull;  ///< of the spin on its two rows
  TiltSquares<T> squares;
  /// t W_t of the elastic energy: where it is zero an axis in no plane is possible.
  T trace_force;
};
template <class T, class Number>
TiltedParts<T> varied_tilted(const Potential& potential, TiltPlane plane, const Inertia3<T>& J,
                             const T& xi, const T& zeta, const T& square_nu, const Number& number) {
  const T rho = tilted_thickness(J, plane, xi, zeta);
  const CentrifugalRates<T> rates = axis_rates(J, Branch::iii, square_nu);
  return with_numbers(potential, number, [&](const auto& model) -> TiltedParts<T> {
    return {tilted_balance(model, plane, xi, zeta, rho, rates),
            tilted_pull(model, plane, xi, zeta, rho, rates),
            tilt_squares_of(model, J, plane, xi, zeta, rho, square_nu),
            plane_forces<T>(model, xi, zeta, rho).trace};
  });
}

struct CoefficientInput {
  FamilyParameter::Kind kind;
  int index;
};
/// All coefficients of an isotropic potential but the parameter.
std::vector<CoefficientInput> coefficient_inputs(const Potential& potential,
                                                 const FamilyParameter& parameter);
/// Whether its formulas have decimals of their own.
bool has_decimals(const Potential& potential);

/// The elastic part by itself, in extended precision and with its conditioning.
class VariedElastic {
 public:
  VariedElastic(const Potential& potential, const FamilyParameter& parameter);

  /// The coefficients but the parameter.
  std::size_t inputs() const { return inputs_.size(); }
  bool has_decimals() const { return has_decimals_; }

  LogBalance<DoubleDouble> at(const DoubleDouble& xi, const DoubleDouble& zeta,
                              const DoubleDouble& rho, const DoubleDouble& p,
                              const InputChange& change) const;
  /// exact: the coefficients are, else inputs.
  LogBalance<Conditioned> at(const Conditioned& xi, const Conditioned& zeta, const Conditioned& rho,
                             const Conditioned& p, bool exact) const;

  /// Likewise of a tilted axis.
  TiltedParts<DoubleDouble> tilted(TiltPlane plane, const Inertia3<DoubleDouble>& J,
                                   const DoubleDouble& xi, const DoubleDouble& zeta,
                                   const DoubleDouble& square_nu, const InputChange& change) const;
  TiltedParts<Conditioned> tilted(TiltPlane plane, const Inertia3<Conditioned>& J,
                                  const Conditioned& xi, const Conditioned& zeta,
                                  const Conditioned& square_nu, bool exact) const;

 private:
  DoubleDouble number(double value, FamilyParameter::Kind kind, int index, const DoubleDouble& p,
                      const InputChange& change) const;

  Potential potential_;
  FamilyParameter parameter_;
  std::vector<CoefficientInput> inputs_;
  bool has_decimals_;
};

}  // namespace stationary
