#include "solver/batch/anisotropic_batch.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "lib/balance/balance.hpp"
#include "lib/matrix/elementwise.hpp"
#include "solver/continuation/corrector.hpp"
#include "solver/family/anisotropic_family.hpp"
#include "solver/family/follow_sheet.hpp"
#include "solver/solve/anisotropic_rest.hpp"
#include "solver/solve/family_solve.hpp"
#include "solver/solve/nonexistence.hpp"

namespace stationary {
namespace {

/// Of the curve between two rows, in (ln x, p over the range).
constexpr double curve_tolerance = 1e-7;
/// The range followed over the largest nu: near a turn of nu the end of a range is not met exactly.
constexpr double beyond = 1.0 + 0x1p-10;

bool is_set(const std::atomic<bool>* stop) {
  return stop != nullptr && stop->load(std::memory_order_relaxed);
}

/// The rows of a sheet in its family's coordinates.
template <int N>
class CoordinateRows final : public CurveSink {
 public:
  struct Row {
    ReducedVector<N> x;
    double p;
  };

  explicit CoordinateRows(const Family<N>& family) : family_(family) {}

  void row(const Member& member, EventType) override {
    rows_.push_back({family_.coordinates(member.q, member.parameter), member.parameter});
  }
  const std::vector<Row>& rows() const { return rows_; }

 private:
  const Family<N>& family_;
  std::vector<Row> rows_;
};

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
    range_ = beyond * nu.back();
    rows_ = followed(rest_, 0.0, range_);
    if (rows_.empty()) return;
    positive_ = family_.linearize(rows_.front().x, rows_.front().p).jacobian.determinant() > 0.0;
    std::vector<Near> pending;
    for (std::size_t b = 1; b < rows_.size(); ++b) {
      std::optional<Arc<N>> arc;
      for (; k < nu.size() && nu[k] <= rows_[b].p; ++k) {
        if (!arc) arc = arc_between(rows_[b - 1], rows_[b]);
        pending.push_back(on_arc(b, *arc, nu[k]));
        pending.back().point = k;
        if (pending.size() < OrientedPoints::size) continue;
        if (is_set(stop_)) return;
        answer(pending, out);
        pending.clear();
      }
    }
    answer(pending, out);
  }

 private:
  using Row = typename CoordinateRows<N>::Row;

  /// A nu, and where on the arc that ends at this row it is met.
  struct Near {
    std::size_t row;
    std::size_t point = 0;
    double nu;
    ReducedVector<N> x;
    double steepness;
  };

  /// Empty where the start is no point of a curve.
  std::vector<Row> followed(const Stretch& q, double from, double to) const {
    FollowOptions how;
    how.continuation.from = from;
    how.continuation.to = to;
    how.continuation.step.tolerance = curve_tolerance;
    how.events = EventSet::none().add(EventType::fold_nu).add(EventType::fold_parameter);
    how.max_points = longest_walk;
    how.stop = stop_;
    CoordinateRows<N> sink(family_);
    follow_family(bare_, q, from, how, sink);
    return sink.rows();
  }

  Arc<N> arc_between(const Row& a, const Row& b) const {
    const Corrector<N> corrector(family_, range_, Circle::none);
    ArcVector<N> chord;
    chord.template head<N>() = logarithms(b.x.array() / a.x.array()).matrix();
    chord[N] = (b.p - a.p) / range_;
    const auto ahead = [&](const Row& at) {
      const ArcVector<N> along = corrector.direction_near(at.x, at.p);
      return along.dot(chord) < 0.0 ? ArcVector<N>(-along) : along;
    };
    return Arc<N>(chord, ahead(a), ahead(b));
  }

  Near on_arc(std::size_t row, const Arc<N>& arc, double nu) const {
    const Row& a = rows_[row - 1];
    const Row& b = rows_[row];
    const auto ahead = [&](double u) { return (a.p - nu) + range_ * arc.at(u)[N]; };
    double u = 1.0;
    if (nu < b.p && ahead(0.0) < 0.0 && ahead(1.0) > 0.0) {
      std::uintmax_t evaluations = 60;
      const auto [low, high] = boost::math::tools::toms748_solve(
          ahead, 0.0, 1.0, boost::math::tools::eps_tolerance<double>(52), evaluations);
      u = 0.5 * (low + high);
    }
    return {.row = row,
            .nu = nu,
            .x = u < 1.0 ? moved<N>(a.x, ReducedVector<N>(arc.at(u).template head<N>())) : b.x,
            .steepness = 1.0 / std::max(arc.direction(u)[N], 1e-3)};
  }

  void answer(const std::vector<Near>& pending, std::span<LanePoint> out) const {
    OrientedPoints points;
    const auto kernel = problem_.kernel<Layout>();
    if (kernel != nullptr && !pending.empty()) {
      for (std::size_t i = 0; i < OrientedPoints::size; ++i) {
        const Near& near = pending[std::min(i, pending.size() - 1)];
        points.nu[i] = i < pending.size() ? near.nu : std::numeric_limits<double>::quiet_NaN();
        points.x[3][i] = 1.0;
        for (int k = 0; k < N; ++k) points.x[static_cast<std::size_t>(k)][i] = near.x[k];
      }
      kernel(*problem_.lane, points);
    }
    for (std::size_t i = 0; i < pending.size(); ++i) {
      if (is_set(stop_)) return;
      const Near& near = pending[i];
      LanePoint& point = out[near.point];
      if (kernel != nullptr && take(points, i, near, point)) continue;
      if (!answer(near, point)) go_on(rows_[near.row - 1], near.nu, point);
    }
  }

  /// Whether what was corrected is at its place on the curve.
  bool stays(const Near& near, const ReducedVector<N>& x, bool positive) const {
    // At this nu, and not across the curve: the steeper the curve the farther.
    constexpr double few = 8.0;
    const double moved_by = ((x - near.x).array() / near.x.array()).abs().maxCoeff();
    return positive == positive_ && moved_by <= few * curve_tolerance * near.steepness;
  }

  /// What a kernel has found, with its residual in doubles.
  bool take(const OrientedPoints& points, std::size_t i, const Near& near, LanePoint& out) const {
    ReducedVector<N> x;
    for (int k = 0; k < N; ++k) x[k] = points.x[static_cast<std::size_t>(k)][i];
    if (points.accepted[i] == 0.0 || !stays(near, x, points.positive[i] != 0.0)) return false;
    const Stretch q{points.alpha[i], x[0], x[1], x[2]};
    if (!(problem_.residual(q, near.nu) <= acceptable_residual)) return false;
    out = {SolveStatus::solved, q, Layout::bound_factor * points.error_bound[i]};
    return true;
  }

  bool answer(const Near& near, LanePoint& out) const {
    ReducedVector<N> x = near.x;
    const Refined refined = correct(x, near.nu, out);
    return refined.converged && stays(near, x, refined.positive);
  }

  /// Along the curve from a row to nu.
  void go_on(const Row& from, double nu, LanePoint& out) const {
    out = LanePoint();
    const Member start = family_.member(from.x, ReducedVector<N>::Zero(), from.p, 0.0);
    const std::vector<Row> rows = followed(start.q, from.p, nu);
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
  std::vector<Row> rows_;
  double range_ = 0.0;
  bool positive_ = true;  ///< det dG/d ln x where the sheet begins
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
