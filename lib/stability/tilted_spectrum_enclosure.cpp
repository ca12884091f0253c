#include "lib/stability/tilted_spectrum_enclosure.hpp"

#include "lib/stability/enclosure_collector.hpp"
#include "lib/stability/interval_form.hpp"

namespace stationary {
SpectrumEnclosure enclose_tilted_spectrum(const TiltedForms<Interval>& forms,
                                          bool material_symmetry, const Spectrum& approximate) {
  EnclosureCollector out;
  // The symmetry turns alpha and pi2: det B = 0.
  const auto in_A = negative_directions(forms.A);
  const auto in_B = negative_directions(forms.B, material_symmetry ? 4 : 5);
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
  IntervalForm<5> minus_BA = product(forms.B, forms.A);
  for (auto& row : minus_BA)
    for (Interval& entry : row) entry = -entry;
  const Polynomial<Interval, 5> p{characteristic(minus_BA)};
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
