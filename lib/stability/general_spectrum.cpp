#include "lib/stability/general_spectrum.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <cmath>
#include <complex>
#include <vector>

#include "lib/material/models/first_order_bound_model.hpp"
#include "lib/stability/mode_collector.hpp"

namespace stationary {
namespace {

using Real = long double;
using Complex = std::complex<Real>;
using Dense = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using ComplexDense = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic>;
using ComplexVector = Eigen::Matrix<Complex, Eigen::Dynamic, 1>;

/// J A for J = [[0, 1], [-1, 0]].
Dense symplectic_times(const Dense& A) {
  const Eigen::Index n = A.rows() / 2;
  Dense out(A.rows(), A.cols());
  out << A.bottomRows(n), -A.topRows(n);
  return out;
}

/// x_k -> c_k x_k, p_k -> p_k/c_k: makes the two diagonals of E'' alike in size.
void scale_symplectically(Dense& E, Dense& magnitude) {
  const Eigen::Index n = E.rows() / 2;
  for (Eigen::Index k = 0; k < n; ++k) {
    const Real c = std::pow(magnitude(n + k, n + k) / magnitude(k, k), Real(0.25));
    if (!std::isfinite(c) || c == Real(0)) continue;
    for (Dense* m : {&E, &magnitude}) {
      m->row(k) *= c;
      m->col(k) *= c;
      m->row(n + k) /= c;
      m->col(n + k) /= c;
    }
  }
}

/// Similarity by the Householder reflection that maps v = W.col(column) in rows [first, first +
/// size) to a multiple of its first unit vector, the same on coordinates and momenta (symplectic).
void reflect(Dense& W, Eigen::Index column, Eigen::Index offset, Eigen::Index first) {
  const Eigen::Index n = W.rows() / 2;
  const Eigen::Index size = n - first;
  if (size < 2) return;
  Eigen::Matrix<Real, Eigen::Dynamic, 1> v = W.col(column).segment(offset + first, size);
  const Real norm = v.norm();
  if (norm == Real(0)) return;
  v[0] += v[0] < Real(0) ? -norm : norm;
  const Real weight = Real(2) / v.squaredNorm();
  for (const Eigen::Index start : {first, n + first}) {
    auto rows = W.middleRows(start, size);
    rows -= weight * v * (v.transpose() * rows);
    auto columns = W.middleCols(start, size);
    columns -= (columns * v) * (weight * v.transpose());
  }
}

/// The Lambdas of H = J E'': eigenvalues of A in the square-reduced form of H^2.
std::vector<Complex> squared_eigenvalues(const Dense& H) {
  Dense W = H * H;
  const Eigen::Index n = W.rows() / 2;
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    reflect(W, k, n, k + 1);  // lower left block, below its (k+1, k) entry
    // A rotation in the plane (x_{k+1}, p_{k+1}) removes that entry against A(k+1, k).
    const Eigen::Index i = k + 1;
    const Real a = W(i, k);
    const Real f = W(n + i, k);
    const Real r = std::hypot(a, f);
    if (r > Real(0)) {
      const Real c = a / r;
      const Real s = f / r;
      const Dense upper = W.row(i);
      const Dense lower = W.row(n + i);
      W.row(i) = c * upper + s * lower;
      W.row(n + i) = c * lower - s * upper;
      const Dense left = W.col(i);
      const Dense right = W.col(n + i);
      W.col(i) = c * left + s * right;
      W.col(n + i) = c * right - s * left;
    }
    reflect(W, k, 0, k + 1);  // A to Hessenberg form
  }
  const Eigen::EigenSolver<Dense> solver(W.topLeftCorner(n, n), false);
  std::vector<Complex> out;
  for (Eigen::Index k = 0; k < n; ++k) out.push_back(solver.eigenvalues()[k]);
  return out;
}

/// The Lambdas where E'' is positive definite; empty where it is not.
std::vector<Complex> definite_eigenvalues(const Dense& E) {
  const Eigen::LLT<Dense> llt(E);
  if (llt.info() != Eigen::Success) return {};
  const Dense L = llt.matrixL();
  const Dense skew = L.transpose() * symplectic_times(L);
  const ComplexDense hermitian = Complex(0, 1) * skew.cast<Complex>();
  const Eigen::SelfAdjointEigenSolver<ComplexDense> solver(hermitian, Eigen::EigenvaluesOnly);
  std::vector<Complex> out;
  for (Eigen::Index k = E.rows() / 2; k < E.rows(); ++k) {
    const Real frequency = solver.eigenvalues()[k];
    out.emplace_back(-frequency * frequency, Real(0));
  }
  return out;
}

struct EigenTriple {
  Complex s;
  ComplexVector right;
  Real error;  ///< bound of |change of Lambda|
};

/// Null vectors of H - s from one singular value decomposition; first-order perturbation bound.
EigenTriple triple(const Dense& H, const Dense& magnitude, Complex lambda, Real u) {
  EigenTriple out;
  out.s = std::sqrt(lambda);
  ComplexDense shifted = H.cast<Complex>();
  shifted.diagonal().array() -= out.s;
  // Of a square matrix: no factorization before it.
  const Eigen::JacobiSVD<ComplexDense, Eigen::NoQRPreconditioner> svd(
      shifted, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Index last = H.rows() - 1;
  out.right = svd.matrixV().col(last);
  const ComplexVector left = svd.matrixU().col(last);
  // |y^* dH x| <= |J y|^T |dE''| |x| u; and what the decomposition itself left.
  const Eigen::Index n = H.rows() / 2;
  Eigen::Matrix<Real, Eigen::Dynamic, 1> y(H.rows());
  y << left.cwiseAbs().tail(n), left.cwiseAbs().head(n);
  const Real perturbation = u * y.dot(magnitude * out.right.cwiseAbs()) +
                            Real(64) * std::numeric_limits<Real>::epsilon() * H.norm();
  const Real overlap = std::abs(left.dot(out.right));
  const Real change = perturbation / overlap;
  // ds = change to first order; near a double s it is at most sqrt(change) times what it takes, and
  // the overlap, which vanishes there, has made the bound that large already.
  out.error = Real(2) * std::abs(out.s) * change + change * change;
  return out;
}

/// Negative eigenvalues of E''; the one a symmetry makes zero has only rounding for a sign.
int negative_directions(const Eigen::Matrix<Real, Eigen::Dynamic, 1>& ascending,
                        MaterialSymmetry symmetry) {
  Eigen::Index zero = -1;
  if (symmetry == MaterialSymmetry::ellipse) ascending.cwiseAbs().minCoeff(&zero);
  int count = 0;
  for (Eigen::Index k = 0; k < ascending.size(); ++k) count += k != zero && ascending[k] < Real(0);
  return count;
}

/// On the circle of (iii), nu3 > 0 (nu3 < 0 gives the same spectrum): is E'' + c (P - |pi|)''
/// definite for some c? P = pi3 + p_alpha (xi - zeta) - 2 alpha (p_xi - p_zeta), the momentum of
/// material rotations; pi3 - |pi| = -(pi1^2 + pi2^2)/(2 |pi|). The least eigenvalue is concave in
/// c.
bool definite_with_momentum(const Leaf<Real>& leaf, Real u) {
  Dense P = Dense::Zero(10, 10);
  const auto set = [&](Eigen::Index i, Eigen::Index j, Real value) { P(i, j) = P(j, i) = value; };
  set(0, 0, -1);
  set(5, 5, -1);
  set(2, 6, 1);
  set(3, 6, -1);
  set(1, 7, -2);
  set(1, 8, 2);
  const auto least = [&](Real c) {
    const Dense E = leaf.second_variation + c * P;
    const Dense spread = leaf.magnitude + std::abs(c) * P.cwiseAbs();
    return Eigen::SelfAdjointEigenSolver<Dense>(E, Eigen::EigenvaluesOnly).eigenvalues()[0] -
           u * spread.norm();
  };
  Real a = -leaf.second_variation.norm();
  Real b = -a;
  for (int k = 0; k < 200 && least(Real(0.5) * (a + b)) <= Real(0); ++k) {
    const Real c1 = a + (b - a) / Real(3);
    const Real c2 = b - (b - a) / Real(3);
    (least(c1) < least(c2) ? a : b) = least(c1) < least(c2) ? c1 : c2;
    if (b - a <= std::numeric_limits<Real>::epsilon() * std::abs(b)) return false;
  }
  return least(Real(0.5) * (a + b)) > Real(0);
}

}  // namespace

Spectrum general_spectrum(const GeneralFacts& facts, const Leaf<long double>& leaf) {
  Dense E = leaf.second_variation;
  Dense magnitude = leaf.magnitude;
  scale_symplectically(E, magnitude);
  const Dense H = symplectic_times(E);
  const Real u = facts.uncertainty;

  ModeCollector out;
  const Eigen::SelfAdjointEigenSolver<Dense> inertia(E, Eigen::EigenvaluesOnly);
  const Real spread = u * magnitude.norm();
  out.set_negative(negative_directions(inertia.eigenvalues(), facts.symmetry));
  const bool definite = inertia.eigenvalues()[0] > spread;

  std::vector<Complex> lambdas;
  if (definite) lambdas = definite_eigenvalues(E);
  if (lambdas.empty()) lambdas = squared_eigenvalues(H);
  if (facts.symmetry == MaterialSymmetry::ellipse) {
    auto smallest = lambdas.begin();
    for (auto it = lambdas.begin(); it != lambdas.end(); ++it)
      if (std::abs(*it) < std::abs(*smallest)) smallest = it;
    lambdas.erase(smallest);
    out.add_forced_zero();
  }
  for (const Complex& lambda : lambdas) {
    if (lambda.imag() < Real(0)) continue;  // its conjugate is counted
    const EigenTriple t = triple(H, magnitude, lambda, u);
    const auto error = static_cast<double>(t.error);
    if (lambda.imag() > Real(0)) {
      out.add_complex(static_cast<double>(lambda.real()), static_cast<double>(lambda.imag()),
                      error);
      continue;
    }
    int krein = 1;
    if (!definite) {
      // Of the leaf as it stands, so that only what was lost on the way to it counts.
      const Real energy = t.right.dot(E.cast<Complex>() * t.right).real();
      const Real doubt = Real(0x1p-50) * t.right.cwiseAbs().dot(magnitude * t.right.cwiseAbs());
      krein = energy > doubt ? 1 : energy < -doubt ? -1 : 0;
    }
    out.add_real(static_cast<double>(lambda.real()), error, krein,
                 definite ? Axis::stays : Axis::may_leave);
  }
  if (facts.symmetry == MaterialSymmetry::circle && leaf.pairs == 5 &&
      definite_with_momentum(leaf, u)) {
    out.set_definite_with_momentum();
  }
  return out.finish();
}

Leaf<Real> motion_leaf(const Body& body, const Potential& potential,
                       const BasicStretch<DoubleDouble>& q, const Vector3<DoubleDouble>& nu) {
  const auto wide = [](const DoubleDouble& x) { return Real(x.hi) + Real(x.lo); };
  const auto input = [](const DoubleDouble& x) { return Conditioned::input(leading(x)); };
  Matrix4<Real> V_qq;
  Matrix4<Real> condition;
  const double size = std::sqrt(leading(q.xi) * leading(q.zeta));
  const BasicStretch<Conditioned> q_c{
      q.alpha == 0.0 ? Conditioned(0.0) : Conditioned(leading(q.alpha), size), input(q.xi),
      input(q.zeta), input(q.rho)};
  const auto take = [&](const auto& exact, const auto& conditioned) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        V_qq(i, j) = wide(exact.hessian(i, j));
        condition(i, j) = conditioned.hessian(i, j).condition;
      }
    }
  };
  if (potential.is_isotropic()) {
    potential.visit_parts([&](const auto& model) {
      take(potential_derivatives<2>(model, q),
           potential_derivatives<2>(conditioned_model(model), q_c));
    });
  } else {
    const AnisotropicPotential& V = potential.anisotropic();
    take(potential_derivatives<2>(V.model(AsExtended()), q),
         potential_derivatives<2>(V.model(AsConditioned()), q_c));
  }
  const BasicStretch<Real> q_wide{wide(q.alpha), wide(q.xi), wide(q.zeta), wide(q.rho)};
  const Vector3<Real> nu_wide{wide(nu[0]), wide(nu[1]), wide(nu[2])};
  return leaf(body, q_wide, nu_wide, V_qq, condition);
}

Spectrum general_spectrum(const Body& body, const Potential& potential,
                          const BasicStretch<DoubleDouble>& q, const Vector3<DoubleDouble>& nu,
                          double uncertainty) {
  const bool at_rest = nu[0] == 0.0 && nu[1] == 0.0 && nu[2] == 0.0;
  const bool circle = q.alpha == 0.0 && q.xi == q.zeta;
  const bool symmetric = potential.is_isotropic() && (body.symmetric() || at_rest);
  const MaterialSymmetry symmetry = !symmetric ? MaterialSymmetry::none
                                    : circle   ? MaterialSymmetry::circle
                                               : MaterialSymmetry::ellipse;
  const bool turned = circle && nu[2] < 0.0;  // see definite_with_momentum()
  return general_spectrum(
      {symmetry, uncertainty},
      motion_leaf(body, potential, q, turned ? Vector3<DoubleDouble>(-nu) : nu));
}

}  // namespace stationary
