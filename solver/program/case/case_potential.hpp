// The potential of a case file: the tables under [potential], read and made into one.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lib/body/body.hpp"
#include "lib/material/potential.hpp"
#include "solver/program/case/case_expression.hpp"
#include "solver/program/case/case_toml.hpp"
#include "solver/program/text/faults.hpp"

namespace stationary {

/// A model by name with its coefficients, or an expression with its parameters, as written under
/// `potential.<slot>`.
struct ModelChoice {
  std::string slot;  ///< plane, thickness, coupled, fibre or second_fibre; gravity or volume
  ModelDescription description;
  std::vector<double> coefficients;                   ///< in the order of description.parameters
  std::shared_ptr<const expression::Tape> tape = {};  ///< of an expression
  std::vector<std::string> facts = {};                ///< found out about an expression
  std::vector<std::string> assumed = {};              ///< of these, known at points only
  Formula formula = {};                               ///< of an expression, its parts and domain
  /// Of a coupled isotropic expression that is separable: used where no fibre stands beside it.
  std::optional<ExpressionParts> parts = {};
};

/// The dotted key of one of a model's coefficients.
std::string coefficient_key(const ModelChoice& model, std::string_view coefficient);

/// The potential of one coupled model, or of a planar and a thickness one, with fibres or without;
/// of these and the body's gravity or held volume. Throws std::invalid_argument with the violated
/// inequality.
Potential make_potential(std::span<const ModelChoice> models, const Body& body);

/// Whether gravity or a held volume is among the models.
bool is_whole_body(std::span<const ModelChoice> models);
/// Place of a coefficient in that body's model (BodyModel).
int place_in_body(const ModelChoice& model, int index);

/// Whether any of the models has directions of its own.
bool anisotropic(std::span<const ModelChoice> models);

/// Of a tree that require_known_keys() has looked at. Nothing where it has found something against the
/// potential, models do not go together, coefficients are outside their domains, an expression is
/// wrong.
std::optional<std::vector<ModelChoice>> read_models(const CaseTree& tree, Faults& faults);

/// Where an override names another model than the file (`before`, its table [potential]), takes out of
/// the tree the file's coefficients that the new model does not have.
void leave_replaced_coefficients(CaseTree& tree, const toml::table& before);

}  // namespace stationary
