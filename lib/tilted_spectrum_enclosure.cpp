#include "lib/tilted_spectrum_enclosure.hpp"

#include <array>
#include <cstddef>

#include "lib/enclosure_collector.hpp"

namespace stationary {
namespace {

Form5<Interval> product(const Form5<Interval>& x, const Form5<Interval>& y) {
  Form5<Interval> out;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < 5; ++j)
      for (std::size_t k = 0; k < 5; ++k) out[i][j] += x[i][k] * y[k][j];
  return out;
}

/// det(Lambda + M) by the recursion of U. J. J. Leverrier and D. K. Faddeev,
///   N_k = M (e_{k-1} - N_{k-1}),  e_k = tr N_k/k,  e_0 = 1, N_0 = 0.
Polynomial<Interval, 5> characteristic(const Form5<Interval>& M) {
  Polynomial<Interval, 5> out;
  out.c[5] = 1.0;
  Form5<Interval> N{};
  for (std::size_t k = 1; k <= 5; ++k) {
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = 0; j < 5; ++j)
        N[i][j] = (i == j ? out.c[6 - k] : Interval(0.0)) - N[i][j];
    N = product(M, N);
    Interval trace;
    for (std::size_t i = 0; i < 5; ++i) trace += N[i][i];
    out.c[5 - k] = trace / static_cast<double>(k);
  }
  return out;
}

/// Negative pivots of the first `pivots` eliminations in an order: the negative eigenvalues, by
/// Sylvester's law, of a form whose remaining ones are zero.
std::optional<int> negative_pivots(Form5<Interval> F, const std::array<std::size_t, 5>& order,
                                   std::size_t pivots) {
  int count = 0;
  for (std::size_t a = 0; a < pivots; ++a) {
    const std::size_t k = order[a];
    const int sign = proven_sign(F[k][k]);
    if (sign == unknown) return std::nullopt;
    count += sign < 0;
    for (std::size_t b = a + 1; b < 5; ++b)
      for (std::size_t c = a + 1; c < 5; ++c)
        F[order[b]][order[c]] -= F[order[b]][k] * F[k][order[c]] / F[k][k];
  }
  return count;
}

}  // namespace

SpectrumEnclosure enclose_tilted_spectrum(const TiltedForms<Interval>& forms,
                                          bool material_symmetry, const Spectrum& approximate) {
  EnclosureCollector out;
  // The kinetic entries first: they are positive. The symmetry turns alpha and pi2: det B = 0.
  const auto in_A = negative_pivots(forms.A, {4, 1, 2, 3, 0}, 5);
  const auto in_B = negative_pivots(forms.B, {1, 2, 3, 0, 4}, material_symmetry ? 4 : 5);
  out.negative.add(in_A);
  out.negative.add(in_B);
  // Definite but for the direction of the symmetry, which the reduced leaf leaves out.
  const bool definite = in_A == 0 && in_B == 0;
  if (definite && !material_symmetry) out.set_definite();
  // Without negative directions in one of them B A has the eigenvalues of a symmetric matrix.
  const bool all_real = in_A == 0 || in_B == 0;
  const auto add = [&](const auto& roots) {
    for (const RootEnclosure& root : roots) out.add(root, definite ? 1 : unknown, definite);
  };
  Polynomial<Interval, 5> p = characteristic(product(forms.B, forms.A));
  if (material_symmetry) {
    out.add_forced_zero();
    add(enclose_roots(Polynomial<Interval, 4>{{p.c[1], p.c[2], p.c[3], p.c[4], p.c[5]}}, all_real));
  } else {
    add(enclose_roots(p, all_real));
  }
  const int negative = out.negative.total().value_or(0);
  if (negative > (material_symmetry ? 1 : 0)) out.set_indefinite();
  // Imaginary modes have two negative directions each or none: a single one is the direction
  // conjugate to the symmetry, which the reduced leaf leaves out.
  if (material_symmetry && negative == 1) out.set_definite_with_momentum();
  return out.finish(approximate);
}

}  // namespace stationary
