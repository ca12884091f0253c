// Spectra of a solved batch's cells, in SIMD lanes (spectrum_kernel.hpp) on the batch's instruction
// sets: the class and the negative directions of each, and where they are asked for its modes.
//
// A class is claimed as by stability() (stability.hpp): in lanes only where every sign it rests on
// is certain 2^10 times over, and where one is not that cell is given to stability() itself. Class,
// negative and Krein signatures are therefore those of stability(); re, im and growth agree to the
// last places. Nothing depends on the instruction set or on which cells are asked for together.
// Cells of coupled and of anisotropic potentials and at nu = 0 take the scalar path.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include "lib/stability/spectrum.hpp"
#include "solver/batch/batch.hpp"

namespace stationary {

struct CellPlace {
  std::size_t lane;
  std::size_t k;  ///< of nu, as in BatchResult::cell()
};

struct CellMode {
  double re;
  double im;
  int krein;
  bool krein_open = false;  ///< as Mode::krein_open
};

/// As Spectrum has them; growth NaN and no modes where they were not asked for.
struct CellSpectrum {
  StabilityClass verdict = StabilityClass::marginal;
  double growth = std::numeric_limits<double>::quiet_NaN();
  int negative = 0;
  int modes = 0;
  std::array<CellMode, 5> mode;
};

struct SpectrumOptions {
  bool modes = true;  ///< false: class and negative directions only, a third of the work
  InstructionSet instructions = best_instruction_set();
};

/// One spectrum a place into out, as many; returns how many the scalar path had to make. Throws
/// std::invalid_argument: sizes that differ, a cell that is not solved, an instruction set that is
/// missing. Places near each other in one lane are cheapest.
std::size_t cell_spectra(const BatchInput& input, const BatchResult& solved,
                         std::span<const CellPlace> places, const SpectrumOptions& options,
                         std::span<CellSpectrum> out);

}  // namespace stationary
