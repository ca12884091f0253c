// A box of stretches against the balance as a sum of terms (lib/formula/term_table.hpp): what of
// it holds no solution is cut off.
//
// For a scale s, one of the terms, every tau_k/s is one exponential of one sum, in which equal
// parts cancel; as an affine form (lib/number/affine_form.hpp) in the coordinates of the box it is
// linear up to a remainder. So is every direction lambda.G/s = sum_k (lambda.C_k) tau_k/s, merged
// before it is evaluated: rows of the balance, their sums and differences, and the rows of the
// inverse Jacobian. Where it cannot be 0 the box is empty; else it bounds each coordinate by the
// others. Arguments of logarithms and roots N > 0 do so too, and where a denominator may have
// either sign both are tried.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "lib/formula/term_table.hpp"
#include "lib/matrix/small_matrix.hpp"
#include "lib/number/affine_form.hpp"
#include "lib/number/interval_functions.hpp"

namespace stationary {

/// The range of sin, cos, tan, tanh or atan.
inline Interval function_range(expression::Function f, const Interval& x) {
  switch (f) {
    case expression::Function::sin:
      return sin(x);
    case expression::Function::cos:
      return cos(x);
    case expression::Function::tan:
      return tan(x);
    case expression::Function::tanh:
      return tanh(x);
    default:
      return atan(x);
  }
}

template <int D>
class TermBounds {
 public:
  using Form = AffineForm<D>;
  using Sides = std::array<Interval, D>;

  /// rates: c_i of each row.
  TermBounds(std::shared_ptr<const expression::TermTable> table,
             const std::array<Interval, D>& rates);

  /// Other rates, for the boxes from now on.
  void set_rates(const std::array<Interval, D>& rates);

  /// Narrows a box of stretches; false where nothing is left of it.
  bool contract(Sides& box) const;

 private:
  using Entry = expression::TermEntry;
  using Entries = std::vector<Entry>;

  /// tau_k/s: exp(linear.x + sum of log N and F) N^n u^i ... .
  struct Ratio {
    struct Part {
      int place;
      Interval coefficient;
      int whole = 0;  ///< of N^n, n < 0: the coefficient as a whole number, else 0
    };
    std::vector<Part> linear;
    std::vector<Part> logarithms;  ///< of bases
    std::vector<Part> exponents;   ///< of exponent atoms
    std::vector<Part> bases;       ///< N^whole, whole > 0
    std::array<int, 3> coordinates{};
    std::vector<expression::Monomial::Factor> factors;
  };

  struct AtomForms {
    Form value;      ///< N, F or f(S)
    Form logarithm;  ///< of |N|
    double log_upper = 0.0;
    bool usable = true;      ///< bounded
    bool has_log = false;    ///< bounded
    bool has_upper = false;  ///< log_upper bounds it, and the sign is known
    bool negative = false;
  };

  /// The range of the coordinates that is left, epsilon in [-1, 1].
  struct Left {
    std::array<Interval, D> epsilon;
    bool empty = false;
  };

  Ratio ratio(const expression::Monomial& term, const expression::Monomial& scale) const;
  static Entries merged(const Entries& x, const Entries& y, double sign);
  std::optional<Form> evaluate(const Ratio& ratio) const;
  std::optional<Form> sum(const Entries& entries, const std::vector<Ratio>& ratios) const;
  /// Signs assumed of bases that may have either: bit k is for the one number k of unsigned_.
  struct Signs {
    unsigned chosen = 0;
    unsigned negative = 0;
  };
  /// Of the box, at points where the bases have these signs and are positive where they must be.
  void evaluate_atoms(const Signs& signs, Left& left) const;
  /// Bits of the bases that may have either sign in the box.
  unsigned undecided_bases() const;
  void keep(const Form& form, const Interval& values, Left& left) const;
  /// Numbers of the scales that are largest in the middle of the box, the largest first: against
  /// a small one the large terms only differ by more.
  std::vector<std::size_t> largest_scales() const;
  void tighten(const Signs& signs, Left& left) const;
  SmallMatrix<D> middle_jacobian() const;

  std::shared_ptr<const expression::TermTable> table_;
  std::vector<Entries> force_;       ///< with the centrifugal terms
  std::vector<Entries> directions_;  ///< rows, their sums and differences
  std::vector<std::vector<Entries>> slope_;
  std::vector<Ratio> scales_;               ///< by 1
  std::vector<std::vector<Ratio>> ratios_;  ///< by scale, of every term
  std::vector<Ratio> terms_;                ///< by 1
  std::vector<int> unsigned_;               ///< bases to whole negative powers alone
  // Of the box that is examined.
  mutable std::array<Form, 3> x_;
  mutable std::vector<AtomForms> atoms_;
};

template <int D>
TermBounds<D>::TermBounds(std::shared_ptr<const expression::TermTable> table,
                          const std::array<Interval, D>& rates)
    : table_(std::move(table)) {
  set_rates(rates);
  const expression::Monomial one;
  for (const expression::Monomial& each : table_->terms) terms_.push_back(ratio(each, one));
  std::vector<expression::Monomial> scales;
  for (const Entries& row : force_) {
    for (const Entry& entry : row) {
      expression::Monomial scale = table_->terms[static_cast<std::size_t>(entry.term)];
      scale.logarithms = {};
      scale.factors.clear();
      const auto same = [&](const expression::Monomial& each) {
        return expression::NormalForms::same(each, scale);
      };
      if (std::ranges::none_of(scales, same)) scales.push_back(scale);
    }
  }
  if (std::ranges::none_of(scales, &expression::Monomial::is_constant)) scales.push_back(one);
  for (const expression::Monomial& scale : scales) {
    std::vector<Ratio> all;
    for (const expression::Monomial& each : table_->terms) all.push_back(ratio(each, scale));
    ratios_.push_back(std::move(all));
    scales_.push_back(ratio(scale, one));
  }
  atoms_.resize(table_->atoms.size());
  for (std::size_t k = 0; k < table_->atoms.size(); ++k)
    if (table_->atoms[k].kind == expression::Atom::Kind::base && !table_->atoms[k].positive)
      unsigned_.push_back(static_cast<int>(k));
}

template <int D>
void TermBounds<D>::set_rates(const std::array<Interval, D>& rates) {
  force_ = table_->force;
  slope_ = table_->slope;
  for (std::size_t i = 0; i < D; ++i) {
    const int square = table_->pull[i];
    const auto add = [&](Entries& entries, const Interval& c) {
      const auto at = std::ranges::find(entries, square, &Entry::term);
      if (at == entries.end()) {
        entries.push_back({square, c});
      } else {
        at->coefficient += c;
      }
    };
    add(force_[i], -rates[i]);
    add(slope_[i][0], -2.0 * rates[i]);
  }
  directions_ = force_;
  for (std::size_t i = 0; i < D; ++i)
    for (std::size_t j = i + 1; j < D; ++j)
      for (const double sign : {1.0, -1.0})
        directions_.push_back(merged(force_[i], force_[j], sign));
}

template <int D>
auto TermBounds<D>::merged(const Entries& x, const Entries& y, double sign) -> Entries {
  Entries out = x;
  for (const Entry& each : y) {
    const auto at = std::ranges::find(out, each.term, &Entry::term);
    if (at == out.end()) {
      out.push_back({each.term, sign * each.coefficient});
    } else if (sign < 0.0 && at->coefficient.lo == each.coefficient.lo &&
               at->coefficient.hi == each.coefficient.hi) {
      out.erase(at);  // the same number in both rows
    } else {
      at->coefficient += sign * each.coefficient;
    }
  }
  return out;
}

template <int D>
auto TermBounds<D>::ratio(const expression::Monomial& term, const expression::Monomial& scale) const
    -> Ratio {
  Ratio out;
  for (std::size_t j = 0; j < 3; ++j) {
    if (term.a[j].key == scale.a[j].key) continue;
    out.linear.push_back({static_cast<int>(j), term.a[j].value - scale.a[j].value});
  }
  const auto exponent = [](const expression::Monomial& of, int atom) {
    for (const auto& each : of.powers)
      if (each.atom == atom) return each.exponent;
    return expression::ExactNumber();
  };
  for (std::size_t k = 0; k < table_->atoms.size(); ++k) {
    const int atom = static_cast<int>(k);
    const expression::ExactNumber a = exponent(term, atom);
    const expression::ExactNumber b = exponent(scale, atom);
    if (a.key == b.key) continue;
    const Interval difference = a.value - b.value;
    if (table_->atoms[k].kind == expression::Atom::Kind::exponent) {
      out.exponents.push_back({atom, difference});
      continue;
    }
    const double nearest = std::round(difference.mid());
    const auto n = static_cast<int>(std::clamp(nearest, -1e6, 1e6));
    const bool whole = expression::ExactNumber::whole(n).key == a.key - b.key;
    constexpr int most = 4;
    if (whole && n > 0 && n <= most) {
      out.bases.push_back({atom, difference, n});
    } else {
      out.logarithms.push_back({atom, whole ? Interval(n) : difference, whole ? n : 0});
    }
  }
  out.coordinates = term.logarithms;
  out.factors = term.factors;
  return out;
}

template <int D>
auto TermBounds<D>::evaluate(const Ratio& ratio) const -> std::optional<Form> {
  AffineSum<D> exponent;
  Interval factor(1.0);
  for (const auto& part : ratio.linear)
    exponent.add(part.coefficient, x_[static_cast<std::size_t>(part.place)]);
  for (const auto& part : ratio.exponents) {
    const AtomForms& atom = atoms_[static_cast<std::size_t>(part.place)];
    if (!atom.usable) return std::nullopt;
    exponent.add(part.coefficient, atom.value);
  }
  for (const auto& part : ratio.logarithms) {
    const AtomForms& atom = atoms_[static_cast<std::size_t>(part.place)];
    if (!atom.usable || !atom.has_upper) return std::nullopt;
    if (atom.negative && part.whole == 0) return std::nullopt;
    if (atom.negative && part.whole % 2 != 0) factor = -factor;
    if (atom.has_log) {
      exponent.add(part.coefficient, atom.logarithm);
    } else if (part.coefficient.positive()) {
      const Interval most = exp(part.coefficient * Interval(atom.log_upper));
      if (!most.bounded()) return std::nullopt;
      factor *= Interval(0.0, most.hi);
    } else {
      return std::nullopt;
    }
  }
  Form out = Form::constant(factor);
  if (!exponent.empty()) {
    const Form power = exp(exponent.form());
    if (!power.bounded()) return std::nullopt;
    out = factor.lo == 1.0 && factor.hi == 1.0 ? power : factor * power;
  }
  for (const auto& part : ratio.bases) {
    const AtomForms& atom = atoms_[static_cast<std::size_t>(part.place)];
    if (!atom.usable) return std::nullopt;
    for (int n = 0; n < part.whole; ++n) out = out * atom.value;
  }
  for (std::size_t j = 0; j < 3; ++j)
    for (int n = 0; n < ratio.coordinates[j]; ++n) out = out * x_[j];
  for (const auto& part : ratio.factors) {
    const AtomForms& atom = atoms_[static_cast<std::size_t>(part.atom)];
    const bool of_base =
        table_->atoms[static_cast<std::size_t>(part.atom)].kind == expression::Atom::Kind::base;
    if (!atom.usable || (of_base && (!atom.has_log || atom.negative))) return std::nullopt;
    for (int n = 0; n < part.exponent; ++n) out = out * (of_base ? atom.logarithm : atom.value);
  }
  if (!out.bounded()) return std::nullopt;
  return out;
}

template <int D>
auto TermBounds<D>::sum(const Entries& entries, const std::vector<Ratio>& ratios) const
    -> std::optional<Form> {
  AffineSum<D> out;
  for (const Entry& each : entries) {
    const auto term = evaluate(ratios[static_cast<std::size_t>(each.term)]);
    if (!term) return std::nullopt;
    out.add(each.coefficient, *term);
  }
  const Form form = out.form();
  if (!form.bounded()) return std::nullopt;
  return form;
}

/// Every epsilon_j to where the form can take one of the values.
template <int D>
void TermBounds<D>::keep(const Form& form, const Interval& values, Left& left) const {
  if (left.empty || !form.bounded()) return;
  const Interval rest(-form.radius, form.radius);
  Interval all = Interval(form.center) + rest;
  std::array<Interval, D> part;
  for (std::size_t j = 0; j < D; ++j) {
    part[j] = form.slope[j] * left.epsilon[j];
    all += part[j];
  }
  if (all.apart_from(values) || form.range.apart_from(values)) {
    left.empty = true;
    return;
  }
  for (std::size_t j = 0; j < D; ++j) {
    if (form.slope[j] == 0.0) continue;
    Interval others = Interval(form.center) + rest;
    for (std::size_t i = 0; i < D; ++i)
      if (i != j) others += part[i];
    // slope epsilon = value - others
    Interval bound = Interval(-others.hi, -others.lo);
    bound = Interval(below(bound.lo + values.lo), above(bound.hi + values.hi));
    Interval epsilon = Interval(bound.lo / form.slope[j], bound.hi / form.slope[j]);
    if (form.slope[j] < 0.0) std::swap(epsilon.lo, epsilon.hi);
    epsilon = Interval(below(epsilon.lo), above(epsilon.hi));
    if (std::isnan(epsilon.lo) || std::isnan(epsilon.hi)) continue;
    if (epsilon.apart_from(left.epsilon[j])) {
      left.empty = true;
      return;
    }
    left.epsilon[j] = common(left.epsilon[j], epsilon);
    part[j] = form.slope[j] * left.epsilon[j];
  }
}

template <int D>
unsigned TermBounds<D>::undecided_bases() const {
  unsigned out = 0;
  for (std::size_t k = 0; k < unsigned_.size(); ++k) {
    const AtomForms& at = atoms_[static_cast<std::size_t>(unsigned_[k])];
    const Interval& range = at.value.range;
    if (at.usable && range.lo < 0.0 && range.hi > 0.0) out |= 1U << k;
  }
  return out;
}

template <int D>
void TermBounds<D>::evaluate_atoms(const Signs& signs, Left& left) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  unsigned bit = 1;
  for (std::size_t k = 0; k < atoms_.size(); ++k) {
    const auto& atom = table_->atoms[k];
    AtomForms& at = atoms_[k];
    at = AtomForms();
    const auto sum_of_terms = sum(atom.sum, terms_);
    at.usable = sum_of_terms.has_value();
    if (sum_of_terms) at.value = *sum_of_terms;
    switch (atom.kind) {
      case expression::Atom::Kind::exponent:
        break;
      case expression::Atom::Kind::function: {
        const Interval value =
            function_range(atom.function, at.usable ? at.value.range : Interval::entire());
        at.value = Form::constant(value);
        at.usable = value.bounded();
        break;
      }
      case expression::Atom::Kind::base: {
        const unsigned own = atom.positive ? 0 : bit;
        if (!atom.positive) bit <<= 1;
        if (!at.usable) break;
        Interval& range = at.value.range;
        const bool either = !atom.positive && range.lo < 0.0 && range.hi > 0.0;
        if (either && !(signs.chosen & own)) break;  // without a logarithm
        at.negative = either ? (signs.negative & own) != 0 : !atom.positive && range.hi <= 0.0;
        const Interval allowed = at.negative ? Interval(-infinity, 0.0) : Interval(0.0, infinity);
        if (range.apart_from(allowed)) {
          left.empty = true;
          break;
        }
        keep(at.value, allowed, left);
        range = common(range, allowed);
        const Form size = at.negative ? Interval(-1.0) * at.value : at.value;
        const Form logarithm = log(size);
        at.has_log = logarithm.bounded();
        if (at.has_log) at.logarithm = logarithm;
        at.has_upper = true;
        at.log_upper = size.range.hi > 0x1p-1000 ? log_of_double(size.range.hi).hi : -690.0;
        break;
      }
    }
  }
}

template <int D>
SmallMatrix<D> TermBounds<D>::middle_jacobian() const {
  SmallMatrix<D> out;
  for (std::size_t i = 0; i < D; ++i) {
    for (std::size_t j = i; j < D; ++j) {
      double entry = 0.0;
      for (const Entry& each : slope_[i][j - i]) {
        const auto term = evaluate(terms_[static_cast<std::size_t>(each.term)]);
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
std::vector<std::size_t> TermBounds<D>::largest_scales() const {
  // Fewer leave more boxes, more take longer over each: least work over published materials.
  constexpr std::size_t most = 8;
  std::vector<std::pair<double, std::size_t>> by_size;
  for (std::size_t k = 0; k < scales_.size(); ++k) {
    const auto value = evaluate(scales_[k]);
    by_size.emplace_back(value ? std::abs(value->center) : 0.0, k);
  }
  std::ranges::sort(by_size, std::greater());
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < std::min(most, by_size.size()); ++k) out.push_back(by_size[k].second);
  return out;
}

template <int D>
void TermBounds<D>::tighten(const Signs& signs, Left& left) const {
  evaluate_atoms(signs, left);
  if (left.empty) return;
  for (const auto& condition : table_->domain) {
    if (!condition.positive) continue;
    if (const auto value = sum(condition.sum, terms_))
      keep(*value, Interval(0.0, std::numeric_limits<double>::infinity()), left);
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
  for (const std::size_t which : largest_scales()) {
    const std::vector<Ratio>& by_scale = ratios_[which];
    bool usable = true;
    for (const Entries& row : force_)
      for (const Entry& each : row) {
        const auto k = static_cast<std::size_t>(each.term);
        terms[k] = evaluate(by_scale[k]);
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
      keep(merged_sum(direction), Interval(0.0), left);
      if (left.empty) return;
    }
    for (const auto& row : rows) {
      Entries all;
      for (std::size_t i = 0; i < D; ++i) {
        for (const Entry& each : force_[i]) {
          const auto at = std::ranges::find(all, each.term, &Entry::term);
          if (at == all.end()) {
            all.push_back({each.term, row[i] * each.coefficient});
          } else {
            at->coefficient += row[i] * each.coefficient;
          }
        }
      }
      keep(merged_sum(all), Interval(0.0), left);
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
      x_[static_cast<std::size_t>(table_->coordinates[j])] =
          Form::coordinate(static_cast<int>(j), logs[j]);
    }
    Left whole;
    whole.epsilon.fill(Interval(-1.0, 1.0));
    Left any = whole;
    evaluate_atoms({}, any);
    const unsigned either = undecided_bases();
    if (std::popcount(either) > most_undecided) return true;
    Left kept;
    kept.empty = true;
    // Every subset of the bits.
    for (unsigned negative = either;; negative = (negative - 1) & either) {
      Left left = whole;
      tighten({either, negative}, left);
      if (!left.empty && kept.empty) {
        kept = left;
      } else if (!left.empty) {
        for (std::size_t j = 0; j < D; ++j)
          kept.epsilon[j] = hull(kept.epsilon[j], left.epsilon[j]);
      }
      if (negative == 0) break;
    }
    if (kept.empty) return false;
    double smallest = 1.0;
    for (std::size_t j = 0; j < D; ++j) {
      const Form& x = x_[static_cast<std::size_t>(table_->coordinates[j])];
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
