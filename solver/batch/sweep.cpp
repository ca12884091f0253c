#include "solver/batch/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lib/number/elementary.hpp"
#include "solver/newton/refine.hpp"

namespace stationary {
namespace {

constexpr int max_attempts = 200;  // per point: enough to halve a step to nothing several times

}  // namespace

Sweep::Sweep(const Problem& problem, const Equilibrium& start, const SweepOptions& options)
    : problem_(problem.on_part_of(start.q)), options_(options) {
  if (start.status != SolveStatus::solved)
    throw std::invalid_argument("a sweep starts from a solved equilibrium");
  const double nu = start.nu[axis(problem.branch())];
  const Stretch& q = start.q;
  // What is not known yet is multiplied by zero in predict(): it must be a number.
  past_.fill({nu, {q.xi, q.zeta, q.rho}});
  const CentrifugalRates<DoubleDouble> rates = problem.rates(two_product(nu, nu));
  circle_ = problem.branch() == Branch::iii && problem.body().symmetric() && q.xi == q.zeta;
  problem.potential().visit([&](const auto& model) {
    const auto take = [&](const auto& jacobian) {
      positive_ = jacobian.determinant() > 0.0;
      watch_side(q, jacobian(0, 0) - jacobian(0, 1));
    };
    if constexpr (requires { model.plane; }) {
      const PlanarSystem<decltype((model.plane))> system{model.plane, rates};
      take(system.linearize({q.xi, q.zeta}).jacobian);
    } else {
      const CoupledSystem<decltype(model)> system{model, rates};
      take(system.linearize({q.xi, q.zeta, q.rho}).jacobian);
    }
  });
}

/// stiffness: against ellipses, of a circle.
void Sweep::watch_side(const Stretch& q, double stiffness) {
  const Body& body = problem_.body();
  if (problem_.potential().has_turned_gravity()) {
    const double apart = std::abs(body.J1 - body.J2) / std::max(body.J1, body.J2);
    constexpr double nearly = 0.01;
    if (problem_.branch() == Branch::iii && apart <= nearly) passed_ = 10.0 * apart + 1e-6;
    return;
  }
  const CentrifugalRates<DoubleDouble> pull = problem_.rates(DoubleDouble(1.0));
  const double more = double(pull.xi - pull.zeta);
  if (more == 0.0) return;
  // A circle is left towards what is pulled more; it is one but for rounding.
  constexpr double rounding = 0x1p-40;
  const bool circle = std::abs(q.xi - q.zeta) <= rounding * q.xi;
  side_ = std::copysign(1.0, circle ? more * stiffness : q.xi - q.zeta);
}

std::array<double, 3> Sweep::predict(double nu) const {
  const auto& [x0, x1, x2] = past_;
  if (known_ == 1) return x0.x;
  const double d01 = x0.nu - x1.nu;
  const double a = (nu - x0.nu) / d01;
  double b = 0.0;
  double ratio = 0.0;
  // Newton's form of the parabola, of three nu; at equal spacing 3 (x0 - x1) + x2.
  if (known_ == 3 && x0.nu != x2.nu) {
    b = (nu - x0.nu) * (nu - x1.nu) / (d01 * (x0.nu - x2.nu));
    ratio = d01 / (x1.nu - x2.nu);
  }
  std::array<double, 3> out;
  for (std::size_t i = 0; i < 3; ++i) {
    const double slope = x0.x[i] - x1.x[i];
    const double extrapolated = x0.x[i] + a * slope + b * (slope - ratio * (x1.x[i] - x2.x[i]));
    out[i] = extrapolated > 0.0 ? extrapolated : x0.x[i];
  }
  return out;
}

bool Sweep::trusted(const Refined& refined, int unknowns) const {
  if (refined.positive != positive_ && !circle_) return false;
  const double first_correction = refined.first_correction;
  if (first_correction <= 0.01) return true;
  if (known_ == 1) return first_correction <= 0.05;
  double last_move = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(unknowns); ++i)
    last_move = std::max(last_move, std::abs(past_[0].x[i] / past_[1].x[i] - 1.0));
  return first_correction <= 0.1 * last_move;
}

namespace {

/// One copy for each system, and not for each pair of a plane and a thickness: it is what takes the
/// compiler its time.
template <bool bound, class System>
[[gnu::noinline]] Refined corrected(const System& system, ReducedVector<System::dimension>& x) {
  constexpr int most_steps = 6;
  return refine<bound>(system, x, most_steps);
}

template <int N>
bool is_short_move(const ReducedVector<N>& from, const ReducedVector<N>& to) {
  constexpr double short_move = 0.02;
  for (int i = 0; i < N; ++i)
    if (!(std::abs(to[i] - from[i]) <= short_move * from[i])) return false;
  return true;
}

/// Whether a long move stays on its sheet: it leads to a solution, and halfway in nu^2 there is one
/// about halfway. On a parabola up to its very turn that is off the middle by 0.21 of the move;
/// across a gap by half of it. middle: the system there. Rarely asked: one copy for each system,
/// apart from the solve that it follows.
template <class System>
[[gnu::cold, gnu::noinline]] bool passes_middle(const System& end, const System& middle,
                                                const ReducedVector<System::dimension>& from,
                                                const ReducedVector<System::dimension>& to) {
  constexpr double off_middle = 0.25;
  constexpr int N = System::dimension;
  // A Jacobian that is singular to rounding lets no correction be seen.
  const auto at = end.linearize(to);
  if (!(largest_magnitude<N>(at.g) <= 0x1p-30 * at.magnitude)) return false;
  ReducedVector<N> halfway;
  double move = 0.0;
  for (int i = 0; i < N; ++i) {
    move = std::max(move, std::abs(log(to[i] / from[i])));
    halfway[i] = std::sqrt(to[i]) * std::sqrt(from[i]);
  }
  ReducedVector<N> x = halfway;
  if (!refine<false>(middle, x).converged) return false;
  for (int i = 0; i < N; ++i)
    if (!(std::abs(log(x[i] / halfway[i])) <= off_middle * move)) return false;
  return true;
}

}  // namespace

/// One solve at nu from the predictor; on success the newest point of the past.
template <class Model, bool bound>
bool Sweep::attempt(const Model& model, double nu, SweepPoint& out) {
  if (nu == past_[0].nu) known_ = 1;  // asked for again: no slope to extrapolate
  std::array<double, 3> next = predict(nu);
  const CentrifugalRates<DoubleDouble> rates = problem_.rates(two_product(nu, nu));
  const auto middle_rates = [&] {
    const double last = past_[0].nu;
    return problem_.rates(0.5 * (two_product(nu, nu) + two_product(last, last)));
  };
  double error_bound = std::numeric_limits<double>::quiet_NaN();
  if constexpr (requires { model.plane; }) {
    using Plane = decltype((model.plane));  // a reference: an expression is no small object
    ReducedVector<2> x(next[0], next[1]);
    const PlanarSystem<Plane> system{model.plane, rates};
    const Refined planar = corrected<bound>(system, x);
    out.steps += planar.steps;
    if (!planar.converged || !trusted(planar, 2) || changes_sides(x[0], x[1])) return false;
    const ReducedVector<2> last(past_[0].x[0], past_[0].x[1]);
    if (!stays_inside(system, last, x)) return false;
    if (!is_short_move(last, x) &&
        !passes_middle(system, PlanarSystem<Plane>{model.plane, middle_rates()}, last, x))
      return false;
    next[0] = x[0];
    next[1] = x[1];
    if (constant_rho_known_) {
      next[2] = past_[0].x[2];
      error_bound = constant_rho_bound_;
    } else {
      using Thickness = decltype((model.thickness));
      const ThicknessSystem<Thickness> thickness{model.thickness, rates.rho};
      ReducedVector<1> rho(next[2]);
      const Refined axial = corrected<bound>(thickness, rho);
      ++thickness_solves_;
      if (!axial.converged) return false;
      const ReducedVector<1> last_rho(past_[0].x[2]);
      if (problem_.thickness_rule() != ThicknessRule::constant && !is_short_move(last_rho, rho) &&
          !passes_middle(thickness, ThicknessSystem<Thickness>{model.thickness, middle_rates().rho},
                         last_rho, rho))
        return false;
      next[2] = rho[0];
      error_bound = axial.error_bound;
      if (problem_.thickness_rule() == ThicknessRule::constant) {
        constant_rho_known_ = true;
        constant_rho_bound_ = error_bound;
      }
    }
    if (bound && planar.error_bound > error_bound) error_bound = planar.error_bound;
  } else {
    ReducedVector<3> x(next[0], next[1], next[2]);
    const CoupledSystem<const Model&> system{model, rates};
    const Refined refined = corrected<bound>(system, x);
    out.steps += refined.steps;
    if (!refined.converged || !trusted(refined, 3) || changes_sides(x[0], x[1])) return false;
    const ReducedVector<3> last(past_[0].x[0], past_[0].x[1], past_[0].x[2]);
    if (!stays_inside(system, last, x)) return false;
    if (!is_short_move(last, x) &&
        !passes_middle(system, CoupledSystem<const Model&>{model, middle_rates()}, last, x))
      return false;
    next = {x[0], x[1], x[2]};
    error_bound = refined.error_bound;
  }
  if (nu != past_[0].nu) {
    past_[2] = past_[1];
    past_[1] = past_[0];
    if (known_ < 3) ++known_;
  }
  past_[0] = {nu, next};
  out.xi = next[0];
  out.zeta = next[1];
  out.rho = next[2];
  out.error_bound = error_bound;
  return true;
}

template <class Model, bool bound>
void Sweep::reach(const Model& model, double nu, SweepPoint& out) {
  const auto past = past_;
  const int known = known_;
  double target = nu;
  for (int k = 0; k < max_attempts; ++k) {
    if (attempt<Model, bound>(model, target, out)) {
      if (target == nu) {
        out.status = SolveStatus::solved;
        return;
      }
      target = nu;
      continue;
    }
    const double halved = past_[0].nu + 0.5 * (target - past_[0].nu);
    if (std::abs(halved - past_[0].nu) <= 1e-14 * std::abs(nu)) break;
    target = halved;
  }
  // A point not found leaves no trace: halved steps crowd against a fold, and a parabola through
  // those leads nowhere else.
  past_ = past;
  known_ = known;
  const int steps = out.steps;  // a halved step's solution is not this point's
  out = SweepPoint{};
  out.nu = nu;
  out.steps = steps;
  out.status = SolveStatus::not_found;
}

// Flattened: the compiler's own budget would leave the kernel in a dozen calls, passing pairs of
// doubles through memory (measured: 1.3 to 1.5 times slower).
template <class Model, bool bound>
[[gnu::flatten]] void Sweep::run_model(const Model& model, std::span<const double> nu,
                                       std::span<SweepPoint> out) {
  for (std::size_t k = 0; k < nu.size(); ++k) {
    SweepPoint point;
    point.nu = nu[k];
    if (attempt<Model, bound>(model, nu[k], point)) {
      point.status = SolveStatus::solved;
    } else {
      reach<Model, bound>(model, nu[k], point);
    }
    out[k] = point;
  }
}

void Sweep::run(std::span<const double> nu, std::span<SweepPoint> out) {
  if (nu.size() != out.size()) throw std::invalid_argument("as many points as values of nu");
  problem_.potential().visit([&](const auto& model) {
    using Model = std::decay_t<decltype(model)>;
    options_.error_bound ? run_model<Model, true>(model, nu, out)
                         : run_model<Model, false>(model, nu, out);
  });
}

}  // namespace stationary
