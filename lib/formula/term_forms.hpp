// Affine forms (lib/number/affine_form.hpp) of the terms of a balance (term_table.hpp) over a box
// of stretches.
//
// For a scale s, one of the terms, every tau_k/s is one exponential of one sum, in which equal
// parts cancel; in the coordinates epsilon of the box it is linear up to a remainder. Arguments of
// logarithms and roots N > 0 cut off the part of the box where they are not positive.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "lib/formula/term_table.hpp"
#include "lib/number/affine_form.hpp"
#include "lib/number/interval_functions.hpp"

namespace stationary::expression {

/// The range of sin, cos, tan, tanh or atan.
inline Interval function_range(Function f, const Interval& x) {
  switch (f) {
    case Function::sin:
      return sin(x);
    case Function::cos:
      return cos(x);
    case Function::tan:
      return tan(x);
    case Function::tanh:
      return tanh(x);
    default:
      return atan(x);
  }
}

template <int D>
class TermForms {
 public:
  using Form = AffineForm<D>;
  using Entries = std::vector<TermEntry>;

  /// Signs assumed of bases that may have either: bit k is for the one number k of unsigned_.
  struct Signs {
    unsigned chosen = 0;
    unsigned negative = 0;
  };

  /// Each term of a row of the balance is a scale, without its logarithms and factors.
  explicit TermForms(std::shared_ptr<const TermTable> table);

  /// The box from now on: ln of its sides.
  void set_box(const std::array<Interval, D>& logarithms);
  const Form& coordinate(int j) const { return x_[place(j)]; }
  /// Of the box, at points where the bases have these signs and are positive where they must be.
  void evaluate_atoms(const Signs& signs, AffineBox<D>& left);
  /// Bits of the bases that may have either sign in the box; of the first 32 of them.
  unsigned undecided_bases() const;

  /// By 1. Nothing where it is not bounded over the box.
  std::optional<Form> term(int k) const { return evaluate(terms_[static_cast<std::size_t>(k)]); }
  std::optional<Form> sum(const Entries& entries) const;
  /// Numbers of the scales that are largest in the middle of the box, the largest first: against
  /// a small one the large terms only differ by more.
  std::vector<std::size_t> largest_scales() const;
  /// By one of the scales.
  std::optional<Form> term_by(std::size_t scale, int k) const {
    return evaluate(ratios_[scale][static_cast<std::size_t>(k)]);
  }

 private:
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
    std::vector<Monomial::Factor> factors;
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

  std::size_t place(int j) const {
    return static_cast<std::size_t>(table_->coordinates[static_cast<std::size_t>(j)]);
  }
  Ratio ratio(const Monomial& term, const Monomial& scale) const;
  std::optional<Form> evaluate(const Ratio& ratio) const;

  std::shared_ptr<const TermTable> table_;
  std::vector<Ratio> scales_;               ///< by 1
  std::vector<std::vector<Ratio>> ratios_;  ///< by scale, of every term
  std::vector<Ratio> terms_;                ///< by 1
  std::vector<int> unsigned_;               ///< bases to whole negative powers alone
  // Of the box that is examined.
  std::array<Form, 3> x_;
  std::vector<AtomForms> atoms_;
};

template <int D>
TermForms<D>::TermForms(std::shared_ptr<const TermTable> table) : table_(std::move(table)) {
  const Monomial one;
  for (const Monomial& each : table_->terms) terms_.push_back(ratio(each, one));
  std::vector<Monomial> scales;
  const auto add = [&](int term) {
    Monomial scale = table_->terms[static_cast<std::size_t>(term)];
    scale.logarithms = {};
    scale.factors.clear();
    const auto same = [&](const Monomial& each) { return NormalForms::same(each, scale); };
    if (std::ranges::none_of(scales, same)) scales.push_back(scale);
  };
  for (std::size_t i = 0; i < D; ++i) {
    for (const TermEntry& each : table_->force[i]) add(each.term);
    add(table_->pull[i]);
  }
  if (std::ranges::none_of(scales, &Monomial::is_constant)) scales.push_back(one);
  for (const Monomial& scale : scales) {
    std::vector<Ratio> all;
    for (const Monomial& each : table_->terms) all.push_back(ratio(each, scale));
    ratios_.push_back(std::move(all));
    scales_.push_back(ratio(scale, one));
  }
  atoms_.resize(table_->atoms.size());
  for (std::size_t k = 0; k < table_->atoms.size(); ++k)
    if (table_->atoms[k].kind == Atom::Kind::base && !table_->atoms[k].positive)
      unsigned_.push_back(static_cast<int>(k));
}

template <int D>
void TermForms<D>::set_box(const std::array<Interval, D>& logarithms) {
  for (std::size_t j = 0; j < D; ++j)
    x_[place(static_cast<int>(j))] = Form::coordinate(static_cast<int>(j), logarithms[j]);
}

template <int D>
auto TermForms<D>::ratio(const Monomial& term, const Monomial& scale) const -> Ratio {
  Ratio out;
  for (std::size_t j = 0; j < 3; ++j) {
    if (term.a[j].key == scale.a[j].key) continue;
    out.linear.push_back({static_cast<int>(j), term.a[j].value - scale.a[j].value});
  }
  const auto exponent = [](const Monomial& of, int atom) {
    for (const auto& each : of.powers)
      if (each.atom == atom) return each.exponent;
    return ExactNumber();
  };
  for (std::size_t k = 0; k < table_->atoms.size(); ++k) {
    const int atom = static_cast<int>(k);
    const ExactNumber a = exponent(term, atom);
    const ExactNumber b = exponent(scale, atom);
    if (a.key == b.key) continue;
    const Interval difference = a.value - b.value;
    if (table_->atoms[k].kind == Atom::Kind::exponent) {
      out.exponents.push_back({atom, difference});
      continue;
    }
    const double nearest = std::round(difference.mid());
    const auto n = static_cast<int>(std::clamp(nearest, -1e6, 1e6));
    const bool whole = ExactNumber::whole(n).key == a.key - b.key;
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
auto TermForms<D>::evaluate(const Ratio& ratio) const -> std::optional<Form> {
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
        table_->atoms[static_cast<std::size_t>(part.atom)].kind == Atom::Kind::base;
    if (!atom.usable || (of_base && (!atom.has_log || atom.negative))) return std::nullopt;
    for (int n = 0; n < part.exponent; ++n) out = out * (of_base ? atom.logarithm : atom.value);
  }
  if (!out.bounded()) return std::nullopt;
  return out;
}

template <int D>
auto TermForms<D>::sum(const Entries& entries) const -> std::optional<Form> {
  AffineSum<D> out;
  for (const TermEntry& each : entries) {
    const auto value = term(each.term);
    if (!value) return std::nullopt;
    out.add(each.coefficient, *value);
  }
  const Form form = out.form();
  if (!form.bounded()) return std::nullopt;
  return form;
}

template <int D>
unsigned TermForms<D>::undecided_bases() const {
  unsigned out = 0;
  for (std::size_t k = 0; k < std::min<std::size_t>(unsigned_.size(), 32); ++k) {
    const AtomForms& at = atoms_[static_cast<std::size_t>(unsigned_[k])];
    const Interval& range = at.value.range;
    if (at.usable && range.lo < 0.0 && range.hi > 0.0) out |= 1U << k;
  }
  return out;
}

template <int D>
void TermForms<D>::evaluate_atoms(const Signs& signs, AffineBox<D>& left) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  unsigned bit = 1;
  for (std::size_t k = 0; k < atoms_.size(); ++k) {
    const auto& atom = table_->atoms[k];
    AtomForms& at = atoms_[k];
    at = AtomForms();
    const auto sum_of_terms = sum(atom.sum);
    at.usable = sum_of_terms.has_value();
    if (sum_of_terms) at.value = *sum_of_terms;
    switch (atom.kind) {
      case Atom::Kind::exponent:
        break;
      case Atom::Kind::function: {
        const Interval value =
            function_range(atom.function, at.usable ? at.value.range : Interval::entire());
        at.value = Form::constant(value);
        at.usable = value.bounded();
        break;
      }
      case Atom::Kind::base: {
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
        left.keep(at.value, allowed);
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
std::vector<std::size_t> TermForms<D>::largest_scales() const {
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

}  // namespace stationary::expression
