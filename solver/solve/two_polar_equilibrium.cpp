#include "solver/solve/two_polar_equilibrium.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "lib/matrix/elementwise.hpp"
#include "solver/motion/two_polar_stability.hpp"
#include "solver/motion/two_polar_system.hpp"
#include "solver/newton/newton.hpp"
#include "solver/newton/nlopt_seed.hpp"
#include "solver/newton/separable_parts.hpp"
#include "solver/newton/thickness_balance.hpp"
#include "solver/search/two_polar_search.hpp"
#include "solver/solve/stability.hpp"

namespace stationary {
namespace {

constexpr double least_ellipse = 1e-7;  // lambda/mu - 1 below this is the circle

class Solver {
 public:
  Solver(const Body& body, const Potential& potential, const SolveOptions& options,
         Equilibrium& out)
      : body_(body), potential_(potential), options_(options), out_(out) {}

  template <template <class> class Motion>
  void run(const Motion<double>& motion) {
    potential_.visit_parts([&](const auto& model) { run_model(model, motion); });
  }

  /// The circle with s3 = p_theta, which the pull of equal momenta keeps lambda = mu: by Newton
  /// from rest.
  void circle(double s3) {
    potential_.visit_parts([&](const auto& model) { circle_model(model, s3); });
  }

  /// The circle out.x, had at omega + theta' rounded, corrected at the two rates. Whether it
  /// converged.
  bool correct_circle(const TwoPolarRates<double>& rates) {
    return potential_.visit_parts(
        [&](const auto& model) { return correct_circle_of(model, rates); });
  }

 private:
  template <class Model>
  bool correct_circle_of(const Model& model, const TwoPolarRates<double>& rates) {
    using Elastic = decltype(elastic_system(model));
    constexpr int N = Elastic::dimension;
    const TwoPolarSystem<Elastic, TwoPolarRates> system{elastic_system(model), body_.J1, rates};
    ReducedVector<N> x = diagonal(out_.q).template head<N>();
    const Refined refined = refine(system, x);
    out_.counts.extended_residuals += refined.steps;
    if (!refined.converged || x[0] != x[1]) return false;
    out_.error_bound = refined.error_bound;
    set_stretches(model, x, out_.q.rho);
    return true;
  }

  template <class Model>
  void circle_model(const Model& model, double s3) {
    using Elastic = decltype(elastic_system(model));
    constexpr int N = Elastic::dimension;
    const TwoPolarSystem<Elastic, TwoPolarEqualMomenta> system{elastic_system(model), body_.J1,
                                                               TwoPolarEqualMomenta<double>{s3}};
    ReducedVector<N> x;
    if constexpr (N == 3) {
      x = diagonal(rest_stretch_of(system.elastic.model));
    } else {
      x[0] = x[1] = system.elastic.model.rest_stretch();
    }
    if (!newton_counted<N>(system, x)) return;
    const Refined refined = refine(system, x);
    out_.counts.extended_residuals += refined.steps;
    if (!refined.converged || x[0] != x[1]) return;
    out_.status = SolveStatus::solved;
    out_.circle = true;
    out_.error_bound = refined.error_bound;
    out_.message +=
        "; this is the circle lambda = mu, where only omega + theta_dot matters: "
        "theta_dot = 0 is written";
    set_stretches(model, x, start_thickness());
  }

  /// The rho asked for, if any.
  std::optional<double> start_thickness() const {
    return options_.start ? std::optional(options_.start->rho) : std::nullopt;
  }

  /// (lambda, mu, rho), rho by its own balance where it is not an unknown: where that has several
  /// solutions, the one near the given.
  template <class Model, int N>
  void set_stretches(const Model& model, const Eigen::Matrix<double, N, 1>& x,
                     const std::optional<double>& near) {
    out_.q = {0.0, x[0], x[1], 0.0};
    if constexpr (N == 3) {
      out_.q.rho = x[2];
    } else {
      const ThicknessBalance thickness =
          balanced_thickness(model.thickness, DoubleDouble(0.0), near);
      out_.q.rho = thickness.rho;
      out_.error_bound = std::max(out_.error_bound, thickness.refined.error_bound);
      if (!thickness.refined.converged) {
        out_.status = SolveStatus::failed;
        out_.message = std::string("the thickness balance V_rho'(rho) = 0 ") + unbalanced;
      }
    }
  }

  template <class Model, template <class> class Motion>
  void run_model(const Model& model, const Motion<double>& motion) {
    using Elastic = decltype(elastic_system(model));
    constexpr int N = Elastic::dimension;
    const TwoPolarSystem<Elastic, Motion> system{elastic_system(model), body_.J1, motion};
    ReducedVector<N> x = ones<N>();
    bool found = false;
    if constexpr (std::is_same_v<Motion<double>, TwoPolarRates<double>>) {
      const auto invariants = invariant_system<N>(system.elastic.model, body_.J1, motion);
      found = search<N>(
          system, x,
          [&](const ReducedVector<N>& at) { return invariants.linearize(to_invariants<N>(at)); },
          [&](ReducedVector<N>& at) {
            ReducedVector<N> y = to_invariants<N>(at);
            return newton_counted<N>(invariants, y) && from_invariants<N>(y, at);
          });
    } else {
      found = search<N>(
          system, x, [&](const ReducedVector<N>& at) { return system.linearize(at); },
          [&](ReducedVector<N>& at) { return newton_counted<N>(system, at); });
    }
    if (found) set_stretches(model, x, start_thickness());
  }

  template <int N>
  static ReducedVector<N> to_invariants(const ReducedVector<N>& x) {
    ReducedVector<N> y = x;
    y[0] = x[0] + x[1];
    y[1] = x[0] * x[1];
    return y;
  }
  /// False where t^2 < 4 d: no real stretches.
  template <int N>
  static bool from_invariants(const ReducedVector<N>& y, ReducedVector<N>& x) {
    const double e = y[0] * y[0] - 4.0 * y[1];
    if (!(e > 0.0)) return false;
    x = y;
    x[0] = 0.5 * (y[0] + std::sqrt(e));
    x[1] = y[1] / x[0];
    return true;
  }

  template <int N, class System>
  bool newton_counted(const System& system, ReducedVector<N>& x) {
    NewtonOptions careful;
    careful.max_log_step = 0.5;
    const NewtonResult result = newton(system, x, careful);
    out_.counts.newton_steps += result.steps;
    out_.counts.jacobians += result.steps;
    return result.converged;
  }

  template <int N, class System>
  bool finish(const System& system, ReducedVector<N>& x, double& bound) {
    const Refined refined = refine(system, x);
    out_.counts.extended_residuals += refined.steps;
    if (!refined.converged) return false;
    if (x[0] < x[1]) std::swap(x[0], x[1]);
    bound = refined.error_bound;
    return x[0] - x[1] > least_ellipse * x[1];
  }

  /// The solution with lambda > mu nearest to the unit stretches among those the seeds lead to.
  /// linearize: the system searched for starts; polish: Newton on it, in place.
  template <int N, class System, class Linearize, class Polish>
  bool search(const System& system, ReducedVector<N>& x, const Linearize& linearize,
              const Polish& polish) {
    SeedOptions seed_options;
    seed_options.stop = options_.stop;
    if constexpr (N == 3) seed_options.evaluations *= 4;
    Seeds<N> seeds;
    if (options_.start) {
      ReducedVector<N> start;
      start[0] = options_.start->xi;
      start[1] = options_.start->zeta;
      if constexpr (N == 3) start[2] = options_.start->rho;
      seeds.points.push_back(start);
    } else {
      seeds = nlopt_seeds<N>(
          [&](const ReducedVector<N>& at) {
            const Linearized<N> l = linearize(at);
            return (l.g / l.magnitude).squaredNorm();
          },
          seed_options);
      out_.counts.nlopt_evaluations += seeds.evaluations;
      out_.counts.residuals += seeds.evaluations;
    }
    if (seeds.interrupted) {
      out_.status = SolveStatus::interrupted;
      return false;
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (ReducedVector<N> candidate : seeds.points) {
      double bound = 0.0;
      if (!polish(candidate) || !finish<N>(system, candidate, bound)) continue;
      if (candidate.minCoeff() < 0.1 * seed_options.min_stretch ||
          candidate.maxCoeff() > 10.0 * seed_options.max_stretch) {
        continue;
      }
      const double distance = logarithms(candidate.array()).abs().maxCoeff();
      if (distance < nearest) {
        nearest = distance;
        x = candidate;
        out_.error_bound = bound;
      }
    }
    if (std::isfinite(nearest)) {
      out_.status = SolveStatus::solved;
      out_.message = options_.start ? "Newton from the given start" : "global search, then Newton";
      return true;
    }
    out_.status = SolveStatus::not_found;
    std::ostringstream text;
    text << "no lambda > mu was found in stretches [" << seed_options.min_stretch << ", "
         << seed_options.max_stretch << "], which is no proof that none exists";
    out_.message = text.str();
    return false;
  }

  const Body& body_;
  const Potential& potential_;
  const SolveOptions& options_;
  Equilibrium& out_;
};

void circle_instead(const Body& body, const Potential& potential,
                    const TwoPolarRates<double>& rates, const SolveOptions& options, Solver& solver,
                    Equilibrium& out) {
  const auto corrected = [&](const Stretch& near) {
    out.q = near;
    if (!solver.correct_circle(rates)) return false;
    out.status = SolveStatus::solved;
    out.circle = true;
    out.message += "; this is the circle lambda = mu, which depends on omega + theta_dot only";
    return true;
  };
  const auto& start = options.start;
  if (start && start->alpha == 0.0 && start->xi == start->zeta && corrected(*start)) return;
  SolveOptions from_rest = options;
  from_rest.start.reset();
  const Equilibrium circle =
      solve(Problem(body, potential, Branch::iii), rates.omega + rates.theta_dot, from_rest);
  out.counts += circle.counts;
  if (circle.status == SolveStatus::interrupted) out.status = SolveStatus::interrupted;
  if (circle.status == SolveStatus::interrupted || circle.status == SolveStatus::none_exists)
    return;
  std::optional<Stretch> q;
  if (circle.status == SolveStatus::solved) {
    q = circle.q;
  } else {
    // Among ellipses of branch (iii) it may be one of many; the search looks at circles alone.
    const SearchResult all = search_two_polar(body, potential, rates, {.stop = options.stop});
    for (const Equilibrium& each : all.solutions)
      if (each.circle) q = each.q;
    if (all.status == SearchStatus::interrupted) out.status = SolveStatus::interrupted;
    if (!q && out.status == SolveStatus::none_exists) {
      out.status = SolveStatus::not_found;
      out.message += "; a circle lambda = mu was not found, which is no proof that none exists";
    }
    if (!q) return;
  }
  if (corrected(*q)) return;
  out.status = SolveStatus::failed;
  out.circle = true;
  out.message += "; the circle lambda = mu did not converge";
}

/// Of all ellipses in the search's box the one nearest to the unit stretches; where none is proven, of
/// those found in boxes left undecided. False where the search does not decide whether there is one.
bool nearest_of_all(const SearchResult& all, Equilibrium& out) {
  if (all.status == SearchStatus::interrupted) {
    out.status = SolveStatus::interrupted;
    return true;
  }
  const Equilibrium* nearest = nullptr;
  int ellipses = 0;
  const auto distance = [](const Equilibrium& at) {
    return logarithms(diagonal(at.q).array()).abs().maxCoeff();
  };
  const auto look_among = [&](const std::vector<Equilibrium>& found) {
    for (const Equilibrium& each : found) {
      if (each.circle) continue;
      ++ellipses;
      if (nearest == nullptr || distance(each) < distance(*nearest)) nearest = &each;
    }
  };
  look_among(all.solutions);
  const bool proven = nearest != nullptr;
  if (!proven) look_among(all.unproven);
  if (nearest != nullptr) {
    const Counts counts = out.counts;
    out = *nearest;
    out.counts = counts;
    out.message = ellipses == 1 ? "exhaustive search: the only ellipse found"
                                : "exhaustive search: of " + std::to_string(ellipses) +
                                      " ellipses the one nearest to the unit stretches";
    if (!proven) out.message += ", in boxes left undecided";
    return true;
  }
  if (all.status != SearchStatus::complete) return false;
  out.status = SolveStatus::not_found;
  out.message = "no lambda > mu: exhaustive search, " + all.message;
  return true;
}

/// all(): every two-polar motion that a search finds.
template <class All>
Equilibrium solved(const Body& body, const Potential& potential, const TwoPolarMotion& motion,
                   const SolveOptions& options, const All& all) {
  Equilibrium out;
  Solver solver(body, potential, options, out);
  const bool by_nlopt = options.start || !options.search || options.method == Method::nlopt;
  if (const auto* rates = std::get_if<TwoPolarRates<double>>(&motion)) {
    const auto verdict = rates_verdict(body.J1, potential, *rates);
    if (verdict && verdict->on_line) {
      out.status = SolveStatus::not_isolated;
      out.message = verdict->line_message();
      return out;
    }
    if (verdict) {
      out.status = SolveStatus::none_exists;
      out.message = "lambda != mu exists only where " + verdict->condition;
    } else if (by_nlopt || !nearest_of_all(all(), out)) {
      solver.run(*rates);
    }
    if (out.status == SolveStatus::none_exists || out.status == SolveStatus::not_found)
      circle_instead(body, potential, *rates, options, solver, out);
  } else {
    const auto& momenta = std::get<TwoPolarMomenta<double>>(motion);
    const bool equal = momenta.s3 == momenta.p_theta;
    if (by_nlopt || !nearest_of_all(all(), out)) {
      if (equal) {
        solver.run(TwoPolarEqualMomenta<double>{momenta.s3});
      } else {
        solver.run(momenta);
      }
    }
    if (equal && out.status == SolveStatus::not_found) solver.circle(momenta.s3);
  }
  if (out.status != SolveStatus::solved) return out;
  set_motion(body, motion, out);
  check_motion(body, potential, out);
  if (options.start && !out.circle) out.connection = Connection::given_start;
  if (!(out.residual <= acceptable_residual)) {
    out.status = SolveStatus::failed;
    out.message += "; but the recomputed balance residual is no equilibrium's";
  }
  return out;
}

/// (lambda, mu, rho) without the rounding of q, at a motion's rates or momenta: of several those count that move q
/// least. Rounded rates may move a body far that its momenta hold, and the other way round.
struct UnroundedStretch {
  explicit UnroundedStretch(const Stretch& near)
      : q{DoubleDouble(near.xi), DoubleDouble(near.zeta), DoubleDouble(near.rho)} {}

  std::array<DoubleDouble, 3> q;
  double moved = 1.0;  ///< of q, relative

  template <class Model, template <class> class Motion>
  void at(const Body& body, const Model& model, const Motion<double>& motion, const Stretch& near) {
    using Elastic = decltype(elastic_system(model));
    constexpr int N = Elastic::dimension;
    const TwoPolarSystem<Elastic, Motion> system{elastic_system(model), body.J1, motion};
    const ReducedVector<N> x = diagonal(near).template head<N>();
    ReducedVector<N> corrected = x;
    const Refined refined = refine<false>(system, corrected);
    constexpr double last_places = 1e-10;  // beyond, extended_solution() keeps x
    if (!refined.converged || !(refined.first_correction < std::min(moved, last_places))) return;
    moved = refined.first_correction;
    const auto unrounded = extended_solution(system, x);
    std::ranges::copy(unrounded, q.begin());
    if constexpr (N == 2) {
      using Thickness = std::decay_t<decltype(model.thickness)>;
      q[2] = extended_solution(ThicknessSystem<Thickness>{model.thickness, DoubleDouble(0.0)},
                               ReducedVector<1>(near.rho))[0];
    }
  }
};

}  // namespace

Equilibrium solve_two_polar(const Body& body, const Potential& potential,
                            const TwoPolarMotion& motion, const SolveOptions& options) {
  require_two_polar(body, motion);
  if (options.start) require_positive_definite(*options.start);
  return solved(body, potential, motion, options,
                [&] { return search_two_polar(body, potential, motion, {.stop = options.stop}); });
}

void solve_two_polar_each(const Body& body, const Potential& potential,
                          const TwoPolarMotion& motion, bool spectra, const SolveOptions& options,
                          const NumberRange& range, std::span<AtValue> at) {
  SolveOptions how = options;
  how.start.reset();
  const SearchOptions search{.stop = options.stop};
  TwoPolarSearches searches(body, potential, motion, range, search);
  for (AtValue& each : at) {
    if (options.stop != nullptr && options.stop->load(std::memory_order_relaxed)) return;
    if (each.solved()) continue;
    each.equilibrium = solved(body, potential, searches.motion_at(each.value), how,
                              [&] { return searches.at(each.value); });
    if (spectra && each.solved())
      each.spectrum = two_polar_stability(body, potential, each.equilibrium);
  }
}

Spectrum two_polar_stability(const Body& body, const Potential& potential,
                             const Equilibrium& equilibrium) {
  if (equilibrium.status != SolveStatus::solved)
    throw std::invalid_argument("a spectrum needs a solved equilibrium");
  const TwoPolarRates<double>& rates = equilibrium.two_polar->rates;
  const TwoPolarMomenta<double>& momenta = equilibrium.two_polar->momenta;
  if (equilibrium.circle) {
    Equilibrium circle = equilibrium;
    const double spin = equilibrium.nu[2];
    // Rates of opposite sense cancel in their sum, half a unit of each does not.
    const double spin_error =
        spin == 0.0
            ? 0.0
            : 0x1p-53 * (std::abs(rates.omega) + std::abs(rates.theta_dot)) / std::abs(spin);
    circle.error_bound = std::max(equilibrium.error_bound, spin_error);
    const UnroundedStretch found = potential.visit_parts([&](const auto& model) {
      UnroundedStretch out(equilibrium.q);
      out.at(body, model, TwoPolarEqualMomenta<double>{momenta.s3}, equilibrium.q);
      return out;
    });
    if (found.moved <= circle.error_bound) {
      circle.error_bound += found.moved;
      const auto& [xi, zeta, rho] = found.q;
      circle.q = {0.0, xi.hi, zeta.hi, rho.hi};
      circle.unrounded = {DoubleDouble(0.0), xi, zeta, rho};
    }
    return stability(Problem(body, potential, Branch::iii), circle);
  }
  return potential.visit_parts([&](const auto& model) {
    UnroundedStretch found(equilibrium.q);
    const auto by_momenta = [&] {
      if (momenta.s3 == momenta.p_theta) {
        found.at(body, model, TwoPolarEqualMomenta<double>{momenta.s3}, equilibrium.q);
      } else {
        found.at(body, model, momenta, equilibrium.q);
      }
    };
    // What was prescribed holds it; where that leads nowhere the others may.
    const bool prescribed = equilibrium.two_polar->by_momenta;
    if (prescribed) by_momenta();
    if (!prescribed || found.moved == 1.0) found.at(body, model, rates, equilibrium.q);
    if (!prescribed && found.moved == 1.0) by_momenta();
    // Where neither leads anywhere, nothing is known of the spectrum.
    return two_polar_stability(body, model, found.q, *equilibrium.two_polar,
                               stretch_uncertainty(equilibrium.error_bound + found.moved));
  });
}

}  // namespace stationary
