// The terms of a formula (solver/proof/term_bounds.hpp) narrowing places on curves, whose
// centrifugal rates differ from place to place. By one thread at a time.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "solver/proof/term_bounds.hpp"
#include "solver/search/model_terms.hpp"

namespace stationary {

template <int D>
class CurveTerms {
 public:
  /// table: of the model, or null where it has none; then nothing is narrowed.
  explicit CurveTerms(std::shared_ptr<const expression::TermTable> table) {
    if (table) bounds_.emplace(std::move(table), std::array<Interval, D>{});
  }

  /// Narrows logarithms of stretches; false where nothing is left of them.
  bool contract(const std::array<Interval, D>& rates, std::array<Interval, D>& x) const {
    if (!bounds_) return true;
    bounds_->set_rates(rates);
    std::array<Interval, D> stretches;
    for (std::size_t i = 0; i < D; ++i) stretches[i] = exp(x[i]);
    const std::array<Interval, D> before = stretches;
    if (!bounds_->contract(stretches)) return false;
    for (std::size_t i = 0; i < D; ++i) {
      if (stretches[i].lo == before[i].lo && stretches[i].hi == before[i].hi) continue;
      const Interval narrowed = log(stretches[i]);
      if (narrowed.bounded() && !narrowed.apart_from(x[i])) x[i] = common(x[i], narrowed);
    }
    return true;
  }

 private:
  mutable std::optional<TermBounds<D>> bounds_;
};

/// Of xi and zeta the same, of the thickness none: a spin about axis 3 with J1 = J2.
template <int D>
std::array<Interval, D> with_plane_rate(const Interval& c) {
  std::array<Interval, D> out{};
  out[0] = out[1] = c;
  return out;
}

}  // namespace stationary
