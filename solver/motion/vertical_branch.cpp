#include "solver/motion/vertical_branch.hpp"

#include <array>
#include <cmath>
#include <initializer_list>
#include <type_traits>

#include "lib/material/models/first_order_bound_model.hpp"
#include "lib/number/first_order_bound_functions.hpp"
#include "solver/motion/two_polar_motion.hpp"
#include "solver/newton/separable_parts.hpp"

namespace stationary {
namespace {

enum class Sign { minus, zero, plus, undefined };

/// Zero: within the rounding of the parameters and of c.
Sign sign(const Conditioned& x) {
  if (!std::isfinite(x.value) || !std::isfinite(x.condition)) return Sign::undefined;
  if (std::abs(x.value) <= 0x1p-48 * x.condition) return Sign::zero;
  return x.value < 0.0 ? Sign::minus : Sign::plus;
}

/// Whether a function of (t, d) is zero wherever it is defined, and whether it has a zero, both on
/// a grid of ellipses.
struct Signs {
  bool all_zero = true;
  bool minus = false;
  bool plus = false;
  bool zero = false;

  void add(Sign s) {
    if (s == Sign::undefined) return;
    all_zero = all_zero && s == Sign::zero;
    minus = minus || s == Sign::minus;
    plus = plus || s == Sign::plus;
    zero = zero || s == Sign::zero;
  }
  bool somewhere() const { return zero || (minus && plus); }
};

/// At c; derivatives(x) has W_t and W_l at planar invariants, that of a held volume's thickness in it.
template <class Derivatives>
std::optional<std::string> condition_on_grid(double c, const Derivatives& derivatives) {
  const Conditioned rate = Conditioned::input(c);
  Signs first;
  Signs second;
  for (double d = 0x1p-8; d <= 0x1p8; d *= 1.75) {
    for (const double ratio : {1.1, 1.7, 3.0, 12.0}) {
      const Conditioned xi = Conditioned::input(std::sqrt(d * ratio));
      const Conditioned zeta = Conditioned::input(std::sqrt(d / ratio));
      const auto x = planar_invariants(xi, zeta);
      const auto [w_t, w_l] = derivatives(x);
      first.add(sign(w_t - rate * x.t));
      second.add(sign(w_l + rate * x.d));
      if (!first.all_zero && !second.all_zero) return std::nullopt;
    }
  }
  if (first.all_zero && second.somewhere()) return "W_t = J1 nu^2 t for all t and d";
  if (second.all_zero && first.somewhere()) return "W_d = -J1 nu^2 for all t and d";
  return std::nullopt;
}

using Slopes = std::array<Conditioned, 2>;

/// Of a written-out plane.
std::optional<std::string> written_condition(const PlanarExpression<>& plane, double c) {
  return condition_on_grid(c, [model = conditioned_model(plane)](const auto& x) {
    const auto w = model.template evaluate<1>(x);
    return Slopes{w.w_t, w.w_l};
  });
}

/// Of a plane whose volume is held: d is free in W(t, l) + V(volume/d).
std::optional<std::string> held_condition(const BodyModel<>& body, double c) {
  if (body.gravitates || !body.volume || !body.elastic.plane) return std::nullopt;
  const Conditioned volume = Conditioned::input(*body.volume);
  return body.elastic.plane->visit([&](const auto& plane) {
    return condition_on_grid(c, [&, model = conditioned_model(plane)](const auto& x) {
      const auto w = model.template evaluate<1>(x);
      Slopes out{w.w_t, w.w_l};
      if (!body.elastic.thickness) return out;
      const Conditioned rho = volume / x.d;
      body.elastic.thickness->visit([&](const auto& thickness) {
        out[1] -= rho * conditioned_model(thickness).template evaluate<1>(rho).v_r;
      });
      return out;
    });
  });
}

}  // namespace

std::optional<std::string> vertical_condition(const Problem& problem, double nu) {
  if (problem.branch() != Branch::iii || !problem.body().symmetric() || nu == 0.0)
    return std::nullopt;
  const double J = problem.body().J1;
  if (const BodyModel<>* body = problem.potential().body_model())
    return held_condition(*body, J * nu * nu);
  const auto parts = separable_parts(problem.potential());
  if (!parts) return std::nullopt;
  if (const auto* written = std::get_if<PlanarExpression<>>(&parts->plane.model))
    return written_condition(*written, J * nu * nu);
  // Without lambda no ellipse balances there.
  const bool held = parts->plane.visit([](const auto& model) {
    using Model = std::decay_t<decltype(model)>;
    if constexpr (std::is_same_v<Model, Biot<>>) return model.lambda > 0.0;
    if constexpr (std::is_same_v<Model, NeoHookean<>>) return model.lambda != 0.0;
    return false;
  });
  if (!held) return std::nullopt;
  const auto verdict = rates_verdict(J, problem.potential(), {nu, 0.0});
  return verdict && verdict->on_line ? std::optional(verdict->condition) : std::nullopt;
}

}  // namespace stationary
