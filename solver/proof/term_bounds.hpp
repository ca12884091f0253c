// A box of stretches against the balance as a sum of terms (lib/formula/term_table.hpp): what of
// it holds no solution is cut off.
//
// The terms by one of them are affine forms in the coordinates of the box
// (lib/formula/term_forms.hpp). So is every direction lambda.G/s = sum_k (lambda.C_k) tau_k/s,
// merged before it is evaluated: rows of the balance, their sums and differences, and the rows of
// the inverse Jacobian. Where it cannot be 0 the box is empty; else it bounds each coordinate by
// the others. Where a denominator may have either sign both are tried.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "lib/formula/term_forms.hpp"
#include "lib/matrix/small_matrix.hpp"

namespace stationary {

template <int D>
class TermBounds {
 public:
  using Sides = std::array<Interval, D>;

  /// rates: c_i of each row.
  TermBounds(std::shared_ptr<const expression::TermTable> table,
             const std::array<Interval, D>& rates)
      : table_(std::move(table)), forms_(table_) {
    set_rates(rates);
  }

  /// Other rates, for the boxes from now on.
  void set_rates(const std::array<Interval, D>& rates);

  /// Narrows a box of stretches; false where nothing is left of it.
  bool contract(Sides& box) const;

 private:
  using Entry = expression::TermEntry;
  using Entries = std::vector<Entry>;
  using Forms = expression::TermForms<D>;
  using Form = AffineForm<D>;
  using Signs = typename Forms::Signs;

  static void add(Entries& entries, const Entry& more);
  static Entries merged(const Entries& x, const Entries& y, double sign);
  void tighten(const Signs& signs, AffineBox<D>& left) const;
  SmallMatrix<D> middle_jacobian() const;

  std::shared_ptr<const expression::TermTable> table_;
  std::vector<Entries> force_;       ///< with the centrifugal terms
  std::vector<Entries> directions_;  ///< rows, their sums and differences
  std::vector<std::vector<Entries>> slope_;
  mutable Forms forms_;  ///< of the box that is examined
};

template <int D>
void TermBounds<D>::set_rates(const std::array<Interval, D>& rates) {
  force_ = table_->force;
  slope_ = table_->slope;
  for (std::size_t i = 0; i < D; ++i) {
    const int square = table_->pull[i];
    add(force_[i], {square, -rates[i]});
    add(slope_[i][0], {square, -2.0 * rates[i]});
  }
  directions_ = force_;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = i + 1; j < D; ++j)
      for (const double sign : {1.0, -1.0})
        directions_.push_back(merged(force_[i], force_[j], sign));
}

template <int D>
void TermBounds<D>::add(Entries& entries, const Entry& more) {
  const auto at = std::ranges::find(entries, more.term, &Entry::term);
  if (at == entries.end()) {
    entries.push_back(more);
  } else {
    at->coefficient += more.coefficient;
    at->key.reset();
  }
}

template <int D>
auto TermBounds<D>::merged(const Entries& x, const Entries& y, double sign) -> Entries {
  Entries out = x;
  for (const Entry& each : y) {
    const auto at = std::ranges::find(out, each.term, &Entry::term);
    // The same number in both rows; two whose intervals are the same need not be.
    const bool of_one_double = at != out.end() && at->coefficient.lo == at->coefficient.hi;
    if (sign < 0.0 && at != out.end() && at->coefficient.lo == each.coefficient.lo &&
        at->coefficient.hi == each.coefficient.hi &&
        (of_one_double || (at->key && at->key == each.key))) {
      out.erase(at);
    } else {
      add(out, {each.term, sign * each.coefficient});
    }
  }
  return out;
}

template <int D>
SmallMatrix<D> TermBounds<D>::middle_jacobian() const {
  SmallMatrix<D> out;
  for (std::size_t i = 0; i < D; ++i) {
    for (std::size_t j = i; j < D; ++j) {
      double entry = 0.0;
      for (const Entry& each : slope_[i][j - i]) {
        const auto term = forms_.term(each.term);
        entry +=
            term ? each.coefficient.mid() * term->center : std::numeric_limits<double>::quiet_NaN();
      }
      out.entries(static_cast<int>(i), static_cast<int>(j)) =
          out.entries(static_cast<int>(j), static_cast<int>(i)) = entry;
    }
  }
  return out;
}

template <int D>
void TermBounds<D>::tighten(const Signs& signs, AffineBox<D>& left) const {
  forms_.evaluate_atoms(signs, left);
  if (left.empty) return;
  for (const auto& condition : table_->domain) {
    if (!condition.positive) continue;
    if (const auto value = forms_.sum(condition.sum))
      left.keep(*value, Interval(0.0, std::numeric_limits<double>::infinity()));
    if (left.empty) return;
  }
  // The rows of the inverse, at the middle of the box.
  std::vector<std::array<double, D>> rows;
  const SmallMatrix<D> inverse = middle_jacobian().inverse();
  for (int i = 0; i < D; ++i) {
    std::array<double, D> row;
    bool finite = true;
    for (int j = 0; j < D; ++j) {
      row[static_cast<std::size_t>(j)] = inverse(i, j);
      finite = finite && std::isfinite(inverse(i, j));
    }
    if (finite && D > 1) rows.push_back(row);
  }
  std::vector<std::optional<Form>> terms(table_->terms.size());
  for (const std::size_t which : forms_.largest_scales()) {
    bool usable = true;
    for (const Entries& row : force_)
      for (const Entry& each : row) {
        const auto k = static_cast<std::size_t>(each.term);
        terms[k] = forms_.term_by(which, each.term);
        usable = usable && terms[k].has_value();
      }
    if (!usable) continue;
    const auto merged_sum = [&](const Entries& entries) {
      AffineSum<D> out;
      for (const Entry& each : entries)
        out.add(each.coefficient, *terms[static_cast<std::size_t>(each.term)]);
      return out.form();
    };
    for (const Entries& direction : directions_) {
      left.keep(merged_sum(direction), Interval(0.0));
      if (left.empty) return;
    }
    for (const auto& row : rows) {
      Entries all;
      for (std::size_t i = 0; i < D; ++i)
        for (const Entry& each : force_[i]) add(all, {each.term, row[i] * each.coefficient});
      left.keep(merged_sum(all), Interval(0.0));
      if (left.empty) return;
    }
  }
}

template <int D>
bool TermBounds<D>::contract(Sides& box) const {
  constexpr int most_passes = 6;
  constexpr double worth_another = 0.8;  // of a side that is left
  constexpr int most_undecided = 2;
  for (int pass = 0; pass < most_passes; ++pass) {
    Sides logs;
    for (std::size_t j = 0; j < D; ++j) {
      logs[j] = log(box[j]);
      if (!logs[j].bounded()) return true;
    }
    forms_.set_box(logs);
    AffineBox<D> any = AffineBox<D>::whole();
    forms_.evaluate_atoms({}, any);
    const unsigned either = forms_.undecided_bases();
    if (std::popcount(either) > most_undecided) return true;
    AffineBox<D> kept = AffineBox<D>::nothing();
    // Every subset of the bits.
    for (unsigned negative = either;; negative = (negative - 1) & either) {
      AffineBox<D> left = AffineBox<D>::whole();
      tighten({either, negative}, left);
      kept.join(left);
      if (negative == 0) break;
    }
    if (kept.empty) return false;
    double smallest = 1.0;
    for (std::size_t j = 0; j < D; ++j) {
      const Form& x = forms_.coordinate(static_cast<int>(j));
      const Interval side = Interval(x.center) + x.slope[j] * kept.epsilon[j];
      const Interval narrowed = exp(side);
      if (!narrowed.bounded() || narrowed.apart_from(box[j])) continue;
      smallest = std::min(smallest, 0.5 * (kept.epsilon[j].hi - kept.epsilon[j].lo));
      box[j] = common(box[j], narrowed);
    }
    if (!(smallest < worth_another)) break;
  }
  return true;
}

}  // namespace stationary
