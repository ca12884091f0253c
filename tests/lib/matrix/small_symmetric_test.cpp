// The closed inverses against Eigen's, and the small operations beside them.
#include "lib/matrix/small_symmetric.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/law.hpp"

namespace stationary {
namespace {

template <class Size>
class SmallSymmetricTest : public ::testing::Test {
 protected:
  static constexpr int N = Size::value;

  SmallSymmetric<N> draw() {
    SmallSymmetric<N> out;
    for (double& entry : out.entries) entry = random.sign() * random.log_uniform(1e-3, 1e3);
    return out;
  }

  support::Random random{20};
};
using Sizes = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                               std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(SmallSymmetricTest, Sizes);

TYPED_TEST(SmallSymmetricTest, MatrixIsSymmetricAndHoldsEveryEntryOnce) {
  constexpr int N = TestFixture::N;
  SmallSymmetric<N> a;
  for (std::size_t k = 0; k < a.entries.size(); ++k) a.entries[k] = static_cast<double>(k);
  const auto m = a.matrix();
  EXPECT_EQ(m, m.transpose());
  double expected = 0.0;
  for (int i = 0; i < N; ++i)
    for (int j = i; j < N; ++j) EXPECT_EQ(m(i, j), expected++);
}

/// A backward error, so that no condition number enters: |A X - 1| against |A| |X|.
TYPED_TEST(SmallSymmetricTest, InverseTimesMatrixIsOne) {
  constexpr int N = TestFixture::N;
  using Matrix = Eigen::Matrix<double, N, N>;
  int compared = 0;
  for (int k = 0; k < 2000; ++k) {
    const auto a = this->draw();
    const Matrix m = a.matrix();
    const double condition =
        m.cwiseAbs().rowwise().sum().maxCoeff() * m.inverse().cwiseAbs().rowwise().sum().maxCoeff();
    if (condition > 1e6) continue;
    const Matrix expected = m.fullPivLu().inverse();
    EXPECT_TRUE(support::all_agree<Matrix>(
        support::at("condition", condition), expected, a.inverse().matrix(),
        64 * 0x1p-53 * condition * condition * expected.cwiseAbs().maxCoeff()));
    EXPECT_TRUE(support::all_agree<Matrix>(support::at("condition", condition), Matrix::Identity(),
                                           m * a.inverse().matrix(),
                                           64 * 0x1p-53 * condition * condition));
    ++compared;
  }
  EXPECT_GE(compared, 1500);
}

TYPED_TEST(SmallSymmetricTest, ProductIsEigens) {
  constexpr int N = TestFixture::N;
  using Vector = Eigen::Matrix<double, N, 1>;
  for (int k = 0; k < 200; ++k) {
    const auto a = this->draw();
    const Vector x = this->random.template direction<N>();
    const double size = (a.absolute().matrix() * x.cwiseAbs()).maxCoeff();
    EXPECT_TRUE(
        support::all_agree<Vector>(support::at("x", x), a.matrix() * x, a * x, 4 * 0x1p-53 * size));
    EXPECT_EQ(a.absolute().matrix(), a.matrix().cwiseAbs());
    const double volume = a.matrix().cwiseAbs().rowwise().sum().prod();
    EXPECT_NEAR(a.determinant(), a.matrix().determinant(), 32 * 0x1p-53 * volume);
  }
}

/// K (1, 1, 1)(1, 1, 1)^T + M, a body K/|M| times stiffer in volume than in shape, against its
/// inverse in extended precision: of K/|M| digits no more are lost than once.
TEST(SmallSymmetric, StiffMatricesLoseTheRatioOnce) {
  support::Random random{21};
  using Wide = Eigen::Matrix<long double, 3, 3>;
  int tried = 0;
  for (int k = 0; k < 2000; ++k) {
    const double stiff = random.log_uniform(1e4, 1e12);
    SmallSymmetric<3> a;
    for (double& entry : a.entries) entry = random.sign() * random.log_uniform(0.1, 10.0);
    for (const int i : {0, 3, 5}) a.entries[static_cast<std::size_t>(i)] += 20.0;  // definite
    for (double& entry : a.entries) entry += stiff;
    const Eigen::FullPivLU<Wide> wide(a.matrix().cast<long double>());
    const Eigen::Matrix3d expected = wide.inverse().cast<double>();
    EXPECT_TRUE(support::all_agree<Eigen::Matrix3d>(
        support::at("stiff", stiff), expected, a.inverse().matrix(),
        64 * 0x1p-53 * stiff * expected.cwiseAbs().maxCoeff()));
    // What an iteration with it contracts by: the entries' errors belong together.
    const Wide left = a.inverse().matrix().cast<long double>() * a.matrix().cast<long double>() -
                      Wide::Identity();
    EXPECT_LE(static_cast<double>(left.cwiseAbs().maxCoeff()), 64 * 0x1p-53 * stiff) << stiff;
    const auto determinant = static_cast<double>(wide.determinant());
    EXPECT_NEAR(a.determinant(), determinant, 64 * 0x1p-53 * stiff * std::abs(determinant))
        << stiff;
    ++tried;
  }
  EXPECT_EQ(tried, 2000);
}

TEST(SmallSymmetric, SingularHasNoFiniteInverse) {
  const auto finite = [](const auto& a) { return a.inverse().matrix().allFinite(); };
  EXPECT_FALSE(finite(SmallSymmetric<1>{{0.0}}));
  EXPECT_FALSE(finite(SmallSymmetric<2>{{1.0, 2.0, 4.0}}));
  EXPECT_FALSE(finite(SmallSymmetric<2>{{0.0, 0.0, 0.0}}));
  EXPECT_FALSE(finite(SmallSymmetric<3>{{1.0, 2.0, 3.0, 4.0, 6.0, 9.0}}));
  EXPECT_TRUE(finite(SmallSymmetric<3>{{1.0, 2.0, 3.0, 4.0, 6.0, 10.0}}) == false);
  EXPECT_TRUE(finite(SmallSymmetric<2>{{1.0, 2.0, 5.0}}));
}

TEST(LargestMagnitude, OfEveryPlaceAndSign) {
  for (int i = 0; i < 3; ++i) {
    Eigen::Vector3d x(1.0, -1.0, 0.5);
    x[i] = -3.0;
    EXPECT_EQ(largest_magnitude<3>(x), 3.0);
    x[i] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(largest_magnitude<3>(x), std::numeric_limits<double>::infinity());
  }
}

TEST(LargestMagnitude, IsNaNWhereverOneIs) {
  for (int i = 0; i < 3; ++i) {
    Eigen::Vector3d x(1.0, 7.0, -2.0);
    x[i] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(largest_magnitude<3>(x))) << i;
  }
}

}  // namespace
}  // namespace stationary
