#include "solver/batch/batch.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include "solver/batch/anisotropic_batch.hpp"
#include "solver/batch/instruction_sets.hpp"
#include "solver/batch/march_plan.hpp"
#include "solver/batch/sweep.hpp"
#include "solver/newton/available_threads.hpp"
#include "solver/newton/thread_arena.hpp"
#include "solver/solve/nonexistence.hpp"

namespace stationary {
namespace {

void require_valid(const BatchInput& input, const BatchOptions& options) {
  require_valid(input);
  if (!has_instruction_set(options.instructions))
    throw std::invalid_argument("an instruction set of this processor");
  if (options.threads < 1) throw std::invalid_argument("threads >= 1");
}

/// The rest state, to double precision: where a sweep starts.
Equilibrium rest_state(const Problem& problem) {
  Equilibrium out;
  out.status = SolveStatus::solved;
  out.nu = angular_velocity(problem.branch(), 0.0);
  problem.potential().visit([&](const auto& model) {
    if constexpr (requires { model.plane; }) {
      const double r = model.plane.rest_stretch();
      out.q = {0.0, r, r, model.thickness.balanced(DoubleDouble(0.0))};
    } else {
      out.q = rest_stretch_of(model);
    }
  });
  return out;
}

/// The numbers of one tile's lanes side by side; lanes beyond the last are copies of it.
struct TileNumbers {
  static constexpr std::size_t size = BatchResult::tile;
  double speed[size];
  double inertia[3][size];
  double plane[2][size];
  double thickness[2][size];
  double rest[size];
  double rest_thickness[size];
  double none[size] = {};

  TileNumbers(const BatchInput& input, std::size_t first) {
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t lane = std::min(first + i, input.lanes - 1);
      speed[i] = input.speed[lane];
      for (std::size_t k = 0; k < 3; ++k) inertia[k][i] = input.inertia[k][lane];
      for (std::size_t k = 0; k < 2; ++k) {
        plane[k][i] = input.plane[k][lane];
        thickness[k][i] = input.thickness[k][lane];
      }
    }
    const auto rest_of = [&](const auto& variant, const double(&values)[2][size], double* out,
                             auto rest_value) {
      std::visit(
          [&](const auto& m) {
            using Model = std::decay_t<decltype(m)>;
            for (std::size_t i = 0; i < size; ++i)
              out[i] = rest_value(Model{values[0][i], values[1][i]});
          },
          variant);
    };
    rest_of(input.potential.plane(), plane, rest, [](const auto& m) { return m.rest_stretch(); });
    rest_of(input.potential.thickness(), thickness, rest_thickness,
            [](const auto& m) { return m.balanced(DoubleDouble(0.0)); });
  }

  /// J where the spin pulls at this stretch, else 0.
  const double* pulling(Branch branch, int stretch) const {
    const bool pulls = branch == Branch::i    ? stretch != 0
                       : branch == Branch::ii ? stretch != 1
                                              : stretch != 2;
    return pulls ? inertia[stretch] : none;
  }
};

}  // namespace

bool has_instruction_set(InstructionSet set) {
#ifdef STATIONARY_X86
  if (set == InstructionSet::avx2)
    return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  if (set == InstructionSet::avx512)
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0;
#endif
  return set == InstructionSet::baseline;
}

InstructionSet best_instruction_set() {
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2})
    if (has_instruction_set(set)) return set;
  return InstructionSet::baseline;
}

/// One call of solve_batch.
class BatchRun {
 public:
  BatchRun(const BatchInput& input, const BatchOptions& options, BatchResult& out)
      : input_(input), options_(options), out_(out), plan_(march_plan(input.nu)) {
    constexpr std::size_t tile = BatchResult::tile;
    const std::size_t tiles = (input.lanes + tile - 1) / tile;
    // A lane that is followed takes milliseconds.
    parts_ = oriented() ? input.lanes : tiles;
    out.lanes_ = input.lanes;
    out.slots_ = plan_.s.size();
    out.slot_ = plan_.slot;
    const std::size_t cells = tiles * tile * out.slots_;
    for (auto* column : {&out.xi_, &out.zeta_, &out.rho_}) column->resize(cells);
    out.alpha_.resize(oriented() ? cells : 0);
    out.error_bound_.resize(options.error_bound ? cells : 0);
    out.status_.resize(cells);
    out.fell_back_.assign(input.lanes, oriented() ? 1 : 0);
  }

  void run() {
    out_.fallbacks_ = 0;
    if (out_.slots_ == 0) return;  // no nu is asked for
    std::atomic<std::size_t> fallbacks = 0;
    const auto solve_parts = [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        fallbacks += oriented() ? follow_lane(k) : solve_tile(k * BatchResult::tile);
        report();
      }
    };
    const int threads = available_threads(options_.threads);
    if (threads == 1) {
      solve_parts(0, parts_);
    } else {
      const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                        static_cast<std::size_t>(threads));
      arena_of(threads).execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, parts_),
                          [&](const auto& range) { solve_parts(range.begin(), range.end()); });
      });
    }
    out_.fallbacks_ = fallbacks;
  }

 private:
  bool stopped() const {
    return options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed);
  }

  bool oriented() const { return !input_.potential.is_isotropic(); }
  /// One more part is done.
  void report() {
    const std::size_t done = ++done_;
    if (!options_.progress) return;
    if (const std::unique_lock lock(reporting_, std::try_to_lock); lock)
      options_.progress(static_cast<double>(done) / static_cast<double>(parts_));
  }

  void put(std::size_t lane, std::size_t slot, const SweepPoint& point) {
    const std::size_t i = out_.index(lane, slot);
    out_.xi_[i] = point.xi;
    out_.zeta_[i] = point.zeta;
    out_.rho_[i] = point.rho;
    if (options_.error_bound) out_.error_bound_[i] = point.error_bound;
    out_.status_[i] = point.status;
  }

  /// Returns how many lanes fell back.
  std::size_t solve_tile(std::size_t first) {
    const std::size_t last = std::min(first + BatchResult::tile, input_.lanes);
    if (stopped()) {
      for (std::size_t lane = first; lane < last; ++lane)
        for (std::size_t slot = 0; slot < out_.slots_; ++slot) put(lane, slot, {});
      return 0;
    }
    std::ptrdiff_t end[BatchResult::tile] = {};
    if (marches(input_.potential)) march_tile(first, end);
    std::size_t fallbacks = 0;
    for (std::size_t lane = first; lane < last; ++lane) {
      const std::ptrdiff_t reached = end[lane - first];
      if (reached == static_cast<std::ptrdiff_t>(plan_.steps.size())) continue;
      ++fallbacks;
      out_.fell_back_[lane] = 1;
      std::size_t slot = 0;
      for (std::ptrdiff_t k = 0; k < reached; ++k)
        if (plan_.steps[static_cast<std::size_t>(k)].slot >= 0) ++slot;
      fall_back(lane, slot);
    }
    return fallbacks;
  }

  /// end: of each lane the step it could not be marched beyond.
  void march_tile(std::size_t first, std::ptrdiff_t* end) {
    constexpr std::size_t tile = BatchResult::tile;
    const TileNumbers numbers(input_, first);
    const std::size_t begin = (first / tile) * out_.slots_ * tile;
    const std::size_t cells = out_.slots_ * tile;
    const MarchKernels& kernels = kernels_for<MarchKernels>(options_.instructions);
    std::vector<double> axial_bound(options_.error_bound ? cells : 0);
    const bool constant_rho = input_.branch == Branch::iii;
    std::fill_n(out_.status_.begin() + static_cast<std::ptrdiff_t>(begin), cells,
                SolveStatus::solved);
    for (std::size_t i = 0; i < tile; i += static_cast<std::size_t>(kernels.lanes)) {
      const auto bounds = [&](std::vector<double>& in, std::size_t from) {
        return options_.error_bound ? in.data() + from + i : nullptr;
      };
      std::ptrdiff_t axial_end[tile];
      MarchStep rest_only{.weight = {1.0}, .slot = 0};
      const std::ptrdiff_t steps = static_cast<std::ptrdiff_t>(plan_.steps.size());
      const March axial{.speed = numbers.speed + i,
                        .inertia = {numbers.pulling(input_.branch, 2) + i, numbers.none},
                        .coefficient = {numbers.thickness[0] + i, numbers.thickness[1] + i},
                        .rest = numbers.rest_thickness + i,
                        .steps = constant_rho ? &rest_only : plan_.steps.data(),
                        .step_count = constant_rho ? 1 : steps,
                        .extended = options_.extended,
                        .bounded = options_.error_bound,
                        .stride = tile,
                        .x = {out_.rho_.data() + begin + i, nullptr},
                        .error_bound = bounds(axial_bound, 0),
                        .end = axial_end};
      const March planar{
          .speed = numbers.speed + i,
          .inertia = {numbers.pulling(input_.branch, 0) + i, numbers.pulling(input_.branch, 1) + i},
          .coefficient = {numbers.plane[0] + i, numbers.plane[1] + i},
          .rest = numbers.rest + i,
          .steps = plan_.steps.data(),
          .step_count = steps,
          .extended = options_.extended,
          .bounded = options_.error_bound,
          .stride = tile,
          .x = {out_.xi_.data() + begin + i, out_.zeta_.data() + begin + i},
          .error_bound = bounds(out_.error_bound_, begin),
          .end = end + i};
      kernels.thickness[input_.potential.thickness().index()](axial);
      kernels.plane[input_.potential.plane().index()](planar);
      for (std::size_t lane = 0; lane < static_cast<std::size_t>(kernels.lanes); ++lane) {
        if (constant_rho && axial_end[lane] == 1) axial_end[lane] = steps;
        end[i + lane] = std::min(end[i + lane], axial_end[lane]);
      }
    }
    double* rho = out_.rho_.data() + begin;
    if (constant_rho)
      for (std::size_t k = tile; k < cells; ++k) rho[k] = rho[k - tile];
    if (!options_.error_bound) return;
    double* bound = out_.error_bound_.data() + begin;
    for (std::size_t k = 0; k < cells; ++k)
      bound[k] = std::max(bound[k], axial_bound[constant_rho ? k % tile : k]);
  }

  /// The lane's cells from a slot on, by the scalar path from rest.
  void fall_back(std::size_t lane, std::size_t slot) {
    const Problem problem = input_.problem(lane);
    std::optional<Sweep> sweep;
    const auto sweep_from = [&](const Equilibrium& start) {
      sweep.emplace(problem, start, SweepOptions{options_.error_bound});
    };
    const Equilibrium rest = rest_state(problem);
    sweep_from(rest);
    bool ended = !std::isfinite(rest.q.xi) || !std::isfinite(rest.q.rho);  // there is no such state
    for (; slot < out_.slots_; ++slot) {
      SweepPoint point;
      if (!stopped()) {
        const double nu = input_.speed[lane] * plan_.s[slot];
        const bool none = nonexistence_reason(problem, nu).has_value();
        ended = ended || none;  // a sheet does not pass where there is nothing
        if (!ended) sweep->run({&nu, 1}, {&point, 1});
        if (!ended && point.status != SolveStatus::solved) {
          // The walk along the sheet has the last word: it also goes where nu turns.
          SolveOptions sheet_alone;
          sheet_alone.search = false;
          const Equilibrium walked = solve(problem, nu, sheet_alone);
          ended = walked.status != SolveStatus::solved;
          if (!ended) {
            sweep_from(walked);
            sweep->run({&nu, 1}, {&point, 1});
            ended = point.status != SolveStatus::solved;
          }
        }
        if (ended) point.status = none ? SolveStatus::none_exists : SolveStatus::not_found;
      }
      put(lane, slot, point);
    }
  }

  /// A lane of a potential that is not isotropic; returns 1.
  std::size_t follow_lane(std::size_t lane) {
    std::vector<double> nu;
    for (const double s : plan_.s) nu.push_back(std::abs(input_.speed[lane] * s));
    std::vector<LanePoint> points(nu.size());
    solve_anisotropic_lane(input_.problem(lane), nu,
                           kernels_for<OrientedKernels>(options_.instructions), options_.stop,
                           points);
    for (std::size_t slot = 0; slot < points.size(); ++slot) {
      const LanePoint& point = points[slot];
      const std::size_t i = out_.index(lane, slot);
      out_.status_[i] = point.status;
      out_.alpha_[i] = point.q.alpha;
      out_.xi_[i] = point.q.xi;
      out_.zeta_[i] = point.q.zeta;
      out_.rho_[i] = point.q.rho;
      if (options_.error_bound) out_.error_bound_[i] = point.error_bound;
    }
    return 1;
  }

  const BatchInput& input_;
  const BatchOptions& options_;
  BatchResult& out_;
  MarchPlan plan_;
  std::size_t parts_ = 0;  ///< tiles, or lanes where each is followed by itself
  std::atomic<std::size_t> done_ = 0;
  std::mutex reporting_;
};

void solve_batch(const BatchInput& input, const BatchOptions& options, BatchResult& out) {
  require_valid(input, options);
  BatchRun(input, options, out).run();
}

}  // namespace stationary
