// Power series in three variables, cut after a total order: value and all partial derivatives of a
// function of three numbers, carried through + - * / and sqrt,
//
//   f = sum c_ijk u^i v^j w^k,  i + j + k <= order,   c_ijk = d^(i+j+k) f / (i! j! k!).
//
// Products drop what is of higher order; quotient and root are solved for order by order.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "lib/number/interval.hpp"
#include "lib/number/number.hpp"

namespace stationary {

/// The exponents of a monomial.
struct Powers {
  int i = 0;
  int j = 0;
  int k = 0;

  constexpr int total() const { return i + j + k; }
  friend constexpr bool operator==(const Powers&, const Powers&) = default;
};

/// The monomials up to an order, lower ones first.
template <int order>
struct Monomials {
  static constexpr std::size_t count =
      std::size_t((order + 1) * (order + 2) * (order + 3)) / std::size_t{6};
  static constexpr std::array<Powers, count> powers = [] {
    std::array<Powers, count> out{};
    std::size_t n = 0;
    for (int total = 0; total <= order; ++total)
      for (int i = total; i >= 0; --i)
        for (int j = total - i; j >= 0; --j) out[n++] = {i, j, total - i - j};
    return out;
  }();
  /// Lower orders stand at the same places in every longer list.
  static constexpr std::size_t place(const Powers& p) {
    const auto total = static_cast<std::size_t>(p.total());
    const auto beside = static_cast<std::size_t>(p.j + p.k);  // total - i
    return total * (total + 1) * (total + 2) / 6 + beside * (beside + 1) / 2 +
           static_cast<std::size_t>(p.k);
  }
  /// Pairs of places whose product is of the order or below: product += x[a] y[b]; those of one
  /// product together, from first_pair[product] on.
  struct Pair {
    std::size_t a;
    std::size_t b;
    std::size_t product;
  };
  static constexpr std::size_t pair_count = [] {
    std::size_t n = 0;
    for (const Powers& a : powers)
      for (const Powers& b : powers)
        if (a.total() + b.total() <= order) ++n;
    return n;
  }();
  static constexpr std::size_t product_of(const Powers& a, const Powers& b) {
    return place({a.i + b.i, a.j + b.j, a.k + b.k});
  }
  static constexpr std::array<std::size_t, count + 1> first_pair = [] {
    std::array<std::size_t, count + 1> out{};
    for (const Powers& a : powers)
      for (const Powers& b : powers)
        if (a.total() + b.total() <= order) ++out[product_of(a, b) + 1];
    for (std::size_t n = 0; n < count; ++n) out[n + 1] += out[n];
    return out;
  }();
  static constexpr std::array<Pair, pair_count> pairs = [] {
    std::array<Pair, pair_count> out{};
    std::array<std::size_t, count + 1> next = first_pair;
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = 0; b < count; ++b) {
        if (powers[a].total() + powers[b].total() > order) continue;
        const std::size_t product = product_of(powers[a], powers[b]);
        out[next[product]++] = {a, b, product};
      }
    }
    return out;
  }();
};

template <class S, int order>
struct PowerSeries {
  using List = Monomials<order>;
  std::array<S, List::count> c;

  PowerSeries() { c.fill(S(0.0)); }
  explicit PowerSeries(const S& constant) : PowerSeries() { c[0] = constant; }
  /// x + the variable number `which`.
  static PowerSeries variable(const S& x, int which) {
    PowerSeries out(x);
    if constexpr (order > 0) out.c[1 + std::size_t(which)] = S(1.0);
    return out;
  }

  const S& value() const { return c[0]; }
  /// The partial derivative.
  S derivative(const Powers& p) const {
    double factorials = 1.0;
    for (const int n : {p.i, p.j, p.k})
      for (int m = 2; m <= n; ++m) factorials *= m;
    const S& coefficient = c[List::place(p)];
    return factorials == 1.0 ? coefficient : S(factorials * coefficient);
  }
  /// Without its constant.
  PowerSeries nilpotent() const {
    PowerSeries out = *this;
    out.c[0] = S(0.0);
    return out;
  }

  friend PowerSeries operator+(PowerSeries x, const PowerSeries& y) {
    for (std::size_t n = 0; n < x.c.size(); ++n) x.c[n] = x.c[n] + y.c[n];
    return x;
  }
  friend PowerSeries operator-(PowerSeries x, const PowerSeries& y) {
    for (std::size_t n = 0; n < x.c.size(); ++n) x.c[n] = x.c[n] - y.c[n];
    return x;
  }
  friend PowerSeries operator*(double a, PowerSeries x) {
    for (S& each : x.c) each = a * each;
    return x;
  }
  friend PowerSeries operator*(const S& a, PowerSeries x) requires(!std::is_same_v<S, double>) {
    for (S& each : x.c) each = a * each;
    return x;
  }
  friend PowerSeries operator*(const PowerSeries& x, const PowerSeries& y) {
    PowerSeries out;
    for (std::size_t n = 0; n < List::count; ++n)
      out.c[n] = sum_of_products(x, y, List::first_pair[n], List::first_pair[n + 1]);
    return out;
  }
  /// 1/x, x != 0.
  friend PowerSeries reciprocal(const PowerSeries& x) {
    PowerSeries out(S(1.0) / x.c[0]);
    // Of each product the first pair has place 0 of x: what is solved for.
    for (std::size_t n = 1; n < List::count; ++n)
      out.c[n] =
          -(out.c[0] * sum_of_products(x, out, List::first_pair[n] + 1, List::first_pair[n + 1]));
    return out;
  }
  /// Of a positive x.
  friend PowerSeries sqrt(const PowerSeries& x) {
    using std::sqrt;
    PowerSeries out(sqrt(x.c[0]));
    const S half = S(0.5) / out.c[0];
    for (std::size_t n = 1; n < List::count; ++n) {
      if constexpr (std::is_same_v<S, Interval>) {
        IntervalSum sum(x.c[n]);
        for_pairs(n, [&](std::size_t a, std::size_t b) {  // each product once
          if (a == 0 || b < a) return;
          const double times = a == b ? -1.0 : -2.0;  // exact
          sum.add_product({times * out.c[a].hi, times * out.c[a].lo}, out.c[b]);
        });
        out.c[n] = half * sum.value();
      } else {
        S sum = x.c[n];
        for_pairs(n, [&](std::size_t a, std::size_t b) {
          if (a != 0 && b != 0) sum = sum - out.c[a] * out.c[b];
        });
        out.c[n] = half * sum;
      }
    }
    return out;
  }

 private:
  /// Of these pairs, one at least.
  static S sum_of_products(const PowerSeries& x, const PowerSeries& y, std::size_t first,
                           std::size_t end) {
    if constexpr (std::is_same_v<S, Interval>) {
      IntervalSum sum;
      for (std::size_t k = first; k < end; ++k)
        sum.add_product(x.c[List::pairs[k].a], y.c[List::pairs[k].b]);
      return sum.value();
    } else {
      const auto product = [&](std::size_t k) {
        return S(x.c[List::pairs[k].a] * y.c[List::pairs[k].b]);
      };
      S sum = product(first);
      for (std::size_t k = first + 1; k < end; ++k) sum = sum + product(k);
      return sum;
    }
  }
  /// f(a, b) of the pairs whose product is coefficient n.
  template <class F>
  static void for_pairs(std::size_t n, const F& f) {
    for (std::size_t k = List::first_pair[n]; k < List::first_pair[n + 1]; ++k)
      f(List::pairs[k].a, List::pairs[k].b);
  }
};

}  // namespace stationary
