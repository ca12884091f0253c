// One case solved and held against 50 digits: is what the answer claims true?
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "solver/proof/certify.hpp"
#include "tests/stress/judge/hard_case.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary::stress {

struct Outcome {
  SolveStatus status = SolveStatus::not_run;
  std::string fault;  ///< the first claim that is not true, with the case; empty: none

  /// Of a solved one.
  std::array<testing::Number50, 3> exact{};  ///< xi, zeta, rho
  double error = 0.0;                        ///< relative, largest of xi, zeta, rho
  double error_bound = 1.0;                  ///< of it; below it: the bound does not hold
  double units = 0.0;            ///< error in units in the last place, largest of the three
  double mode_over_bound = 0.0;  ///< |change of Lambda| / lambda_error, largest of the modes
  bool marginal = false;         ///< no class was claimed
  bool wrong_class = false;      ///< the class claimed is not the one decided in 50 digits
  bool wrong_sheet = false;      ///< said to be connected to rest, and continuation ends elsewhere
  bool certified = false;        ///< error bound and existence proven
  std::optional<StabilityClass> proven_class;
  bool wrong_proof = false;  ///< the proven bound or class does not hold
  bool not_finite = false;   ///< a NaN or infinity where a number was promised

  /// Of any other.
  bool wrong_absence = false;  ///< none_exists, and the exhaustive search proves that one does
  bool overlooked = false;     ///< not_found, likewise: no false claim

  long work = 0;  ///< evaluations, of whatever kind
};

Outcome judged(const HardCase& c);

/// Evaluations in all.
long work(const Counts& counts);

/// The parts of a verdict, for motions of other families. The stretches against 50 digits:
void judge_stretch(const std::array<testing::Number50, 3>& exact, const std::array<double, 3>& x,
                   double error_bound, const std::string& text, Outcome& out);

/// Error and class against what is proven of them; after judge_stretch(). `enclose` is asked only
/// where the certificate is proven.
void judge_by_proof(const Certificate& certificate, const Spectrum& spectrum,
                    const std::function<SpectrumEnclosure()>& enclose, const std::string& text,
                    Outcome& out);

}  // namespace stationary::stress
