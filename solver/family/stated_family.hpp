// A family from its equations alone, which are stated once for any number type:
//
//   struct Equations {
//     static constexpr int dimension;   // of x, unknowns that are > 0
//     template <class T, class Number>  // G(x; p), number(c): what a number c of the problem is in T
//     std::array<T, dimension> balance(const std::array<T, dimension>& x, const T& p,
//                                      const Number& number) const;
//     template <class T> T spin_inertia(const std::array<T, dimension>& x) const;
//     ReducedVector<dimension> unknowns(const Stretch& q) const;
//     Member member(const ReducedVector<dimension>& x, double p) const;
//     Branch branch() const;
//   };
//
// and, where it has them, events(), mirrored(), conditions(x), mirror_point(x, p) and a member with
// its tail and error bound, as Family asks for them.
//
// From that one function: duals over doubles give the Jacobian in ln x and the slope in p, pairs of
// doubles the residual, numbers with their conditioning the error bound, and duals over intervals
// the proofs. Families that are evaluated millions of times state these by hand instead.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/matrix/small_matrix.hpp"
#include "lib/number/dual.hpp"
#include "lib/number/first_order_bound_functions.hpp"
#include "solver/motion/event.hpp"
#include "solver/newton/refine.hpp"
#include "solver/proof/box_balance.hpp"

namespace stationary {

/// Slopes that the equations of a family are taken in: of four where they would do with fewer, so that
/// a model's code stands once for all.
constexpr std::size_t stated_slopes(int dimension) {
  return dimension < 4 ? 4 : static_cast<std::size_t>(dimension);
}

/// At one p, as newton() and refine() take it; rows divided by the size of their own slopes.
template <class Equations>
struct StatedSystem {
  static constexpr int dimension = Equations::dimension;
  static constexpr auto N = static_cast<std::size_t>(dimension);
  struct At {
    ReducedVector<dimension> g;
    SmallMatrix<dimension> jacobian;
    ReducedVector<dimension> slope;  ///< dG/dp
    ReducedVector<dimension> scale;
    double magnitude = 1.0;
  };
  const Equations& equations;
  double p;

  template <class T>
  static std::array<T, N> in(const ReducedVector<dimension>& x) {
    std::array<T, N> out;
    for (std::size_t i = 0; i < N; ++i) out[i] = T(x[static_cast<Eigen::Index>(i)]);
    return out;
  }

  At linearize(const ReducedVector<dimension>& x) const {
    using T = Dual<double, stated_slopes(dimension) + 1>;
    std::array<T, N> y;
    for (std::size_t i = 0; i < N; ++i) y[i] = T::logarithmic(x[static_cast<Eigen::Index>(i)], i);
    const auto G = equations.balance(y, T::along(p, 1.0, N), [](double c) { return T(c); });
    At out;
    for (int i = 0; i < dimension; ++i) {
      const T& row = G[static_cast<std::size_t>(i)];
      double size = std::abs(row.value);
      for (std::size_t k = 0; k < N; ++k) size += std::abs(row.slope[k]);
      out.scale[i] = 1.0 / size;
      out.g[i] = row.value / size;
      out.slope[i] = row.slope[N] / size;
      for (int k = 0; k < dimension; ++k)
        out.jacobian.entries(i, k) = row.slope[static_cast<std::size_t>(k)] / size;
    }
    return out;
  }
  ReducedVector<dimension> extended_residual(const ReducedVector<dimension>& x) const {
    return extended_residual(x, linearize(x).scale);
  }
  ReducedVector<dimension> extended_residual(const ReducedVector<dimension>& x,
                                             const ReducedVector<dimension>& scale) const {
    using T = DoubleDouble;
    const auto G = equations.balance(in<T>(x), T(p), [](double c) { return T(c); });
    ReducedVector<dimension> out = scale;
    for (int i = 0; i < dimension; ++i) out[i] *= double(G[static_cast<std::size_t>(i)]);
    return out;
  }
  /// Sum over the numbers of the problem, p among them, of |c dG/dc|.
  ReducedVector<dimension> input_sensitivity(const ReducedVector<dimension>& x) const {
    return input_sensitivity(x, linearize(x).scale);
  }
  ReducedVector<dimension> input_sensitivity(const ReducedVector<dimension>& x,
                                             const ReducedVector<dimension>& scale) const {
    using T = Conditioned;
    const auto G = equations.balance(in<T>(x), T::input(p), [](double c) { return T::input(c); });
    ReducedVector<dimension> out = scale;
    for (int i = 0; i < dimension; ++i) out[i] *= G[static_cast<std::size_t>(i)].condition;
    return out;
  }
};

/// The same over a box of the unknowns.
template <class Equations>
struct StatedBoxes {
  static constexpr int dimension = Equations::dimension;
  static constexpr auto N = static_cast<std::size_t>(dimension);
  const Equations& equations;
  double p;
  Inputs inputs = Inputs::decimals;

  GeneralBoxLinearized<dimension> linearize(const Box<dimension>& box) const {
    using T = Dual<Interval, stated_slopes(dimension)>;
    std::array<T, N> y;
    for (std::size_t i = 0; i < N; ++i) y[i] = T::logarithmic(box[i], i);
    const auto number = [this](double c) { return T(as_input(c, inputs)); };
    const auto G = equations.balance(y, number(p), number);
    GeneralBoxLinearized<dimension> out;
    for (std::size_t i = 0; i < N; ++i) {
      out.g[i] = G[i].value;
      std::copy_n(G[i].slope.begin(), N, out.slope[i].begin());
    }
    return out;
  }
};

/// As continuation sees it; p is nu.
template <class Equations>
class StatedFamily final : public Family<Equations::dimension> {
 public:
  static constexpr int N = Equations::dimension;
  using X = ReducedVector<N>;

  explicit StatedFamily(const Equations& equations) : equations_(equations) {}

  Branch branch() const override { return equations_.branch(); }
  bool along_nu() const override { return true; }
  bool material_symmetry() const override { return false; }

  KindEvents events() const override {
    if constexpr (requires { equations_.events(); }) {
      return equations_.events();
    } else {
      return axis_events();
    }
  }
  std::optional<int> mirrored() const override {
    if constexpr (requires { equations_.mirrored(); }) {
      return equations_.mirrored();
    } else {
      return std::nullopt;
    }
  }
  std::optional<Member> mirror_point(const X& x, double p) const override {
    if constexpr (requires { equations_.mirror_point(x, p); }) {
      return equations_.mirror_point(x, p);
    } else {
      return std::nullopt;
    }
  }
  std::vector<ConditionValue> conditions(const X& x, double) const override {
    if constexpr (requires { equations_.conditions(x); }) {
      return equations_.conditions(x);
    } else {
      return {};
    }
  }

  X coordinates(const Stretch& q, double) const override { return equations_.unknowns(q); }
  SpinInertia<N> spin_inertia(const Member& member) const override {
    using T = Dual<double, stated_slopes(N) + 1>;
    const X x = equations_.unknowns(member.q);
    std::array<T, static_cast<std::size_t>(N)> y;
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] = T::logarithmic(x[static_cast<Eigen::Index>(i)], i);
    const T I = equations_.spin_inertia(y);
    SpinInertia<N> out{I.value, X::Zero()};
    for (int i = 0; i < N; ++i) out.half_slope[i] = 0.5 * I.slope[static_cast<std::size_t>(i)];
    return out;
  }

  FamilyLinearization<N> linearize(const X& x, double p) const override {
    ++this->evaluations_.jacobians;
    const auto at = system(p).linearize(x);
    return {{at.jacobian.matrix(), at.slope, at.slope}, at.g};
  }
  Refined refine_at(X& x, X& tail, double p) const override {
    const Refined out = refine(system(p), x, most_corrections, &tail);
    this->evaluations_.extended_residuals += out.steps;
    this->evaluations_.jacobians += out.steps;
    this->evaluations_.sensitivities += out.converged;
    return out;
  }
  X extended_residual(const X& x, double p) const override {
    ++this->evaluations_.extended_residuals;
    return system(p).extended_residual(x);
  }
  X input_perturbation(const X& x, double p) const override {
    ++this->evaluations_.sensitivities;
    return 0x1p-53 * system(p).input_sensitivity(x);
  }
  Member member(const X& x, const X& tail, double p, double error_bound) const override {
    Member out;
    if constexpr (requires { equations_.member(x, tail, p, error_bound); }) {
      this->evaluations_.spectra += equations_.has_spectrum();
      return equations_.member(x, tail, p, error_bound);
    } else {
      out = equations_.member(x, p);
    }
    out.parameter = out.nu = p;
    out.error_bound = error_bound;
    return out;
  }

 private:
  StatedSystem<Equations> system(double p) const { return {equations_, p}; }

  Equations equations_;
};

}  // namespace stationary
