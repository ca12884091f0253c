#include "lib/stability/tilted_spectrum_enclosure.hpp"

#include <algorithm>

#include "lib/stability/enclosure_collector.hpp"

namespace stationary {
namespace {

template <std::size_t n>
std::array<Interval, n + 1> coefficients(const SquareForm<Interval, n>& M) {
  return characteristic(M);
}
template <std::size_t n>
std::array<Sloped, n + 1> coefficients(const SquareForm<Sloped, n>& M) {
  return CharacteristicRecursion<Sloped, n>(M, /*even=*/false).c;
}

/// Whether p, c_D = 1, is shown to have D different roots below 0, by its signs at 0 and between the roots of
/// its middle. In S terms that vary alike cancel there, which in the roots' enclosures they do not.
template <class S, int D>
bool has_negative_roots(const Polynomial<S, D>& p, bool positive_at_0) {
  std::array<double, D> near;
  std::size_t k = 0;
  for (const std::complex<double>& root : middle_roots(ranges(p))) {
    if (root.imag() != 0.0) return false;
    near[k++] = root.real();
  }
  std::ranges::sort(near);
  const auto has_sign = [&](double z, bool positive) {
    S value = p.c[D];
    for (std::size_t i = D; i-- > 0;) value = z * value + p.c[i];
    return positive ? range(value).positive() : range(value).negative();
  };
  if (!positive_at_0 && !has_sign(0.0, true)) return false;
  for (std::size_t i = 1; i < D; ++i) {
    const double between = 0.5 * (near[i - 1] + near[i]);
    if (!(between < 0.0) || !has_sign(between, (D - i) % 2 == 0)) return false;
  }
  return true;
}

template <class S, std::size_t n>
SpectrumEnclosure enclose(const TiltedForms<S, n>& forms, bool material_symmetry,
                          const Spectrum& approximate) {
  EnclosureCollector out;
  // The symmetry turns alpha and pi2: det B = 0.
  S det_A(0.0);
  S det_B(0.0);
  const auto in_A = negative_directions(forms.A, n, &det_A);
  const auto in_B = negative_directions(forms.B, material_symmetry ? n - 1 : n, &det_B);
  out.negative.add(in_A);
  out.negative.add(in_B);
  // Definite but for the direction of the symmetry, which the reduced leaf leaves out.
  const bool definite = in_A == 0 && in_B == 0;
  if (definite && !material_symmetry) out.set_definite();
  // Without negative directions in one of them -B A has the eigenvalues of a symmetric matrix, as many
  // of them positive as the other has; of a semidefinite B perhaps one fewer. Else det B A tells whether
  // their number is odd.
  const bool all_real = in_A == 0 || in_B == 0;
  bool even = false;
  if (in_A && in_B) {
    const bool odd = !material_symmetry && (*in_A + *in_B) % 2 == 1;
    even = !material_symmetry && !odd;
    const bool some = in_A == 0 ? *in_B > 0 : in_B == 0 && *in_A > (material_symmetry ? 1 : 0);
    if (odd || some) out.set_growing();
  }
  const auto add = [&](const auto& polynomial) {
    const auto in_ranges = ranges(polynomial);
    const int told = sign_of_roots(in_ranges, all_real);
    if (told > 0) out.set_growing();
    const bool below = told < 0 || has_negative_roots(polynomial, even);
    const int krein = definite ? 1 : unknown;
    for (const RootEnclosure& root : enclose_roots(in_ranges, all_real)) {
      if (below) {
        out.add_of_sign(root.z.re, -1, krein);
      } else {
        out.add(root, krein, definite);
      }
    }
  };
  SquareForm<S, n> minus_BA = product(forms.B, forms.A);
  for (auto& row : minus_BA)
    for (S& entry : row) entry = -entry;
  auto c = coefficients(minus_BA);
  // In the recursion most of it cancels.
  if (const S of_pivots = det_A * det_B;
      in_A && in_B && !material_symmetry && range(of_pivots).width() < range(c[0]).width())
    c[0] = of_pivots;
  if (material_symmetry) {
    out.add_forced_zero();
    Polynomial<S, n - 1> rest;
    std::copy(c.begin() + 1, c.end(), rest.c.begin());
    add(rest);
  } else {
    add(Polynomial<S, n>{c});
  }
  const int negative = out.negative.total().value_or(0);
  if (negative > (material_symmetry ? 1 : 0)) out.set_indefinite();
  // Imaginary modes have two negative directions each or none: a single one is the direction
  // conjugate to the symmetry, which the reduced leaf leaves out.
  if (material_symmetry && negative == 1) out.set_definite_with_momentum();
  return out.finish(approximate);
}

}  // namespace

SpectrumEnclosure enclose_tilted_spectrum(const TiltedForms<Interval, 5>& forms,
                                          bool material_symmetry, const Spectrum& approximate) {
  return enclose(forms, material_symmetry, approximate);
}
SpectrumEnclosure enclose_tilted_spectrum(const TiltedForms<Interval, 4>& forms,
                                          bool material_symmetry, const Spectrum& approximate) {
  return enclose(forms, material_symmetry, approximate);
}
SpectrumEnclosure enclose_tilted_spectrum(const TiltedForms<Sloped, 5>& forms,
                                          bool material_symmetry, const Spectrum& approximate) {
  return enclose(forms, material_symmetry, approximate);
}
SpectrumEnclosure enclose_tilted_spectrum(const TiltedForms<Sloped, 4>& forms,
                                          bool material_symmetry, const Spectrum& approximate) {
  return enclose(forms, material_symmetry, approximate);
}

}  // namespace stationary
