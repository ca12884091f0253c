#include "lib/expression/normal_form.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace stationary::expression {
namespace {

bool bounded(const NormalSum& x) {
  return std::ranges::all_of(
      x, [](const NormalTerm& term) { return term.coefficient.value.bounded(); });
}

}  // namespace

bool Monomial::is_constant() const {
  return powers.empty() && is_exponential() &&
         std::ranges::all_of(a, [](const ExactNumber& x) { return x.is_zero(); });
}

std::strong_ordering NormalForms::compare(const Monomial& x, const Monomial& y) {
  using expression::compare;
  for (std::size_t j = 0; j < 3; ++j)
    if (const auto order = compare(x.a[j], y.a[j]); order != 0) return order;
  if (const auto order = x.logarithms <=> y.logarithms; order != 0) return order;
  std::size_t i = 0;
  std::size_t k = 0;
  const ExactNumber none;
  while (i < x.powers.size() || k < y.powers.size()) {
    const int left = i < x.powers.size() ? x.powers[i].atom : std::numeric_limits<int>::max();
    const int right = k < y.powers.size() ? y.powers[k].atom : std::numeric_limits<int>::max();
    const ExactNumber& a = left <= right ? x.powers[i].exponent : none;
    const ExactNumber& b = right <= left ? y.powers[k].exponent : none;
    if (const auto order = compare(a, b); order != 0) return order;
    i += left <= right;
    k += right <= left;
  }
  return x.factors <=> y.factors;
}

NormalForms::NormalForms(const Graph& graph, std::span<const NodeId> roots,
                         std::span<const Interval> parameters)
    : graph_(graph), coefficients_(graph, roots, parameters) {}

NormalSum NormalForms::constant(const ExactNumber& c) {
  if (c.is_zero()) return {};
  return {{c, {}}};
}

NormalSum NormalForms::coordinate(int j) {
  NormalTerm out{ExactNumber::whole(1), {}};
  out.monomial.a[static_cast<std::size_t>(j)] = ExactNumber::whole(1);
  return {out};
}

NormalSum NormalForms::add(const NormalSum& x, const NormalSum& y) const {
  NormalSum out;
  std::size_t i = 0;
  std::size_t k = 0;
  while (i < x.size() || k < y.size()) {
    const auto order = i == x.size()   ? std::strong_ordering::greater
                       : k == y.size() ? std::strong_ordering::less
                                       : compare(x[i].monomial, y[k].monomial);
    if (order < 0) {
      out.push_back(x[i++]);
    } else if (order > 0) {
      out.push_back(y[k++]);
    } else {
      const ExactNumber c = x[i].coefficient + y[k].coefficient;
      if (!c.is_zero()) out.push_back({c, x[i].monomial});
      ++i;
      ++k;
    }
  }
  if (out.size() > most_terms) throw NotNormal("more terms than there is room for");
  return out;
}

NormalSum NormalForms::multiply(const NormalTerm& x, const NormalTerm& y) {
  NormalTerm out{x.coefficient * y.coefficient, x.monomial};
  Monomial& m = out.monomial;
  for (std::size_t j = 0; j < 3; ++j) {
    m.a[j] = m.a[j] + y.monomial.a[j];
    m.logarithms[j] += y.monomial.logarithms[j];
  }
  for (const Monomial::Power& each : y.monomial.powers) {
    const auto at = std::ranges::lower_bound(m.powers, each.atom, {}, &Monomial::Power::atom);
    if (at == m.powers.end() || at->atom != each.atom) {
      m.powers.insert(at, each);
    } else {
      at->exponent = at->exponent + each.exponent;
    }
  }
  std::erase_if(m.powers, [](const Monomial::Power& each) { return each.exponent.is_zero(); });
  for (const Monomial::Factor& each : y.monomial.factors) {
    const auto at = std::ranges::lower_bound(m.factors, each.atom, {}, &Monomial::Factor::atom);
    if (at == m.factors.end() || at->atom != each.atom) {
      m.factors.insert(at, each);
    } else {
      at->exponent += each.exponent;
    }
  }
  // N^n, n > 0, is multiplied out.
  for (const Monomial::Power& each : m.powers) {
    const Atom& atom = atoms_[static_cast<std::size_t>(each.atom)];
    const auto n = as_whole(each.exponent);
    if (atom.kind != Atom::Kind::base || !n || *n < 1 || *n > largest_power) continue;
    const NormalSum expanded = whole_power(NormalSum(atom.sum), *n);
    const int which = each.atom;
    std::erase_if(m.powers, [&](const Monomial::Power& p) { return p.atom == which; });
    return multiply({out}, expanded);
  }
  return {out};
}

NormalSum NormalForms::multiply(const NormalSum& x, const NormalSum& y) {
  if (x.size() * y.size() > 4 * most_terms) throw NotNormal("more terms than there is room for");
  NormalSum out;
  for (const NormalTerm& a : x)
    for (const NormalTerm& b : y) out = add(out, multiply(a, b));
  return out;
}

NormalSum NormalForms::whole_power(const NormalSum& x, int n) {
  if (n == 0) return constant(ExactNumber::whole(1));
  if (n == 1) return x;
  if (x.size() == 1 && (n > 0 || x[0].monomial.is_exponential())) {
    NormalTerm out = x[0];
    out.coefficient = expression::power(out.coefficient, n);
    const ExactNumber times = ExactNumber::whole(n);
    for (ExactNumber& a : out.monomial.a) a = a.is_zero() ? a : a * times;
    for (int& i : out.monomial.logarithms) i *= n;
    for (Monomial::Power& each : out.monomial.powers) each.exponent = each.exponent * times;
    for (Monomial::Factor& each : out.monomial.factors) each.exponent *= n;
    return {out};
  }
  if (n > 0 && n <= largest_power) {
    const NormalSum half = whole_power(x, n / 2);
    const NormalSum even = multiply(half, half);
    return n % 2 == 0 ? even : multiply(even, x);
  }
  const Normalized parts = normalize(x);
  NormalSum out = whole_power(NormalSum{parts.factor}, n);
  if (parts.base < 0) return out;
  NormalTerm base{ExactNumber::whole(1), {}};
  base.monomial.powers.push_back({parts.base, ExactNumber::whole(n)});
  return multiply(out, {base});
}

/// The leading term without what may change its sign or is no exponential, |c| its coefficient.
NormalForms::Normalized NormalForms::normalize(const NormalSum& x) {
  if (x.empty()) throw NotNormal("a power or a logarithm of 0");
  Normalized out;
  out.factor = x[0];
  out.factor.coefficient = magnitude(x[0].coefficient);
  Monomial& m = out.factor.monomial;
  m.logarithms = {};
  m.factors.clear();
  std::erase_if(m.powers, [&](const Monomial::Power& each) {
    const Atom& atom = atoms_[static_cast<std::size_t>(each.atom)];
    return atom.kind == Atom::Kind::base && !atom.positive;
  });
  NormalTerm inverse = whole_power(NormalSum{out.factor}, -1)[0];
  NormalSum rest;
  for (const NormalTerm& term : x) rest = add(rest, multiply(term, inverse));
  const bool is_one =
      rest.size() == 1 && rest[0].monomial.is_constant() && rest[0].coefficient.value.positive();
  if (is_one) return out;
  Atom base;
  base.sum = std::move(rest);
  out.base = intern(std::move(base));
  return out;
}

/// c tau N^n > 0, n odd and c > 0, is N > 0.
void NormalForms::note_positive(const NormalSum& x) {
  if (x.size() != 1 || !x[0].coefficient.value.positive() || !x[0].monomial.is_exponential())
    return;
  Atom* only = nullptr;
  for (const Monomial::Power& each : x[0].monomial.powers) {
    Atom& atom = atoms_[static_cast<std::size_t>(each.atom)];
    if (atom.kind != Atom::Kind::base || atom.positive) continue;
    const auto n = as_whole(each.exponent);
    if (only != nullptr || !n || *n % 2 == 0) return;
    only = &atom;
  }
  if (only != nullptr) only->positive = true;
}

NormalSum NormalForms::power(const NormalSum& x, const ExactNumber& r) {
  if (const auto n = as_whole(r)) return whole_power(x, *n);
  note_positive(x);
  const Normalized parts = normalize(x);
  NormalTerm out = parts.factor;
  out.coefficient = expression::power(out.coefficient, r);
  for (ExactNumber& a : out.monomial.a) a = a.is_zero() ? a : a * r;
  for (Monomial::Power& each : out.monomial.powers) each.exponent = each.exponent * r;
  if (parts.base < 0) return multiply({out}, constant(ExactNumber::whole(1)));
  atoms_[static_cast<std::size_t>(parts.base)].positive = true;
  NormalTerm base{ExactNumber::whole(1), {}};
  base.monomial.powers.push_back({parts.base, r});
  return multiply({out}, {base});
}

NormalSum NormalForms::atom_as_sum(int atom) {
  NormalTerm out{ExactNumber::whole(1), {}};
  out.monomial.factors.push_back({atom, 1});
  return {out};
}

NormalSum NormalForms::logarithm(const NormalSum& x) {
  note_positive(x);
  const Normalized parts = normalize(x);
  NormalSum out;
  const ExactNumber& c = parts.factor.coefficient;
  if (!c.is_one()) out = constant(expression::logarithm(c));
  const Monomial& m = parts.factor.monomial;
  for (std::size_t j = 0; j < 3; ++j) {
    if (m.a[j].is_zero()) continue;
    NormalTerm term{m.a[j], {}};
    term.monomial.logarithms[j] = 1;
    out = add(out, {term});
  }
  for (const Monomial::Power& each : m.powers) {
    const Atom& atom = atoms_[static_cast<std::size_t>(each.atom)];
    const NormalSum part =
        atom.kind == Atom::Kind::exponent ? NormalSum(atom.sum) : atom_as_sum(each.atom);
    out = add(out, multiply(part, constant(each.exponent)));
  }
  if (parts.base >= 0) {
    atoms_[static_cast<std::size_t>(parts.base)].positive = true;
    out = add(out, atom_as_sum(parts.base));
  }
  if (!bounded(out)) throw NotNormal("the logarithm of a coefficient");
  return out;
}

NormalSum NormalForms::exponential(const NormalSum& x) {
  NormalTerm out{ExactNumber::whole(1), {}};
  NormalSum product{out};
  for (const NormalTerm& term : x) {
    const Monomial& m = term.monomial;
    NormalTerm factor{ExactNumber::whole(1), {}};
    const bool plain = m.powers.empty() && std::ranges::all_of(m.a, &ExactNumber::is_zero);
    const int logarithms = m.logarithms[0] + m.logarithms[1] + m.logarithms[2];
    const bool of_base =
        plain && logarithms == 0 && m.factors.size() == 1 && m.factors[0].exponent == 1 &&
        atoms_[static_cast<std::size_t>(m.factors[0].atom)].kind == Atom::Kind::base;
    if (plain && logarithms == 1 && m.factors.empty()) {
      for (std::size_t j = 0; j < 3; ++j)
        if (m.logarithms[j] == 1) factor.monomial.a[j] = term.coefficient;
    } else if (of_base) {
      factor.monomial.powers.push_back({m.factors[0].atom, term.coefficient});
    } else {
      Atom atom;
      atom.kind = Atom::Kind::exponent;
      atom.sum = {{ExactNumber::whole(1), m}};
      factor.monomial.powers.push_back({intern(std::move(atom)), term.coefficient});
    }
    product = multiply(product, {factor});
  }
  return product;
}

int NormalForms::intern(Atom atom) {
  std::vector<Residue> key;
  const auto plain = [&key](std::uint64_t x) { key.push_back({x, 0}); };
  plain(static_cast<std::uint64_t>(atom.kind));
  plain(static_cast<std::uint64_t>(atom.function));
  for (const NormalTerm& term : atom.sum) {
    key.push_back(term.coefficient.key);
    for (const ExactNumber& a : term.monomial.a) key.push_back(a.key);
    for (const int i : term.monomial.logarithms) plain(static_cast<std::uint64_t>(i));
    plain(term.monomial.powers.size());
    for (const auto& each : term.monomial.powers) {
      plain(static_cast<std::uint64_t>(each.atom));
      key.push_back(each.exponent.key);
    }
    plain(term.monomial.factors.size());
    for (const auto& each : term.monomial.factors) {
      plain(static_cast<std::uint64_t>(each.atom));
      plain(static_cast<std::uint64_t>(each.exponent));
    }
  }
  if (!bounded(atom.sum)) throw NotNormal("a coefficient that is not bounded");
  const auto [at, fresh] =
      known_atoms_.try_emplace(std::move(key), static_cast<int>(atoms_.size()));
  if (fresh) atoms_.push_back(std::move(atom));
  return at->second;
}

NormalSum NormalForms::function(const Node& node) {
  const NormalSum& x = known_.at(node.a);
  switch (node.function) {
    case Function::sqrt:
      return power(x, {Interval(0.5), *reciprocal(ExactNumber::whole(2).key)});
    case Function::exp:
      return exponential(x);
    case Function::log:
      return logarithm(x);
    case Function::abs:
    case Function::power:
      throw NotNormal("a function without derivatives");
    default:
      break;
  }
  Atom atom;
  atom.kind = Atom::Kind::function;
  atom.function = node.function;
  atom.sum = x;
  return atom_as_sum(intern(std::move(atom)));
}

NormalSum NormalForms::make(NodeId x) {
  const Node& node = graph_[x];
  switch (node.kind) {
    case Kind::variable:
      switch (static_cast<Variable>(node.index)) {
        case Variable::xi:
          return coordinate(0);
        case Variable::zeta:
          return coordinate(1);
        case Variable::rho:
          return coordinate(2);
        default:
          throw NotNormal("a variable that is no stretch");
      }
    case Kind::sum: {
      NormalSum out = constant(coefficients_(node.a));
      for (const Term& term : node.terms)
        out = add(out, multiply(known_.at(term.node), constant(coefficients_(term.coefficient))));
      return out;
    }
    case Kind::product: {
      // Powers of single terms first: what they cancel is not multiplied out.
      NormalSum out = constant(ExactNumber::whole(1));
      for (const bool single : {true, false})
        for (const Term& factor : node.terms)
          if ((known_.at(factor.node).size() == 1) == single)
            out = multiply(out, whole_power(known_.at(factor.node), factor.exponent));
      return out;
    }
    case Kind::power:
      return power(known_.at(node.a), coefficients_(node.b));
    case Kind::function:
      return function(node);
    default:
      throw NotNormal("a kernel of the principal stretches");
  }
}

NormalSum NormalForms::of(NodeId x) {
  if (graph_.is_coefficient(x)) return constant(coefficients_(x));
  const std::array<NodeId, 1> root{x};
  for (const NodeId part : graph_.parts(root))
    if (!graph_.is_coefficient(part) && !known_.contains(part)) known_.emplace(part, make(part));
  return known_.at(x);
}

}  // namespace stationary::expression
