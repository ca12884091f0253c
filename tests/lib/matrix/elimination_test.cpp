// Elimination against what a matrix was made of: determinants by a product of triangles, inverses by the solution that
// was put in. Rows and columns of any size.
#include "lib/matrix/elimination.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lib/matrix/scaled_rows.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary {
namespace {

template <class Size>
class EliminationTest : public ::testing::Test {
 protected:
  static constexpr int N = Size::value;
  using Matrix = Eigen::Matrix<double, N, N>;
  using Numbers = typename ScaledRows<N>::Numbers;
  using Columns = std::array<Numbers, static_cast<std::size_t>(N)>;

  /// Small integers: products and sums of them are exact.
  Matrix integers(int most = 9) {
    Matrix out;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) out(i, j) = random.integer(-most, most);
    return out;
  }
  /// Unit triangles L and R, and a diagonal: A = L D R.
  Matrix of_determinant(double& determinant) {
    Matrix L = integers(1);
    Matrix R = integers(1);
    Matrix D = Matrix::Zero();
    determinant = 1.0;
    for (int i = 0; i < N; ++i) {
      L(i, i) = R(i, i) = 1.0;
      for (int j = i + 1; j < N; ++j) L(i, j) = R(j, i) = 0.0;
      D(i, i) = random.sign() * random.integer(1, 4);
      determinant *= D(i, i);
    }
    return L * D * R;
  }
  static Columns columns_of(const Matrix& A) {
    Columns out;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j)
        out[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = A(i, j);
    return out;
  }

  support::Random random{27};
};
using EliminationSizes =
    ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>,
                     std::integral_constant<int, 4>, std::integral_constant<int, 5>,
                     std::integral_constant<int, 6>>;
TYPED_TEST_SUITE(EliminationTest, EliminationSizes);

TYPED_TEST(EliminationTest, DeterminantIsTheProductOfTheDiagonal) {
  constexpr int N = TestFixture::N;
  for (int k = 0; k < 500; ++k) {
    double expected = 0.0;
    const auto A = this->of_determinant(expected);
    double terms = 1.0;  // Hadamard's bound
    for (int i = 0; i < N; ++i) terms *= A.row(i).norm();
    EXPECT_NEAR(Elimination<N>(A).determinant(), expected, 64 * 0x1p-53 * terms) << A;
    EXPECT_NEAR(determinant<N>(A), expected, 64 * 0x1p-53 * terms) << A;
  }
}

TYPED_TEST(EliminationTest, TwoRowsExchangedTurnTheSignAndTheColumnsOfTheInverse) {
  constexpr int N = TestFixture::N;
  for (int k = 0; k < 200; ++k) {
    double expected = 0.0;
    const auto A = this->of_determinant(expected);
    auto B = A;
    B.row(0).swap(B.row(N - 1));
    EXPECT_EQ(Elimination<N>(A).determinant() < 0.0, Elimination<N>(B).determinant() > 0.0);
    auto inverse = Elimination<N>(B).inverse();
    inverse.col(0).swap(inverse.col(N - 1));
    const auto own = Elimination<N>(A).inverse();
    EXPECT_LT((own - inverse).cwiseAbs().maxCoeff(), 1e-6 * own.cwiseAbs().maxCoeff()) << A;
  }
}

TYPED_TEST(EliminationTest, ASingularMatrixHasNoInverse) {
  constexpr int N = TestFixture::N;
  auto A = this->integers();
  A.row(N - 1) = A.row(0);
  EXPECT_EQ(Elimination<N>(A).determinant(), 0.0);
  EXPECT_FALSE(Elimination<N>(A).inverse().allFinite());
}

TYPED_TEST(EliminationTest, RowsAndColumnsMayBeOfAnySize) {
  constexpr int N = TestFixture::N;
  int compared = 0;
  for (int k = 0; k < 500; ++k) {
    double det = 0.0;
    const auto A = this->of_determinant(det);
    const double condition = A.cwiseAbs().sum() * Elimination<N>(A).inverse().cwiseAbs().sum();
    if (!(condition < 1e6)) continue;
    auto scaled = A;
    typename TestFixture::Numbers x;
    typename TestFixture::Numbers size;
    typename TestFixture::Numbers b{};
    for (std::size_t j = 0; j < x.size(); ++j) {
      size[j] = std::ldexp(1.0, this->random.integer(-200, 200));
      scaled.col(static_cast<int>(j)) *= size[j];
      x[j] = this->random.integer(1, 8);
    }
    for (int i = 0; i < N; ++i) {
      const double row = std::ldexp(1.0, this->random.integer(-200, 200));
      scaled.row(i) *= row;
      for (int j = 0; j < N; ++j)
        b[static_cast<std::size_t>(i)] += row * A(i, j) * x[static_cast<std::size_t>(j)];
    }
    ScaledRows<N> rows;
    rows.eliminate(this->columns_of(scaled));
    const auto found = rows.solve(b);
    for (std::size_t j = 0; j < x.size(); ++j)
      EXPECT_NEAR(found[j] * size[j], x[j], 1e3 * 0x1p-53 * condition);
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TYPED_TEST(EliminationTest, TheLargestChangeIsThatOfSomeSigns) {
  constexpr int N = TestFixture::N;
  double det = 0.0;
  const auto A = this->of_determinant(det);
  ScaledRows<N> rows;
  rows.eliminate(this->columns_of(A));
  typename TestFixture::Numbers off;
  typename TestFixture::Numbers scaled;
  for (std::size_t i = 0; i < off.size(); ++i) {
    off[i] = this->random.uniform(0.1, 1.0);
    scaled[i] = rows.scaled(i, off[i]);
  }
  typename TestFixture::Numbers most{};
  for (int signs = 0; signs < (1 << N); ++signs) {
    auto b = off;
    for (std::size_t i = 0; i < b.size(); ++i)
      if (((signs >> i) & 1) != 0) b[i] = -b[i];
    const auto x = rows.solve(b);
    for (std::size_t i = 0; i < x.size(); ++i) most[i] = std::max(most[i], x[i]);
  }
  const auto largest = rows.largest(scaled);
  for (std::size_t i = 0; i < most.size(); ++i)
    EXPECT_NEAR(largest[i], most[i], 1e-9 * std::abs(most[i]));
}

TYPED_TEST(EliminationTest, OfASingularMatrixNothingIsFinite) {
  constexpr int N = TestFixture::N;
  const auto A = this->integers();
  auto zero = A;
  zero.row(1).setZero();
  auto twice = A;
  twice.row(N - 1) = twice.row(0);
  auto none = A;
  none(0, 1) = std::numeric_limits<double>::quiet_NaN();
  typename TestFixture::Numbers b;
  b.fill(1.0);
  for (const auto& each : {zero, twice, none}) {
    ScaledRows<N> rows;
    rows.eliminate(this->columns_of(each));
    for (const double x : rows.solve(b)) EXPECT_TRUE(std::isnan(x));
    for (const double x : rows.largest(b)) EXPECT_TRUE(std::isnan(x));
  }
}

}  // namespace
}  // namespace stationary
