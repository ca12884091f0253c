// A body whose potential is not its elastic energy alone, as one coupled model:
//
//   V = V_elastic - g F(T, D, z)   (gravity_derivatives.hpp; g = 0 without gravity),
//
// or, where det S = C is held, what is left of it when rho is eliminated (held_volume.hpp). Where
// J1 != J2 gravity is not isotropic, but even in alpha: what holds of isotropic bodies at alpha = 0
// holds of these, and not that alpha is 0 (Potential::may_shear()).
//
// The interface of a coupled model that takes the principal stretches apart: log_balance() is its
// balance in every number type.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "lib/gravity/self_energy.hpp"
#include "lib/material/gravitating/body_terms.hpp"
#include "lib/material/gravitating/elastic_part.hpp"
#include "lib/material/gravitating/held_volume.hpp"
#include "lib/material/models/potential_derivatives.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {

template <class C = double>
struct BodyModel {
  ElasticPart<C> elastic;
  bool gravitates = false;  ///< else g and J do not enter
  C g = C(0.0);
  GravitatingInertia<C> J{};
  std::optional<C> volume;
  /// k of the volume's equation: of the size of V's second derivatives.
  double stiffness = 1.0;

  /// Places of its own numbers among the coefficients, after the elastic ones.
  static constexpr std::size_t g_place = ElasticPart<C>::places;
  static constexpr std::size_t volume_place = g_place + 1;
  static constexpr std::size_t inertia_place = g_place + 2;
  static constexpr std::size_t places = g_place + 5;

  /// Else there is no circle at rest.
  bool isotropic() const requires std::is_same_v<C, double> { return !gravitates || J.J1 == J.J2; }

  std::array<C, places> coefficients() const {
    std::array<C, places> out{};
    elastic.for_models([&](const auto& model, std::size_t first) {
      const auto& c = model.coefficients();
      std::copy(c.begin(), c.end(), out.begin() + static_cast<std::ptrdiff_t>(first));
    });
    out[g_place] = g;
    if (volume) out[volume_place] = *volume;
    if (gravitates) {
      out[inertia_place] = J.J1;
      out[inertia_place + 1] = J.J2;
      out[inertia_place + 2] = J.J3;
    }
    return out;
  }

  bool has_principal_stretches() const { return true; }
  bool has_decimals() const {
    bool out = false;
    elastic.for_models([&](const auto& model, std::size_t) {
      if constexpr (requires { model.has_decimals(); }) out = out || model.has_decimals();
    });
    return out;
  }
  bool has_conditions() const {
    bool out = false;
    elastic.for_models([&](const auto& model, std::size_t) {
      if constexpr (requires { model.has_conditions(); }) out = out || model.has_conditions();
    });
    return out;
  }
  /// Of its formulas, at the volume held.
  std::vector<ConditionValue> conditions_at(Stretch q) const requires std::is_same_v<C, double> {
    if (volume) q.rho = *volume / planar_invariants(q).d;
    std::vector<ConditionValue> out;
    elastic.for_models([&](const auto& model, std::size_t) {
      if constexpr (requires { model.conditions_at(q); })
        for (const ConditionValue& each : model.conditions_at(q)) out.push_back(each);
    });
    return out;
  }
  BodyModel on_part_of(Stretch q) const requires std::is_same_v<C, double> {
    if (volume) q.rho = *volume / planar_invariants(q).d;
    BodyModel out = *this;
    if (out.elastic.plane) out.elastic.plane = out.elastic.plane->on_part_of(q);
    if (out.elastic.thickness) out.elastic.thickness = out.elastic.thickness->on_part_of(q);
    if (auto* formula = std::get_if<CoupledExpression<>>(&out.elastic.coupled))
      *formula = formula->on_part_of(q);
    return out;
  }
  /// Whether a box of stretches holds no solution: a formula is defined nowhere in it, or the
  /// volume is another.
  bool outside_in(const Interval& xi, const Interval& zeta,
                  const Interval& rho) const requires std::is_same_v<C, Interval> {
    if (volume && (xi * zeta * rho).apart_from(*volume)) return true;
    const Interval thickness = volume ? *volume / (xi * zeta) : rho;
    if (const auto* formula = std::get_if<CoupledExpression<C>>(&elastic.coupled))
      return formula->outside_in(xi, zeta, thickness);
    return (elastic.plane && elastic.plane->outside_in(xi, zeta)) ||
           (elastic.thickness && elastic.thickness->outside_in(thickness));
  }

  /// The centrifugal rates of its own may be any numbers of R.
  template <int order = 2, class R>
  LogBalance<R> log_balance(const R& xi, const R& zeta, const R& rho, const R& c_xi,
                            const R& c_zeta, const R& c_rho) const {
    return held_of<order>(whole<order>(xi, zeta, thickness(xi, zeta, rho), c_xi, c_zeta, c_rho), xi,
                          zeta, rho);
  }
  /// rho, or what the held volume leaves of it.
  template <class R>
  R thickness(const R& xi, const R& zeta, const R& rho) const {
    return volume ? R(*volume) / (xi * zeta) : rho;
  }
  /// log_balance() from whole() at thickness().
  template <int order, class R>
  LogBalance<R> held_of(const LogBalance<R>& all, const R& xi, const R& zeta, const R& rho) const {
    if (!volume) return all;
    const R excess = log(xi * zeta * rho / R(*volume));
    return with_volume<order>(held<order>(all), excess, stiffness);
  }
  template <class R>
  LogBalance<R> residual(const R& xi, const R& zeta, const R& rho, const R& c_xi, const R& c_zeta,
                         const R& c_rho) const {
    return log_balance<1>(xi, zeta, rho, c_xi, c_zeta, c_rho);
  }

  /// The terms that the balance is the difference of: as above at rho, no volume held.
  template <int order, class R>
  LogBalance<R> whole(const R& xi, const R& zeta, const R& rho, const R& c_xi, const R& c_zeta,
                      const R& c_rho) const {
    LogBalance<R> out = elastic.log_balance(xi, zeta, rho, c_xi, c_zeta, c_rho);
    if (!gravitates) return out;
    const GravityBalance<R> pull = gravity_balance<order>(
        R(g), R(R(J.J1) * square(xi)), R(R(J.J2) * square(zeta)), R(R(J.J3) * square(rho)));
    out.g_xi += pull.pull[0];
    out.g_zeta += pull.pull[1];
    out.g_rho += pull.pull[2];
    if constexpr (order >= 2) {
      out.uu += pull.slope[0];
      out.uv += pull.slope[1];
      out.uw += pull.slope[2];
      out.vv += pull.slope[3];
      out.vw += pull.slope[4];
      out.ww += pull.slope[5];
    }
    return out;
  }

  /// In (t, l, r), J1 = J2; of a held volume with its equation, as log_balance() has it.
  template <int order, class S>
  CoupledDerivatives<Product<C, S>> evaluate(const PlanarInvariants<S>& x, const S& rho) const {
    using R = Product<C, S>;
    CoupledDerivatives<R> out = in_plane<order>(x, volume ? R(*volume / x.d) : R(rho));
    if (volume) {
      if constexpr (order >= 1) {
        const R pull = stiffness * log(R(x.d * rho / *volume));
        out.plane.w_l += pull;
        out.w_r += pull;
      }
      if constexpr (order >= 2)
        for (R* slope : {&out.plane.w_ll, &out.w_lr, &out.w_rr}) *slope += R(stiffness);
    }
    return out;
  }
  /// Of a held volume, in (t, l) alone: rho is C/d. J1 = J2.
  template <int order, class S>
  PlanarDerivatives<Product<C, S>> along_volume(const PlanarInvariants<S>& x) const {
    return in_plane<order>(x, Product<C, S>(*volume / x.d)).plane;
  }

  /// In q; of a held volume along it.
  template <int order, class S>
  PotentialDerivatives<Product<C, S>> derivatives(const BasicStretch<S>& q) const {
    using R = Product<C, S>;
    const auto x = planar_invariants(q);
    const R thickness = volume ? R(*volume / x.d) : R(q.rho);
    const BasicStretch<R> at{R(q.alpha), R(q.xi), R(q.zeta), R(q.rho)};
    PotentialDerivatives<R> out = in_stretch<order>(elastic_at<order>(x, thickness), at);
    if (!gravitates) return out;
    const CoupledDerivatives<R> V =
        at_volume<order>(R(g), planar_moment(GravitatingInertia<R>{R(J.J1), R(J.J2), R(J.J3)}, at),
                         R(x.d), thickness);
    add_gravity<order>(V, GravitatingInertia<R>{R(J.J1), R(J.J2), R(J.J3)}, at, out);
    return out;
  }

  /// The multiplier P of det S = C: grad V - P grad(d rho) is the centrifugal force. c_rho: the
  /// centrifugal rate of rho. Only of a held volume.
  template <class R>
  R pressure(const R& xi, const R& zeta, const R& c_rho) const {
    const R none(0.0);
    const R rho = R(*volume) / (xi * zeta);
    return whole<1>(xi, zeta, rho, none, none, c_rho).g_rho / R(*volume);
  }

 private:
  /// In (t, l, r), J1 = J2, at a thickness that is rho, or what a held volume leaves.
  template <int order, class S>
  CoupledDerivatives<Product<C, S>> in_plane(const PlanarInvariants<S>& x,
                                             const Product<C, S>& thickness) const {
    using R = Product<C, S>;
    CoupledDerivatives<R> out = elastic_at<order>(x, thickness);
    if (!gravitates) return out;
    const R t(x.t);
    const R d(x.d);
    R T;
    if constexpr (std::is_same_v<R, Interval>) {
      T = R(J.J1) * (R(x.e) + 2.0 * d);  // terms that are not negative: the narrower form
    } else {
      T = R(J.J1) * (t * t - 2.0 * d);
    }
    add<order>(gravity_of_trace<order>(at_volume<order>(R(g), T, d, thickness), R(J.J1), t, d),
               out);
    return out;
  }
  template <int order, class S>
  CoupledDerivatives<Product<C, S>> elastic_at(const PlanarInvariants<S>& x,
                                               const Product<C, S>& thickness) const {
    using R = Product<C, S>;
    const PlanarInvariants<R> wide{R(x.t), R(x.d), R(x.e)};
    const CoupledDerivatives<R> V = elastic.template evaluate<order>(wide, thickness);
    return volume ? held<order>(V) : V;
  }
  template <int order, class R>
  CoupledDerivatives<R> at_volume(const R& strength, const R& T, const R& d,
                                  const R& thickness) const {
    const GravitatingInertia<R> inertia{R(J.J1), R(J.J2), R(J.J3)};
    const CoupledDerivatives<R> V = gravity_derivatives<order>(strength, inertia, T, d, thickness);
    return volume ? held<order>(V) : V;
  }
  template <int order, class R>
  static void add(const CoupledDerivatives<R>& more, CoupledDerivatives<R>& to) {
    to.plane.w += more.plane.w;
    if constexpr (order >= 1) {
      to.plane.w_t += more.plane.w_t;
      to.plane.w_l += more.plane.w_l;
      to.w_r += more.w_r;
    }
    if constexpr (order >= 2) {
      to.plane.w_tt += more.plane.w_tt;
      to.plane.w_tl += more.plane.w_tl;
      to.plane.w_ll += more.plane.w_ll;
      to.w_tr += more.w_tr;
      to.w_lr += more.w_lr;
      to.w_rr += more.w_rr;
    }
  }
};

/// With convert(c, k) for its coefficient c at place k.
template <class Convert>
auto with_indexed_coefficients(const BodyModel<double>& model, const Convert& convert) {
  using C = std::remove_cvref_t<decltype(convert(0.0, std::size_t(0)))>;
  using Model = BodyModel<double>;
  constexpr std::size_t J = Model::inertia_place;
  BodyModel<C> out;
  out.elastic = with_indexed_coefficients(model.elastic, convert);
  out.stiffness = model.stiffness;
  out.gravitates = model.gravitates;
  if (model.gravitates) {
    out.g = convert(model.g, Model::g_place);
    out.J = {convert(model.J.J1, J), convert(model.J.J2, J + 1), convert(model.J.J3, J + 2)};
  }
  if (model.volume) out.volume = convert(*model.volume, Model::volume_place);
  return out;
}

}  // namespace stationary
