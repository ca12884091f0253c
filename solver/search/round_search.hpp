// The search of a body with J1 = J2. Where a box near the circle xi = zeta is not decided as any other is, its circles
// and its ellipses are sought by themselves (round_boxes.hpp): where ellipses branch off, both are regular, and what is
// decided hardly depends on how near that is.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "solver/motion/two_polar_system.hpp"
#include "solver/search/branch_and_prune.hpp"
#include "solver/search/round_boxes.hpp"

namespace stationary {

/// System in x with both unknowns of the plane the same, whose two rows are added. It refers to it.
template <class System>
struct CircleSystem {
  static constexpr int dimension = System::dimension - 1;
  static constexpr int N = dimension;
  const System& system;

  Linearized<N> linearize(const ReducedVector<N>& x) const {
    const Linearized<N + 1> all = system.linearize(whole(x));
    const auto at = [&](int i, int j) { return all.jacobian(i, j); };
    Linearized<N> out;
    out.g = added(all.g);
    out.jacobian.entries[0] = at(0, 0) + at(1, 1) + 2.0 * at(0, 1);
    if constexpr (N == 2) {
      out.jacobian.entries[1] = at(0, 2) + at(1, 2);
      out.jacobian.entries[2] = at(2, 2);
    }
    out.magnitude = 2.0 * all.magnitude;
    return out;
  }
  ReducedVector<N> extended_residual(const ReducedVector<N>& x) const {
    return added(system.extended_residual(whole(x)));
  }
  ReducedVector<N> input_sensitivity(const ReducedVector<N>& x) const {
    return added(system.input_sensitivity(whole(x)));
  }

 private:
  static ReducedVector<N + 1> whole(const ReducedVector<N>& x) {
    ReducedVector<N + 1> out;
    out[0] = out[1] = x[0];
    if constexpr (N == 2) out[2] = x[1];
    return out;
  }
  static ReducedVector<N> added(const ReducedVector<N + 1>& of) {
    ReducedVector<N> out;
    out[0] = of[0] + of[1];
    if constexpr (N == 2) out[1] = of[2];
    return out;
  }
};

/// What a search of each part has found and left, the ellipses near the circle as (g, r[, rho]). Of one that is not
/// divided all is `apart`, which may be near it too.
template <int N>
struct FoundInParts {
  PruneResult<N - 1> circles;
  PruneResult<N> near;
  PruneResult<N> apart;

  long boxes() const { return circles.boxes + near.boxes + apart.boxes; }
  bool interrupted() const { return circles.interrupted || near.interrupted || apart.interrupted; }
};

/// What RoundSearch is of a system whose search is not divided. It refers to both.
template <class System, class Boxes>
class WholeSearch {
 public:
  static constexpr int N = Boxes::dimension;
  using Parts = FoundInParts<N>;

  WholeSearch(const System& system, const Boxes& boxes, Mirror mirror, const Box<N>& everything)
      : searched_(system, boxes), mirror_(mirror), everything_(everything) {}

  Parts begun(const PruneOptions& options, const Parts* before) const {
    Parts out;
    out.apart = before
                    ? branch_and_prune<N>(searched_, mirror_, options, everything_, before->apart)
                    : branch_and_prune<N>(searched_, mirror_, options, everything_);
    return out;
  }
  std::optional<PruneResult<N>> finished(const PruneOptions& options, const Parts* before) const {
    if (before == nullptr) return branch_and_prune<N>(searched_, mirror_, options, everything_);
    auto known = solutions_within<N>(searched_, before->apart.solutions);
    if (!known) return std::nullopt;
    PruneResult<N> begun;
    begun.solutions = std::move(*known);
    begun.undecided = before->apart.undecided;
    return branch_and_prune<N>(searched_, mirror_, options, everything_, begun);
  }

 private:
  SearchedPair<System, Boxes> searched_;
  Mirror mirror_;
  Box<N> everything_;
};

/// System, Boxes: of all ellipsoids, symmetric in x_0 and x_1. Invariants: as TwoPolarInvariantSystem; Ellipses:
/// as EllipseBoxSystem. It refers to all four.
template <class System, class Boxes, class Invariants, class Ellipses>
class RoundSearch {
 public:
  static constexpr int N = Boxes::dimension;
  using Parts = FoundInParts<N>;

  RoundSearch(const System& system, const Boxes& boxes, const Invariants& invariants,
              const Ellipses& ellipses, Mirror mirror, const Box<N>& everything)
      : system_(system),
        boxes_(boxes),
        circle_{system},
        circle_boxes_{boxes},
        circles_(circle_, circle_boxes_),
        near_(boxes, invariants, ellipses),
        apart_(system, boxes),
        mirror_(mirror),
        everything_(everything) {
    circle_everything_[0] = hull(everything[0], everything[1]);
    if constexpr (N == 3) circle_everything_[1] = everything[2];
    near_everything_ = everything;
    near_everything_[0] = circle_everything_[0];
    near_everything_[1] = {1.0, greatest_r};
  }

  /// Coarsely, of many systems of which others are cases; before: of more of them.
  Parts begun(const PruneOptions& options, const Parts* before) const {
    Parts out;
    if (before != nullptr) out = *before;
    go_on(options, 0x1p-6, before != nullptr, out);
    return out;
  }

  /// All solutions. before: begun() of systems that this one is a case of, which have each of its
  /// solutions alone; nothing where one of those is not found.
  std::optional<PruneResult<N>> finished(const PruneOptions& options, const Parts* before) const {
    Parts own;
    if (before != nullptr) {
      own = *before;
      if (!make_own(circles_, own.circles) || !make_own(near_, own.near) ||
          !make_own(apart_, own.apart))
        return std::nullopt;
    }
    PruneOptions part = options;
    part.to_go_on = true;
    go_on(part, 0x1p-22, before != nullptr, own);
    PruneResult<N> all;
    all.solutions = std::move(own.apart.solutions);
    for (ProvenSolution<N>& each : all.solutions) prove_circle(each);
    std::vector<Box<N>> left;
    for (const auto& each : own.circles.solutions) add(of_circle(each), all.solutions, left);
    for (const auto& each : own.near.solutions) add_ellipse(each, all.solutions, left);
    for (const auto& box : own.circles.undecided) left.push_back(on_circle(box));
    for (const auto& box : own.near.undecided) left.push_back(stretches_of_ellipses(box));
    const bool coarse = widest(left) > fine;
    left.insert(left.end(), own.apart.undecided.begin(), own.apart.undecided.end());
    PruneResult<N> out = branch_and_prune<N>(apart_, mirror_, options, everything_, all, left);
    out.boxes += own.boxes();
    out.interrupted = out.interrupted || own.interrupted();
    if (before != nullptr || out.interrupted || !coarse) return out;
    // A formula may be bounded better in the stretches than in their invariants.
    PruneResult<N> whole = branch_and_prune<N>(SearchedPair<System, Boxes>(system_, boxes_),
                                               mirror_, options, everything_);
    whole.boxes += out.boxes;
    if (widest(whole.undecided) < widest(out.undecided)) return whole;
    out.boxes = whole.boxes;
    return out;
  }

 private:
  /// xi/zeta up to which an ellipse is near the circle, and its r.
  static constexpr double nearest = 1.15;
  static constexpr double greatest_r = 1.00245;  // (nearest + 1)/(2 sqrt nearest) = 1.002444...
  static constexpr double fine = 0x1p-10;        ///< of a box that is left, in ln x

  /// What of it is near the circle and not decided it leaves to the others.
  class ApartFromCircle final : public SearchedPair<System, Boxes> {
   public:
    using SearchedPair<System, Boxes>::SearchedPair;
    bool passes_on(const Box<N>& x) const override { return x[0].hi <= nearest * x[1].lo; }
  };

  /// In (g, r[, rho]); Newton's method in the invariants.
  class NearCircle final : public SearchedSystem<N> {
   public:
    NearCircle(const Boxes& boxes, const Invariants& invariants, const Ellipses& ellipses)
        : SearchedSystem<N>(BoxEquations<N>(ellipses)), all_(boxes), invariants_(invariants) {}

    bool converges(ReducedVector<N>& x) const override {
      ReducedVector<N> y = x;
      y[0] = 2.0 * x[0] * x[1];
      y[1] = x[0] * x[0];
      NewtonOptions few;
      few.max_steps = 12;
      if (!newton(invariants_, y, few).converged) return false;
      x = y;
      x[0] = std::sqrt(y[1]);
      x[1] = 0.5 * y[0] / x[0];
      return x[1] >= 1.0;
    }
    /// Of boxes left at the end, which these have none of.
    Refined refined(ReducedVector<N>&) const override { return {}; }
    Box<N> solution_box() const override {
      Box<N> out;
      out.fill(Interval::entire());
      return out;
    }
    /// By the balance in the stretches, which is the narrower where the box is wide.
    bool excludes(const Box<N>& x) const override {
      const Box<N> at = stretches_of_ellipses(x);
      if (all_.excludes(at)) return true;
      return std::ranges::any_of(all_.linearize(at).g,
                                 [](const Interval& g) { return !g.may_be(0.0); });
    }
    bool contract(Box<N>&) const override { return true; }
    bool splits_by_slopes() const override { return false; }

   private:
    const Boxes& all_;
    const Invariants& invariants_;
  };

  /// Goes on with all parts. r - 1 is of the second order in xi - zeta: its boxes are narrower by a factor.
  void go_on(const PruneOptions& options, double narrower, bool begun, Parts& parts) const {
    parts.apart = begun ? branch_and_prune<N>(apart_, mirror_, options, everything_, parts.apart)
                        : branch_and_prune<N>(apart_, mirror_, options, everything_);
    for (const Box<N>& box : parts.apart.passed_on) {
      if (!box[0].apart_from(box[1])) {
        Box<N - 1> circle;
        circle[0] = common(box[0], box[1]);
        if constexpr (N == 3) circle[1] = box[2];
        parts.circles.undecided.push_back(circle);
      }
      if (const auto ellipses = ellipses_of_stretches(box))
        parts.near.undecided.push_back(*ellipses);
    }
    parts.circles =
        branch_and_prune<N - 1>(circles_, Mirror::none, of_those_left(options, parts.apart.boxes),
                                circle_everything_, parts.circles);
    PruneOptions finer = of_those_left(options, parts.apart.boxes + parts.circles.boxes);
    finer.min_width *= narrower;
    parts.near = branch_and_prune<N>(near_, Mirror::none, finer, near_everything_, parts.near);
  }

  /// With the boxes that are left of those allowed.
  static PruneOptions of_those_left(PruneOptions options, long used) {
    options.max_boxes = std::max(options.max_boxes - used, 0L);
    return options;
  }

  /// Of a case of the system the solutions; false where one is not found.
  template <int M>
  static bool make_own(const SearchedSystem<M>& system, PruneResult<M>& parts) {
    auto own = solutions_within<M>(system, parts.solutions);
    if (own) parts.solutions = std::move(*own);
    return own.has_value();
  }

  /// A circle that the search of all has found, as one by itself: its two stretches are the same, and its bound that.
  void prove_circle(ProvenSolution<N>& found) const {
    const Box<N> solution = found.proof.solution;
    const Box<N> unique = found.proof.unique;
    if (!solution[0].within(unique[1]) || !solution[1].within(unique[0])) return;
    ReducedVector<N - 1> x;
    x[0] = found.x[0];
    if constexpr (N == 3) x[1] = found.x[2];
    if (!circles_.converges(x)) return;
    const Proof<N - 1> proof = Krawczyk<N - 1>(circles_.boxes(), x).prove();
    if (!proof.proven || !within(on_circle(proof.solution), unique)) return;
    found = of_circle({x, proof});
    found.proof.unique = unique;
  }
  static ProvenSolution<N> of_circle(const ProvenSolution<N - 1>& circle) {
    ProvenSolution<N> out;
    out.x[0] = out.x[1] = circle.x[0];
    if constexpr (N == 3) out.x[2] = circle.x[1];
    out.proof.proven = circle.proof.proven;
    out.proof.solution = on_circle(circle.proof.solution);
    // Of ellipses beside it the others tell.
    out.proof.unique = out.proof.solution;
    out.proof.error_bound = circle.proof.error_bound;
    return out;
  }

  /// By the balance in (xi, zeta) where that tells it from its mirror image.
  void add_ellipse(const ProvenSolution<N>& ellipse, std::vector<ProvenSolution<N>>& out,
                   std::vector<Box<N>>& left) const {
    const Box<N> at = stretches_of_ellipses(ellipse.proof.solution);
    ProvenSolution<N> found;
    for (int k = 0; k < N; ++k) found.x[k] = at[static_cast<std::size_t>(k)].mid();
    ReducedVector<N> x = found.x;
    if (apart_.converges(x)) {
      const Proof<N> proof = Krawczyk<N>(apart_.boxes(), x).prove();
      const auto same = ellipses_of_stretches(proof.solution);
      if (proof.proven && same && within(*same, ellipse.proof.unique)) {
        add({x, proof}, out, left);
        return;
      }
    }
    if (!(at[0].lo > at[1].hi)) {
      left.push_back(at);
      return;
    }
    found.proof.proven = true;
    found.proof.solution = found.proof.unique = at;
    double error = 0.0;
    for (int k = 0; k < N; ++k)
      error = std::max(error, (found.x[k] / at[static_cast<std::size_t>(k)] - 1.0).magnitude());
    found.proof.error_bound = error;
    add(found, out, left);
  }

  /// One that another part has found too is left out, and one beyond the box, whose (g, r) hold more than it.
  void add(const ProvenSolution<N>& found, std::vector<ProvenSolution<N>>& out,
           std::vector<Box<N>>& left) const {
    if (apart(found.proof.solution, everything_)) return;
    for (const ProvenSolution<N>& known : out) {
      if (within(found.proof.solution, known.proof.unique) ||
          within(known.proof.solution, found.proof.unique))
        return;
      if (!apart(found.proof.solution, known.proof.solution)) {  // one solution twice, or two
        left.push_back(found.proof.solution);
        return;
      }
    }
    out.push_back(found);
  }

  static double widest(const std::vector<Box<N>>& boxes) {
    double out = 0.0;
    for (const Box<N>& box : boxes)
      for (const Interval& side : box) out = std::max(out, log(side.hi / side.lo));
    return out;
  }

  const System& system_;
  const Boxes& boxes_;
  CircleSystem<System> circle_;
  CircleBoxSystem<Boxes> circle_boxes_;
  SearchedPair<CircleSystem<System>, CircleBoxSystem<Boxes>> circles_;
  NearCircle near_;
  ApartFromCircle apart_;
  Mirror mirror_;
  Box<N> everything_;
  Box<N - 1> circle_everything_;
  Box<N> near_everything_;
};

}  // namespace stationary
