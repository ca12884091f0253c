#include "solver/batch/anisotropic_batch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "lib/balance/balance.hpp"
#include "solver/family/anisotropic_family.hpp"
#include "solver/solve/anisotropic_rest.hpp"
#include "solver/solve/curve_points.hpp"
#include "solver/solve/family_solve.hpp"
#include "solver/solve/nonexistence.hpp"

namespace stationary {
namespace {

/// The range followed over the largest nu: near a turn of nu the end of a range is not met exactly.
constexpr double beyond = 1.0 + 0x1p-10;

bool is_set(const std::atomic<bool>* stop) {
  return stop != nullptr && stop->load(std::memory_order_relaxed);
}

/// What corrects a lane's points many at a time, if it can.
struct LaneProblem {
  const Body& body;
  const AnisotropicPotential& V;
  Branch branch;
  std::optional<OrientedLane> lane;
  const OrientedKernels& kernels;

  /// Null where there is none.
  template <class Layout>
  OrientedKernels::Kernel kernel() const {
    if (!lane) return nullptr;
    return (Layout::alpha ? kernels.sheared : kernels.straight)[lane->plane_model];
  }
  double residual(const Stretch& q, double nu) const {
    return check_balance(body, potential_derivatives<2>(V.model(), q), q,
                         angular_velocity(branch, nu))
        .residual;
  }
};

/// A family through a rest state, at many nu.
template <class Layout>
class FollowedLane {
 public:
  static constexpr int N = Layout::dimension;
  /// bare: the same family, its members without errors and energy.
  FollowedLane(const Family<N>& family, const Family<N>& bare, const LaneProblem& problem,
               const Stretch& rest, const std::atomic<bool>* stop)
      : family_(family), bare_(bare), problem_(problem), rest_(rest), stop_(stop) {}

  /// What is not met stays as it is.
  void solve(std::span<const double> nu, std::span<LanePoint> out) {
    std::size_t k = 0;
    for (; k < nu.size() && nu[k] == 0.0; ++k) {
      ReducedVector<N> x = family_.coordinates(rest_, 0.0);
      correct(x, 0.0, out[k]);
    }
    if (k == nu.size()) return;
    const double range = beyond * nu.back();
    CurvePoints<N> curve(family_, followed(rest_, 0.0, range), range);
    std::vector<At> pending;
    for (std::size_t b = 1; b < curve.rows().size(); ++b) {
      for (; k < nu.size() && nu[k] <= curve.rows()[b].p; ++k) {
        pending.push_back({curve.near(b, nu[k]), k});
        if (pending.size() < OrientedPoints::size) continue;
        if (is_set(stop_)) return;
        answer(curve, pending, out);
        pending.clear();
      }
    }
    answer(curve, pending, out);
  }

 private:
  using Near = typename CurvePoints<N>::Near;

  /// Where one of the lane's nu is met.
  struct At {
    Near near;
    std::size_t point;
  };

  /// Empty where the start is no point of a curve.
  std::vector<CurveRow<N>> followed(const Stretch& q, double from, double to) const {
    CoordinateRows<N> sink(family_);
    follow_family(bare_, q, from, curve_options(from, to, stop_), sink);
    return sink.rows();
  }

  void answer(const CurvePoints<N>& curve, const std::vector<At>& pending,
              std::span<LanePoint> out) const {
    OrientedPoints points;
    const auto kernel = problem_.kernel<Layout>();
    if (kernel != nullptr && !pending.empty()) {
      for (std::size_t i = 0; i < OrientedPoints::size; ++i) {
        const Near& near = pending[std::min(i, pending.size() - 1)].near;
        points.nu[i] = i < pending.size() ? near.p : std::numeric_limits<double>::quiet_NaN();
        points.x[3][i] = 1.0;
        for (int k = 0; k < N; ++k) points.x[static_cast<std::size_t>(k)][i] = near.x[k];
      }
      kernel(*problem_.lane, points);
    }
    for (std::size_t i = 0; i < pending.size(); ++i) {
      if (is_set(stop_)) return;
      const Near& near = pending[i].near;
      LanePoint& point = out[pending[i].point];
      if (kernel != nullptr && take(points, i, near, point)) continue;
      if (!answer(near, point)) go_on(curve.rows()[near.row - 1], near.p, point);
    }
  }

  /// What a kernel has found, with its residual in doubles.
  bool take(const OrientedPoints& points, std::size_t i, const Near& near, LanePoint& out) const {
    ReducedVector<N> x;
    for (int k = 0; k < N; ++k) x[k] = points.x[static_cast<std::size_t>(k)][i];
    if (points.accepted[i] == 0.0 || !CurvePoints<N>::stays(near, x, points.positive[i] != 0.0))
      return false;
    const Stretch q{points.alpha[i], x[0], x[1], x[2]};
    if (!(problem_.residual(q, near.p) <= acceptable_residual)) return false;
    out = {SolveStatus::solved, q, Layout::bound_factor * points.error_bound[i]};
    return true;
  }

  bool answer(const Near& near, LanePoint& out) const {
    ReducedVector<N> x = near.x;
    const Refined refined = correct(x, near.p, out);
    return refined.converged && CurvePoints<N>::stays(near, x, refined.positive);
  }

  /// Along the curve from a row to nu.
  void go_on(const CurveRow<N>& from, double nu, LanePoint& out) const {
    out = LanePoint();
    const Member start = family_.member(from.x, ReducedVector<N>::Zero(), from.p, 0.0);
    const std::vector<CurveRow<N>> rows = followed(start.q, from.p, nu);
    if (rows.empty() || rows.back().p != nu) return;
    ReducedVector<N> x = rows.back().x;
    correct(x, nu, out);
  }

  Refined correct(ReducedVector<N>& x, double nu, LanePoint& out) const {
    ReducedVector<N> tail;
    const Refined refined = family_.refine_at(x, tail, nu);
    if (!refined.converged) return refined;
    const Member member = family_.member(x, tail, nu, refined.error_bound);
    out.status = member.residual <= acceptable_residual ? SolveStatus::solved : SolveStatus::failed;
    out.q = member.q;
    out.error_bound = member.error_bound;
    return refined;
  }

  const Family<N>& family_;
  const Family<N>& bare_;
  const LaneProblem& problem_;
  const Stretch& rest_;
  const std::atomic<bool>* stop_;
};

/// About an axis that V_alpha leaves no motion but by chance.
void solve_off_axis(const Problem& problem, std::span<const double> nu,
                    const std::atomic<bool>* stop, std::span<LanePoint> out) {
  SolveOptions how;
  how.stop = stop;
  for (std::size_t k = 0; k < nu.size(); ++k) {
    if (is_set(stop)) return;
    const Equilibrium at = solve(problem, nu[k], how);
    if (at.status == SolveStatus::interrupted) return;
    out[k] = {at.status, at.q, at.error_bound};
  }
}

}  // namespace

void solve_anisotropic_lane(const Problem& problem, std::span<const double> nu,
                            const OrientedKernels& kernels, const std::atomic<bool>* stop,
                            std::span<LanePoint> out) {
  std::ranges::fill(out, LanePoint());
  const AnisotropicPotential& V = problem.potential().anisotropic();
  const bool off_axis = problem.branch() != Branch::iii && !V.shear_free();
  // At rest no axis is asked for.
  const auto spinning = static_cast<std::size_t>(
      std::ranges::find_if(nu, [](double each) { return each > 0.0; }) - nu.begin());
  const std::size_t followed = off_axis ? spinning : nu.size();
  if (off_axis) solve_off_axis(problem, nu.subspan(spinning), stop, out.subspan(spinning));
  if (followed == 0 || is_set(stop)) return;
  SolveOptions how;
  how.stop = stop;
  Counts counts;
  const AnisotropicRest rest = anisotropic_rest(problem.body(), problem.potential(), how, counts);
  if (rest.q) {
    const Branch branch = off_axis ? Branch::iii : problem.branch();
    const LaneProblem lane{problem.body(), V, branch, oriented_lane(problem.body(), branch, V),
                           kernels};
    const auto family = [&](bool errors) {
      return anisotropic_family(
          problem.body(), V, branch, false,
          {.parameter = {}, .spectrum = false, .errors = errors, .energy = false});
    };
    const AnyFamily own = family(true);
    const AnyFamily bare = family(false);
    const auto follow = [&]<class Layout>(Layout) {
      using Own = std::unique_ptr<Family<Layout::dimension>>;
      if (!std::holds_alternative<Own>(own)) return;
      FollowedLane<Layout>(*std::get<Own>(own), *std::get<Own>(bare), lane, *rest.q, stop)
          .solve(nu.first(followed), out.first(followed));
    };
    follow(StraightLayout());
    follow(ShearedLayout());
  }
  if (is_set(stop)) return;  // what was not met may only not have been come to
  for (std::size_t k = 0; k < followed; ++k) {
    if (out[k].status != SolveStatus::not_run) continue;
    out[k].status =
        nonexistence_reason(problem, nu[k]) ? SolveStatus::none_exists : SolveStatus::not_found;
  }
}

}  // namespace stationary
