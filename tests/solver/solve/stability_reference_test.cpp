// The tables of independently computed spectra (25 digits) against solve and stability.
#include <gtest/gtest.h>

#include "tests/support/bodies/motions.hpp"
#include "tests/support/reference_table.hpp"

namespace stationary {
namespace {

using namespace testing;
using support::nearest;
using support::Real50;
using support::ReferenceRow;

struct TableMode {
  Real50 re;
  Real50 im;
  Real50 lambda_re() const { return re * re - im * im; }
  Real50 lambda_im() const { return 2 * re * im; }
};

std::vector<TableMode> table_modes(const ReferenceRow& row) {
  std::vector<TableMode> out;
  for (const char* k : {"1", "2", "3", "4", "5"})
    out.push_back(
        {row.number<Real50>(std::string("re") + k), row.number<Real50>(std::string("im") + k)});
  return out;
}

/// Every mode in the table's order. Returns the largest |Delta Lambda| / max |Lambda|.
double expect_table_modes(const ReferenceRow& row, const Spectrum& spectrum, double absolute,
                          double relative) {
  const auto table = table_modes(row);
  EXPECT_EQ(spectrum.modes, 5) << row.where();
  Real50 size = 0;
  for (const TableMode& t : table)
    size = std::max(size, Real50(abs(t.lambda_re()) + abs(t.lambda_im())));
  double worst = 0.0;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const Mode& m = spectrum.mode[k];
    const Real50 re = Real50(m.lambda_re) - table[k].lambda_re();
    const Real50 im = Real50(m.lambda_im) - table[k].lambda_im();
    const Real50 off = sqrt(Real50(re * re + im * im));
    const Real50 own = abs(table[k].lambda_re()) + abs(table[k].lambda_im());
    const double ratio = nearest(Real50(off / size));
    worst = std::max(worst, ratio);
    EXPECT_LE(ratio, absolute) << row.where() << " mode " << k << "\n" << spectrum;
    if (own >= size * 1e-8) {
      EXPECT_LE(nearest(Real50(off / own)), relative) << row.where() << " mode " << k << "\n"
                                                      << spectrum;
      // s itself.
      EXPECT_LE(nearest(Real50(abs(Real50(m.re - table[k].re)) + abs(Real50(m.im - table[k].im)))),
                relative * nearest(Real50(table[k].re + table[k].im)) +
                    2.0 * absolute * std::sqrt(nearest(size)))
          << row.where() << " mode " << k;
    }
    EXPECT_LE(nearest(off), m.lambda_error + 1e-24 * nearest(size))
        << row.where() << " mode " << k << "\n"
        << spectrum;
  }
  return worst;
}

/// The class from the table's own numbers: growth from its eigenvalues, `stable` where it counts no
/// negative direction. With J1 = J2 the count may hold the meaningless one, and the circle has a
/// second invariant: nothing is said then.
std::optional<StabilityClass> table_class(const ReferenceRow& row) {
  bool real = false;
  bool complex = false;
  for (const TableMode& t : table_modes(row)) {
    real = real || (t.re > 1e-15 && t.im < 1e-15);
    complex = complex || (t.re > 1e-15 && t.im > 1e-15);
  }
  if (real) return StabilityClass::unstable;
  if (complex) return StabilityClass::oscillatory;
  if (row.text("negative") == "0") return StabilityClass::stable;
  if (row.text("J1") == row.text("J2")) return std::nullopt;
  return StabilityClass::elliptic;
}

class SpectrumTableTest : public ::testing::TestWithParam<const char*> {};

TEST_P(SpectrumTableTest, SolveAndStability) {
  const auto rows = support::reference_table(GetParam());
  ASSERT_FALSE(rows.empty());
  int classes = 0;
  double worst = 0.0;
  for (const ReferenceRow& row : rows) {
    const Problem problem(row.body(), row.potential(), row.branch());
    const double nu = row.number<double>("nu");
    Equilibrium at = solve(problem, nu);
    if (at.status != SolveStatus::solved ||
        std::abs(at.q.xi - row.number<double>("xi")) > 1e-8 * at.q.xi) {
      SolveOptions options;  // a sheet that rest does not reach
      options.method = Method::newton;
      options.start = row.stretch<double>();
      at = solve(problem, nu, options);
    }
    ASSERT_EQ(at.status, SolveStatus::solved) << row.where();
    const Spectrum spectrum = stability(problem, at);
    worst = std::max(worst, expect_table_modes(row, spectrum, 2e-15, 2e-15));
    EXPECT_EQ(std::to_string(spectrum.negative), row.text("negative")) << row.where();
    if (const auto expected = table_class(row)) {
      EXPECT_EQ(name(spectrum.verdict), name(*expected)) << row.where() << "\n" << spectrum;
      ++classes;
    } else {
      EXPECT_TRUE(spectrum.verdict == StabilityClass::stable ||
                  spectrum.verdict == StabilityClass::elliptic)
          << row.where() << "\n"
          << spectrum;
    }
    double growth = 0.0;
    for (const TableMode& t : table_modes(row)) growth = std::max(growth, nearest(t.re));
    EXPECT_NEAR(spectrum.growth, growth > 1e-15 ? growth : 0.0, 1e-14 * (1.0 + growth))
        << row.where();
  }
  RecordProperty("worst", ::testing::PrintToString(worst));
  EXPECT_GT(classes, static_cast<int>(rows.size()) * 3 / 4);
}

INSTANTIATE_TEST_SUITE_P(Tables, SpectrumTableTest,
                         ::testing::Values("equilibria.csv", "equilibria_extreme.csv"),
                         [](const auto& info) {
                           const std::string name = info.param;
                           return name.substr(0, name.find('.'));
                         });

DoubleDouble extended(const Real50& x) {
  const double hi = nearest(x);
  return {hi, nearest(Real50(x - hi))};
}

/// Inputs of this table are decimals: J to their doubles costs an ulp or so.
TEST(SpectrumTable, Tilted) {
  double worst = 0.0;
  for (const ReferenceRow& row : support::reference_table("tilted.csv")) {
    const auto wide = row.stretch<Real50>();
    const BasicStretch<DoubleDouble> q{0.0, extended(wide.xi), extended(wide.zeta),
                                       extended(wide.rho)};
    Vector3<DoubleDouble> nu;
    for (int k = 0; k < 3; ++k) nu[k] = extended(row.nu<Real50>()[k]);
    const Spectrum spectrum = general_spectrum(row.body(), row.potential(), q, nu, 0x1p-53);
    worst = std::max(worst, expect_table_modes(row, spectrum, 4e-15, 4e-13));
    const bool grows = row.number<double>("re1") > 0.0;
    EXPECT_EQ(spectrum.verdict == StabilityClass::unstable, grows) << row.where() << spectrum;
    if (!grows) {
      EXPECT_EQ(spectrum.growth, 0.0) << row.where();
    }
  }
  RecordProperty("worst", ::testing::PrintToString(worst));
}

}  // namespace
}  // namespace stationary
