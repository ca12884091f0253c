// What is proven of the spectrum of a motion about a tilted axis whose state is known in intervals,
// as spectrum_enclosure.hpp for an axis that is a material one: from the two halves of its second
// variation (tilted_linearization.hpp), their inertias and the roots of det(Lambda + B A).
#pragma once

#include "lib/number/sloped.hpp"
#include "lib/stability/spectrum_enclosure.hpp"
#include "lib/stability/tilted_linearization.hpp"

namespace stationary {

/// material_symmetry: J1 = J2, which forces a zero.
SpectrumEnclosure enclose_tilted_spectrum(const TiltedForms<Interval, 5>& forms,
                                          bool material_symmetry, const Spectrum& approximate);
/// Of a held volume.
SpectrumEnclosure enclose_tilted_spectrum(const TiltedForms<Interval, 4>& forms,
                                          bool material_symmetry, const Spectrum& approximate);
/// Of all motions along a curve.
SpectrumEnclosure enclose_tilted_spectrum(const TiltedForms<Sloped, 5>& forms,
                                          bool material_symmetry, const Spectrum& approximate);
SpectrumEnclosure enclose_tilted_spectrum(const TiltedForms<Sloped, 4>& forms,
                                          bool material_symmetry, const Spectrum& approximate);

}  // namespace stationary
