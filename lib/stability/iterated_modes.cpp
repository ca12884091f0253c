#include "lib/stability/iterated_modes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/stability/leaf_modes.hpp"

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
  ComplexVector right;
  Real error;  ///< bound of |change of Lambda|
};

/// Null vectors of H - s from one singular value decomposition; first-order perturbation bound.
EigenTriple triple(const Dense& H, const Dense& magnitude, Complex lambda, Real u) {
  EigenTriple out;
  const Complex s = std::sqrt(lambda);
  ComplexDense shifted = H.cast<Complex>();
  shifted.diagonal().array() -= s;
  // Of a square matrix: no factorization before it.
  const Eigen::JacobiSVD<ComplexDense, Eigen::NoQRPreconditioner> svd(
      shifted, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Index last = H.rows() - 1;
  out.right = svd.matrixV().col(last);
  const ComplexVector left = svd.matrixU().col(last);
  // |y^* dH x| <= |J y|^T |dE''| |x| u; what the decomposition itself left; and how far s is from an
  // eigenvalue of H, as a slow one beside stiff ones may be.
  const Eigen::Index n = H.rows() / 2;
  Eigen::Matrix<Real, Eigen::Dynamic, 1> y(H.rows());
  y << left.cwiseAbs().tail(n), left.cwiseAbs().head(n);
  const Real perturbation = u * y.dot(magnitude * out.right.cwiseAbs()) +
                            Real(64) * std::numeric_limits<Real>::epsilon() * H.norm() +
                            svd.singularValues()[last];
  const Real overlap = std::abs(left.dot(out.right));
  const Real change = perturbation / overlap;
  // ds = change to first order; near a double s it is at most sqrt(change) times what it takes, and
  // the overlap, which vanishes there, has made the bound that large already.
  out.error = Real(2) * std::abs(s) * change + change * change;
  return out;
}

}  // namespace

std::vector<IteratedMode> iterated_modes(const Leaf& leaf, const LeafFacts& facts, bool definite) {
  const auto size = static_cast<Eigen::Index>(2 * leaf.pairs);
  Dense E(size, size);
  Dense magnitude(size, size);
  for (std::size_t i = 0; i < 2 * leaf.pairs; ++i) {
    for (std::size_t j = 0; j < 2 * leaf.pairs; ++j) {
      const DoubleDouble& x = leaf.second_variation[i][j];
      const auto row = static_cast<Eigen::Index>(i);
      const auto column = static_cast<Eigen::Index>(j);
      E(row, column) = Real(x.hi) + Real(x.lo);
      magnitude(row, column) = Real(leaf.magnitude[i][j]);
    }
  }
  scale_symplectically(E, magnitude);
  const Dense H = symplectic_times(E);
  std::vector<Complex> lambdas;
  if (definite) lambdas = definite_eigenvalues(E);
  if (lambdas.empty()) lambdas = squared_eigenvalues(H);
  std::vector<IteratedMode> out;
  if (facts.forced_zero) {
    lambdas.erase(std::ranges::min_element(lambdas, {},
                                           [](const Complex& lambda) { return std::abs(lambda); }));
    out.push_back({.forced = true});
  }
  for (const Complex& lambda : lambdas) {
    if (lambda.imag() < Real(0)) continue;  // its conjugate is there
    const EigenTriple t = triple(H, magnitude, lambda, Real(facts.uncertainty));
    IteratedMode mode{.lambda = std::complex<double>(lambda),
                      .error = static_cast<double>(t.error)};
    if (lambda.imag() > Real(0)) {
      out.push_back(mode);
      mode.lambda = std::conj(mode.lambda);
    } else {
      // Of the leaf as it stands, so that only what was lost on the way to it counts.
      const Real energy = t.right.dot(E.cast<Complex>() * t.right).real();
      const Real doubt =
          Real(energy_doubt) * t.right.cwiseAbs().dot(magnitude * t.right.cwiseAbs());
      mode.energy = energy > doubt ? 1 : energy < -doubt ? -1 : 0;
    }
    out.push_back(mode);
  }
  return out;
}

}  // namespace stationary
