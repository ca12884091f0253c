// The balance of an isotropic potential whose numbers may be of any type and are given one by one:
// the parameter of a family an unknown, an input changed by a little, each with its conditioning.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "lib/body/inertia.hpp"
#include "lib/material/models/model_coefficients.hpp"
#include "lib/number/double_double_functions.hpp"
#include "lib/number/first_order_bound_functions.hpp"
#include "solver/motion/family_parameter.hpp"
#include "solver/motion/problem.hpp"

namespace stationary {

/// One of the inputs is larger by a relative amount; none where there is no such input.
struct InputChange {
  std::size_t input = std::numeric_limits<std::size_t>::max();
  double relative = 0.0;

  /// Input number k, of this value.
  DoubleDouble operator()(double value, std::size_t k) const {
    return k == input ? DoubleDouble(value) + two_product(value, relative) : DoubleDouble(value);
  }
  /// Of the inputs from number k on.
  InputChange from(std::size_t k) const {
    return input == InputChange().input || input < k ? InputChange()
                                                     : InputChange{input - k, relative};
  }
};

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

/// G and dG/d ln x of all three stretches; number(value, kind, index): a coefficient in T.
template <class T, class Number>
LogBalance<T> varied_balance(const Potential& potential, const T& xi, const T& zeta, const T& rho,
                             const CentrifugalRates<T>& rates, const Number& number) {
  using Kind = FamilyParameter::Kind;
  const auto with_numbers = [&](const auto& model, Kind kind) {
    return with_indexed_coefficients(
        model, [&](double c, std::size_t k) { return number(c, kind, static_cast<int>(k)); });
  };
  return potential.visit_parts([&](const auto& model) -> LogBalance<T> {
    if constexpr (requires { model.plane; }) {
      const auto plane = with_numbers(model.plane, Kind::plane);
      const auto thickness = with_numbers(model.thickness, Kind::thickness);
      LogBalance<T> out = plane.log_balance(xi, zeta, rates.xi, rates.zeta);
      const LogBalance<T> axial = thickness.log_balance(rho, rates.rho);
      out.g_rho = axial.g_rho;
      out.ww = axial.ww;
      out.uw = out.vw = T(0.0);
      return out;
    } else {
      return with_numbers(model, Kind::plane)
          .log_balance(xi, zeta, rho, rates.xi, rates.zeta, rates.rho);
    }
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

 private:
  Potential potential_;
  FamilyParameter parameter_;
  std::vector<CoefficientInput> inputs_;
  bool has_decimals_;
};

}  // namespace stationary
