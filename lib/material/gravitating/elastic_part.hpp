// The elastic energy of a body that has its volume held or its own gravity beside: a plane and a
// thickness, a plane alone (a held volume leaves it nothing to lack), one coupled model, or nothing
// at all (a fluid).
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "lib/material/models/any_model.hpp"

namespace stationary {

template <class C = double>
struct ElasticPart {
  std::optional<AnyPlane<C>> plane;
  std::optional<AnyThickness<C>> thickness;
  std::variant<std::monostate, NeoHookean3d<C>, CoupledExpression<C>> coupled;

  /// f(model, where) of each of its models; where: place of its first coefficient among all.
  template <class F>
  void for_models(const F& f) const {
    if (plane) plane->visit([&](const auto& model) { f(model, plane_place); });
    if (thickness) thickness->visit([&](const auto& model) { f(model, thickness_place); });
    std::visit(
        [&](const auto& model) {
          if constexpr (requires { model.coefficients(); }) f(model, plane_place);
        },
        coupled);
  }
  static constexpr std::size_t plane_place = 0;
  static constexpr std::size_t thickness_place = expression::largest_parameter_count;
  static constexpr std::size_t places = 2 * expression::largest_parameter_count;

  /// Whether it is known that W_t > 0 everywhere, t = xi + zeta at fixed d.
  bool rises_with_trace() const {
    bool out = false;
    for_models([&](const auto& model, std::size_t) {
      out = out || requires { model.rises_with_trace; };
    });
    return out;
  }
  bool is_fluid() const { return !plane && std::holds_alternative<std::monostate>(coupled); }

  /// Derivatives in (t, l, r); zero where there is nothing.
  template <int order, class S>
  CoupledDerivatives<Product<C, S>> evaluate(const PlanarInvariants<S>& x, const S& rho) const;

  /// The balance with the centrifugal terms.
  template <class R>
  LogBalance<R> log_balance(const R& xi, const R& zeta, const R& rho, const R& c_xi,
                            const R& c_zeta, const R& c_rho) const;

 private:
  /// Of nothing but the centrifugal terms c_k s_k^2.
  template <class R>
  static LogBalance<R> of_pull(const R& xi, const R& zeta, const R& rho) {
    return {.g_xi = -xi,
            .g_zeta = -zeta,
            .g_rho = -rho,
            .uu = -2.0 * xi,
            .uv = R(0.0),
            .vv = -2.0 * zeta,
            .uw = R(0.0),
            .vw = R(0.0),
            .ww = -2.0 * rho};
  }
};

template <class C>
template <int order, class S>
CoupledDerivatives<Product<C, S>> ElasticPart<C>::evaluate(const PlanarInvariants<S>& x,
                                                           const S& rho) const {
  using R = Product<C, S>;
  CoupledDerivatives<R> out;
  if (const auto* model = std::get_if<NeoHookean3d<C>>(&coupled))
    return model->template evaluate<order>(x, rho);
  if (const auto* model = std::get_if<CoupledExpression<C>>(&coupled))
    return model->template evaluate<order>(x, rho);
  const R none(0.0);
  out = {{none, none, none, none, none, none}, none, none, none, none};
  if (plane) out.plane = plane->template evaluate<order>(x);
  if (thickness) {
    const auto axial = thickness->template evaluate<order>(rho);
    out.plane.w += axial.v;
    out.w_r = axial.v_r;
    out.w_rr = axial.v_rr;
  }
  return out;
}

template <class C>
template <class R>
LogBalance<R> ElasticPart<C>::log_balance(const R& xi, const R& zeta, const R& rho, const R& c_xi,
                                          const R& c_zeta, const R& c_rho) const {
  if (const auto* model = std::get_if<NeoHookean3d<C>>(&coupled))
    return model->log_balance(xi, zeta, rho, c_xi, c_zeta, c_rho);
  if (const auto* model = std::get_if<CoupledExpression<C>>(&coupled))
    return model->log_balance(xi, zeta, rho, c_xi, c_zeta, c_rho);
  LogBalance<R> out = plane ? LogBalance<R>(plane->log_balance(xi, zeta, c_xi, c_zeta))
                            : of_pull(c_xi * square(xi), c_zeta * square(zeta), R(0.0));
  const LogBalance<R> axial = thickness ? LogBalance<R>(thickness->log_balance(rho, c_rho))
                                        : of_pull(R(0.0), R(0.0), c_rho * square(rho));
  out.g_rho = axial.g_rho;
  out.ww = axial.ww;
  out.uw = out.vw = R(0.0);
  return out;
}

/// The same with convert(c, k) for its coefficient c at place k.
template <class Convert>
auto with_indexed_coefficients(const ElasticPart<double>& part, const Convert& convert) {
  using C = std::remove_cvref_t<decltype(convert(0.0, std::size_t(0)))>;
  using Part = ElasticPart<double>;
  ElasticPart<C> out;
  const auto from = [&](std::size_t first) {
    return [&convert, first](double c, std::size_t k) { return convert(c, first + k); };
  };
  if (part.plane)
    out.plane.emplace(with_indexed_coefficients(*part.plane, from(Part::plane_place)));
  if (part.thickness)
    out.thickness.emplace(with_indexed_coefficients(*part.thickness, from(Part::thickness_place)));
  std::visit(
      [&](const auto& model) {
        if constexpr (requires { model.coefficients(); })
          out.coupled = with_indexed_coefficients(model, from(Part::plane_place));
      },
      part.coupled);
  return out;
}

// Compiled once, as those of its models (built_in_model.hpp), with coefficients C and a state in S.
#define STATIONARY_COMPILED_PART(keyword, C, S)                                                   \
  keyword CoupledDerivatives<S> ElasticPart<C>::evaluate<1>(const PlanarInvariants<S>&, const S&) \
      const;                                                                                      \
  keyword CoupledDerivatives<S> ElasticPart<C>::evaluate<2>(const PlanarInvariants<S>&, const S&) \
      const;                                                                                      \
  keyword LogBalance<S> ElasticPart<C>::log_balance(const S&, const S&, const S&, const S&,       \
                                                    const S&, const S&) const;
#define STATIONARY_COMPILED_PARTS(keyword)                      \
  STATIONARY_COMPILED_PART(keyword, double, DoubleDouble)       \
  STATIONARY_COMPILED_PART(keyword, DoubleDouble, DoubleDouble) \
  STATIONARY_COMPILED_PART(keyword, Interval, Interval)         \
  STATIONARY_COMPILED_PART(keyword, Conditioned, Conditioned)
STATIONARY_COMPILED_PARTS(extern template)

}  // namespace stationary
