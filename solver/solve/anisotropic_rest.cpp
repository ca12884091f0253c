#include "solver/solve/anisotropic_rest.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "lib/number/elementary.hpp"
#include "solver/motion/oriented_system.hpp"
#include "solver/newton/newton.hpp"
#include "solver/search/anisotropic_search.hpp"

namespace stationary {
namespace {

class RestSearch {
 public:
  RestSearch(const Body& body, const Potential& potential, const SolveOptions& options,
             Counts& counts)
      : body_(body),
        potential_(potential),
        V_(potential.anisotropic()),
        options_(options),
        counts_(counts) {}

  std::optional<Stretch> from_isotropic(const Stretch& isotropic) {
    for (const int steps : {1, 8, 64}) {
      Stretch q = isotropic;
      bool reached = true;
      for (int k = 1; reached && k <= steps; ++k) reached = correct(double(k) / steps, q);
      if (reached) return q;
    }
    return std::nullopt;
  }

  /// rho: of the thickness at rest, or near it; all lengths in units of `unit`.
  std::optional<Stretch> nearest_minimum(double rho, double unit) {
    const auto from_rest = [&](const Stretch& q) {
      return from_unit({q.alpha / unit, q.xi / unit, q.zeta / unit, q.rho / unit}, rho);
    };
    std::array<std::optional<Stretch>, 3> nearest;  // by rank, the best first
    const auto consider = [&](const Stretch& q) {
      if (const auto rank = rank_of(q))
        if (auto& best = nearest[*rank]; !best || from_rest(q) < from_rest(*best)) best = q;
    };
    const auto found = [&]() -> std::optional<Stretch> {
      for (const auto& each : nearest)
        if (each) return each;
      return std::nullopt;
    };
    for (const double xi : {1.0, 0.7, 1.5}) {
      for (const double zeta : {1.0, 0.7, 1.5}) {
        for (const double shear : {0.0, 0.2, -0.2}) {
          Stretch q{unit * shear * std::sqrt(xi * zeta), unit * xi, unit * zeta, unit * rho};
          if (const auto volume = V_.body().volume) q.rho = *volume / planar_invariants(q).d;
          if (correct(1.0, q)) consider(q);
        }
      }
    }
    if (found() || !options_.search) return found();
    const Problem problem(body_, potential_, Branch::iii);
    // A tenth of the boxes, a second: the rest of them solve.all goes through.
    const SearchOptions few{.max_boxes = 1000, .stop = options_.stop};
    const SearchResult all = search_anisotropic(problem, 0.0, few);
    for (const Equilibrium& each : all.solutions) consider(each.q);
    return found();
  }

 private:
  /// q to the rest state with a share of the fibres' stiffness, by Newton; unchanged where false.
  bool correct(double share, Stretch& q) {
    AnisotropicPotential part = V_;
    int place = V_.fibre_place();
    for (const Fibre& fibre : V_.fibres()) {
      part = part.with_coefficient(place, share * fibre.k);
      place += 2;
    }
    const OrientedModels models(part);
    const OrientedSystem<ShearedLayout> system{&models, body_, Branch::iii, 0.0};
    ReducedVector<4> x(q.xi, q.zeta, q.rho, shear_coordinate(q));
    const NewtonResult found = newton(system, x);
    counts_.newton_steps += found.steps;
    counts_.jacobians += found.steps;
    if (!found.converged) return false;
    // Newton from alpha = 0 stays there but for rounding.
    if (V_.shear_free() && q.alpha == 0.0) x[3] = 1.0;
    q = oriented_stretch(x[0], x[1], x[2], x[3]).q;
    return true;
  }

  /// Of an even V the families from rest keep alpha = 0: minima of V there come first, those that
  /// shear makes less next, and last minima with alpha != 0. Nothing: no minimum.
  std::optional<std::size_t> rank_of(const Stretch& q) const {
    if (is_minimum(q, true)) return V_.shear_free() && q.alpha != 0.0 ? 2U : 0U;
    if (V_.shear_free() && q.alpha == 0.0 && is_minimum(q, false)) return 1U;
    return std::nullopt;
  }

  bool is_minimum(const Stretch& q, bool of_alpha_too) const {
    // alpha comes first. Along a held volume rho follows.
    const int first = of_alpha_too ? 0 : 1;
    const int free = (V_.body().volume ? 3 : 4) - first;
    const Eigen::MatrixXd H = potential_.derivatives(q).hessian.block(first, first, free, free);
    return Eigen::LLT<Eigen::MatrixXd>(H).info() == Eigen::Success;
  }

  /// Largest |ln| of the principal stretches, rho's over what it is at rest.
  static double from_unit(const Stretch& q, double rho) {
    const PrincipalStretches plane = principal_stretches(q);
    return std::max(
        {std::abs(log(plane.lambda)), std::abs(log(plane.mu)), std::abs(log(q.rho / rho))});
  }

  const Body& body_;
  const Potential& potential_;
  const AnisotropicPotential& V_;
  const SolveOptions& options_;
  Counts& counts_;
};

}  // namespace

AnisotropicRest anisotropic_rest(const Body& body, const Potential& potential,
                                 const SolveOptions& options, Counts& counts) {
  RestSearch search(body, potential, options, counts);
  const double r = potential.anisotropic().rest_stretch();
  const double rho = potential.anisotropic().rest_thickness();
  if (std::isfinite(r) && std::isfinite(rho))
    return {search.from_isotropic({0.0, r, r, rho}),
            "no rest state was found from that without fibres"};
  const auto& volume = potential.anisotropic().body().volume;
  return {search.nearest_minimum(std::isfinite(rho) ? rho : 1.0, volume ? cube_root(*volume) : 1.0),
          "no rest state, a minimum of V, was found"};
}

}  // namespace stationary
