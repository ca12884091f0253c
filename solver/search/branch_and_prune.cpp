#include "solver/search/branch_and_prune.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <utility>

#include "lib/number/elementary.hpp"

namespace stationary {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// In the box, for the mean value theorem.
template <int N>
ReducedVector<N> middle(const Box<N>& box) {
  ReducedVector<N> out;
  for (int i = 0; i < N; ++i) {
    const Interval& side = box[index(i)];
    out[i] = std::clamp(std::sqrt(side.lo) * std::sqrt(side.hi), side.lo, side.hi);
  }
  return out;
}

template <int N>
class BranchAndPrune {
 public:
  BranchAndPrune(const SearchedSystem<N>& system, Mirror mirror, const PruneOptions& options)
      : system_(system), mirror_(mirror), symmetric_(mirror != Mirror::none), options_(options) {}

  PruneResult<N> run(const Box<N>& everything) {
    everything_ = everything;
    Box<N> start = everything;
    const Box<N> holding = system_.solution_box();
    if (apart(holding, everything)) {
      ++out_.boxes;
      return std::move(out_);
    }
    for (int i = 0; i < N; ++i) start[index(i)] = common(start[index(i)], holding[index(i)]);
    queue_.push_back(start);
    return examine_all();
  }

  PruneResult<N> go_on(const Box<N>& everything, const PruneResult<N>& before,
                       const std::vector<Box<N>>& left) {
    everything_ = everything;
    out_.solutions = before.solutions;
    for (const Box<N>& box : left) leave_undecided(box);
    queue_.assign(before.undecided.begin(), before.undecided.end());
    return examine_all();
  }

 private:
  using Square = Eigen::Matrix<double, N, N>;
  static double log_width(const Interval& x) { return log(x.hi / x.lo); }

  PruneResult<N> examine_all() {
    while (!queue_.empty()) {
      if (options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed)) {
        out_.interrupted = true;
        return std::move(out_);
      }
      if (out_.boxes >= options_.max_boxes) {
        for (const Box<N>& box : queue_) leave_undecided(box);
        break;
      }
      const Box<N> box = queue_.front();
      queue_.pop_front();
      examine(box);
    }
    if (options_.to_go_on) return std::move(out_);
    if constexpr (N >= 2) {
      if (mirror_ == Mirror::both) add_mirrored();
      if (mirror_ == Mirror::one) keep_one_of_each_pair();
    }
    look_into_undecided();
    return std::move(out_);
  }

  static Box<N> mirrored(Box<N> box) {
    std::swap(box[0], box[1]);
    return box;
  }

  void examine(Box<N> box) {
    ++out_.boxes;
    constexpr int passes = 8;
    BoxSlopes<N> over;
    for (int pass = 0; pass < passes; ++pass) {
      if constexpr (N >= 2) {
        if (symmetric_ && box[0].hi < box[1].lo) return;
      }
      for (const auto& known : out_.solutions)
        if (within(box, known.proof.unique)) return;
      if (system_.excludes(box)) return;
      if (pass == 0 && !system_.contract(box)) return;
      over = system_.boxes().linearize(box);
      for (const Interval& g : over.g)
        if (!g.may_be(0.0)) return;
      const Square inverse = over.inverse();
      if (!finite(inverse)) break;
      double kept = 1.0;
      bool regular = false;
      if (!gauss_seidel(over, inverse, box, kept, regular)) return;
      if (regular && settle(box)) return;
      if (kept > 0.75) break;
    }
    split(box, over);
  }

  static bool finite(const Square& a) {
    double sum = 0.0;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) sum += a(i, j);
    return std::isfinite(sum);
  }

  /// Narrows the box; false if nothing is left. kept: the smallest fraction left of a side.
  /// regular: every M_ii excludes 0.
  bool gauss_seidel(const BoxSlopes<N>& over, const Square& Y, Box<N>& box, double& kept,
                    bool& regular) const {
    const ReducedVector<N> center = middle<N>(box);
    Box<N> at;
    Box<N> d;
    for (int i = 0; i < N; ++i) {
      at[index(i)] = center[i];
      d[index(i)] = log(box[index(i)] / center[i]);
    }
    VariedResidual<N> g;
    const bool varies = system_.boxes().varies();
    if (varies) {
      g = system_.boxes().varied(at);
    } else {
      g.at = system_.boxes().residual(at);
    }
    // Row by row first: where the box is large Y says little.
    for (int i = 0; i < N; ++i) {
      IntervalSum row(g.at[index(i)]);
      if (varies) row.add_product(g.slope[index(i)], g.offset);
      for (int j = 0; j < N; ++j) row.add_product(over(i, j), d[index(j)]);
      if (!row.value().may_be(0.0)) return false;
    }
    regular = true;
    for (int i = 0; i < N; ++i) {
      const auto entry = [&](int j) {
        IntervalSum out;
        for (int k = 0; k < N; ++k) out.add_product(Y(i, k), over(k, j));
        return out.value();
      };
      IntervalSum others;
      for (int k = 0; k < N; ++k) others.add_product(Y(i, k), g.at[index(k)]);
      if (varies) others.add_product(1.0, g.by_number(Y, i));
      for (int j = 0; j < N; ++j)
        if (j != i) others.add_product(entry(j), d[index(j)]);
      const Interval sum = others.value();
      const Interval diagonal = entry(i);
      if (diagonal.may_be(0.0) || !diagonal.bounded()) {
        regular = false;
        continue;
      }
      const Interval step = -sum / diagonal;
      if (step.apart_from(d[index(i)])) return false;
      const double before = d[index(i)].hi - d[index(i)].lo;
      d[index(i)] = common(d[index(i)], step);
      kept = std::min(kept, (d[index(i)].hi - d[index(i)].lo) / before);
      const Interval narrowed = center[i] * exp(d[index(i)]);
      if (!narrowed.bounded()) continue;
      if (narrowed.apart_from(box[index(i)])) return false;
      box[index(i)] = common(box[index(i)], narrowed);
    }
    return true;
  }

  /// Proves that the box holds one solution, or none because the one nearby lies outside.
  bool settle(const Box<N>& box) {
    ReducedVector<N> x = middle<N>(box);
    if (!system_.converges(x)) return false;
    ReducedVector<N> radius;
    for (int i = 0; i < N; ++i) {
      const Interval offset = log(box[index(i)] / x[i]);
      radius[i] = 1.001 * offset.magnitude() + 0x1p-40;
      if (!(radius[i] < 2.0 * log_width(everything_[index(i)]))) return false;
    }
    const Krawczyk<N> test(system_.boxes(), x);
    // In stretches that cover the box, then as closely as it can be.
    const auto covering = test.unique(radius);
    if (!covering) return false;
    Proof<N> proof = test.prove();
    if (!proof.proven || !within(proof.solution, *covering)) return false;
    proof.unique = *covering;
    if (apart(proof.solution, everything_)) return true;
    for (const auto& known : out_.solutions) {
      if (within(proof.solution, known.proof.unique) || within(known.proof.solution, proof.unique))
        return true;
      // One solution twice, or two: not decided here.
      if (!apart(proof.solution, known.proof.solution)) return false;
    }
    out_.solutions.push_back({x, proof});
    return true;
  }

  int side_to_split(const Box<N>& box, const BoxSlopes<N>& over) const {
    std::array<double, N> width;
    int widest = 0;
    for (int i = 0; i < N; ++i) {
      width[index(i)] = log_width(box[index(i)]);
      if (width[index(i)] > width[index(widest)]) widest = i;
    }
    if (!system_.splits_by_slopes()) return widest;
    // The largest share that a side has in the spread of any row; none that is far narrower than
    // another, so that all become narrow in the end.
    const double narrowest = std::max(0x1p-4 * width[index(widest)], options_.min_width);
    int out = widest;
    double most = 0.0;
    for (int k = 0; k < N; ++k) {
      std::array<double, N> part;
      double spread = 0.0;
      for (int i = 0; i < N; ++i)
        spread += part[index(i)] = over(k, i).magnitude() * width[index(i)];
      for (int i = 0; i < N; ++i) {
        if (!(width[index(i)] > narrowest && part[index(i)] / spread > most)) continue;
        most = part[index(i)] / spread;
        out = i;
      }
    }
    return out;
  }

  void split(const Box<N>& box, const BoxSlopes<N>& over) {
    if (system_.passes_on(box)) {
      out_.passed_on.push_back(box);
      return;
    }
    const int chosen = side_to_split(box, over);
    const Interval side = box[index(chosen)];
    const double cut = std::sqrt(side.lo) * std::sqrt(side.hi);
    if (!(log_width(side) > options_.min_width) || !(side.lo < cut && cut < side.hi)) {
      // Contracted to so little at once it was not asked yet.
      if (!system_.excludes(box)) leave_undecided(box);
      return;
    }
    Box<N> half = box;
    half[index(chosen)] = {side.lo, cut};
    queue_.push_back(half);
    half[index(chosen)] = {cut, side.hi};
    queue_.push_back(half);
  }

  void leave_undecided(Box<N> box) {
    if (options_.to_go_on) {
      out_.undecided.push_back(box);
      return;
    }
    for (std::size_t k = 0; k < out_.undecided.size();) {
      if (apart(box, out_.undecided[k])) {
        ++k;
        continue;
      }
      for (int i = 0; i < N; ++i) box[index(i)] = hull(box[index(i)], out_.undecided[k][index(i)]);
      out_.undecided[k] = out_.undecided.back();
      out_.undecided.pop_back();
      k = 0;
    }
    out_.undecided.push_back(box);
  }

  void add_mirrored() {
    const auto found = out_.solutions;
    for (const auto& each : found) {
      const Box<N> image = mirrored(each.proof.solution);
      bool known = false;
      for (const auto& other : found) known = known || within(image, other.proof.unique);
      if (known) continue;
      ProvenSolution<N> twin = each;
      std::swap(twin.x[0], twin.x[1]);
      twin.proof.solution = image;
      twin.proof.unique = mirrored(each.proof.unique);
      out_.solutions.push_back(twin);
    }
    const auto undecided = out_.undecided;
    for (const Box<N>& box : undecided) leave_undecided(mirrored(box));
  }

  /// x_0 >= x_1 as far as the doubles say; an image of one that is there already is left out.
  void keep_one_of_each_pair() {
    auto found = std::move(out_.solutions);
    out_.solutions.clear();
    for (ProvenSolution<N>& each : found) {
      if (each.x[0] < each.x[1]) {
        std::swap(each.x[0], each.x[1]);
        each.proof.solution = mirrored(each.proof.solution);
        each.proof.unique = mirrored(each.proof.unique);
      }
      bool known = false;
      bool unclear = false;
      for (const auto& other : out_.solutions) {
        if (within(each.proof.solution, other.proof.unique) ||
            within(other.proof.solution, each.proof.unique)) {
          known = true;
        } else if (!apart(each.proof.solution, other.proof.solution)) {
          unclear = true;
        }
      }
      if (known) continue;
      if (unclear) {
        leave_undecided(each.proof.solution);
      } else {
        out_.solutions.push_back(each);
      }
    }
  }

  /// Newton's method from the middle of each box that is left and from a few points around.
  void look_into_undecided() {
    constexpr std::size_t most_boxes = 64;
    constexpr std::size_t most_found = 32;
    std::size_t examined = 0;
    for (const Box<N>& box : out_.undecided) {
      if (++examined > most_boxes) return;
      for (int corner = 0; corner <= (1 << N); ++corner) {
        ReducedVector<N> x = middle<N>(box);
        for (int i = 0; corner > 0 && i < N; ++i) {
          const Interval& side = box[index(i)];
          x[i] = std::sqrt(x[i] * ((((corner - 1) >> i) & 1) != 0 ? side.hi : side.lo));
        }
        if (out_.unproven.size() < most_found) try_unproven(x, box);
      }
    }
  }

  void try_unproven(ReducedVector<N> x, const Box<N>& box) {
    const Refined refined = system_.refined(x);
    // At a double root, or on a line of solutions, any point would do; and where half of a double's
    // digits are lost the rounding of the case decides whether there is one.
    constexpr double isolated = 1e-9;
    if (!refined.converged || !(refined.error_bound < isolated)) return;
    ProvenSolution<N> found{x, {}};
    found.proof.error_bound = refined.error_bound;
    for (int i = 0; i < N; ++i)
      found.proof.solution[index(i)] =
          x[i] * Interval(1.0 - 2.0 * refined.error_bound, 1.0 + 2.0 * refined.error_bound);
    found.proof.unique = found.proof.solution;
    if (apart(found.proof.solution, box)) return;
    const auto same = [&](const ProvenSolution<N>& each) {
      return !apart(each.proof.unique, found.proof.solution);
    };
    if (std::ranges::none_of(out_.solutions, same) && std::ranges::none_of(out_.unproven, same))
      out_.unproven.push_back(found);
  }

  const SearchedSystem<N>& system_;
  Mirror mirror_;
  bool symmetric_;
  PruneOptions options_;
  Box<N> everything_;
  std::deque<Box<N>> queue_;
  PruneResult<N> out_;
};

}  // namespace

template <int N>
PruneResult<N> branch_and_prune(const SearchedSystem<N>& system, Mirror mirror,
                                const PruneOptions& options, const Box<N>& everything) {
  return BranchAndPrune<N>(system, mirror, options).run(everything);
}

template <int N>
PruneResult<N> branch_and_prune(const SearchedSystem<N>& system, Mirror mirror,
                                const PruneOptions& options, const Box<N>& everything,
                                const PruneResult<N>& before, const std::vector<Box<N>>& left) {
  return BranchAndPrune<N>(system, mirror, options).go_on(everything, before, left);
}

template <int N>
std::optional<std::vector<ProvenSolution<N>>> solutions_within(
    const SearchedSystem<N>& system, std::span<const ProvenSolution<N>> of_more) {
  std::vector<ProvenSolution<N>> out;
  for (const ProvenSolution<N>& each : of_more) {
    ReducedVector<N> x = each.x;
    if (!system.converges(x)) return std::nullopt;
    Proof<N> proof = Krawczyk<N>(system.boxes(), x).prove();
    if (!proof.proven || !within(proof.solution, each.proof.unique)) return std::nullopt;
    proof.unique = each.proof.unique;
    out.push_back({x, proof});
  }
  return out;
}

template PruneResult<1> branch_and_prune<1>(const SearchedSystem<1>&, Mirror, const PruneOptions&,
                                            const Box<1>&);
template PruneResult<2> branch_and_prune<2>(const SearchedSystem<2>&, Mirror, const PruneOptions&,
                                            const Box<2>&);
template PruneResult<3> branch_and_prune<3>(const SearchedSystem<3>&, Mirror, const PruneOptions&,
                                            const Box<3>&);
template PruneResult<4> branch_and_prune<4>(const SearchedSystem<4>&, Mirror, const PruneOptions&,
                                            const Box<4>&);
template PruneResult<5> branch_and_prune<5>(const SearchedSystem<5>&, Mirror, const PruneOptions&,
                                            const Box<5>&);

template PruneResult<1> branch_and_prune<1>(const SearchedSystem<1>&, Mirror, const PruneOptions&,
                                            const Box<1>&, const PruneResult<1>&,
                                            const std::vector<Box<1>>&);
template PruneResult<2> branch_and_prune<2>(const SearchedSystem<2>&, Mirror, const PruneOptions&,
                                            const Box<2>&, const PruneResult<2>&,
                                            const std::vector<Box<2>>&);
template PruneResult<3> branch_and_prune<3>(const SearchedSystem<3>&, Mirror, const PruneOptions&,
                                            const Box<3>&, const PruneResult<3>&,
                                            const std::vector<Box<3>>&);
template std::optional<std::vector<ProvenSolution<1>>> solutions_within<1>(
    const SearchedSystem<1>&, std::span<const ProvenSolution<1>>);
template std::optional<std::vector<ProvenSolution<2>>> solutions_within<2>(
    const SearchedSystem<2>&, std::span<const ProvenSolution<2>>);
template std::optional<std::vector<ProvenSolution<3>>> solutions_within<3>(
    const SearchedSystem<3>&, std::span<const ProvenSolution<3>>);

}  // namespace stationary
