#include "solver/batch_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "solver/spectrum_tile.hpp"
#include "solver/stability.hpp"

namespace stationary {
namespace {

const SpectrumKernels& spectrum_kernels(InstructionSet set) {
#ifdef STATIONARY_X86
  if (set == InstructionSet::avx512) return spectrum_kernels_avx512();
  if (set == InstructionSet::avx2) return spectrum_kernels_avx2();
#endif
  (void)set;
  return spectrum_kernels_baseline();
}

double uncertainty_of(const BatchCell& cell) {
  return std::isnan(cell.error_bound) ? 1e-15 : std::max(cell.error_bound, 0x1p-53);
}

/// One call of cell_spectra.
class SpectrumRun {
 public:
  SpectrumRun(const BatchInput& input, const BatchResult& solved, const SpectrumOptions& options)
      : input_(input),
        solved_(solved),
        options_(options),
        kernels_(spectrum_kernels(options.instructions)) {}

  /// At most SpectrumTile::size of them, in lanes.
  void solve(std::span<const CellPlace> places, std::span<CellSpectrum> out) {
    for (std::size_t i = 0; i < SpectrumTile::size; ++i)
      put(places[std::min(i, places.size() - 1)], i);
    kernels_.plane[input_.potential.plane().index()](tile_, options_.modes);
    kernels_.thickness[input_.potential.thickness().index()](tile_, options_.modes);
    (input_.branch == Branch::iii ? kernels_.normal : kernels_.in_plane)(tile_, options_.modes);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (tile_.verdict[i] < 0.0) {
        out[i] = alone(places[i]);
      } else {
        out[i] = taken(i);
      }
    }
  }

  CellSpectrum alone(const CellPlace& place) {
    ++scalar_;
    if (!problem_ || lane_ != place.lane) problem_.emplace(input_.problem(lane_ = place.lane));
    const BatchCell cell = solved_.cell(place.lane, place.k);
    Equilibrium equilibrium;
    equilibrium.status = SolveStatus::solved;
    equilibrium.q = {0.0, cell.xi, cell.zeta, cell.rho};
    equilibrium.nu =
        angular_velocity(input_.branch, input_.speed[place.lane] * input_.nu[place.k]);
    equilibrium.error_bound = cell.error_bound;
    const Spectrum all = stability(*problem_, equilibrium);
    CellSpectrum out;
    out.verdict = all.verdict;
    out.negative = all.negative;
    if (!options_.modes) return out;
    out.growth = all.growth;
    out.modes = all.modes;
    for (std::size_t k = 0; k < static_cast<std::size_t>(all.modes); ++k)
      out.mode[k] = {all.mode[k].re, all.mode[k].im, all.mode[k].krein};
    return out;
  }

  std::size_t scalar() const { return scalar_; }

 private:
  void put(const CellPlace& place, std::size_t i) {
    const BatchCell cell = solved_.cell(place.lane, place.k);
    const Branch branch = input_.branch;
    const std::size_t first = branch == Branch::ii ? 1 : 0;  // (ii) is (i), 1 and 2 exchanged
    tile_.nu[i] = input_.speed[place.lane] * input_.nu[place.k];
    tile_.q[first][i] = cell.xi;
    tile_.q[1 - first][i] = cell.zeta;
    tile_.q[2][i] = cell.rho;
    tile_.uncertainty[i] = uncertainty_of(cell);
    tile_.inertia[first][i] = input_.inertia[0][place.lane];
    tile_.inertia[1 - first][i] = input_.inertia[1][place.lane];
    tile_.inertia[2][i] = input_.inertia[2][place.lane];
    const std::size_t still = branch == Branch::iii ? 2 : 0;
    for (std::size_t k = 0; k < 3; ++k)
      tile_.pull[k][i] = k == still ? 0.0 : tile_.inertia[k][i];
    for (std::size_t k = 0; k < 2; ++k) {
      tile_.plane[k][i] = input_.plane[k][place.lane];
      tile_.thickness[k][i] = input_.thickness[k][place.lane];
    }
  }

  CellSpectrum taken(std::size_t i) const {
    CellSpectrum out;
    out.verdict = static_cast<StabilityClass>(static_cast<int>(tile_.verdict[i]));
    out.negative = static_cast<int>(tile_.negative[i]);
    if (!options_.modes) return out;
    out.growth = tile_.growth[i];
    out.modes = 5;
    for (std::size_t k = 0; k < out.mode.size(); ++k)
      out.mode[k] = {tile_.re[k][i], tile_.im[k][i], static_cast<int>(tile_.krein[k][i])};
    return out;
  }

  const BatchInput& input_;
  const BatchResult& solved_;
  const SpectrumOptions& options_;
  const SpectrumKernels& kernels_;
  SpectrumTile tile_;
  std::optional<Problem> problem_;
  std::size_t lane_ = 0;
  std::size_t scalar_ = 0;
};

}  // namespace

std::size_t cell_spectra(const BatchInput& input, const BatchResult& solved,
                         std::span<const CellPlace> places, const SpectrumOptions& options,
                         std::span<CellSpectrum> out) {
  if (places.size() != out.size()) throw std::invalid_argument("one spectrum a place");
  if (!has_instruction_set(options.instructions))
    throw std::invalid_argument("an instruction set of this processor");
  for (const CellPlace& place : places)
    if (solved.cell(place.lane, place.k).status != SolveStatus::solved)
      throw std::invalid_argument("a spectrum needs a solved cell");
  SpectrumRun run(input, solved, options);
  for (std::size_t i = 0; i < places.size(); i += SpectrumTile::size) {
    const std::size_t count = std::min(SpectrumTile::size, places.size() - i);
    if (input.potential.is_separable()) {
      run.solve(places.subspan(i, count), out.subspan(i, count));
    } else {
      for (std::size_t k = i; k < i + count; ++k) out[k] = run.alone(places[k]);
    }
  }
  return run.scalar();
}

}  // namespace stationary
