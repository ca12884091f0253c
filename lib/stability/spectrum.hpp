// Eigenvalues s = +-sqrt(Lambda) of the linearized dynamics at a stationary ellipsoid, what they
// and the second variation of E = H - kappa |pi|^2/2 say of its stability.
//
//   stable       E'' definite (positive) on the leaf, reduced by the material symmetry where
//                J1 = J2; on the circle of (iii) also where E'' + c (P -+ |pi|)'' is, P the
//                material momentum
//   elliptic     all eigenvalues imaginary and semisimple, E'' indefinite: spectrally stable only
//   unstable     a real pair (also where a quadruple is present)
//   oscillatory  a complex quadruple, no real pair
//   marginal     the error bounds do not decide: a Lambda not forced to zero contains zero, or
//                two of one block that may leave the axis, of opposite signature where they are
//                imaginary, cannot be told apart
//
// A class is a claim: it is made only where the bound of every Lambda supports it. Zeros that a
// symmetry forces are exactly zero and no obstacle. Krein signature: sign of E'' on an imaginary
// mode.
#pragma once

#include <array>
#include <string_view>

#include "lib/number/first_order_bound.hpp"
#include "lib/stability/linearization.hpp"

namespace stationary {

enum class StabilityClass { stable, elliptic, unstable, oscillatory, marginal };
constexpr std::string_view stability_names[] = {"stable", "elliptic", "unstable", "oscillatory",
                                                "marginal"};
constexpr std::string_view name(StabilityClass c) { return stability_names[static_cast<int>(c)]; }

/// What a mode moves; modes of different blocks do not see each other.
enum class Block {
  even,       ///< xi, zeta (rho where coupled; in (iii) alpha too)
  odd,        ///< the axis: alpha and two of pi in (i), (ii), pi1 and pi2 in (iii)
  thickness,  ///< rho alone, of a separable V in (iii)
  shear       ///< on the circle of (iii): alpha, xi - zeta
};

/// One representative s = re + i im of a +- pair, re >= 0, im >= 0; a quadruple fills two modes.
struct Mode {
  double re = 0.0;
  double im = 0.0;
  int krein = 0;            ///< +1, -1; 0: not imaginary, or zero
  bool krein_open = false;  ///< imaginary as it stands here, but its signature is not certain
  double lambda_re = 0.0;
  double lambda_im = 0.0;     ///< >= 0
  double lambda_error = 0.0;  ///< bound of |change in Lambda|; 0 where forced
  bool forced_zero = false;   ///< a symmetry's
  Block block = Block::even;
};

struct Spectrum {
  StabilityClass verdict = StabilityClass::marginal;
  double growth = 0.0;  ///< largest real part, of a marginal one of what grows for certain
  /// Negative directions of E'' on the leaf, which has two dimensions a mode.
  int negative = 0;
  int modes = 0;  ///< 5; 4 at nu = 0; two-polar 4, 3 at s3 = 0; one less of a held volume
  std::array<Mode, 5> mode;  ///< ascending in im, then re

  /// Whether no Lambda but a symmetry's can be zero: then `negative` is certain, but where J1 = J2 in (i)
  /// and (ii) near I1 = I3, I2 = I3, whose sign is in no Lambda.
  bool away_from_zero() const;
};

/// What a block path needs beside the state.
struct BlockFacts {
  Branch branch;
  bool material_symmetry;  ///< J1 = J2 and V isotropic
  bool rho_coupled;        ///< V_xr or V_zr not identically zero; unused where the volume is held
  /// Relative uncertainty of every input of the Conditioned state (q, nu, J, coefficients): the
  /// larger of the equilibrium's error bound and 2^-53.
  double uncertainty;
  bool isotropic = true;     ///< else V is bound to the material axes, as gravity with J1 != J2
  bool volume_held = false;  ///< det S: the state's V along it, of which xi and zeta are left
};

/// From the same state in extended precision (values) and with its conditioning (bounds).
/// alpha = 0, V even in alpha. nu = 0 is taken from omega == 0.
Spectrum block_spectrum(const BlockFacts& facts, const StraightState<DoubleDouble>& state,
                        const StraightState<Conditioned>& conditioned);

/// Two-polar family, lambda != mu, on its 8-dimensional leaf (|s| and p_theta fixed; 6 where s3 is
/// exactly 0, with no wobble): four modes (three). theta_dot as an input of each computation.
Spectrum two_polar_spectrum(const StraightState<DoubleDouble>& state, const DoubleDouble& theta_dot,
                            const StraightState<Conditioned>& conditioned,
                            const Conditioned& theta_dot_conditioned, double s3, double uncertainty,
                            bool volume_held = false);

}  // namespace stationary
