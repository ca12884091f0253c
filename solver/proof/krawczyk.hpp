// Krawczyk's operator in logarithmic coordinates about a double x: for solutions x e^d, d in D,
//
//   K(D) = -Y G(x) + (1 - Y J(x e^H)) D,   J = dG/d ln x,   Y about the inverse of J,
//                                          H the hull of D and 0.
//
// If K(D) lies in the interior of D, there is exactly one solution with d in D, and its d is in
// K(D); for every value the inputs have in their intervals. Any solution with d in D has it in
// K(D). Source: R. Krawczyk, Computing 4 (1969) 187; A. Neumaier, Interval Methods for Systems of
// Equations (1990), theorem 5.1.8.
#pragma once

#include <limits>
#include <optional>
#include <type_traits>

#include "solver/proof/box_balance.hpp"

namespace stationary {

template <int N>
struct Proof {
  bool proven = false;
  Box<N> unique;    ///< stretches among which there is exactly one solution
  Box<N> solution;  ///< it is in here
  /// Bound of |x_i / solution_i - 1| for the x the proof is about.
  double error_bound = std::numeric_limits<double>::quiet_NaN();
};

/// G and dG/d ln x over a box, of any system.
template <int N>
struct BoxSlopes {
  Box<N> g;
  std::array<Box<N>, static_cast<std::size_t>(N)> slope;  ///< rows
  bool symmetric = false;

  BoxSlopes() = default;
  template <class Linearized>  // BoxLinearized or GeneralBoxLinearized
  explicit BoxSlopes(const Linearized& over)
      : g(over.g), symmetric(std::is_same_v<Linearized, BoxLinearized<N>>) {
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j)
        slope[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = over(i, j);
  }

  const Interval& operator()(int i, int j) const {
    return slope[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  /// Of the middle of the slopes; not finite where that is singular.
  Eigen::Matrix<double, N, N> inverse() const;
};

/// Of a system one of whose numbers p is an interval: G = at + slope (p - p_0), at of p = p_0, for every p.
/// Times a matrix these know, as rows that are intervals do not, that all rows have the same p.
template <int N>
struct VariedResidual {
  Box<N> at;
  Box<N> slope;
  Interval offset;  ///< p - p_0

  /// What p adds to row i of Y G.
  template <class Matrix>
  Interval by_number(const Matrix& Y, int i) const {
    IntervalSum sum;
    for (int k = 0; k < N; ++k) sum.add_product(Y(i, k), slope[static_cast<std::size_t>(k)]);
    return sum.value() * offset;
  }
};

/// A system over boxes, of as many equations as unknowns; the machinery of proofs stands once for each N. It refers to
/// the system, which must outlive it.
template <int N>
class BoxEquations {
 public:
  template <class System>
  explicit BoxEquations(const System& system)
      : system_(&system),
        linearize_([](const void* own, const Box<N>& x) {
          return BoxSlopes<N>(static_cast<const System*>(own)->linearize(x));
        }),
        residual_([](const void* own, const Box<N>& x) {
          const auto& of = *static_cast<const System*>(own);
          if constexpr (requires { of.residual(x); }) return Box<N>(of.residual(x));
          return Box<N>(of.linearize(x).g);
        }) {
    if constexpr (requires(const Box<N>& x) { system.varied(x); }) {
      if (system.varies())
        varied_ = [](const void* own, const Box<N>& x) {
          return static_cast<const System*>(own)->varied(x);
        };
    }
  }

  BoxSlopes<N> linearize(const Box<N>& x) const { return linearize_(system_, x); }
  /// G alone.
  Box<N> residual(const Box<N>& x) const { return residual_(system_, x); }
  /// Whether a number of it varies, and G then.
  bool varies() const { return varied_ != nullptr; }
  VariedResidual<N> varied(const Box<N>& x) const { return varied_(system_, x); }

 private:
  const void* system_;
  BoxSlopes<N> (*linearize_)(const void*, const Box<N>&);
  Box<N> (*residual_)(const void*, const Box<N>&);
  VariedResidual<N> (*varied_)(const void*, const Box<N>&) = nullptr;
};

/// N = 1 ... 7.
template <int N>
class Krawczyk {
 public:
  /// The system must outlive it.
  template <class System>
  Krawczyk(const System& system, const ReducedVector<N>& x)
      : Krawczyk(BoxEquations<N>(system), x) {}
  Krawczyk(const BoxEquations<N>& equations, const ReducedVector<N>& x);

  /// x e^D.
  Box<N> stretches(const Box<N>& d) const;

  /// K(D); entire where something is not bounded.
  Box<N> operator()(const Box<N>& d) const;

  /// The stretches with |d_i| <= radius_i, if the test shows exactly one solution among them.
  std::optional<Box<N>> unique(const ReducedVector<N>& radius) const;

  /// The same around everything x is within a relative error of: |x_i/y_i - 1| <= error < 1/5 is
  /// |d_i| <= -ln(1 - error) < 1.25 error.
  std::optional<Box<N>> unique_within(double error) const;

  /// Widens D from the Newton step until the test succeeds.
  Proof<N> prove() const;

 private:
  Proof<N> proof(const Box<N>& d, Box<N> image) const;

  BoxEquations<N> equations_;
  ReducedVector<N> x_;
  Eigen::Matrix<double, N, N> inverse_;
  Box<N> newton_;
};

template <class System>
Krawczyk(const System&, const ReducedVector<System::dimension>&) -> Krawczyk<System::dimension>;

}  // namespace stationary
