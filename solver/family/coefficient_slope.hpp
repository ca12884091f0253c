// A model with one of its coefficients varied, and the slope of the reduced balance in it, or in an inertia.
#pragma once

#include "solver/family/axis_family.hpp"
#include "solver/newton/reduced_system.hpp"

namespace stationary {

/// model with one coefficient at another value.
template <template <class> class Model>
Model<double> with_coefficient(const Model<double>& model, int index, double value) {
  return with_indexed_coefficients(model, [&](double c, std::size_t k) {
    return k == static_cast<std::size_t>(index) ? value : c;
  });
}

/// model with the coefficient the parameter names, if it names one, at another value.
template <class Model>
Model at_coefficient(Model model, const FamilyParameter& parameter, double value) {
  using Kind = FamilyParameter::Kind;
  if constexpr (requires { model.plane; }) {
    if (parameter.kind == Kind::plane || parameter.kind == Kind::shared)
      model.plane = with_coefficient(model.plane, parameter.index, value);
    if (parameter.kind == Kind::thickness || parameter.kind == Kind::shared)
      model.thickness = with_coefficient(model.thickness, parameter.index, value);
  } else {
    if (parameter.kind == Kind::plane) model = with_coefficient(model, parameter.index, value);
  }
  return model;
}

/// model with its coefficients as dual numbers of slope one: direction k is coefficient k.
template <template <class> class Model>
auto with_duals(const Model<double>& model) {
  return with_indexed_coefficients(model, [](double c, std::size_t k) {
    return CoefficientDual<Model<double>>::along(c, 1.0, k);
  });
}

template <int N, class Model>
ReducedVector<N> gradient_slope(const Model& model, std::size_t direction,
                                const ReducedVector<N>& x);

/// gradient_slope() of a body's number at this place.
inline ReducedVector<3> body_slope(const BodyModel<>& model, std::size_t place,
                                   const ReducedVector<3>& x) {
  const double rho = model.thickness(x[0], x[1], x[2]);
  ReducedVector<3> out = ReducedVector<3>::Zero();
  if (place == BodyModel<>::volume_place) {
    const double C = *model.volume;
    const auto b = model.whole<2>(x[0], x[1], rho, 0.0, 0.0, 0.0);
    const double k = model.stiffness;
    return {(b.uw - b.ww - k) / C, (b.vw - b.ww - k) / C, -k / C};
  }
  if (place >= BodyModel<>::g_place) {
    if (!model.gravitates) return out;
    const std::size_t k =
        place == BodyModel<>::g_place ? 0 : place - BodyModel<>::inertia_place + 1;
    const auto b =
        gravity_with_duals(model, x[0], x[1], rho, [](double, std::size_t) { return 1.0; });
    out = {b.g_xi.slope[k], b.g_zeta.slope[k], b.g_rho.slope[k]};
  } else {
    using Part = ElasticPart<>;
    if (place >= Part::thickness_place) {
      out[2] = gradient_slope<1>(*model.elastic.thickness, place - Part::thickness_place,
                                 ReducedVector<1>(rho))[0];
    } else if (model.elastic.plane) {
      out.head<2>() = gradient_slope<2>(*model.elastic.plane, place, ReducedVector<2>(x[0], x[1]));
    } else {
      std::visit(
          [&](const auto& coupled) {
            if constexpr (requires { coupled.coefficients(); })
              out = gradient_slope<3>(coupled, place, ReducedVector<3>(x[0], x[1], rho));
          },
          model.elastic.coupled);
    }
  }
  if (model.volume) out = {out[0] - out[2], out[1] - out[2], 0.0};
  return out;
}

/// d/dc of the gradient of V in (ln xi, ln zeta), or in all three of a coupled model, c coefficient
/// number `direction`.
template <int N, class Model>
ReducedVector<N> gradient_slope(const Model& model, std::size_t direction,
                                const ReducedVector<N>& x) {
  if constexpr (is_body_model<Model>) {
    return body_slope(model, direction, x);
  } else if constexpr (requires { model.of_any_kind; }) {
    return model.visit([&](const auto& own) { return gradient_slope<N>(own, direction, x); });
  } else if constexpr (N == 1) {
    return ReducedVector<1>(with_duals(model).template evaluate<1>(x[0]).v_r.slope[direction]);
  } else {
    const CentrifugalRates<double> none{0.0, 0.0, 0.0};
    const auto invariants = planar_invariants(x[0], x[1]);
    if constexpr (N == 2) {
      const auto b = planar_log_balance<1>(with_duals(model).template evaluate<1>(invariants), x[0],
                                           x[1], none);
      return {b.g_xi.slope[direction], b.g_zeta.slope[direction]};
    } else {
      const auto b = coupled_log_balance<1>(
          with_duals(model).template evaluate<1>(invariants, x[2]), x[0], x[1], x[2], none);
      return {b.g_xi.slope[direction], b.g_zeta.slope[direction], b.g_rho.slope[direction]};
    }
  }
}

/// dG/dc of the reduced balance in (ln xi, ln zeta[, ln rho]), c the coefficient the parameter
/// names; zero where it enters no equation of these.
template <int N, class Model>
ReducedVector<N> coefficient_slope(const Model& model, const FamilyParameter& parameter,
                                   const ReducedVector<N>& x) {
  const auto direction = static_cast<std::size_t>(parameter.index);
  if constexpr (requires { model.plane; }) {
    ReducedVector<N> out = ReducedVector<N>::Zero();
    if (parameter.kind != FamilyParameter::Kind::thickness)
      out.template head<2>() =
          gradient_slope<2>(model.plane, direction, ReducedVector<2>(x[0], x[1]));
    if constexpr (N == 3) {
      if (parameter.kind != FamilyParameter::Kind::plane)
        out[2] = gradient_slope<1>(model.thickness, direction, ReducedVector<1>(x[2]))[0];
    }
    return out;
  } else {
    return gradient_slope<3>(model, direction, x);
  }
}

/// -c_i x_i^2: of G what the spin takes.
template <int N, class Model>
ReducedVector<N> minus_pull(const Model& model, const CentrifugalRates<double>& c,
                            const ReducedVector<N>& x) {
  const auto pull = centrifugal_pull(model, c, x[0], x[1], x[N - 1]);
  ReducedVector<N> out;
  for (int k = 0; k < N; ++k) out[k] = -pull[static_cast<std::size_t>(k)];
  return out;
}

/// dG/dp of the inertia or the coefficient that the parameter names. rates: of the body's spin.
template <int N, class Model>
ReducedVector<N> parameter_slope(const Model& model, const Body& body,
                                 const CentrifugalRates<DoubleDouble>& rates,
                                 const FamilyParameter& parameter, const ReducedVector<N>& x) {
  const int k = parameter.index;
  if (parameter.kind != FamilyParameter::Kind::inertia) {
    ReducedVector<N> out = coefficient_slope<N>(model, parameter, x);
    if constexpr (is_body_model<Model>) {
      // rho = C/d, and its pull with it.
      if (k == static_cast<int>(Model::volume_place) && model.volume) {
        const double rho = model.thickness(x[0], x[1], x[2]);
        const double pull = 2.0 * double(rates.rho) * rho * rho / *model.volume;
        out[0] += pull;
        out[1] += pull;
      }
    }
    return out;
  }
  // The pull on x_k is J_k times nu^2 or nothing, and on no other.
  const double J[3] = {body.J1, body.J2, body.J3};
  const CentrifugalRates<double> c{double(rates.xi), double(rates.zeta), double(rates.rho)};
  ReducedVector<N> out = ReducedVector<N>::Zero();
  if constexpr (is_body_model<Model>) {
    // Along a held volume the pull on rho is one on xi and zeta.
    const CentrifugalRates<double> own{k == 0 ? c.xi : 0.0, k == 1 ? c.zeta : 0.0,
                                       k == 2 ? c.rho : 0.0};
    out = minus_pull<N>(model, own, x) / J[k] +
          body_slope(model, Model::inertia_place + static_cast<std::size_t>(k), x);
  } else if (k < N) {
    out[k] = minus_pull<N>(model, c, x)[k] / J[k];
  }
  return out;
}

}  // namespace stationary
