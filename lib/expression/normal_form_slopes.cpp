// Derivatives of normal forms: of a term by the product rule, of an atom once in each coordinate.
#include <algorithm>
#include <utility>

#include "lib/expression/normal_form.hpp"

namespace stationary::expression {

NormalSum NormalForms::derivative(const NormalTerm& term, int coordinate) {
  const auto j = static_cast<std::size_t>(coordinate);
  NormalSum out;
  if (!term.monomial.a[j].is_zero()) out = {{term.coefficient * term.monomial.a[j], term.monomial}};
  if (const int i = term.monomial.logarithms[j]; i > 0) {
    NormalTerm lower = term;
    --lower.monomial.logarithms[j];
    lower.coefficient = lower.coefficient * ExactNumber::whole(i);
    out = add(out, {lower});
  }
  for (const Monomial::Power& each : term.monomial.powers) {
    const NormalSum& slope = atom_derivative(each.atom, coordinate);
    if (slope.empty()) continue;
    NormalSum part = multiply({term}, constant(each.exponent));
    if (atoms_[static_cast<std::size_t>(each.atom)].kind == Atom::Kind::base) {
      NormalTerm inverse{ExactNumber::whole(1), {}};
      inverse.monomial.powers.push_back({each.atom, ExactNumber::whole(-1)});
      part = multiply(part, {inverse});
    }
    out = add(out, multiply(part, slope));
  }
  for (const Monomial::Factor& each : term.monomial.factors) {
    const NormalSum& slope = atom_derivative(each.atom, coordinate);
    if (slope.empty()) continue;
    NormalTerm lower = term;
    lower.coefficient = lower.coefficient * ExactNumber::whole(each.exponent);
    for (Monomial::Factor& factor : lower.monomial.factors)
      if (factor.atom == each.atom) --factor.exponent;
    std::erase_if(lower.monomial.factors,
                  [](const Monomial::Factor& factor) { return factor.exponent == 0; });
    NormalSum part{lower};
    const Atom atom = atoms_[static_cast<std::size_t>(each.atom)];
    const NormalSum one = constant(ExactNumber::whole(1));
    const auto function_atom = [&](Function f) {
      Atom other = atom;
      other.function = f;
      return atom_as_sum(intern(std::move(other)));
    };
    const auto minus = [&](const NormalSum& x) {
      return multiply(x, constant(ExactNumber::whole(-1)));
    };
    if (atom.kind == Atom::Kind::base) {
      NormalTerm inverse{ExactNumber::whole(1), {}};
      inverse.monomial.powers.push_back({each.atom, ExactNumber::whole(-1)});
      part = multiply(part, {inverse});
    } else if (atom.function == Function::sin) {
      part = multiply(part, function_atom(Function::cos));
    } else if (atom.function == Function::cos) {
      part = multiply(part, minus(function_atom(Function::sin)));
    } else if (atom.function == Function::tan || atom.function == Function::tanh) {
      const NormalSum itself = function_atom(atom.function);
      const NormalSum squared = multiply(itself, itself);
      part = multiply(part, add(one, atom.function == Function::tan ? squared : minus(squared)));
    } else {
      part = multiply(part, whole_power(add(one, whole_power(atom.sum, 2)), -1));
    }
    out = add(out, multiply(part, slope));
  }
  return out;
}

const NormalSum& NormalForms::atom_derivative(int atom, int coordinate) {
  const std::pair key(atom, coordinate);
  const auto found = derivatives_.find(key);
  if (found != derivatives_.end()) return found->second;
  const NormalSum sum = atoms_[static_cast<std::size_t>(atom)].sum;
  return derivatives_.emplace(key, derivative(sum, coordinate)).first->second;
}

NormalSum NormalForms::derivative(const NormalSum& x, int coordinate) {
  NormalSum out;
  for (const NormalTerm& term : x) out = add(out, derivative(term, coordinate));
  return out;
}

}  // namespace stationary::expression
