// A potential V(q): either V_plane(alpha, xi, zeta) + V_rho(rho) ("separable", the paper's case) or
// coupled; every built-in one is isotropic, a function of (t, l = ln d, r = ln rho), and then
//   V_q = W_t t_q + W_l l_q + W_r r_q,   l_q = (-2 alpha, zeta, xi)/d,  r_q = 1/rho,
//   V_qq = W_tt t_q t_q + W_tl (t_q l_q + l_q t_q) + (W_ll - W_l) l_q l_q + W_l d_qq/d + ...
// so value, gradient and Hessian in q come from one evaluation and have no singularity at the
// circle.
//
// Two layers. Templates: a model is a small aggregate of coefficients with
//   evaluate<order>(invariants, rho) -> CoupledDerivatives
// in any number type; Separable<Plane, Thickness> makes one of two. Run time: class Potential holds
// one of the models and visit() gives it back as its own type, once per solve.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/potentials/biot.hpp"
#include "lib/potentials/biot_log.hpp"
#include "lib/potentials/hencky.hpp"
#include "lib/potentials/neo_hookean.hpp"
#include "lib/potentials/neo_hookean_3d.hpp"
#include "lib/potentials/reciprocal_determinant.hpp"
#include "lib/potentials/saint_venant_kirchhoff.hpp"
#include "lib/potentials/thickness.hpp"
#include "lib/stretch.hpp"

namespace stationary {

/// V(q), its gradient (4) and Hessian (4x4) in q = (alpha, xi, zeta, rho).
template <class S>
struct PotentialDerivatives {
  S value;
  Vector4<S> gradient;
  Matrix4<S> hessian;
};

/// A planar model and a thickness model as one isotropic model; W_tr = W_lr = 0.
template <class Plane, class Thickness>
struct Separable {
  Plane plane;
  Thickness thickness;

  template <int order, class S>
  auto evaluate(const PlanarInvariants<S>& x, const S& rho) const {
    const auto planar = plane.template evaluate<order>(x);
    const auto axial = thickness.template evaluate<order>(rho);
    CoupledDerivatives<std::remove_cvref_t<decltype(planar.w + axial.v)>> out;
    out.plane = planar;
    out.plane.w = planar.w + axial.v;
    out.w_r = axial.v_r;
    out.w_rr = axial.v_rr;
    if constexpr (order >= 2) out.w_tr = out.w_lr = decltype(out.w_tr)(0.0);
    return out;
  }

  template <class S>
  auto log_balance(const S& xi, const S& zeta, const S& rho, const S& c_xi, const S& c_zeta,
                   const S& c_rho) const {
    auto out = plane.log_balance(xi, zeta, c_xi, c_zeta);
    const auto axial = thickness.log_balance(rho, c_rho);
    out.g_rho = axial.g_rho;
    out.uw = out.vw = decltype(out.uw)(0.0);
    out.ww = axial.ww;
    return out;
  }
};

/// The chain rule above. order 0, 1, 2 as in evaluate(); what was not asked for is NaN.
template <int order, class Model, class S>
auto potential_derivatives(const Model& model, const BasicStretch<S>& q) {
  const auto w = model.template evaluate<order>(planar_invariants(q), q.rho);
  using R = std::remove_cvref_t<decltype(w.plane.w)>;
  PotentialDerivatives<R> out{w.plane.w, Vector4<R>::Constant(poison<R>()),
                              Matrix4<R>::Constant(poison<R>())};
  if constexpr (order >= 1) {
    const S inverse_d = S(1.0) / planar_invariants(q).d;
    const S inverse_rho = S(1.0) / q.rho;
    const S l[3] = {-2.0 * q.alpha * inverse_d, q.zeta * inverse_d, q.xi * inverse_d};
    const R w_l = w.plane.w_l;
    out.gradient[0] = w_l * l[0];
    out.gradient[1] = w.plane.w_t + w_l * l[1];
    out.gradient[2] = w.plane.w_t + w_l * l[2];
    out.gradient[3] = w.w_r * inverse_rho;
    if constexpr (order >= 2) {
      const R curvature = w.plane.w_ll - w_l;
      auto& H = out.hessian;
      for (int i = 0; i < 3; ++i) {
        for (int j = i; j < 3; ++j) {
          R h = curvature * (l[i] * l[j]);
          if (i > 0) h += w.plane.w_tl * l[j];
          if (j > 0) h += w.plane.w_tl * l[i];
          if (i > 0 && j > 0) h += w.plane.w_tt;
          H(i, j) = h;
        }
        R h = w.w_lr * l[i];
        if (i > 0) h += w.w_tr;
        H(i, 3) = h * inverse_rho;
      }
      H(0, 0) += -2.0 * w_l * inverse_d;
      H(1, 2) += w_l * inverse_d;
      H(3, 3) = (w.w_rr - w.w_r) * (inverse_rho * inverse_rho);
      for (int i = 1; i < 4; ++i)
        for (int j = 0; j < i; ++j) H(i, j) = H(j, i);
    }
  }
  return out;
}

using PlanarPotential = std::variant<ReciprocalDeterminant<>, SaintVenantKirchhoff<>, Biot<>,
                                     BiotLog<>, NeoHookean<>, Hencky<>>;
using ThicknessPotential = std::variant<ReciprocalQuadratic<>, Harmonic<>>;
using CoupledPotential = std::variant<NeoHookean3d<>>;

/// What `stationary models` prints of a model.
struct ModelDescription {
  enum class Kind { planar, thickness, coupled } kind;
  std::string_view name;
  std::string_view formula;
  std::vector<std::string_view> parameters;
  std::vector<std::string_view> domain;  ///< inequalities on the parameters, all required
};

/// Every built-in model, planar ones first.
const std::vector<ModelDescription>& model_descriptions();

class Potential {
 public:
  /// Throw std::invalid_argument with the violated inequality of the model's domain.
  Potential(const PlanarPotential& plane, const ThicknessPotential& thickness);
  explicit Potential(const CoupledPotential& coupled);

  /// By name; coefficients in the order of ModelDescription::parameters. Throws
  /// std::invalid_argument for an unknown name, a wrong count or a coefficient outside the domain.
  static PlanarPotential planar(std::string_view name, std::span<const double> coefficients);
  static ThicknessPotential thickness(std::string_view name, std::span<const double> coefficients);
  static CoupledPotential coupled(std::string_view name, std::span<const double> coefficients);

  bool is_separable() const { return std::holds_alternative<SeparableModels>(models_); }
  /// The parts; only where is_separable() (std::bad_variant_access otherwise).
  const PlanarPotential& plane() const { return std::get<SeparableModels>(models_).plane; }
  const ThicknessPotential& thickness() const {
    return std::get<SeparableModels>(models_).thickness;
  }
  /// Only where not separable.
  const CoupledPotential& coupled() const { return std::get<CoupledPotential>(models_); }

  /// Calls f with the one model held, as its own type (Separable<Plane, Thickness> or a coupled
  /// one).
  template <class F>
  decltype(auto) visit(F&& f) const {
    if (const auto* parts = std::get_if<SeparableModels>(&models_)) {
      return std::visit(
          [&](const auto& plane, const auto& thickness) -> decltype(auto) {
            return f(Separable<std::decay_t<decltype(plane)>, std::decay_t<decltype(thickness)>>{
                plane, thickness});
          },
          parts->plane, parts->thickness);
    }
    return std::visit([&](const auto& model) -> decltype(auto) { return f(model); },
                      std::get<CoupledPotential>(models_));
  }

  /// Value, gradient and Hessian at a positive definite q (not checked).
  PotentialDerivatives<double> derivatives(const Stretch& q) const;
  double value(const Stretch& q) const;

 private:
  struct SeparableModels {
    PlanarPotential plane;
    ThicknessPotential thickness;
  };
  std::variant<SeparableModels, CoupledPotential> models_;
};

}  // namespace stationary
