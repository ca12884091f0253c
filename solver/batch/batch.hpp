// Many families at once: each lane is a body and potential of its own, all of one branch and the
// same models, and is solved at nu = speed nu_k for every k, on the sheet of its rest state:
//
//   march     from rest through growing |nu|: predictor (a cubic in nu^2) and Newton in packs of
//             lanes (march_kernel.hpp), on the best instruction set of the processor
//   fallback  a lane that cannot be marched on with goes on by the scalar path, Sweep and, where
//             that ends, solve; coupled potentials and expressions take it from the start
//   follow    lanes of an anisotropic potential, alpha an unknown in (iii): each by itself, its nu
//             side by side (anisotropic_batch.hpp)
//
// All correct with a residual in extended precision, so S is rounded correctly; results do not
// depend on the instruction set, on the number of threads or on the other lanes. Every cell has a
// status: solved; none_exists (proven, nonexistence.hpp, or by the search there); not_found (the
// sheet was not followed to this nu, nearly always because it ends before; no statement about other
// sheets); failed (what was found is
// no equilibrium); not_run (stopped).
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "solver/batch/batch_input.hpp"
#include "solver/batch/march.hpp"
#include "solver/solve/solve.hpp"

namespace stationary {

/// The best this processor has.
InstructionSet best_instruction_set();
/// Whether the processor, and this build, have it.
bool has_instruction_set(InstructionSet set);
constexpr std::string_view instruction_set_names[] = {"baseline", "avx2", "avx512"};
constexpr std::string_view name(InstructionSet set) {
  return instruction_set_names[static_cast<int>(set)];
}

struct BatchOptions {
  bool error_bound = true;  ///< false: not touched
  /// false: residuals in double, and S to some units in the last place (the error bound knows).
  bool extended = true;
  int threads = 1;
  InstructionSet instructions = best_instruction_set();
  const std::atomic<bool>* stop = nullptr;  ///< becomes true: what is left has status not_run
  /// Called now and then with the fraction done, by one thread at a time.
  std::function<void(double)> progress = {};
};

struct BatchCell {
  SolveStatus status;
  double alpha;  ///< 0 of every isotropic potential
  double xi;
  double zeta;
  double rho;
  double error_bound;  ///< as Equilibrium::error_bound
};

/// Cells in tiles of `tile` lanes, within a tile by |nu|, then by lane, as they are computed.
class BatchResult {
 public:
  static constexpr std::size_t tile = 16;

  std::size_t lanes() const { return lanes_; }
  /// Numbers of nu, as in the input.
  std::size_t count() const { return slot_.size(); }
  BatchCell cell(std::size_t lane, std::size_t k) const {
    const std::size_t i = index(lane, slot_[k]);
    return {status_[i],
            alpha_.empty() ? 0.0 : alpha_[i],
            xi_[i],
            zeta_[i],
            rho_[i],
            error_bound_.empty() ? std::numeric_limits<double>::quiet_NaN() : error_bound_[i]};
  }
  /// Lanes the scalar path had to go on with; of an anisotropic potential all of them.
  std::size_t fallbacks() const { return fallbacks_; }
  /// Whether a lane is one of these.
  bool fell_back(std::size_t lane) const { return fell_back_[lane] != 0; }

 private:
  friend class BatchRun;
  std::size_t index(std::size_t lane, std::size_t slot) const {
    return ((lane / tile) * slots_ + slot) * tile + lane % tile;
  }

  std::size_t lanes_ = 0;
  std::size_t slots_ = 0;          ///< different |nu|
  std::vector<std::size_t> slot_;  ///< of each nu
  std::size_t fallbacks_ = 0;
  std::vector<unsigned char> fell_back_;  ///< of each lane; bytes, which threads set side by side
  std::vector<double> xi_, zeta_, rho_, error_bound_;
  std::vector<double> alpha_;  ///< empty where it is 0 in every cell
  std::vector<SolveStatus> status_;
};

/// Into a result that may have been used before, whose memory is used again. Throws
/// std::invalid_argument: a nu that is not finite, a body or coefficient outside its domain (with
/// the violated inequality), numbers of lanes that do not fit, an instruction set that is missing.
void solve_batch(const BatchInput& input, const BatchOptions& options, BatchResult& out);

}  // namespace stationary
