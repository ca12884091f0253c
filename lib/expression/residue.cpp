#include "lib/expression/residue.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "lib/expression/root_signs.hpp"
#include "lib/expression/symmetric_kernel.hpp"

namespace stationary::expression {
namespace {

__extension__ using Wide = unsigned __int128;

/// p = 7 modulo 8 and m = 3 modulo 4: 2 is a square, -1 is none, roots are powers. So are all primes
/// up to 43 squares, and roots of the numbers made of them what they are of real numbers.
constexpr std::uint64_t p = 4611686018404548599U;
constexpr std::uint64_t m = (p - 1) / 2;
constexpr std::uint64_t generator = 4;  ///< of the squares

constexpr std::uint64_t add(std::uint64_t x, std::uint64_t y, std::uint64_t modulus) {
  const std::uint64_t out = x + y;
  return out >= modulus ? out - modulus : out;
}
constexpr std::uint64_t minus(std::uint64_t x, std::uint64_t modulus) {
  return x == 0 ? 0 : modulus - x;
}
/// Both are 2^k less a small number, k = 62 or 61: 2^k counts as that number.
constexpr std::uint64_t times(std::uint64_t x, std::uint64_t y, std::uint64_t modulus) {
  const int k = modulus == p ? 62 : 61;
  const std::uint64_t low = (std::uint64_t{1} << k) - 1;
  const std::uint64_t small = low + 1 - modulus;
  Wide out = Wide{x} * y;
  out = (out & low) + (out >> k) * small;
  out = (out & low) + (out >> k) * small;
  const auto rest = static_cast<std::uint64_t>(out);
  return rest >= modulus ? rest - modulus : rest;
}
constexpr std::uint64_t to_power(std::uint64_t x, std::uint64_t n, std::uint64_t modulus) {
  std::uint64_t out = 1;
  for (; n > 0; n >>= 1) {
    if (n & 1U) out = times(out, x, modulus);
    x = times(x, x, modulus);
  }
  return out;
}
constexpr std::uint64_t inverse(std::uint64_t x, std::uint64_t modulus) {
  return to_power(x, modulus - 2, modulus);
}
/// Of 2 and 10, known once.
constexpr std::uint64_t inverse_of(int base, std::uint64_t modulus) {
  constexpr std::array of_two{inverse(2, p), inverse(2, m)};
  constexpr std::array of_ten{inverse(10, p), inverse(10, m)};
  return (base == 2 ? of_two : of_ten)[modulus == p ? 0 : 1];
}
constexpr bool is_square(std::uint64_t x) { return to_power(x, m, p) == 1; }
constexpr std::uint64_t whole(long n, std::uint64_t modulus) {
  return n < 0 ? minus(static_cast<std::uint64_t>(-n), modulus) : static_cast<std::uint64_t>(n);
}
/// Half of 1.
constexpr std::uint64_t half(std::uint64_t modulus) { return (modulus + 1) / 2; }

/// S. Vigna's splitmix64.
constexpr std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

/// Whether an exponent is n/d, d even: only then has a power a sign to choose, x^2 to 1/2 being x or -x.
bool is_root(const Residue& exponent) {
  constexpr std::uint64_t largest = 64;
  const auto is_whole = [](std::uint64_t x) { return x <= largest || minus(x, m) <= largest; };
  for (const std::uint64_t half : {1U, 2U, 3U, 4U, 5U, 6U}) {
    const std::uint64_t part = times(half, exponent.exponent, m);
    if (is_whole(part)) return false;
    if (is_whole(add(part, part, m))) return true;
  }
  return false;
}

}  // namespace

Residue operator+(const Residue& x, const Residue& y) {
  return {add(x.plain, y.plain, p), add(x.exponent, y.exponent, m)};
}
Residue operator-(const Residue& x) { return {minus(x.plain, p), minus(x.exponent, m)}; }
Residue operator-(const Residue& x, const Residue& y) { return x + -y; }
Residue operator*(const Residue& x, const Residue& y) {
  return {times(x.plain, y.plain, p), times(x.exponent, y.exponent, m)};
}
Residue residue_of(std::uint64_t n) { return {n % p, n % m}; }
std::optional<Residue> reciprocal(const Residue& x) {
  if (x.plain == 0 || x.exponent == 0) return std::nullopt;
  return Residue{inverse(x.plain, p), inverse(x.exponent, m)};
}
Residue symbol(std::uint64_t which, const Residue& x, const Residue& y) {
  std::uint64_t hash = mixed(which);
  for (const std::uint64_t part : {x.plain, x.exponent, y.plain, y.exponent})
    hash = mixed(hash + 0x9e3779b97f4a7c15U + part);
  return {hash % p, mixed(hash) % m};
}

enum class ResiduePoint::Symbol : std::uint8_t {
  parameter,
  pi,
  euler,
  inexact_literal,
  logarithm,
  half_angle,
  arc_tangent,
  magnitude,
  minimum,
  maximum,
  exponent_of_power,
  exponent_of_function,
  kernel
};

ResiduePoint::ResiduePoint(const Graph& graph, std::uint64_t seed, const std::vector<bool>* open)
    : graph_(graph), state_(seed), key_(mixed(seed ^ 0x5851f42d4c957f2dU)), open_(open) {
  choose_stretches();
}

std::uint64_t ResiduePoint::next() {
  state_ += 0x9e3779b97f4a7c15U;
  return mixed(state_);
}

std::uint64_t ResiduePoint::next_square() {
  const std::uint64_t root = 1 + next() % (p - 1);
  return times(root, root, p);
}

/// xi = c^2 lambda + s^2 mu, zeta = s^2 lambda + c^2 mu, alpha = c s (lambda - mu),
/// c = (1 - h^2)/(1 + h^2), s = 2 h/(1 + h^2), modulo p and modulo m.
void ResiduePoint::choose_stretches() {
  for (;;) {
    const Residue lambda{next_square(), next() % m};
    const Residue mu{next_square(), next() % m};
    const Residue h{next() % p, next() % m};
    const Residue one{1, 1};
    const Residue h2 = h * h;
    const Residue below = one + h2;
    if (below.plain == 0 || below.exponent == 0) continue;
    const Residue c = quotient(one - h2, below);
    const Residue s = quotient(h + h, below);
    const Residue c2 = c * c;
    const Residue s2 = s * s;
    const Residue xi = (c2 * lambda) + (s2 * mu);
    const Residue zeta = (s2 * lambda) + (c2 * mu);
    if (!is_square(xi.plain) || !is_square(zeta.plain)) continue;
    const Residue difference = lambda - mu;
    set(Variable::xi, xi);
    set(Variable::zeta, zeta);
    set(Variable::alpha, c * s * difference);
    set(Variable::rho, {next_square(), next() % m});
    set(Variable::lambda, lambda);
    set(Variable::mu, mu);
    set(Variable::t, lambda + mu);
    set(Variable::d, lambda * mu);
    set(Variable::first_invariant, lambda * lambda + mu * mu);
    set(Variable::discriminant, difference * difference);
    return;
  }
}

Residue ResiduePoint::symbol(Symbol which, const Residue& x, const Residue& y) const {
  return expression::symbol(key_ + static_cast<std::uint64_t>(which), x, y);
}

Residue ResiduePoint::quotient(const Residue& x, const Residue& y) {
  const std::optional<Residue> below = reciprocal(y);
  if (!below) usable_ = false;
  return below ? x * *below : x;
}

Residue ResiduePoint::whole_power(const Residue& x, int n) {
  const auto size = static_cast<std::uint64_t>(std::abs(n));
  const Residue out{to_power(x.plain, size, p), to_power(x.exponent, size, m)};
  return n < 0 ? quotient({1, 1}, out) : out;
}

Residue ResiduePoint::power(const Residue& base, const Residue& exponent,
                            std::optional<NodeId> of) {
  has_roots_ = true;
  if (!is_square(base.plain)) usable_ = false;
  const Residue out{to_power(base.plain, exponent.exponent, p),
                    symbol(Symbol::exponent_of_power, base, exponent).exponent};
  const bool opposite = of && open_ != nullptr && (*open_)[*of] && is_root(exponent) &&
                        (mixed(key_ ^ base.plain) & 1U) != 0;
  return opposite ? Residue{minus(out.plain, p), out.exponent} : out;
}

/// An exact double is a whole number times a power of two.
Residue ResiduePoint::literal(const Node& node) {
  const auto modulo = [](std::uint64_t modulus, int base, std::uint64_t digits, int power) {
    const auto of_base = static_cast<std::uint64_t>(base);
    const std::uint64_t unit = power < 0 ? inverse_of(base, modulus) : of_base;
    return times(digits % modulus,
                 to_power(unit, static_cast<std::uint64_t>(std::abs(power)), modulus), modulus);
  };
  if (node.index != 0) {
    if (!node.decimal.known())
      return symbol(Symbol::inexact_literal, {std::bit_cast<std::uint64_t>(node.literal),
                                              static_cast<std::uint64_t>(node.decimal.power)});
    return {modulo(p, 10, node.decimal.digits, node.decimal.power),
            modulo(m, 10, node.decimal.digits, node.decimal.power)};
  }
  if (!std::isfinite(node.literal)) usable_ = false;
  int power = 0;
  const double fraction = std::frexp(std::abs(node.literal), &power);
  auto digits = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  const int zeros = digits == 0 ? 0 : std::countr_zero(digits);
  digits >>= zeros;
  power += zeros - 53;
  const Residue out{modulo(p, 2, digits, power), modulo(m, 2, digits, power)};
  return node.literal < 0.0 ? -out : out;
}

Residue ResiduePoint::parameter(int index) const {
  return symbol(Symbol::parameter, {static_cast<std::uint64_t>(index), 0});
}

Residue ResiduePoint::variable(Variable v) {
  auto& known = variables_[static_cast<std::size_t>(v)];
  if (known) return *known;
  const int index = static_cast<int>(v) - static_cast<int>(Variable::first_parameter);
  known = index >= 0 ? parameter(index) : Residue{next() % p, next() % m};
  return *known;
}

/// g^(the argument modulo m), but x^c for a term c log(x) of it.
Residue ResiduePoint::exponential(NodeId argument) {
  const Node& node = graph_[argument];
  Residue left = *known_[argument];
  Residue powers{1, 1};
  const auto take = [&](NodeId logarithm, const Residue& coefficient) {
    const Node& of = graph_[logarithm];
    if (of.kind != Kind::function || of.function != Function::log) return;
    powers = powers * power(*known_[of.a], coefficient, of.a);
    left = left - (coefficient * *known_[logarithm]);
  };
  take(argument, {1, 1});
  if (node.kind == Kind::sum)
    for (const Term& term : node.terms) take(term.node, *known_[term.coefficient]);
  const Residue out{times(powers.plain, to_power(generator, left.exponent, p), p),
                    symbol(Symbol::exponent_of_function, *known_[argument]).exponent};
  return out;
}

/// Of |x|, of which no more is known.
Residue ResiduePoint::logarithm_symbol(const Residue& x) const {
  return symbol(Symbol::logarithm,
                {std::min(x.plain, minus(x.plain, p)), std::min(x.exponent, minus(x.exponent, m))});
}

/// Of |x|.
Residue ResiduePoint::logarithm(NodeId x) {
  if (logarithms_[x]) return *logarithms_[x];
  const Node& node = graph_[x];
  const Residue& value = *known_[x];
  const auto own = [&](const Residue& of) { return logarithm_symbol(of); };
  Residue out;
  if (value.plain == 0) usable_ = false;
  switch (node.kind) {
    case Kind::euler:
      out = {1, 1};
      break;
    case Kind::coefficient_product:
      out = logarithm(node.a) + logarithm(node.b);
      break;
    case Kind::coefficient_quotient:
      out = logarithm(node.a) - logarithm(node.b);
      break;
    case Kind::power:
      out = *known_[node.b] * logarithm(node.a);
      break;
    case Kind::product:
      for (const Term& factor : node.terms)
        out = out + (Residue{whole(factor.exponent, p), whole(factor.exponent, m)} *
                     logarithm(factor.node));
      break;
    case Kind::sum: {
      // c (x + (c'/c) y + ...): the first coefficient is a factor, whatever it is.
      const NodeId first = node.terms[0].coefficient;
      const Residue rest = quotient(value, *known_[first]);
      const bool alone = node.terms.size() == 1 && graph_.is_zero(node.a);
      out = logarithm(first) + (alone ? logarithm(node.terms[0].node) : own(rest));
      break;
    }
    case Kind::function:
      if (node.function == Function::exp) {
        out = *known_[node.a];
      } else if (node.function == Function::sqrt) {
        out = Residue{half(p), half(m)} * logarithm(node.a);
      } else {
        out = own(value);
      }
      break;
    case Kind::literal:
      out = value.plain == 1 || value.plain == p - 1 ? Residue{} : own(value);
      break;
    default:
      out = own(value);
  }
  logarithms_[x] = out;
  return out;
}

Residue ResiduePoint::applied(Function f, const Residue& x) {
  // Odd and even functions: of the smaller of x and -x.
  const bool negative = x.plain > minus(x.plain, p);
  const Residue size = negative ? -x : x;
  const auto odd = [&](const Residue& of_size) { return negative ? -of_size : of_size; };
  const Residue one{1, 1};
  switch (f) {
    case Function::sin:
    case Function::cos:
    case Function::tan: {
      const bool none = x.plain == 0 && x.exponent == 0;
      const Residue h = none ? Residue{} : symbol(Symbol::half_angle, size);
      const Residue h2 = h * h;
      const Residue below = one + h2;
      const Residue above = one - h2;
      if (f == Function::cos) return quotient(above, below);
      return odd(quotient(h + h, f == Function::sin ? below : above));
    }
    case Function::tanh: {
      // (E - 1)/(E + 1), E = exp(2 x).
      const std::uint64_t e = to_power(generator, add(x.exponent, x.exponent, m), p);
      const std::uint64_t below = add(e, 1, p);
      if (below == 0) usable_ = false;
      return {times(add(e, p - 1, p), inverse(below, p), p),
              odd(symbol(Symbol::exponent_of_function, size)).exponent};
    }
    case Function::atan:
      return odd(symbol(Symbol::arc_tangent, size));
    default:
      return symbol(Symbol::magnitude, size);  // abs
  }
}

Residue ResiduePoint::function(const Node& node) {
  switch (node.function) {
    case Function::exp:
      return exponential(node.a);
    case Function::log:
      return logarithm(node.a);
    case Function::sqrt:
      return power(*known_[node.a], {half(p), half(m)}, node.a);
    default:
      return applied(node.function, *known_[node.a]);
  }
}

Residue ResiduePoint::derivative(const Node& kernel, int n, const Residue& x,
                                 const Residue& exponent) {
  const auto number = [](long k) { return Residue{whole(k, p), whole(k, m)}; };
  switch (kernel.function) {
    case Function::power: {
      Residue out = power(x, exponent + number(-n));
      for (int k = 0; k < n; ++k) out = out * (exponent + number(-k));
      return out;
    }
    case Function::log: {
      if (n == 0) return logarithm_symbol(x);
      Residue out = whole_power(x, -n);
      for (int k = 1; k < n; ++k) out = out * number(-k);
      return out;
    }
    case Function::exp:
      return {to_power(generator, x.exponent, p), symbol(Symbol::exponent_of_function, x).exponent};
    default:
      if (n == 0) return applied(kernel.function, x);
      return symbol(Symbol::kernel, x,
                    {static_cast<std::uint64_t>(n), static_cast<std::uint64_t>(kernel.function)});
  }
}

/// From the values at a +- r, r^2 = y (symmetric_kernel.hpp).
Residue ResiduePoint::kernel(const Node& node) {
  const Residue& a = *known_[node.a];
  const Residue& y = *known_[node.b];
  const Residue& exponent = *known_[node.terms[0].node];
  has_roots_ = true;
  // Roots modulo m are powers too: (m + 1)/4 is whole.
  const Residue r{to_power(y.plain, (p + 1) / 4, p), to_power(y.exponent, (m + 1) / 4, m)};
  if (times(r.plain, r.plain, p) != y.plain || times(r.exponent, r.exponent, m) != y.exponent)
    usable_ = false;
  const Residue plus = a + r;
  const Residue less = a - r;
  const Residue two{2, 2};
  const auto even = [&](int n) {
    return quotient(derivative(node, n, plus, exponent) + derivative(node, n, less, exponent), two);
  };
  const auto odd = [&](int n) {
    return quotient(derivative(node, n, plus, exponent) - derivative(node, n, less, exponent),
                    two * r);
  };
  // O_y = (E[f'] - O)/(2 y),  O_yy = (O[f'']/2 - 3 O_y)/(2 y).
  const auto odd_y = [&](int n) { return quotient(even(n + 1) - odd(n), two * y); };
  const int n = kernel_derivatives(node.index);
  switch (kernel_part(node.index)) {
    case KernelPart::even:
      return even(n);
    case KernelPart::odd:
      return odd(n);
    case KernelPart::odd_y:
      return odd_y(n);
    case KernelPart::odd_yy:
      break;
  }
  return quotient(quotient(odd(n + 2), two) - Residue{3, 3} * odd_y(n), two * y);
}

Residue ResiduePoint::of(NodeId id) {
  const Node& node = graph_[id];
  switch (node.kind) {
    case Kind::literal:
      return literal(node);
    case Kind::parameter:
      return parameter(node.index);
    case Kind::pi:
      return symbol(Symbol::pi, {});
    case Kind::euler:
      return {generator, symbol(Symbol::euler, {}).exponent};
    case Kind::coefficient_sum:
      return *known_[node.a] + *known_[node.b];
    case Kind::coefficient_product:
      return *known_[node.a] * *known_[node.b];
    case Kind::coefficient_quotient:
      return quotient(*known_[node.a], *known_[node.b]);
    case Kind::minimum:
    case Kind::maximum: {
      const auto [a, b] =
          std::minmax(*known_[node.a], *known_[node.b],
                      [](const Residue& x, const Residue& y) { return x.plain < y.plain; });
      return symbol(node.kind == Kind::minimum ? Symbol::minimum : Symbol::maximum, a, b);
    }
    case Kind::function:
      return function(node);
    case Kind::power:
      return power(*known_[node.a], *known_[node.b], node.a);
    case Kind::variable:
      return variable(static_cast<Variable>(node.index));
    case Kind::sum: {
      Residue out = *known_[node.a];
      for (const Term& term : node.terms)
        out = out + (*known_[term.coefficient] * *known_[term.node]);
      return out;
    }
    case Kind::product: {
      Residue out{1, 1};
      for (const Term& factor : node.terms)
        out = out * whole_power(*known_[factor.node], factor.exponent);
      return out;
    }
    case Kind::kernel:
      return kernel(node);
  }
  return {};
}

std::optional<Residue> ResiduePoint::operator()(NodeId x) {
  known_.resize(graph_.size());
  logarithms_.resize(graph_.size());
  const std::array<NodeId, 1> root{x};
  for (const NodeId part : graph_.parts(root)) {
    if (!known_[part]) known_[part] = of(part);
    if (!usable_) return std::nullopt;
  }
  return known_[x];
}

Residues residues(const Graph& graph, NodeId x) {
  // Each point leaves a probability of 1e-12 and less, each sign of a root one half.
  constexpr int enough = 4;
  constexpr int enough_with_roots = 100;
  constexpr int tries = 6400;
  const std::optional<std::vector<NodeId>> roots = roots_of_open_sign(graph, x);
  std::vector<bool> open(graph.size(), false);
  for (const NodeId base : roots.value_or(std::vector<NodeId>())) open[base] = true;
  // As squares have them, and with signs at random: what is 0 so only the first time is 0 but for signs.
  const auto found = [&](const std::vector<bool>* signs) {
    int zero = 0;
    int other = 0;
    int wanted = enough;
    for (int k = 0; k < tries && zero + other < wanted; ++k) {
      ResiduePoint at(graph, static_cast<std::uint64_t>(k) + 20101131U, signs);
      const std::optional<Residue> value = at(x);
      if (!value) continue;
      (value->plain == 0 ? zero : other) += 1;
      if (at.has_roots()) wanted = enough_with_roots;
      if (zero > 0 && other > 0) return Residues::unclear;
      if (other >= enough && zero == 0 && !at.has_roots()) break;
    }
    if (zero == wanted) return Residues::zero;
    return zero == 0 && other >= enough ? Residues::not_zero : Residues::unclear;
  };
  const Residues as_squares = found(nullptr);
  if (as_squares != Residues::zero) return as_squares;
  if (!roots) return Residues::zero_but_for_signs;
  if (roots->empty() || found(&open) == Residues::zero) return Residues::zero;
  return Residues::zero_but_for_signs;
}

}  // namespace stationary::expression
