// A function of the stretches in one form, however it is spelled: with x = (u, v, w) the logarithms
// of xi, zeta and rho,
//
//   sum of  c exp(a.x) u^i v^j w^k  product of N^p, log(N)^m, f(S)^n and exp(q F),
//
// N, S and F sums of the same kind. Products and whole powers are multiplied out, quotients by a
// single term divided, logarithms and powers of single terms taken apart, exponentials merged.
// Every N is normalized: its leading term is 1 or -1, every F: its leading coefficient is 1. What
// the logarithms' sums have in common is found so, and two spellings of one material are one sum.
//
// Numbers are exact (exact_number.hpp).
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "lib/expression/exact_coefficients.hpp"
#include "lib/expression/exact_number.hpp"
#include "lib/expression/graph.hpp"
#include "lib/expression/residue.hpp"
#include "lib/number/interval.hpp"

namespace stationary::expression {

/// What a normal form is made of beside the exponentials of coordinates.
struct Atom {
  enum class Kind : std::uint8_t {
    base,      ///< N, to powers and under logarithms
    exponent,  ///< F, under an exponential
    function   ///< f(S), f none of exp, log and powers
  };
  Kind kind = Kind::base;
  Function function = Function::exp;
  std::vector<struct NormalTerm> sum;
  bool positive = false;  ///< a base under a logarithm or to a power that is not whole: N > 0
};

/// exp(a.x) u^i v^j w^k times powers of atoms.
struct Monomial {
  struct Power {
    int atom = 0;
    ExactNumber exponent;
  };
  struct Factor {
    int atom = 0;      ///< log(N) or f(S)
    int exponent = 0;  ///< > 0
    auto operator<=>(const Factor&) const = default;
  };
  std::array<ExactNumber, 3> a{};
  std::array<int, 3> logarithms{};
  std::vector<Power> powers;    ///< N^p and exp(p F), by atom
  std::vector<Factor> factors;  ///< by atom

  /// exp(a.x) N^p exp(q F) alone.
  bool is_exponential() const { return factors.empty() && logarithms == std::array<int, 3>{}; }
  bool is_constant() const;
};

struct NormalTerm {
  ExactNumber coefficient;
  Monomial monomial;
};
using NormalSum = std::vector<NormalTerm>;

/// Makes normal forms of the nodes of one graph, in xi, zeta and rho as its variables.
class NormalForms {
 public:
  static constexpr std::size_t most_terms = 300;
  static constexpr int largest_power = 8;  ///< of a sum, multiplied out

  /// Of what the roots are made of; parameters: their values. Throws NotNormal.
  NormalForms(const Graph& graph, std::span<const NodeId> roots,
              std::span<const Interval> parameters);

  NormalSum of(NodeId x);
  /// The derivative in coordinate 0, 1 or 2.
  NormalSum derivative(const NormalSum& x, int coordinate);
  NormalSum add(const NormalSum& x, const NormalSum& y) const;

  const std::vector<Atom>& atoms() const { return atoms_; }

  /// Whether the exponents and factors are the same.
  static bool same(const Monomial& x, const Monomial& y) { return compare(x, y) == 0; }
  static std::strong_ordering compare(const Monomial& x, const Monomial& y);

 private:
  NormalSum make(NodeId x);
  NormalSum function(const Node& node);

  static NormalSum constant(const ExactNumber& c);
  static NormalSum coordinate(int j);
  NormalSum multiply(const NormalSum& x, const NormalSum& y);
  NormalSum multiply(const NormalTerm& x, const NormalTerm& y);
  NormalSum whole_power(const NormalSum& x, int n);
  NormalSum power(const NormalSum& x, const ExactNumber& r);
  NormalSum logarithm(const NormalSum& x);
  NormalSum exponential(const NormalSum& x);
  /// Of x > 0: the base that is positive then.
  void note_positive(const NormalSum& x);
  static NormalSum atom_as_sum(int atom);
  /// x as factor * N, N normalized; N none where x is a single exponential.
  struct Normalized {
    NormalTerm factor;
    int base = -1;
  };
  Normalized normalize(const NormalSum& x);
  int intern(Atom atom);
  /// (d/dx_j of the monomial) / (the monomial without what is differentiated), as a sum.
  NormalSum derivative(const NormalTerm& term, int coordinate);
  const NormalSum& atom_derivative(int atom, int coordinate);

  const Graph& graph_;
  ExactCoefficients coefficients_;
  std::vector<Atom> atoms_;
  std::map<std::vector<Residue>, int> known_atoms_;
  std::map<NodeId, NormalSum> known_;
  std::map<std::pair<int, int>, NormalSum> derivatives_;
};

}  // namespace stationary::expression
