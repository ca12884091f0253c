#include "lib/stability/tilted_spectrum_enclosure.hpp"

#include <algorithm>

#include "lib/stability/enclosure_collector.hpp"

namespace stationary {
namespace {

template <std::size_t n>
SpectrumEnclosure enclose(const TiltedForms<Interval, n>& forms, bool material_symmetry,
                          const Spectrum& approximate) {
  EnclosureCollector out;
  // The symmetry turns alpha and pi2: det B = 0.
  const auto in_A = negative_directions(forms.A);
  const auto in_B = negative_directions(forms.B, material_symmetry ? n - 1 : n);
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
  IntervalForm<n> minus_BA = product(forms.B, forms.A);
  for (auto& row : minus_BA)
    for (Interval& entry : row) entry = -entry;
  const Polynomial<Interval, n> p{characteristic(minus_BA)};
  if (material_symmetry) {
    out.add_forced_zero();
    Polynomial<Interval, n - 1> rest;
    std::copy(p.c.begin() + 1, p.c.end(), rest.c.begin());
    add(enclose_roots(rest, all_real));
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

}  // namespace

SpectrumEnclosure enclose_tilted_spectrum(const TiltedForms<Interval, 5>& forms,
                                          bool material_symmetry, const Spectrum& approximate) {
  return enclose(forms, material_symmetry, approximate);
}
SpectrumEnclosure enclose_tilted_spectrum(const TiltedForms<Interval, 4>& forms,
                                          bool material_symmetry, const Spectrum& approximate) {
  return enclose(forms, material_symmetry, approximate);
}

}  // namespace stationary
