#include "lib/expression/normal_form.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "lib/number/double_double_functions.hpp"
#include "lib/number/interval_functions.hpp"

namespace stationary::expression {
namespace {

constexpr std::uint64_t power_symbol = 1;
constexpr std::uint64_t logarithm_symbol = 2;

/// x as a whole number, where it is one and small.
std::optional<int> whole(const ExactNumber& x) {
  static const auto keys = [] {
    std::array<Residue, 2 * Graph::largest_exponent + 1> out;
    for (int n = 0; n <= 2 * Graph::largest_exponent; ++n)
      out[static_cast<std::size_t>(n)] = ExactNumber::whole(n - Graph::largest_exponent).key;
    return out;
  }();
  const double nearest = std::round(x.value.mid());
  if (!(std::abs(nearest) <= Graph::largest_exponent)) return std::nullopt;
  const int n = static_cast<int>(nearest);
  if (keys[static_cast<std::size_t>(n + Graph::largest_exponent)] != x.key) return std::nullopt;
  return n;
}

/// Whole numbers are known exactly.
ExactNumber snapped(const ExactNumber& x) {
  if (x.value.lo == x.value.hi) return x;
  const auto n = whole(x);
  return n ? ExactNumber{Interval(*n), x.key} : x;
}

ExactNumber operator+(const ExactNumber& x, const ExactNumber& y) {
  if (x.is_zero()) return y;
  if (y.is_zero()) return x;
  return snapped({x.value + y.value, x.key + y.key});
}
ExactNumber operator-(const ExactNumber& x) { return {-x.value, -x.key}; }
ExactNumber operator*(const ExactNumber& x, const ExactNumber& y) {
  if (x.is_one()) return y;
  if (y.is_one()) return x;
  return snapped({x.value * y.value, x.key * y.key});
}

Interval whole_power(const Interval& x, int n) {
  if (n < 0) return Interval(1.0) / whole_power(x, -n);
  if (n == 0) return Interval(1.0);
  const Interval half = whole_power(x, n / 2);
  return n % 2 == 0 ? square(half) : square(half) * x;
}

Residue whole_power(const Residue& x, int n) {
  if (n < 0) {
    const std::optional<Residue> below = reciprocal(x);
    if (!below) throw NotNormal("a division by what is 0");
    return whole_power(*below, -n);
  }
  if (n == 0) return {1, 1};
  const Residue half = whole_power(x, n / 2);
  return n % 2 == 0 ? half * half : half * half * x;
}

ExactNumber power(const ExactNumber& x, int n) {
  if (n == 1 || x.is_one()) return x;
  return snapped({whole_power(x.value, n), whole_power(x.key, n)});
}

/// x > 0.
ExactNumber power(const ExactNumber& x, const ExactNumber& r) {
  if (x.is_one()) return x;
  if (const auto n = whole(r)) return power(x, *n);
  return {pow(x.value, r.value), symbol(power_symbol, x.key, r.key)};
}

ExactNumber magnitude(const ExactNumber& x) {
  if (x.value.positive()) return x;
  if (x.value.negative()) return -x;
  throw NotNormal("a coefficient whose sign is not known");
}

std::strong_ordering compare(const ExactNumber& x, const ExactNumber& y) {
  if (x.key == y.key) return std::strong_ordering::equal;
  const double a = x.value.mid();
  const double b = y.value.mid();
  if (a != b) return a < b ? std::strong_ordering::less : std::strong_ordering::greater;
  return x.key <=> y.key;
}

bool bounded(const NormalSum& x) {
  return std::ranges::all_of(
      x, [](const NormalTerm& term) { return term.coefficient.value.bounded(); });
}

}  // namespace

ExactNumber ExactNumber::whole(int n) {
  // 1 + 1 + ... by doubling.
  Residue key;
  for (unsigned bit = 1U << 30; bit != 0; bit >>= 1) {
    key = key + key;
    if (static_cast<unsigned>(std::abs(n)) & bit) key = key + Residue{1, 1};
  }
  return {Interval(n), n < 0 ? -key : key};
}

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
    : graph_(graph), parameters_(parameters.begin(), parameters.end()) {
  // Of roots of parameters, a point where all of them are squares.
  const std::vector<NodeId> parts = graph.parts(roots);
  constexpr std::uint64_t tries = 10000;
  for (std::uint64_t seed = 1; seed < tries; ++seed) {
    residues_.emplace(graph, seed);
    if (std::ranges::all_of(parts, [&](NodeId id) {
          return !graph.is_coefficient(id) || (*residues_)(id).has_value();
        }))
      return;
  }
  throw NotNormal("coefficients without residues");
}

ExactNumber NormalForms::number(NodeId coefficient) {
  const Interval at = value(coefficient);
  if (!at.bounded()) throw NotNormal("a coefficient that is not bounded");
  return snapped({at, *(*residues_)(coefficient)});
}

Interval NormalForms::value(NodeId x) {
  const auto found = values_.find(x);
  if (found != values_.end()) return found->second;
  const Node& node = graph_[x];
  Interval out = Interval::entire();
  switch (node.kind) {
    case Kind::literal:
      out = node.index == 0 ? Interval(node.literal) : Interval::decimal(node.literal);
      break;
    case Kind::parameter:
      out = parameters_[node.index];
      break;
    case Kind::pi:
      out = Interval(double_double_pi.hi, above(double_double_pi.hi));
      break;
    case Kind::euler:
      out = Interval(double_double_e.hi, above(double_double_e.hi));
      break;
    case Kind::coefficient_sum:
      out = value(node.a) + value(node.b);
      break;
    case Kind::coefficient_product:
      out = node.a == node.b ? square(value(node.a)) : value(node.a) * value(node.b);
      break;
    case Kind::coefficient_quotient:
      out = value(node.a) / value(node.b);
      break;
    case Kind::minimum:
      out = smaller(value(node.a), value(node.b));
      break;
    case Kind::maximum:
      out = -smaller(-value(node.a), -value(node.b));
      break;
    case Kind::power:
      out = pow(value(node.a), value(node.b));
      break;
    case Kind::function: {
      const Interval of = value(node.a);
      switch (node.function) {
        case Function::sqrt:
          out = sqrt(of);
          break;
        case Function::exp:
          out = exp(of);
          break;
        case Function::log:
          out = log(of);
          break;
        case Function::sin:
          out = sin(of);
          break;
        case Function::cos:
          out = cos(of);
          break;
        case Function::tan:
          out = tan(of);
          break;
        case Function::tanh:
          out = tanh(of);
          break;
        case Function::atan:
          out = atan(of);
          break;
        case Function::abs:
          out = absolute(of);
          break;
        case Function::power:
          break;
      }
      break;
    }
    default:
      break;
  }
  values_.emplace(x, out);
  return out;
}

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
    const auto n = expression::whole(each.exponent);
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
    const auto n = expression::whole(each.exponent);
    if (only != nullptr || !n || *n % 2 == 0) return;
    only = &atom;
  }
  if (only != nullptr) only->positive = true;
}

NormalSum NormalForms::power(const NormalSum& x, const ExactNumber& r) {
  if (const auto n = expression::whole(r)) return whole_power(x, *n);
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
  if (!c.is_one()) out = constant({log(c.value), symbol(logarithm_symbol, c.key)});
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
      NormalSum out = constant(number(node.a));
      for (const Term& term : node.terms)
        out = add(out, multiply(known_.at(term.node), constant(number(term.coefficient))));
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
      return power(known_.at(node.a), number(node.b));
    case Kind::function:
      return function(node);
    default:
      throw NotNormal("a kernel of the principal stretches");
  }
}

NormalSum NormalForms::of(NodeId x) {
  if (graph_.is_coefficient(x)) return constant(number(x));
  const std::array<NodeId, 1> root{x};
  for (const NodeId part : graph_.parts(root))
    if (!graph_.is_coefficient(part) && !known_.contains(part)) known_.emplace(part, make(part));
  return known_.at(x);
}

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
