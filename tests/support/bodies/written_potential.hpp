// Potentials from text, for tests.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/formula/facts.hpp"
#include "lib/material/models/anisotropic_expression.hpp"
#include "solver/program/text/expression_parser.hpp"

namespace stationary::support {

/// Names of the parameters of most formulas.
inline const std::vector<std::string> k_and_n{"k", "n"};
inline const std::vector<std::string> p_and_q{"p", "q"};

inline PlanarExpression<> written_plane(std::string_view text,
                                        const std::vector<std::string>& parameters,
                                        const std::vector<double>& values) {
  const auto parsed = parse_expression(text, parameters, ExpressionSlot::plane);
  return {expression::planar_tape(parsed.expression), coefficient_list(values)};
}
inline ThicknessExpression<> written_thickness(std::string_view text,
                                               const std::vector<std::string>& parameters,
                                               const std::vector<double>& values) {
  const auto parsed = parse_expression(text, parameters, ExpressionSlot::thickness);
  return {expression::thickness_tape(parsed.expression), coefficient_list(values)};
}
inline CoupledExpression<> written_coupled(std::string_view text,
                                           const std::vector<std::string>& parameters,
                                           const std::vector<double>& values) {
  const auto parsed = parse_expression(text, parameters, ExpressionSlot::coupled);
  return {expression::coupled_tape(parsed.expression), coefficient_list(values)};
}
inline AnisotropicExpression<> written_anisotropic(std::string_view text,
                                                   const std::vector<std::string>& parameters,
                                                   const std::vector<double>& values) {
  const auto parsed = parse_expression(text, parameters, ExpressionSlot::coupled);
  return {expression::anisotropic_tape(parsed.expression), coefficient_list(values)};
}

inline expression::Facts written_facts(std::string_view text,
                                       const std::vector<std::string>& parameters) {
  const auto parsed = parse_expression(text, parameters, ExpressionSlot::coupled);
  return expression::facts(parsed.expression, ExpressionSlot::coupled);
}

/// V at q, by the models of an isotropic potential where it is one.
inline double written_value(std::string_view text, const std::vector<std::string>& parameters,
                            const std::vector<double>& values, const Stretch& q) {
  if (!written_facts(text, parameters).is_isotropic())
    return written_anisotropic(text, parameters, values).derivatives<0>(q).value;
  return written_coupled(text, parameters, values).evaluate<0>(planar_invariants(q), q.rho).plane.w;
}

}  // namespace stationary::support
