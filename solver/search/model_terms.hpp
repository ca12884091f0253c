// The balance of a model that is a formula as a sum of terms (lib/formula/term_table.hpp), made
// once for searches in which the centrifugal rates may differ from box to box.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "lib/formula/term_table.hpp"
#include "solver/proof/box_balance.hpp"
#include "solver/proof/term_bounds.hpp"

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

/// Boxes of all three stretches, narrowed by the formulas of a model: a coupled one, or its parts. By one
/// thread at a time.
class StretchTerms {
 public:
  template <class Model>
  StretchTerms(const Model& model, Inputs inputs) {
    if constexpr (requires { model.plane; }) {
      begin(plane_, model_terms<2>(model.plane, inputs));
      begin(thickness_, model_terms<1>(model.thickness, inputs));
    } else {
      begin(coupled_, model_terms<3>(model, inputs));
    }
  }

  bool any() const { return coupled_ || plane_ || thickness_; }
  /// rates: c_i of each row, in intervals. False where nothing is left of it.
  bool contract(const std::array<Interval, 3>& rates, std::array<Interval, 3>& box) const {
    if (coupled_) {
      coupled_->set_rates(rates);
      return coupled_->contract(box);
    }
    if (plane_) {
      plane_->set_rates({rates[0], rates[1]});
      std::array<Interval, 2> x{box[0], box[1]};
      if (!plane_->contract(x)) return false;
      box[0] = x[0];
      box[1] = x[1];
    }
    if (thickness_) {
      thickness_->set_rates({rates[2]});
      std::array<Interval, 1> x{box[2]};
      if (!thickness_->contract(x)) return false;
      box[2] = x[0];
    }
    return true;
  }

 private:
  template <int D>
  static void begin(std::optional<TermBounds<D>>& out,
                    std::shared_ptr<const expression::TermTable> table) {
    if (table) out.emplace(std::move(table), std::array<Interval, D>{});
  }

  mutable std::optional<TermBounds<3>> coupled_;
  mutable std::optional<TermBounds<2>> plane_;
  mutable std::optional<TermBounds<1>> thickness_;
};

}  // namespace stationary
