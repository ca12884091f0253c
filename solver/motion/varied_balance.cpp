#include "solver/motion/varied_balance.hpp"

#include <algorithm>

namespace stationary {

std::vector<CoefficientInput> coefficient_inputs(const Potential& potential,
                                                 const FamilyParameter& parameter) {
  using Kind = FamilyParameter::Kind;
  std::vector<CoefficientInput> out;
  potential.visit_parts([&](const auto& model) {
    const auto add = [&](const auto& part, Kind kind) {
      const auto coefficients = part.coefficients();
      for (std::size_t k = 0; k < coefficients.size(); ++k)
        if (const int index = static_cast<int>(k);
            coefficients[k] != 0.0 && !varies(parameter, kind, index))
          out.push_back({kind, index});
    };
    if constexpr (requires { model.plane; }) {
      add(model.plane, Kind::plane);
      add(model.thickness, Kind::thickness);
    } else {
      add(model, Kind::plane);
    }
  });
  return out;
}

bool has_decimals(const Potential& potential) {
  const auto of = [](const auto& part) {
    if constexpr (requires { part.has_decimals(); }) {
      return part.has_decimals();
    } else {
      return false;
    }
  };
  return potential.visit_parts([&](const auto& model) {
    if constexpr (requires { model.plane; }) {
      return of(model.plane) || of(model.thickness);
    } else {
      return of(model);
    }
  });
}

VariedElastic::VariedElastic(const Potential& potential, const FamilyParameter& parameter)
    : potential_(potential),
      parameter_(parameter),
      inputs_(coefficient_inputs(potential, parameter)),
      has_decimals_(stationary::has_decimals(potential)) {}

DoubleDouble VariedElastic::number(double value, FamilyParameter::Kind kind, int index,
                                   const DoubleDouble& p, const InputChange& change) const {
  if (varies(parameter_, kind, index)) return p;
  const auto place = std::ranges::find_if(inputs_, [&](const CoefficientInput& each) {
    return each.kind == kind && each.index == index;
  });
  return change(value, static_cast<std::size_t>(place - inputs_.begin()));
}

LogBalance<DoubleDouble> VariedElastic::at(const DoubleDouble& xi, const DoubleDouble& zeta,
                                           const DoubleDouble& rho, const DoubleDouble& p,
                                           const InputChange& change) const {
  const CentrifugalRates<DoubleDouble> at_rest{0.0, 0.0, 0.0};
  return varied_balance(potential_, xi, zeta, rho, at_rest,
                        [&](double value, FamilyParameter::Kind kind, int index) {
                          return number(value, kind, index, p, change);
                        });
}

LogBalance<Conditioned> VariedElastic::at(const Conditioned& xi, const Conditioned& zeta,
                                          const Conditioned& rho, const Conditioned& p,
                                          bool exact) const {
  const CentrifugalRates<Conditioned> at_rest{0.0, 0.0, 0.0};
  return varied_balance(potential_, xi, zeta, rho, at_rest,
                        [&](double value, FamilyParameter::Kind kind, int index) {
                          if (varies(parameter_, kind, index)) return p;
                          return exact ? Conditioned(value) : Conditioned::input(value);
                        });
}

TiltedParts<DoubleDouble> VariedElastic::tilted(TiltPlane plane, const Inertia3<DoubleDouble>& J,
                                                const DoubleDouble& xi, const DoubleDouble& zeta,
                                                const DoubleDouble& square_nu,
                                                const InputChange& change) const {
  return varied_tilted(potential_, plane, J, xi, zeta, square_nu,
                       [&](double value, FamilyParameter::Kind kind, int index) {
                         return number(value, kind, index, {}, change);
                       });
}

TiltedParts<Conditioned> VariedElastic::tilted(TiltPlane plane, const Inertia3<Conditioned>& J,
                                               const Conditioned& xi, const Conditioned& zeta,
                                               const Conditioned& square_nu, bool exact) const {
  return varied_tilted(potential_, plane, J, xi, zeta, square_nu,
                       [&](double value, FamilyParameter::Kind, int) {
                         return exact ? Conditioned(value) : Conditioned::input(value);
                       });
}

}  // namespace stationary
