#include "solver/search/sheared_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "lib/number/interval_functions.hpp"
#include "solver/family/sheared_boxes.hpp"
#include "solver/search/search_run.hpp"

namespace stationary {
namespace {

/// xi, zeta and alpha^2 of (t, d, T).
template <class S>
struct PlaneOf {
  S xi;
  S zeta;
  S square_alpha;
};
template <class S>
PlaneOf<S> plane_of(const Inertia3<S>& J, const S& t, const S& d, const S& T) {
  const S mean = (T + (J.J1 + J.J2) * d) / t;  // J1 xi + J2 zeta
  const S difference = J.J1 - J.J2;
  const S xi = (mean - J.J2 * t) / difference;
  const S zeta = (J.J1 * t - mean) / difference;
  return {xi, zeta, xi * zeta - d};
}

/// The equations in (t, d, T) and, where no volume is held, rho.
template <int N>
struct ShearedInvariants {
  static constexpr int dimension = N;
  static constexpr auto size = static_cast<std::size_t>(N);
  const ShearedEquations<N>& family;

  template <class S, class Number>
  ShearedState<S> state(const std::array<S, size>& x, const S& p, const Number& number) const {
    const auto& [t, d, T] = std::tie(x[0], x[1], x[2]);
    const Inertia3<S> J = family.template inertias<S>(number);
    const BodyModel<S> model = family.template model_in<S>(number);
    const S rho = model.volume ? S(*model.volume / d) : x[size - 1];
    return sheared_state<S>(family.axis, J, model,
                            PlanarInvariants<S>{t, d, S(square(t) - 4.0 * d)}, T, rho,
                            S(square(p)));
  }
  template <class S, class Number>
  std::array<S, size> balance(const std::array<S, size>& x, const S& p,
                              const Number& number) const {
    return sheared_balance<N, S>(family.axis, state(x, p, number), S(square(p)));
  }
};

/// The same over boxes, with what is a motion.
template <int N>
struct InvariantBoxes : StatedBoxes<ShearedInvariants<N>> {
  static constexpr bool split_by_slopes = true;
  using Base = StatedBoxes<ShearedInvariants<N>>;
  SearchOptions options;

  InvariantBoxes(const ShearedInvariants<N>& of, double nu, const SearchOptions& search)
      : Base{of, nu, search.inputs}, options(search) {}

  Interval number(double c) const { return as_input(c, this->inputs); }
  const ShearedEquations<N>& family() const { return this->equations.family; }
  Inertia3<Interval> J() const {
    return family().template inertias<Interval>([this](double c) { return number(c); });
  }
  PlaneOf<Interval> plane(const Box<N>& x) const {
    return plane_of<Interval>(J(), x[0], x[1], x[2]);
  }
  Interval rho(const Box<N>& x) const {
    if constexpr (N == 4) return x[3];
    return number(*family().model.volume) / x[1];
  }
  StretchBox stretch(const Box<N>& x) const {
    const PlaneOf<Interval> at = plane(x);
    const Interval least(std::max(at.square_alpha.lo, 0.0), std::max(at.square_alpha.hi, 0.0));
    return {at.xi, at.zeta, rho(x), sqrt(least)};
  }

  Box<N> everything() const {
    const Interval xi = options.range(0);
    const Interval zeta = options.range(1);
    const Inertia3<Interval> J = this->J();
    const double shear = options.most_shear();
    const Hyperbolic<Interval> most = hyperbolic(Interval(shear));
    const Interval area = xi * zeta;
    Box<N> out;
    out[0] = xi + zeta;
    out[1] = Interval((Interval(area.lo) * square(most.sech)).lo, area.hi);
    const Interval own = J.J1 * square(xi) + J.J2 * square(zeta);
    out[2] = Interval(own.lo, (Interval(own.hi) + (J.J1 + J.J2) * Interval(area.hi)).hi);
    if constexpr (N == 4) out[3] = options.range(2);
    return out;
  }

  bool excludes(const Box<N>& x) const {
    const PlaneOf<Interval> at = plane(x);
    const Inertia3<Interval> J = this->J();
    if (at.square_alpha.hi < 0.0 || (square(x[0]) - 4.0 * x[1]).hi < 0.0 ||
        (square(x[2]) - 4.0 * (J.J1 * J.J2 * square(x[1]))).hi < 0.0)
      return true;
    if (at.xi.apart_from(options.range(0)) || at.zeta.apart_from(options.range(1))) return true;
    if (N == 3 && rho(x).apart_from(options.range(2))) return true;
    if (family().axis == ShearedAxis::third) return false;
    const ShearedState<Interval> state =
        this->equations.state(x, number(this->p), [this](double c) { return number(c); });
    const Interval square_nu = square(number(this->p));
    if (family().axis == ShearedAxis::oblique) return state.w(square_nu).lo >= 0.0;
    const auto squares = sheared_squares(family().axis, state, square_nu);
    return squares.in_plane.hi <= 0.0 || squares.normal.hi <= 0.0;
  }
};

template <int N>
class ShearedSearch {
 public:
  ShearedSearch(const ShearedEquations<N>& equations, double nu, const SearchOptions& options)
      : equations_(equations),
        invariants_{equations},
        family_(equations),
        nu_(nu),
        options_(options),
        boxes_(invariants_, nu, options),
        search_(equations.potential, options) {}

  SearchResult run() {
    const StatedSystem<ShearedInvariants<N>> system{invariants_, nu_};
    constexpr long box_factor = 20;
    search_.each_of(
        search_.prune(system, boxes_, Mirror::none, boxes_.everything(), box_factor),
        [this](const Box<N>& x) { return boxes_.stretch(x); },
        [this](const ProvenSolution<N>& each) { add(each); });
    return search_.finish(
        [](const Equilibrium& each) { return std::tuple(each.q.xi, each.q.zeta, each.q.alpha); },
        "a fold, a bifurcation, solutions that are not isolated, or an alpha or an axis within "
        "rounding of one that belongs to other motions");
  }

 private:
  using X = ReducedVector<N>;

  void add(const ProvenSolution<N>& each) {
    const bool proven = each.proof.proven;
    const StretchBox box = boxes_.stretch(each.proof.solution);
    // What decides a box need not be in it.
    if (proven && boxes_.excludes(each.proof.solution)) return;
    const std::optional<X> x = unknowns(each.x);
    if (!x) {
      if (proven) search_.leave_undecided(box);
      return;
    }
    X at = *x;
    X tail;
    const Refined refined = family_.refine_at(at, tail, nu_);
    if (!refined.converged) {
      if (proven) search_.leave_undecided(box);
      return;
    }
    const Member member = family_.member(at, tail, nu_, refined.error_bound);
    const std::optional<double> bound = proven ? proven_bound(at, member, box) : std::nullopt;
    if (member.beyond_end() || (proven && !bound)) {
      if (proven) search_.leave_undecided(box);
      return;
    }
    Equilibrium motion =
        equilibrium_of_search(member.q, bound ? *bound : member.error_bound, proven);
    motion.nu = member.angular_velocity;
    motion.residual = member.residual;
    motion.compatibility = member.compatibility;
    search_.add(motion, proven);
  }

  /// Of the family, at (t, d, T[, rho]); nothing where these are no stretch with alpha > 0.
  std::optional<X> unknowns(const X& invariants) const {
    const auto at = plane_of<double>({equations_.body.J1, equations_.body.J2, equations_.body.J3},
                                     invariants[0], invariants[1], invariants[2]);
    if (!(at.square_alpha > 0.0 && at.xi > 0.0 && at.zeta > 0.0)) return std::nullopt;
    double rho = 1.0;
    if constexpr (N == 4) rho = invariants[3];
    return equations_.unknowns({std::sqrt(at.square_alpha), at.xi, at.zeta, rho});
  }

  /// Of the motion at x, whose invariants are proven to be in a box of stretches: that it is the one
  /// proven there, and how far it may be off. Nothing where its alpha or its axis may be another's.
  std::optional<double> proven_bound(const X& x, const Member& member,
                                     const StretchBox& box) const {
    const StatedBoxes<ShearedEquations<N>> boxes{equations_, nu_, options_.inputs};
    const ShearedBoxes<N> stated(equations_, nu_, options_.inputs);
    const Proof<N> proof = Krawczyk(boxes, x).prove();
    if (!proof.proven || !stated.axis(proof.solution)) return std::nullopt;
    const StretchBox own = stated.stretch(proof.solution);
    const bool same = !own.xi.apart_from(box.xi) && !own.zeta.apart_from(box.zeta) &&
                      !own.alpha.apart_from(box.alpha) && !own.rho.apart_from(box.rho);
    if (!same || !own.alpha.positive()) return std::nullopt;
    const double of_rho = (Interval(member.q.rho) / own.rho - Interval(1.0)).magnitude();
    return std::max(ShearedEquations<N>::bound_factor * proof.error_bound, of_rho);
  }

  const ShearedEquations<N>& equations_;
  ShearedInvariants<N> invariants_;
  StatedFamily<ShearedEquations<N>> family_;
  double nu_;
  const SearchOptions& options_;
  InvariantBoxes<N> boxes_;
  SearchRun search_;
};

}  // namespace

template <int N>
SearchResult search_sheared(const ShearedEquations<N>& equations, double nu,
                            const SearchOptions& options) {
  return ShearedSearch<N>(equations, nu, options).run();
}

template SearchResult search_sheared<3>(const ShearedEquations<3>&, double, const SearchOptions&);
template SearchResult search_sheared<4>(const ShearedEquations<4>&, double, const SearchOptions&);

}  // namespace stationary
