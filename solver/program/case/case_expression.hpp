// A potential that the case file writes out: { expression = "mu/2*(I1 - 2 - 2*log(d))", mu = 1.0 }
// under potential.plane, .thickness or .coupled. Beside it stand its parameters, and, where wanted,
// parts with names, let = { J = "d*rho" }, and conditions, domain = "I1 < 4" or a list of them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/formula/expression.hpp"
#include "solver/program/case/case_toml.hpp"
#include "solver/program/text/expression_parser.hpp"

namespace stationary {

/// Whether a table under `potential` writes its potential out.
bool is_written_out(const toml::table& table);

/// Throws InputError unless every other key is a finite number with a name that a parameter may
/// have (expression_parser.hpp), `let` or `domain`, these of the right types.
void require_written_out(const CaseTree& tree, const std::string& path, const toml::table& table);

/// A potential as the sum of two, each with all the parameters of the whole.
struct ExpressionParts {
  std::shared_ptr<const expression::Tape> plane;
  std::shared_ptr<const expression::Tape> thickness;
};

struct WrittenPotential {
  Formula formula;
  std::shared_ptr<const expression::Tape> tape;
  std::vector<double> coefficients;           ///< in the order of tape->parameters
  std::vector<std::string> facts;             ///< what was found out about it, a sentence each
  bool isotropic = true;                      ///< else the tape is of oriented_tape()
  std::vector<std::string> assumed;           ///< facts known at points only (facts.hpp)
  std::optional<ExpressionParts> parts = {};  ///< of a coupled isotropic one that is separable
};

/// Of a table that require_written_out() let pass. slot: plane, thickness or coupled. Throws
/// InputError at the character that is wrong, for constants that are not finite at the
/// coefficients, or for an expression that is no such potential.
WrittenPotential read_written_out(const CaseTree& tree, std::string_view slot,
                                  const toml::table& table);

}  // namespace stationary
