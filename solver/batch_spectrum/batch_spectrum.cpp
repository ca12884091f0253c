#include "solver/batch_spectrum/batch_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "solver/batch/instruction_sets.hpp"
#include "solver/batch_spectrum/spectrum_tile.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"
#include "solver/solve/stability.hpp"

namespace stationary {
namespace {

/// One call of cell_spectra.
class SpectrumRun {
 public:
  SpectrumRun(const BatchInput& input, const BatchResult& solved, const SpectrumOptions& options)
      : input_(input),
        solved_(solved),
        options_(options),
        kernels_(kernels_for<SpectrumKernels>(options.instructions)),
        first_(input.branch == Branch::ii ? 1 : 0),
        still_(input.branch == Branch::iii ? 2 : 0) {}

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
        take(i, out[i]);
      }
    }
  }

  CellSpectrum alone(const CellPlace& place) {
    ++scalar_;
    if (!problem_ || problem_lane_ != place.lane) {
      anisotropic_.reset();
      problem_.emplace(input_.problem(problem_lane_ = place.lane));
      if (!problem_->potential().is_isotropic()) anisotropic_.emplace(*problem_);
    }
    const BatchCell cell = solved_.cell(place.lane, place.k);
    Equilibrium equilibrium;
    equilibrium.status = cell.status;  // neither takes one that is not solved
    equilibrium.q = {cell.alpha, cell.xi, cell.zeta, cell.rho};
    equilibrium.nu = angular_velocity(input_.branch, input_.speed[place.lane] * input_.nu[place.k]);
    equilibrium.error_bound = cell.error_bound;
    const Spectrum all =
        anisotropic_ ? anisotropic_->at(equilibrium) : stability(*problem_, equilibrium);
    CellSpectrum out;
    out.verdict = all.verdict;
    out.negative = all.negative;
    if (!options_.modes) return out;
    out.growth = all.growth;
    out.modes = all.modes;
    for (std::size_t k = 0; k < static_cast<std::size_t>(all.modes); ++k)
      out.mode[k] = {all.mode[k].re, all.mode[k].im, all.mode[k].krein, all.mode[k].krein_open};
    return out;
  }

  std::size_t scalar() const { return scalar_; }

 private:
  void put(const CellPlace& place, std::size_t i) {
    if (lane_ != place.lane) go_to(place.lane);
    const BatchCell cell = solved_.cell(place.lane, place.k);
    if (cell.status != SolveStatus::solved)
      throw std::invalid_argument("a spectrum needs a solved cell");
    tile_.nu[i] = speed_ * input_.nu[place.k];
    tile_.q[first_][i] = cell.xi;
    tile_.q[1 - first_][i] = cell.zeta;
    tile_.q[2][i] = cell.rho;
    tile_.uncertainty[i] = stretch_uncertainty(cell.error_bound);
    for (std::size_t k = 0; k < 3; ++k) {
      tile_.inertia[k][i] = inertia_[k];
      tile_.pull[k][i] = pull_[k];
    }
    for (std::size_t k = 0; k < 2; ++k) {
      tile_.plane[k][i] = plane_[k];
      tile_.thickness[k][i] = thickness_[k];
    }
  }

  /// What all cells of a lane have in common, of models with two coefficients each.
  void go_to(std::size_t lane) {
    lane_ = lane;
    speed_ = input_.speed[lane];
    inertia_[first_] = input_.inertia[0][lane];
    inertia_[1 - first_] = input_.inertia[1][lane];
    inertia_[2] = input_.inertia[2][lane];
    for (std::size_t k = 0; k < 3; ++k) pull_[k] = k == still_ ? 0.0 : inertia_[k];
    for (std::size_t k = 0; k < 2; ++k) {
      plane_[k] = input_.plane[k][lane];
      thickness_[k] = input_.thickness[k][lane];
    }
  }

  void take(std::size_t i, CellSpectrum& out) const {
    out.verdict = static_cast<StabilityClass>(static_cast<int>(tile_.verdict[i]));
    out.negative = static_cast<int>(tile_.negative[i]);
    out.growth = options_.modes ? tile_.growth[i] : std::numeric_limits<double>::quiet_NaN();
    out.modes = options_.modes ? 5 : 0;
    if (!options_.modes) return;
    for (std::size_t k = 0; k < out.mode.size(); ++k)
      out.mode[k] = {tile_.re[k][i], tile_.im[k][i], static_cast<int>(tile_.krein[k][i])};
  }

  const BatchInput& input_;
  const BatchResult& solved_;
  const SpectrumOptions& options_;
  const SpectrumKernels& kernels_;
  SpectrumTile tile_;
  const std::size_t first_;  ///< of xi: (ii) is (i), 1 and 2 exchanged
  const std::size_t still_;  ///< the stretch along the axis, at which the spin does not pull
  std::size_t lane_ = std::numeric_limits<std::size_t>::max();
  double speed_;
  double inertia_[3];
  double pull_[3];
  double plane_[2];
  double thickness_[2];
  std::optional<Problem> problem_;  ///< of the lane the scalar path was last in
  std::optional<AnisotropicSpectra> anisotropic_;
  std::size_t problem_lane_ = 0;
  std::size_t scalar_ = 0;
};

}  // namespace

std::size_t cell_spectra(const BatchInput& input, const BatchResult& solved,
                         std::span<const CellPlace> places, const SpectrumOptions& options,
                         std::span<CellSpectrum> out) {
  if (places.size() != out.size()) throw std::invalid_argument("one spectrum a place");
  if (!has_instruction_set(options.instructions))
    throw std::invalid_argument("an instruction set of this processor");
  SpectrumRun run(input, solved, options);
  for (std::size_t i = 0; i < places.size(); i += SpectrumTile::size) {
    const std::size_t count = std::min(SpectrumTile::size, places.size() - i);
    if (marches(input.potential)) {
      run.solve(places.subspan(i, count), out.subspan(i, count));
    } else {
      for (std::size_t k = i; k < i + count; ++k) out[k] = run.alone(places[k]);
    }
  }
  return run.scalar();
}

}  // namespace stationary
