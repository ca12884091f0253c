// The balance of a model that is a formula as a sum of terms (lib/formula/term_table.hpp), made
// once for searches in which the centrifugal rates may differ from box to box.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "lib/formula/term_table.hpp"
#include "solver/proof/box_balance.hpp"

namespace stationary {

/// Of D stretches; null where the model is no formula, or has no such form.
template <int D, class Model>
std::shared_ptr<const expression::TermTable> model_terms(const Model& model, Inputs inputs) {
  if constexpr (requires { model.is_expression(); }) {
    return model.visit([&](const auto& own) { return model_terms<D>(own, inputs); });
  } else if constexpr (requires { model.tape(); }) {
    constexpr std::array coordinates{0, 1, 2};
    std::vector<Interval> parameters;
    for (const double c : model.coefficients()) parameters.push_back(as_input(c, inputs));
    return expression::term_table(
        *model.tape()->source,
        D == 1 ? std::span(coordinates).last(1) : std::span(coordinates).first(std::size_t(D)),
        parameters);
  } else {
    return nullptr;
  }
}

}  // namespace stationary
