// All solutions of G(x) = 0 in a box of stretches, by branch and prune: a box is
//
//   discarded   where some G_i excludes 0 over it, by its own range or that of the mean value theorem,
//               G_i(c) + sum_j J_ij(X) d_j, x = c e^d, or where the Gauss-Seidel step
//               d_i <- d_i n -(b_i + sum_{j != i} M_ij d_j)/M_ii,  M = Y J(X), b = Y G(c),
//               leaves nothing of it: no solution in it
//   settled     where Krawczyk's test proves one solution in a box that covers it
//   narrowed    by that step, or split in two, where it is widest or, of a system that asks for it,
//               where the bounds of G depend on it most, and examined again
//   undecided   where it is as narrow as min_width and neither holds (a double root, a continuum),
//               or where the number of boxes allowed is used up
//
// Largest boxes first, so that what a continuum of solutions leaves undecided covers it evenly. A
// value that is not bounded decides nothing. Symmetric systems (G unchanged with x_0 and x_1
// exchanged) are searched where x_0 >= x_1, and mirrored unless one of each pair is asked for.
// A system that knows a box that holds all its solutions is searched there; one that knows more
// than its G (signs that a motion must have) discards what that excludes; one that can bound its
// solutions by more than G and its slopes narrows each box first.
// Source: E. Hansen, G. W. Walster, Global Optimization Using Interval Analysis (2004), chapter 11.
#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <vector>

#include "solver/newton/newton.hpp"
#include "solver/proof/krawczyk.hpp"

namespace stationary {

struct PruneOptions {
  double min_width = 0x1p-26;  ///< of a box, in ln x
  long max_boxes = 10000;
  /// Another search goes on with this one's result: solutions and undecided boxes stay as they are.
  bool to_go_on = false;
  const std::atomic<bool>* stop = nullptr;
};

/// Of a system unchanged with x_0 and x_1 exchanged, which of a solution and its image are listed.
enum class Mirror { none, both, one };

template <int N>
struct ProvenSolution {
  ReducedVector<N> x;  ///< correctly rounded as far as refine() can
  Proof<N> proof;
};

template <int N>
struct PruneResult {
  std::vector<ProvenSolution<N>> solutions;
  std::vector<Box<N>> undecided;  ///< touching ones merged into their hull
  /// What Newton's method found in those, with the error bound of refine(); nothing of it is
  /// proven.
  std::vector<ProvenSolution<N>> unproven;
  std::vector<Box<N>> passed_on;  ///< undecided ones that are another search's
  long boxes = 0;                 ///< examined
  bool interrupted = false;
};

/// What is searched, whatever its equations are: the search stands once for each N.
template <int N>
class SearchedSystem {
 public:
  explicit SearchedSystem(const BoxEquations<N>& boxes) : boxes_(boxes) {}
  virtual ~SearchedSystem() = default;

  const BoxEquations<N>& boxes() const { return boxes_; }

  /// By Newton's method in few steps, then in extended precision; x in place.
  virtual bool converges(ReducedVector<N>& x) const = 0;
  /// Likewise without that limit, and with its error bound.
  virtual Refined refined(ReducedVector<N>& x) const = 0;

  /// Holds every solution.
  virtual Box<N> solution_box() const = 0;
  virtual bool excludes(const Box<N>& box) const = 0;
  /// Narrows the box; false where nothing is left of it.
  virtual bool contract(Box<N>& box) const = 0;
  virtual bool splits_by_slopes() const = 0;
  /// Whether a box that is not decided is left to another search instead of being split.
  virtual bool passes_on(const Box<N>&) const { return false; }

 private:
  BoxEquations<N> boxes_;
};

/// System: the reduced balance in double and extended precision; BoxSystem: the same in intervals, with what it has
/// of solution_box(), excludes(), contract() and split_by_slopes. It refers to both.
template <class System, class BoxSystem>
class SearchedPair : public SearchedSystem<BoxSystem::dimension> {
 public:
  static constexpr int N = BoxSystem::dimension;

  SearchedPair(const System& system, const BoxSystem& boxes)
      : SearchedSystem<N>(BoxEquations<N>(boxes)), system_(system), boxes_(boxes) {}

  bool converges(ReducedVector<N>& x) const override {
    NewtonOptions few;
    few.max_steps = 12;
    return newton(system_, x, few).converged && refine<false>(system_, x).converged;
  }
  Refined refined(ReducedVector<N>& x) const override {
    return newton(system_, x).converged ? refine(system_, x) : Refined{};
  }

  Box<N> solution_box() const override {
    if constexpr (requires { boxes_.solution_box(); }) return boxes_.solution_box();
    Box<N> out;
    out.fill(Interval::entire());
    return out;
  }
  bool excludes(const Box<N>& box) const override {
    if constexpr (requires { boxes_.excludes(box); }) return boxes_.excludes(box);
    return false;
  }
  bool contract(Box<N>& box) const override {
    if constexpr (requires { boxes_.contract(box); }) return boxes_.contract(box);
    return true;
  }
  bool splits_by_slopes() const override {
    return requires { BoxSystem::split_by_slopes; };
  }

 private:
  const System& system_;
  const BoxSystem& boxes_;
};

/// All solutions in a box; N = 1 ... 5.
template <int N>
PruneResult<N> branch_and_prune(const SearchedSystem<N>& system, Mirror mirror,
                                const PruneOptions& options, const Box<N>& everything);
/// The same after a search to_go_on of a system that this one is a case of, from its solutions, made this
/// system's, and its undecided boxes; left: boxes that another search left undecided. N = 1, 2, 3.
template <int N>
PruneResult<N> branch_and_prune(const SearchedSystem<N>& system, Mirror mirror,
                                const PruneOptions& options, const Box<N>& everything,
                                const PruneResult<N>& before, const std::vector<Box<N>>& left = {});

/// Of a case of the system that has each of these alone in its box `unique`, its own solutions there: by
/// Newton's method from that, proven as those of a search are. Nothing where that fails of one.
template <int N>
std::optional<std::vector<ProvenSolution<N>>> solutions_within(
    const SearchedSystem<N>& system, std::span<const ProvenSolution<N>> of_more);

}  // namespace stationary
