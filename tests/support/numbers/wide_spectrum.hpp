// Spectra in 50 digits: Lambda from the templates of lib/stability/linearization.hpp at the
// 50-digit solution, the class from them and from the inertia of E''
// (lib/leaf/symplectic_leaf.hpp), reduced by the material symmetry where there is one. The
// inputs are the doubles of the problem, or these shaken by a relative amount.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "lib/leaf/symplectic_leaf.hpp"
#include "lib/material/models/coefficients.hpp"
#include "lib/stability/linearization.hpp"
#include "tests/support/bodies/models.hpp"
#include "tests/support/bodies/motions.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary::testing {

using WideMatrix = Eigen::Matrix<Number50, Eigen::Dynamic, Eigen::Dynamic>;

struct WideLambda {
  Number50 re;
  Number50 im;  ///< >= 0; a complex pair is in the list twice
};

/// Inputs as 50-digit numbers and what they give.
struct WideMotion {
  StraightState<Number50> state;
  std::vector<WideLambda> lambdas;  ///< ascending; forced zeros included
};

template <class Pair>
void append(const Pair& pair, std::vector<WideLambda>& out) {
  if (pair.separation < 0) {
    const Number50 im = sqrt(Number50(-pair.separation));
    out.push_back({pair.mean, im});
    out.push_back({pair.mean, im});
  } else {
    out.push_back({pair.large, 0});
    out.push_back({pair.small, 0});
  }
}
inline void append(const CubicRoots<Number50>& roots, std::vector<WideLambda>& out) {
  out.push_back({roots.single, 0});
  append(roots.pair, out);
}

inline std::vector<WideLambda> wide_lambdas(const StraightState<Number50>& given, Branch branch,
                                            bool symmetric, bool coupled) {
  std::vector<WideLambda> out;
  const bool at_rest = given.omega == 0;
  if (branch != Branch::iii && !at_rest) {
    const auto s = branch == Branch::ii ? given.exchanged() : given;
    append(cubic_roots(even_pencil_i(s).characteristic()), out);
    const auto odd = odd_forms_i(s).characteristic();
    append(quadratic_roots(odd.c[1], symmetric ? Number50(0) : odd.c[0]), out);
  } else {
    if (!at_rest) out.push_back({odd_lambda_iii(given), 0});
    auto block = even_block_iii(given);
    if (symmetric && given.xi != given.zeta) block.K_alpha = 0;
    if (coupled) {
      const auto p = block.characteristic_coupled();
      if (block.K_alpha == 0) {
        out.push_back({0, 0});
        append(cubic_roots(Polynomial<Number50, 3>{{p.c[1], p.c[2], p.c[3], p.c[4]}}), out);
      } else {
        const auto roots = quartic_roots(p);
        append(roots.first, out);
        append(roots.second, out);
      }
    } else {
      out.push_back({-given.V_rr / given.J.J3, 0});
      const auto p = block.characteristic();
      if (block.K_alpha == 0) {
        out.push_back({0, 0});
        append(quadratic_roots(Number50(p.c[2] / p.c[3]), Number50(p.c[1] / p.c[3])), out);
      } else {
        append(cubic_roots(p), out);
      }
    }
  }
  std::sort(out.begin(), out.end(), [](const WideLambda& a, const WideLambda& b) {
    return a.re != b.re ? a.re < b.re : a.im < b.im;
  });
  return out;
}

/// shake(double) -> Number50 is applied to every input: coefficients, J (equal ones equally), nu.
template <class Shake>
WideMotion wide_motion(const SolvedMotion& motion, const Shake& shake) {
  const Problem& problem = motion.problem;
  const Body& body = problem.body();
  const Number50 J1 = shake(body.J1);
  const Number50 J2 = body.symmetric() ? J1 : shake(body.J2);
  const Inertia3<Number50> J{J1, J2, shake(body.J3)};
  const Number50 nu = shake(motion.nu());
  Number50 squares[3] = {0, 0, 0};
  squares[axis(problem.branch())] = nu * nu;
  const CentrifugalRates<Number50> c{J.J1 * (squares[1] + squares[2]),
                                     J.J2 * (squares[0] + squares[2]),
                                     J.J3 * (squares[0] + squares[1])};
  const Stretch& q = motion.at.q;
  using Two = std::array<Number50, 2>;
  using Three = std::array<Number50, 3>;
  const auto finish = [&](const auto& model, Three x) {
    if (abs(Number50(x[0] - x[1])) < Number50("1e-40")) x[0] = x[1];
    WideMotion out{straight_state(J, model, x[0], x[1], x[2], nu), {}};
    out.lambdas = wide_lambdas(out.state, problem.branch(), body.symmetric(),
                               !problem.potential().is_separable());
    return out;
  };
  return problem.potential().visit_parts([&](const auto& model) {
    if constexpr (requires { model.plane; }) {
      const auto plane = with_coefficients(model.plane, shake);
      const auto thickness = with_coefficients(model.thickness, shake);
      const Two x = newton_50<2>({Number50(q.xi), Number50(q.zeta)}, [&](const Two& at) {
        const auto w = plane.template evaluate<2>(planar_invariants(at[0], at[1]));
        const auto b = planar_log_balance<2>(w, at[0], at[1], c);
        return std::pair{Two{b.g_xi, b.g_zeta}, std::array<Two, 2>{{{b.uu, b.uv}, {b.uv, b.vv}}}};
      });
      using One = std::array<Number50, 1>;
      const One rho = newton_50<1>({Number50(q.rho)}, [&](const One& at) {
        const auto v = thickness.template evaluate<2>(at[0]);
        const Number50 pull = c.rho * at[0] * at[0];
        return std::pair{One{v.v_r - pull}, std::array<One, 1>{{{v.v_rr - 2 * pull}}}};
      });
      using Whole = Separable<std::decay_t<decltype(plane)>, std::decay_t<decltype(thickness)>>;
      return finish(Whole{plane, thickness}, {x[0], x[1], rho[0]});
    } else {
      const auto whole = with_coefficients(model, shake);
      const Three x =
          newton_50<3>({Number50(q.xi), Number50(q.zeta), Number50(q.rho)}, [&](const Three& at) {
            const auto w = whole.template evaluate<2>(planar_invariants(at[0], at[1]), at[2]);
            const auto b = coupled_log_balance<2>(w, at[0], at[1], at[2], c);
            return std::pair{
                Three{b.g_xi, b.g_zeta, b.g_rho},
                std::array<Three, 3>{{{b.uu, b.uv, b.uw}, {b.uv, b.vv, b.vw}, {b.uw, b.vw, b.ww}}}};
          });
      return finish(whole, x);
    }
  });
}
inline WideMotion wide_motion(const SolvedMotion& motion) {
  return wide_motion(motion, [](double x) { return Number50(x); });
}

struct WideInertia {
  int negative = 0;
  int zero = 0;
};

/// Signs of a symmetric matrix' eigenvalues: pivots of an elimination (Sylvester) after a fixed
/// congruence that leaves no leading minor to vanish by structure. Rows of very different units are
/// brought to one size first.
inline WideInertia inertia_of(WideMatrix E) {
  const Eigen::Index n = E.rows();
  for (int sweep = 0; sweep < 3; ++sweep) {
    for (Eigen::Index i = 0; i < n; ++i) {
      const Number50 largest = E.row(i).cwiseAbs().maxCoeff();
      if (largest == 0) continue;
      const Number50 factor = 1 / sqrt(largest);
      E.row(i) *= factor;
      E.col(i) *= factor;
    }
  }
  support::Random random(7);
  WideMatrix R(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) R(i, j) = (i == j ? 1.5 : 0.0) + random.uniform(-0.5, 0.5);
  WideMatrix A = R.transpose() * E * R;
  const Number50 tiny = A.cwiseAbs().maxCoeff() * Number50("1e-30");
  WideInertia out;
  for (Eigen::Index k = 0; k < n; ++k) {
    const Number50 pivot = A(k, k);
    if (abs(pivot) <= tiny) {
      ++out.zero;
      continue;
    }
    if (pivot < 0) ++out.negative;
    for (Eigen::Index i = k + 1; i < n; ++i) {
      const Number50 f = A(i, k) / pivot;
      for (Eigen::Index j = i; j < n; ++j) {
        A(i, j) -= f * A(k, j);
        A(j, i) = A(i, j);
      }
    }
  }
  return out;
}

/// E restricted to the directions x with a . x = 0, in some basis.
inline WideMatrix restricted(const WideMatrix& E, const std::vector<Number50>& a) {
  const Eigen::Index n = E.rows();
  Eigen::Index k = 0;
  const auto entry = [&](Eigen::Index i) { return a[static_cast<std::size_t>(i)]; };
  for (Eigen::Index i = 0; i < n; ++i)
    if (abs(entry(i)) > abs(entry(k))) k = i;
  WideMatrix B = WideMatrix::Constant(n, n - 1, Number50(0));
  for (Eigen::Index i = 0, column = 0; i < n; ++i) {
    if (i == k) continue;
    B(i, column) = 1;
    B(k, column++) = -entry(i) / entry(k);
  }
  return B.transpose() * E * B;
}

struct WideVerdict {
  StabilityClass verdict = StabilityClass::marginal;
  int negative = -1;  ///< on the whole leaf, zeros of the symmetry not counted
};

/// The class, decided in 50 digits.
inline WideVerdict wide_verdict(const SolvedMotion& motion, const WideMotion& wide) {
  const Problem& problem = motion.problem;
  const Body& body = problem.body();
  const auto& s = wide.state;
  const Number50 zero = 0;
  const BasicStretch<Number50> q{zero, s.xi, s.zeta, s.rho};
  Matrix4<Number50> V_qq = Matrix4<Number50>::Constant(zero);
  V_qq(0, 0) = s.V_aa;
  V_qq(1, 1) = s.V_xx;
  V_qq(2, 2) = s.V_zz;
  V_qq(3, 3) = s.V_rr;
  V_qq(1, 2) = V_qq(2, 1) = s.V_xz;
  V_qq(1, 3) = V_qq(3, 1) = s.V_xr;
  V_qq(2, 3) = V_qq(3, 2) = s.V_zr;
  const Number50 speed = s.omega < 0 ? Number50(-s.omega) : s.omega;  // the same spectrum
  const Vector3<Number50> nu = angular_velocity(problem.branch(), speed);
  const LeafForm<Number50> form =
      second_variation(body, q, nu, LeafShape{s.omega != 0, false}, V_qq);
  const Eigen::Index dimensions = s.omega == 0 ? 8 : 10;
  WideMatrix E(dimensions, dimensions);
  for (Eigen::Index i = 0; i < dimensions; ++i)
    for (Eigen::Index j = 0; j < dimensions; ++j)
      E(i, j) = form[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  WideVerdict out;
  out.negative = inertia_of(E).negative;
  bool real = false;
  bool complex = false;
  for (const WideLambda& lambda : wide.lambdas) {
    complex = complex || lambda.im > 0;
    real = real || (lambda.im == 0 && lambda.re > 0);
  }
  if (real || complex) {
    out.verdict = real ? StabilityClass::unstable : StabilityClass::oscillatory;
    return out;
  }
  out.verdict = out.negative == 0 ? StabilityClass::stable : StabilityClass::elliptic;
  if (!body.symmetric() || s.omega == 0) return out;
  // P = pi3 + p_alpha (xi - zeta) - 2 alpha (p_xi - p_zeta) in the coordinates of the leaf
  // (b1, alpha, xi, zeta, rho; b2, p_alpha, ...).
  if (problem.branch() == Branch::iii && s.xi == s.zeta) {
    WideMatrix P = WideMatrix::Constant(10, 10, zero);
    P(0, 0) = P(5, 5) = -1;  // pi3 - |pi| = -(b1^2 + b2^2)/2
    P(2, 6) = P(6, 2) = 1;
    P(3, 6) = P(6, 3) = -1;
    P(1, 7) = P(7, 1) = -2;
    P(1, 8) = P(8, 1) = 2;
    // The window of c for the shears and the wobble; whether it is one, the inertia says.
    const Number50 K_aa = even_block_iii(s).K_alpha;
    const Number50 Omega = sqrt(Number50(speed * speed + K_aa / (2 * s.J.J1)));
    const Number50 low = -(Omega + speed) / 2;
    const Number50 wobble = speed * (s.I3() / s.I1() - 1);
    const Number50 shear = (Omega - speed) / 2;
    const Number50 high = shear < wobble ? shear : wobble;
    const Number50 c = (low + high) / 2;
    if (inertia_of(E + c * P).negative == 0) out.verdict = StabilityClass::stable;
    return out;
  }
  std::vector<Number50> dP(10, zero);
  const Number50 g = s.J.J1 * s.xi - s.J.J2 * s.zeta;
  if (problem.branch() == Branch::iii) {
    const Number50 p_alpha = -g * speed;
    dP[2] = p_alpha;
    dP[3] = -p_alpha;
  } else {
    // pi along axis 1 or 2; symplectic_leaf.hpp's e1 is e_2 x e_1 = -e_3 in (i), e_1 x e_2 = e_3 in
    // (ii).
    const bool first = problem.branch() == Branch::i;
    const Number50 size = sqrt(Number50((first ? s.I1() : s.I2()) * speed));
    dP[0] = first ? Number50(-size) : size;
  }
  dP[6] = s.xi - s.zeta;
  out.verdict = inertia_of(restricted(E, dP)).negative == 0 ? StabilityClass::stable
                                                            : StabilityClass::elliptic;
  return out;
}

/// |Lambda - exact| of the pairing by_lambda().
inline double distance(const Mode& mode, const WideLambda& exact) {
  const Number50 re = Number50(mode.lambda_re) - exact.re;
  const Number50 im = Number50(mode.lambda_im) - exact.im;
  return sqrt(Number50(re * re + im * im)).convert_to<double>();
}

}  // namespace stationary::testing
