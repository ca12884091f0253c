#include "lib/leaf/iterated_modes.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/leaf/leaf_modes.hpp"
#include "lib/matrix/eigen_pair.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {
namespace {

using Real = EigenPair;
using Complex = ComplexPair;
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

/// E'' and |change| of its entries of inputs of relative uncertainty 1.
struct WideLeaf {
  Dense E;
  Dense magnitude;
};

WideLeaf wide(const Leaf& leaf) {
  const auto size = static_cast<Eigen::Index>(2 * leaf.pairs);
  WideLeaf out{Dense(size, size), Dense(size, size)};
  for (std::size_t i = 0; i < 2 * leaf.pairs; ++i) {
    for (std::size_t j = 0; j < 2 * leaf.pairs; ++j) {
      const DoubleDouble& x = leaf.second_variation[i][j];
      const auto row = static_cast<Eigen::Index>(i);
      const auto column = static_cast<Eigen::Index>(j);
      out.E(row, column) = Real(x);
      out.magnitude(row, column) = Real(leaf.magnitude[i][j]);
    }
  }
  return out;
}

/// x_k -> x_k/c_k, p_k -> c_k p_k: makes the two diagonals of E'' alike in size. Returns c.
std::vector<Real> scale_symplectically(Dense& E, Dense& magnitude) {
  const Eigen::Index n = E.rows() / 2;
  std::vector<Real> out(static_cast<std::size_t>(n), Real(1));
  for (Eigen::Index k = 0; k < n; ++k) {
    const Real c = sqrt(sqrt(magnitude(n + k, n + k) / magnitude(k, k)));
    if (!isfinite(c) || c == Real(0)) continue;
    out[static_cast<std::size_t>(k)] = c;
    for (Dense* m : {&E, &magnitude}) {
      m->row(k) *= c;
      m->col(k) *= c;
      m->row(n + k) /= c;
      m->col(n + k) /= c;
    }
  }
  return out;
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

/// The Lambdas of H = J E'': eigenvalues of A in the square-reduced form of H^2; empty where the
/// iteration does not converge.
std::vector<Complex> squared_eigenvalues(const Dense& H) {
  Dense W = H * H;
  const Eigen::Index n = W.rows() / 2;
  for (Eigen::Index k = 0; k + 1 < n; ++k) {
    reflect(W, k, n, k + 1);  // lower left block, below its (k+1, k) entry
    // A rotation in the plane (x_{k+1}, p_{k+1}) removes that entry against A(k+1, k).
    const Eigen::Index i = k + 1;
    const Real a = W(i, k);
    const Real f = W(n + i, k);
    const Real r = sqrt(a * a + f * f);
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
  if (solver.info() != Eigen::Success) return {};
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
  if (solver.info() != Eigen::Success) return {};
  std::vector<Complex> out;
  for (Eigen::Index k = E.rows() / 2; k < E.rows(); ++k) {
    const Real frequency = solver.eigenvalues()[k];
    out.emplace_back(-frequency * frequency, Real(0));
  }
  return out;
}

struct EigenTriple {
  ComplexVector right;
  Real change;  ///< bound of |change of s|, to first order
  Real error;   ///< bound of |change of Lambda|
};

/// Null vectors of H - s by inverse iteration, which gives those of its least singular value;
/// first-order perturbation bound.
EigenTriple triple(const Dense& H, const Dense& magnitude, Complex lambda, Real u) {
  const Eigen::Index size = H.rows();
  EigenTriple out;
  const Complex s = sqrt(lambda);
  const Real rounding = Real(64) * std::numeric_limits<Real>::epsilon() * H.norm();
  ComplexDense shifted = H.cast<Complex>();
  shifted.diagonal().array() -= s;
  // A little off s, so that no pivot is zero.
  ComplexDense beside = shifted;
  beside.diagonal().array() -= Complex(std::numeric_limits<Real>::epsilon() * H.norm());
  const Eigen::PartialPivLU<ComplexDense> elimination(beside);
  // Entries unlike each other: no null vector is orthogonal to such a start by symmetry.
  ComplexVector left(size);
  out.right.resize(size);
  for (Eigen::Index k = 0; k < size; ++k)
    out.right[k] = Complex(1.0 / double(2 * k + 3), 1.0 / double(k * k + 7));
  // A step gains the ratio of the two least singular values, squared.
  for (int step = 0; step < 3; ++step) {
    left = elimination.adjoint().solve(out.right);
    left /= Complex(left.norm());
    out.right = elimination.solve(left);
    out.right /= Complex(out.right.norm());
  }
  // |y^* dH x| <= |J y|^T |dE''| |x| u; what rounding left; and how far s is from an eigenvalue of H,
  // as a slow one beside stiff ones may be.
  const Eigen::Index n = size / 2;
  Eigen::Matrix<Real, Eigen::Dynamic, 1> y(size);
  y << left.cwiseAbs().tail(n), left.cwiseAbs().head(n);
  const Real residual = std::max((shifted * out.right).norm(), (shifted.adjoint() * left).norm());
  const Real perturbation = u * y.dot(magnitude * out.right.cwiseAbs()) + rounding + residual;
  const Real overlap = abs(left.dot(out.right));
  const Real change = out.change = perturbation / overlap;
  // ds = change to first order; near a double s it is at most sqrt(change) times what it takes, and
  // the overlap, which vanishes there, has made the bound that large already.
  out.error = Real(2) * abs(s) * change + change * change;
  return out;
}

/// Of a Lambda that cannot be told from zero s and -s nearly meet, and the less their vectors overlap
/// the larger is the bound, without end at Lambda = 0. Of vectors a little away from it, at what the
/// least bound takes, it is as small as that of Lambda, which is simple.
EigenTriple triple_beside_zero(const Dense& H, const Dense& magnitude, Complex lambda, Real u) {
  const EigenTriple at = triple(H, magnitude, lambda, u);
  if (at.error < abs(lambda)) return at;
  const Real product = abs(sqrt(lambda)) * at.change;
  const Real away = product > Real(0) && isfinite(product) ? product : u * H.squaredNorm();
  EigenTriple beside = triple(H, magnitude, lambda - away, u);
  beside.error += away;
  beside.right = at.right;  // the energy is that of the mode's own vector
  return beside.error < at.error || !isfinite(at.error) ? beside : at;
}

}  // namespace

std::vector<IteratedMode> iterated_modes(const Leaf& leaf, const LeafFacts& facts, bool definite) {
  auto [E, magnitude] = wide(leaf);
  scale_symplectically(E, magnitude);
  const Dense H = symplectic_times(E);
  std::vector<Complex> lambdas;
  if (definite) lambdas = definite_eigenvalues(E);
  if (lambdas.empty()) lambdas = squared_eigenvalues(H);
  std::vector<IteratedMode> out;
  if (lambdas.empty()) {
    out.assign(leaf.pairs, {.error = std::numeric_limits<double>::infinity()});
    return out;
  }
  if (facts.forced_zero) {
    const auto zero =
        std::ranges::min_element(lambdas, {}, [](const Complex& lambda) { return abs(lambda); });
    const Complex erased = *zero;
    lambdas.erase(zero);
    // Zero has no conjugate: what rounding has made one is real, and their sum is its own.
    if (erased.imag() != Real(0))
      *std::ranges::min_element(lambdas, {}, [&](const Complex& lambda) {
        return abs(lambda - std::conj(erased));
      }) = Complex(Real(2) * erased.real());
    out.push_back({.forced = true});
  }
  for (const Complex& lambda : lambdas) {
    if (lambda.imag() < Real(0)) continue;  // its conjugate is there
    const EigenTriple t = triple_beside_zero(H, magnitude, lambda, Real(facts.uncertainty));
    IteratedMode mode{.lambda = {double(lambda.real()), double(lambda.imag())},
                      .error = double(t.error)};
    mode.error += 0x1p-53 * modulus(mode.lambda);
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

LeafVector leaf_vector(const Leaf& leaf, std::complex<double> s, std::size_t before) {
  auto [E, magnitude] = wide(leaf);
  const std::vector<Real> c = scale_symplectically(E, magnitude);
  const Dense H = symplectic_times(E);
  ComplexDense shifted = H.cast<Complex>();
  shifted.diagonal().array() -= Complex(Real(s.real()), Real(s.imag()));
  // Of a square matrix: no factorization before it.
  const Eigen::JacobiSVD<ComplexDense, Eigen::NoQRPreconditioner> svd(shifted, Eigen::ComputeFullV);
  const Eigen::Index n = H.rows() / 2;
  const Eigen::Index column = 2 * n - 1 - static_cast<Eigen::Index>(before);
  LeafVector out{std::vector<std::complex<double>>(static_cast<std::size_t>(2 * n)),
                 double(Real(svd.singularValues()[column] / H.norm()))};
  const auto part = [&](Eigen::Index row, const Real& factor) {
    const Complex x = svd.matrixV()(row, column);
    return std::complex<double>(double(Real(x.real() * factor)), double(Real(x.imag() * factor)));
  };
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto at = static_cast<std::size_t>(k);
    out.x[at] = part(k, c[at]);
    out.x[at + leaf.pairs] = part(n + k, Real(1) / c[at]);
  }
  return out;
}

}  // namespace stationary
