// A body whose volume det S = C is held, as a potential of xi and zeta alone: rho is C/(xi zeta)
// (held_volume.hpp). The interface of a planar model, with a centrifugal rate of rho beside.
#pragma once

#include "lib/material/gravitating/body_model.hpp"

namespace stationary {

template <class C = double>
struct HeldPlane {
  BodyModel<C> body;  ///< of a held volume

  /// G_xi and G_zeta, Gamma_1 - Gamma_3 and Gamma_2 - Gamma_3, and their slopes in ln xi, ln zeta.
  template <int order = 2, class R>
  LogBalance<R> log_balance(const R& xi, const R& zeta, const R& c_xi, const R& c_zeta,
                            const R& c_rho = R(0.0)) const {
    return held<order>(
        body.template whole<order>(xi, zeta, thickness(xi, zeta), c_xi, c_zeta, c_rho));
  }
  template <class R>
  R thickness(const R& xi, const R& zeta) const {
    return R(*body.volume) / (xi * zeta);
  }

  /// J1 = J2 where the body gravitates.
  template <int order, class S>
  PlanarDerivatives<Product<C, S>> evaluate(const PlanarInvariants<S>& x) const {
    return body.template along_volume<order>(x);
  }

  /// A formula is defined nowhere in the box.
  bool outside_in(const Interval& xi,
                  const Interval& zeta) const requires std::is_same_v<C, Interval> {
    return body.outside_in(xi, zeta, thickness(xi, zeta));
  }
};

/// With convert(c, k) for its coefficient c at place k.
template <class Convert>
auto with_indexed_coefficients(const HeldPlane<double>& model, const Convert& convert) {
  const auto body = with_indexed_coefficients(model.body, convert);
  using C = std::remove_cvref_t<decltype(body.g)>;
  return HeldPlane<C>{body};
}

}  // namespace stationary
