// An expression evaluated exactly at a random point, in residues modulo a prime p = 2 m + 1 whose m
// is prime too: what is 0 at many such points is 0 identically.
//
// The squares modulo p are a group of m elements, so that every exponent has a meaning modulo m:
//
//   x^r      of a square x, r modulo m:  x^r x^s = x^(r+s),  (x y)^r = x^r y^r,  sqrt(x)^2 = x
//   exp(x)   g^x, x evaluated modulo m at variables of its own:  exp(x + y) = exp(x) exp(y)
//   log(x)   the sum of the logarithms of the factors of x; of what has none, and whatever its
//            sign, a random residue that depends on |x| alone
//   sin, cos, tan  the rational functions of one random residue;  atan, ...: a random residue each
//
// Each rule holds of the functions themselves wherever both sides are defined, so what is 0 by them
// is 0. A polynomial of degree n that is not 0 vanishes at a random point with a probability of
// n/p, p = 4.6e18 (J. T. Schwartz, J. ACM 27 (1980) 701). That a root of x^2 is x where x is a
// square, and -x elsewhere, stands for the sign of x: half of the points have either. Of a number it
// is the same at all points, and sqrt(n^2) = -n where n is no square; all made of primes up to 43 are. So it is of a
// number times a square, however it is written. Roots of sums and of other numbers (root_signs.hpp) get either sign,
// at random: what is 0 so is 0 whatever their signs are. A power of what is negative, to a parameter that may be whole,
// has a residue nowhere. What is 0 with such powers, or by one sign of a root only, is so but for signs (residues()).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "lib/expression/graph.hpp"

namespace stationary::expression {

/// A number modulo p, and the one modulo m that it is as an exponent.
struct Residue {
  std::uint64_t plain = 0;
  std::uint64_t exponent = 0;

  bool is_zero() const { return plain == 0 && exponent == 0; }
  auto operator<=>(const Residue&) const = default;
};
Residue operator+(const Residue& x, const Residue& y);
Residue operator-(const Residue& x);
Residue operator-(const Residue& x, const Residue& y);
Residue operator*(const Residue& x, const Residue& y);
/// Of a whole number.
Residue residue_of(std::uint64_t n);
/// Nothing where x is 0 modulo p or m.
std::optional<Residue> reciprocal(const Residue& x);
/// A residue that depends on x and y and on nothing else, as random.
Residue symbol(std::uint64_t which, const Residue& x, const Residue& y = {});

/// Stretches and parameters at random: xi, zeta, rho and d squares, and t^2 - 4 d one.
class ResiduePoint {
 public:
  /// open: by node, whether roots of it get a sign at random, the same for the same value; or null: none.
  ResiduePoint(const Graph& graph, std::uint64_t seed, const std::vector<bool>* open = nullptr);

  /// The value of x; nothing where a power is taken of what is no square here, or a division is by
  /// 0.
  std::optional<Residue> operator()(NodeId x);

  /// Whether the values so far hold a root or a power whose sign depends on the point.
  bool has_roots() const { return has_roots_; }

 private:
  enum class Symbol : std::uint8_t;

  void set(Variable v, const Residue& x) { variables_[static_cast<std::size_t>(v)] = x; }
  void choose_stretches();
  std::uint64_t next();
  std::uint64_t next_square();

  Residue symbol(Symbol which, const Residue& x, const Residue& y = {}) const;
  Residue quotient(const Residue& x, const Residue& y);
  Residue whole_power(const Residue& x, int n);
  /// base^exponent, modulo p alone where both are known there; of: the base's node, if it has one.
  Residue power(const Residue& base, const Residue& exponent,
                std::optional<NodeId> of = std::nullopt);
  Residue literal(const Node& node);
  Residue variable(Variable v);
  Residue parameter(int index) const;
  Residue exponential(NodeId argument);
  Residue logarithm_symbol(const Residue& x) const;
  Residue logarithm(NodeId argument);
  Residue function(const Node& node);
  Residue applied(Function f, const Residue& x);
  Residue kernel(const Node& node);
  /// f^(n)(x) of a kernel's function; exponent: of a power.
  Residue derivative(const Node& kernel, int n, const Residue& x, const Residue& exponent);
  Residue of(NodeId id);

  const Graph& graph_;
  std::uint64_t state_;
  std::uint64_t key_;
  std::array<std::optional<Residue>, 256> variables_;
  std::vector<std::optional<Residue>> known_;
  std::vector<std::optional<Residue>> logarithms_;
  const std::vector<bool>* open_;
  bool usable_ = true;
  bool has_roots_ = false;
};

/// What residues say of x at many points.
enum class Residues : std::uint8_t {
  zero,                ///< 0 at all of them: x is 0 but for a probability below 1e-30
  zero_but_for_signs,  ///< likewise, if the roots in it have the signs that they have here
  not_zero,            ///< 0 at none
  unclear              ///< some of either (a root whose sign is not known), or no point was usable
};
Residues residues(const Graph& graph, NodeId x);

}  // namespace stationary::expression
