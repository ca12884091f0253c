// The reduced balance over a box of stretches X, in interval arithmetic: every G(x) and every
// dG/d ln x, x in X, lies in what linearize(X) returns, whatever values the inputs have in theirs.
//
// The three systems of reduced_system.hpp with coefficients and centrifugal rates as intervals, and
// with the models' log_balance(), which is the narrower form over an interval.
#pragma once

#include <array>
#include <memory>

#include "lib/balance/balance.hpp"
#include "lib/material/models/model_coefficients.hpp"
#include "lib/matrix/small_matrix.hpp"
#include "lib/number/interval.hpp"
#include "lib/stability/linearization.hpp"
#include "solver/newton/reduced_system.hpp"
#include "solver/proof/term_bounds.hpp"

namespace stationary {

template <int N>
using Box = std::array<Interval, N>;

template <std::size_t N>
bool within(const std::array<Interval, N>& inner, const std::array<Interval, N>& outer) {
  for (std::size_t i = 0; i < N; ++i)
    if (!inner[i].within(outer[i])) return false;
  return true;
}
template <std::size_t N>
bool apart(const std::array<Interval, N>& a, const std::array<Interval, N>& b) {
  for (std::size_t i = 0; i < N; ++i)
    if (a[i].apart_from(b[i])) return true;
  return false;
}

/// Whether the numbers of a case are the doubles they were read as, or decimals within half a unit
/// of the last place of those.
enum class Inputs { doubles, decimals };

inline Interval as_input(double x, Inputs inputs) {
  return inputs == Inputs::doubles ? Interval(x) : Interval::decimal(x);
}

inline Inertia3<Interval> inertia_intervals(const Body& body, Inputs inputs) {
  return {as_input(body.J1, inputs), as_input(body.J2, inputs), as_input(body.J3, inputs)};
}

template <class Model>
auto interval_model(const Model& model, Inputs inputs) {
  return with_coefficients(model, [inputs](double c) { return as_input(c, inputs); });
}

/// Whether a model that may be an expression is defined nowhere in a box of what it depends on.
template <class Model, class... Sides>
bool defined_nowhere(const Model& model, const Sides&... box) {
  if constexpr (requires { model.plane; }) {  // of all three stretches
    const std::array<Interval, 3> all{box...};
    return defined_nowhere(model.plane, all[0], all[1]) || defined_nowhere(model.thickness, all[2]);
  } else if constexpr (requires { model.outside_in(box...); }) {
    return model.outside_in(box...);
  } else {
    return false;
  }
}

/// Residual and Jacobian over a box; the upper triangle as SmallSymmetric has it.
template <int N>
struct BoxLinearized {
  Box<N> g;
  Box<N*(N + 1) / 2> jacobian;

  const Interval& operator()(int i, int j) const {
    return jacobian[static_cast<std::size_t>(SmallSymmetric<N>::index(i, j))];
  }
  /// The middle of the Jacobian.
  SmallSymmetric<N> middle() const {
    SmallSymmetric<N> out;
    for (std::size_t k = 0; k < jacobian.size(); ++k) out.entries[k] = jacobian[k].mid();
    return out;
  }
};

/// As BoxLinearized, of equations without symmetry.
template <int N>
struct GeneralBoxLinearized {
  Box<N> g;
  std::array<Box<N>, static_cast<std::size_t>(N)> slope;  ///< rows

  const Interval& operator()(int i, int j) const {
    return slope[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  SmallMatrix<N> middle() const {
    SmallMatrix<N> out;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) out.entries(i, j) = (*this)(i, j).mid();
    return out;
  }
};

template <class Thickness>
struct ThicknessBoxSystem {
  static constexpr int dimension = 1;
  Thickness model;
  Interval rate;
  std::shared_ptr<const TermBounds<1>> terms = {};  ///< of a formula, for searches

  BoxLinearized<1> linearize(const Box<1>& x) const {
    const auto b = model.log_balance(x[0], rate);
    return {{b.g_rho}, {b.ww}};
  }
  bool excludes(const Box<1>& x) const { return defined_nowhere(model, x[0]); }
  bool contract(Box<1>& x) const { return !terms || terms->contract(x); }
};

/// Holds every solution, where the balance is linear in powers of the stretches and regular
/// (Cramer's rule); entire elsewhere.
template <class Plane>
Box<2> linear_solution_box(const Plane& model, const CentrifugalRates<Interval>& rates) {
  Box<2> out{Interval::entire(), Interval::entire()};
  if constexpr (requires { model.of_any_kind; }) {
    return model.visit([&](const auto& own) { return linear_solution_box(own, rates); });
  } else if constexpr (requires { model.balance_power; }) {
    const auto b = model.linear_balance(rates.xi, rates.zeta);
    const Interval det = b.a_xi * b.a_zeta - square(b.cross);
    out[0] = (b.load_xi * b.a_zeta - b.load_zeta * b.cross) / det;
    out[1] = (b.load_zeta * b.a_xi - b.load_xi * b.cross) / det;
    if constexpr (Plane::balance_power == 2) {
      for (Interval& x : out)
        if (x.bounded()) x = x.negative() ? x : sqrt(Interval(std::max(x.lo, 0.0), x.hi));
    }
  }
  return out;
}

template <class Plane>
struct PlanarBoxSystem {
  static constexpr int dimension = 2;
  Plane model;
  CentrifugalRates<Interval> rates;
  std::shared_ptr<const TermBounds<2>> terms = {};

  BoxLinearized<2> linearize(const Box<2>& x) const {
    const auto b = model.log_balance(x[0], x[1], rates.xi, rates.zeta);
    return {{b.g_xi, b.g_zeta}, {b.uu, b.uv, b.vv}};
  }
  bool excludes(const Box<2>& x) const { return defined_nowhere(model, x[0], x[1]); }
  bool contract(Box<2>& x) const { return !terms || terms->contract(x); }
  Box<2> solution_box() const { return linear_solution_box(model, rates); }
};

template <class Coupled>
struct CoupledBoxSystem {
  static constexpr int dimension = 3;
  Coupled model;
  CentrifugalRates<Interval> rates;
  std::shared_ptr<const TermBounds<3>> terms = {};

  BoxLinearized<3> linearize(const Box<3>& x) const {
    const auto b = model.log_balance(x[0], x[1], x[2], rates.xi, rates.zeta, rates.rho);
    return {{b.g_xi, b.g_zeta, b.g_rho}, {b.uu, b.uv, b.uw, b.vv, b.vw, b.ww}};
  }
  bool excludes(const Box<3>& x) const {
    if (defined_nowhere(model, x[0], x[1], x[2])) return true;
    if constexpr (is_body_model<Coupled>) {
      // At a solution the volume's equation holds, so the others do without what it adds to them.
      if (model.volume) {
        const auto b = held<1>(model.template whole<1>(
            x[0], x[1], model.thickness(x[0], x[1], x[2]), rates.xi, rates.zeta, rates.rho));
        return !b.g_xi.may_be(0.0) || !b.g_zeta.may_be(0.0);
      }
    }
    return false;
  }
  bool contract(Box<3>& x) const {
    if constexpr (is_body_model<Coupled>) {
      if (!model.volume) return true;
      for (std::size_t k = 0; k < 3; ++k) {
        const Interval left = *model.volume / (x[(k + 1) % 3] * x[(k + 2) % 3]);
        if (left.apart_from(x[k])) return false;
        x[k] = {std::max(x[k].lo, left.lo), std::min(x[k].hi, left.hi)};
      }
      return true;
    }
    return !terms || terms->contract(x);
  }
};

}  // namespace stationary
