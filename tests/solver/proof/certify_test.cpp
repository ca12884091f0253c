// Certificates: the tables' 25 digits are inside, fakes are refused, what is not decided is not
// claimed.
#include "solver/proof/certify.hpp"

#include <gtest/gtest.h>

#include <set>

#include "lib/stability/leaf_enclosure.hpp"
#include "solver/proof/motion_spectrum.hpp"
#include "solver/solve/stability.hpp"
#include "tests/support/bodies/anisotropic_motions.hpp"
#include "tests/support/bodies/motions.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/numbers/high_precision.hpp"
#include "tests/support/reference_table.hpp"

namespace stationary {
namespace {

using namespace testing;
using support::nearest;
using support::Random;
using support::Real50;
using support::ReferenceRow;

bool holds(const Interval& x, const Real50& exact) {
  return Real50(x.lo) <= exact && exact <= Real50(x.hi);
}

/// Digits of the table itself end somewhere.
bool holds_table(const Interval& x, const Real50& printed, const Real50& scale) {
  const Real50 slack = scale * Real50("1e-24");
  return Real50(x.lo) - slack <= printed && printed <= Real50(x.hi) + slack;
}

struct TableCase {
  Problem problem;
  Equilibrium at;

  explicit TableCase(const ReferenceRow& row)
      : problem(row.body(), row.potential(), row.branch()),
        at(solve(problem, row.number<double>("nu"))) {}
};

class CertificateTableTest : public ::testing::TestWithParam<const char*> {
 protected:
  std::vector<ReferenceRow> rows() const { return support::reference_table(GetParam()); }
};

TEST_P(CertificateTableTest, EveryRowIsProvenAndHoldsTheDigits) {
  for (const ReferenceRow& row : rows()) {
    const TableCase posed(row);
    ASSERT_EQ(posed.at.status, SolveStatus::solved) << row.where();
    const auto exact = row.stretch<Real50>();
    for (const Inputs inputs : {Inputs::doubles, Inputs::decimals}) {
      const Certificate found = certify(posed.problem, posed.at, inputs);
      ASSERT_TRUE(found.proven) << row.where() << " " << found.reason;
      EXPECT_TRUE(found.reason.empty());
      EXPECT_TRUE(holds(found.solution.xi, exact.xi)) << row.where();
      EXPECT_TRUE(holds(found.solution.zeta, exact.zeta)) << row.where();
      EXPECT_TRUE(holds(found.solution.rho, exact.rho)) << row.where();
      EXPECT_TRUE(found.solution.xi.within(found.unique.xi)) << row.where();
      EXPECT_TRUE(found.solution.zeta.within(found.unique.zeta)) << row.where();
      EXPECT_TRUE(found.solution.rho.within(found.unique.rho)) << row.where();
      for (const auto& [at, unique] : {std::pair(posed.at.q.xi, found.unique.xi),
                                       std::pair(posed.at.q.zeta, found.unique.zeta),
                                       std::pair(posed.at.q.rho, found.unique.rho)}) {
        EXPECT_TRUE(
            (at / Interval(1.0 - found.error_bound, 1.0 + found.error_bound)).within(unique))
            << row.where();
      }
      const double error = relative_error(posed.at.q, {exact.xi, exact.zeta, exact.rho});
      EXPECT_LE(error, found.error_bound) << row.where();
      EXPECT_LE(found.error_bound, 1e-10) << row.where();
    }
  }
}

TEST_P(CertificateTableTest, SpectraHoldTheDigits) {
  for (const ReferenceRow& row : rows()) {
    const TableCase posed(row);
    const Spectrum spectrum = stability(posed.problem, posed.at);
    const Certificate proof = certify(posed.problem, posed.at);
    ASSERT_TRUE(proof.proven) << row.where();
    const SpectrumEnclosure found = enclose_spectrum(posed.problem, posed.at, proof, spectrum);
    ASSERT_EQ(found.modes, 5) << row.where();
    Real50 largest = 0;
    for (const Mode& m : spectrum.mode)
      largest = std::max(largest, Real50(std::hypot(m.lambda_re, m.lambda_im)));
    for (int k = 0; k < 5; ++k) {
      const std::string mode = std::to_string(k + 1);
      const Real50 re = row.number<Real50>("re" + mode);
      const Real50 im = row.number<Real50>("im" + mode);
      const ComplexInterval& lambda = found.lambda[static_cast<std::size_t>(k)];
      EXPECT_TRUE(holds_table(lambda.re, re * re - im * im, largest)) << row.where() << " " << mode;
      EXPECT_TRUE(holds_table(lambda.im, 2 * re * im, largest)) << row.where() << " " << mode;
      EXPECT_LE(lambda.re.width(), 1e-9 * nearest(largest)) << row.where() << " " << mode;
    }
    ASSERT_TRUE(found.negative.has_value()) << row.where();
    EXPECT_EQ(std::to_string(*found.negative), row.text("negative")) << row.where();
    ASSERT_TRUE(found.verdict.has_value()) << row.where();
    EXPECT_EQ(name(*found.verdict), name(spectrum.verdict)) << row.where();
  }
}

/// The motion of a row in intervals `about` its doubles, as the whole leaf takes it.
template <class About>
SpectrumEnclosure leaf_spectrum_of(const TableCase& posed, const About& about,
                                   const Spectrum& spectrum) {
  const Body& body = posed.problem.body();
  const Stretch& q = posed.at.q;
  const int along = axis(posed.problem.branch());
  EnclosedMotion motion{
      {about(body.J1), about(body.J2), about(body.J3)},
      {0.0, about(q.xi), about(q.zeta), about(q.rho)},
      about(std::abs(posed.at.nu[along])),
      Vector3<Interval>::Constant(Interval(0.0)),
      {},
      {.about_third = along == 2, .coupled = !posed.problem.potential().is_separable()}};
  motion.axis[along] = 1.0;
  motion.V_qq = posed.problem.potential().visit_parts([&](const auto& model) {
    return Matrix4<Interval>(
        potential_derivatives<2>(with_coefficients(model, about), motion.q).hessian);
  });
  return enclose_leaf_spectrum(motion, spectrum);
}

/// Of motions from rest on, rest is none: the class is that of those that turn, or it is not told.
TEST(EnclosedSpectrum, FromRestOnIsThatOfWhatTurns) {
  std::set<StabilityClass> classes;
  for (const double J3 : {0.6, 2.5, 4.0}) {
    const Body body(1.0, 1.7, J3);
    const Potential V = fibred(NeoHookean<>{1.0, 2.0}, 0.4, 30.0);
    const Problem problem(body, V, Branch::iii);
    const Equilibrium rest = solve(problem, 0.0);
    const Equilibrium slow = solve(problem, 1e-3);
    ASSERT_EQ(slow.status, SolveStatus::solved) << slow.message;
    const auto both = [](double a, double b) {
      return hull(Interval(a), Interval(b)) * Interval(1.0 - 1e-12, 1.0 + 1e-12);
    };
    MotionBox box;
    box.stretches = {both(rest.q.xi, slow.q.xi), both(rest.q.zeta, slow.q.zeta),
                     both(rest.q.rho, slow.q.rho), both(rest.q.alpha, slow.q.alpha)};
    box.nu = Interval(0.0, 1e-3);
    const SpectrumEnclosure found = enclose_spectrum(problem, box, {}, Inputs::doubles);
    const Spectrum exact = stability(problem, slow);
    ASSERT_TRUE(found.verdict) << J3;
    EXPECT_EQ(*found.verdict, exact.verdict) << J3;
    EXPECT_EQ(found.negative, exact.negative) << J3;
    classes.insert(exact.verdict);

    box.axis = {Interval(1.0), Interval(0.0)};
    const auto oblique = enclose_oblique_spectrum(body, V, box, {}, Inputs::doubles);
    EXPECT_FALSE(oblique.verdict) << J3;
    EXPECT_FALSE(oblique.negative) << J3;
  }
  EXPECT_EQ(classes.size(), 3U);
}

/// Also without the help of blocks.
TEST_P(CertificateTableTest, TheWholeLeafHoldsTheDigits) {
  int rows_compared = 0;
  int decided = 0;
  for (const ReferenceRow& row : rows()) {
    const TableCase posed(row);
    if (posed.problem.body().symmetric()) continue;  // its zero is none of an anisotropic V
    const Spectrum spectrum = stability(posed.problem, posed.at);
    const double width = 2.0 * certify(posed.problem, posed.at).error_bound;
    const auto about = [&](double x) { return x * Interval(1.0 - width, 1.0 + width); };
    const SpectrumEnclosure found = leaf_spectrum_of(posed, about, spectrum);
    ASSERT_EQ(found.modes, 5) << row.where();
    double largest = 0.0;
    for (const Mode& m : spectrum.mode)
      largest = std::max(largest, std::hypot(m.lambda_re, m.lambda_im));
    for (int k = 0; k < 5; ++k) {
      const std::string mode = std::to_string(k + 1);
      const Real50 re = row.number<Real50>("re" + mode);
      const Real50 im = row.number<Real50>("im" + mode);
      const ComplexInterval& lambda = found.lambda[static_cast<std::size_t>(k)];
      EXPECT_TRUE(holds_table(lambda.re, re * re - im * im, largest)) << row.where() << " " << mode;
      EXPECT_TRUE(holds_table(lambda.im, 2 * re * im, largest)) << row.where() << " " << mode;
    }
    if (found.negative) {
      EXPECT_EQ(std::to_string(*found.negative), row.text("negative")) << row.where();
    }
    ++rows_compared;
    if (!found.verdict) continue;
    ++decided;
    EXPECT_EQ(name(*found.verdict), name(spectrum.verdict)) << row.where();
  }
  // Extreme: frequencies of 1e5 to 1 in one polynomial.
  const bool extreme = std::string_view(GetParam()) != "equilibria.csv";
  EXPECT_GE(decided, extreme ? rows_compared / 2 : rows_compared);
  RecordProperty("decided", std::to_string(decided) + " of " + std::to_string(rows_compared));
}

TEST_P(CertificateTableTest, FakesAreRefused) {
  for (const ReferenceRow& row : rows()) {
    const TableCase posed(row);
    for (double Stretch::*part : {&Stretch::xi, &Stretch::zeta, &Stretch::rho}) {
      for (const double sign : {1.0, -1.0}) {
        Equilibrium fake = posed.at;
        fake.q.*part *= 1.0 + sign * 1e-9;
        const Certificate found = certify(posed.problem, fake);
        EXPECT_FALSE(found.proven) << row.where();
        EXPECT_FALSE(found.reason.empty()) << row.where();
        EXPECT_TRUE(std::isnan(found.error_bound)) << row.where();
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Tables, CertificateTableTest,
                         ::testing::Values("equilibria.csv", "equilibria_extreme.csv"),
                         [](const auto& info) {
                           const std::string name = info.param;
                           return name.substr(0, name.find('.'));
                         });

TEST(Certificate, HoldsForEveryDecimalThatReadsAsTheInputs) {
  Random random(931);
  int proven = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Posed posed = random_problem(random, 2.0);
    const Equilibrium at = solve(posed.problem, posed.nu);
    if (at.status != SolveStatus::solved) continue;
    const Certificate wide = certify(posed.problem, at);
    const Certificate narrow = certify(posed.problem, at, Inputs::doubles);
    if (!wide.proven) continue;
    ++proven;
    EXPECT_TRUE(narrow.proven) << posed.text;
    EXPECT_LE(narrow.error_bound, wide.error_bound) << posed.text;
    const auto expect_in = [&](const Certificate& proof, double nu) {
      const auto exact = reference_solution(posed.problem, nu, at.q);
      EXPECT_TRUE(holds(proof.solution.xi, Real50(exact[0])) &&
                  holds(proof.solution.zeta, Real50(exact[1])) &&
                  holds(proof.solution.rho, Real50(exact[2])))
          << posed.text;
    };
    expect_in(narrow, posed.nu);
    // Intervals of decimals end at the next doubles.
    expect_in(wide, std::nextafter(posed.nu, 1e9));
    expect_in(wide, std::nextafter(posed.nu, -1e9));
  }
  EXPECT_GT(proven, 200);
}

/// tests/lib/balance/spurious_test.cpp: solutions of the balance that are no stationary motions.
TEST(Certificate, SpuriousBranchIsRefused) {
  const double k = 2.0;
  const double nu = 4.0 / 3.0;
  const double d = std::sqrt(1.5);
  const double plane[] = {1.0, k};
  const double axial[] = {1.0, 3.0};
  const Problem problem(Body(1.0, 3.0, 0.6),
                        Potential(Potential::planar("reciprocal-determinant", plane),
                                  Potential::thickness("reciprocal-quadratic", axial)),
                        Branch::ii);
  for (const double xi : {2.0, 2.5, 3.0}) {
    Equilibrium fake;
    fake.status = SolveStatus::solved;
    fake.q = {std::sqrt(xi * xi / 3.0 - d), xi, xi / 3.0, std::cbrt(1.0 / (3.0 - 0.6 * nu * nu))};
    fake.nu = angular_velocity(Branch::ii, nu);
    const Certificate found = certify(problem, fake);
    EXPECT_FALSE(found.proven);
    EXPECT_NE(found.reason.find("alpha"), std::string::npos) << found.reason;
    fake.q.alpha = 0.0;
    EXPECT_FALSE(certify(problem, fake).proven);
  }
}

TEST(Certificate, NonsenseIsRefused) {
  const TableCase posed(support::reference_table("equilibria.csv").front());
  Equilibrium fake = posed.at;
  fake.q.xi = -1.0;
  EXPECT_FALSE(certify(posed.problem, fake).proven);
  fake.q.xi = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(certify(posed.problem, fake).proven);
  fake = posed.at;
  fake.nu[0] += 0.1;
  EXPECT_FALSE(certify(posed.problem, fake).proven);
  fake = Equilibrium();
  EXPECT_FALSE(certify(posed.problem, fake).proven);
  EXPECT_THROW(
      enclose_spectrum(posed.problem, posed.at, Certificate(), stability(posed.problem, posed.at)),
      std::invalid_argument);
}

/// Everything the certificate says of the spectrum agrees with stability() wherever both speak, in
/// the circle, with the material symmetry, at rest and coupled.
TEST(SpectrumEnclosure, AgreesWithStability) {
  Random random(932);
  int modes = 0;
  int classes = 0;
  int claimed = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    Posed posed = random_problem(random, 2.0);
    if (trial % 25 == 0) posed.nu = 0.0;
    const Equilibrium at = solve(posed.problem, posed.nu);
    if (at.status != SolveStatus::solved) continue;
    const Certificate proof = certify(posed.problem, at);
    if (!proof.proven) continue;
    const Spectrum spectrum = stability(posed.problem, at);
    const SpectrumEnclosure found = enclose_spectrum(posed.problem, at, proof, spectrum);
    ASSERT_EQ(found.modes, spectrum.modes) << posed.text;
    for (int k = 0; k < found.modes; ++k) {
      const Mode& m = spectrum.mode[static_cast<std::size_t>(k)];
      const ComplexInterval& lambda = found.lambda[static_cast<std::size_t>(k)];
      EXPECT_TRUE(lambda.re.may_be(m.lambda_re) && lambda.im.may_be(m.lambda_im))
          << posed.text << " mode " << k << " [" << lambda.re.lo << ", " << lambda.re.hi << "]\n"
          << spectrum;
      ++modes;
    }
    if (found.negative) {
      EXPECT_EQ(*found.negative, spectrum.negative) << posed.text;
    }
    if (spectrum.verdict == StabilityClass::marginal) continue;
    ++claimed;
    if (!found.verdict) continue;
    ++classes;
    EXPECT_EQ(name(*found.verdict), name(spectrum.verdict)) << posed.text << "\n" << spectrum;
  }
  EXPECT_GT(modes, 3000);
  EXPECT_GT(classes, claimed * 9 / 10);
  RecordProperty("classes", std::to_string(classes) + " of " + std::to_string(claimed));
}

/// Of frequencies that nearly meet some are enclosed with others and some by themselves: each mode has one that it
/// may lie in.
TEST(SpectrumEnclosure, IsThatOfItsMode) {
  for (const double J : {2.43, 2.4299999999999997}) {
    for (const double nu : {1.876675873854705e-06, 3e-6, 1e-5}) {
      const Problem problem(Body(J, J, J), Potential(NeoHookean3d<>{2.2, 0.64}), Branch::i);
      const Equilibrium at = solve(problem, nu);
      const Certificate proof = certify(problem, at);
      ASSERT_TRUE(proof.proven) << proof.reason;
      const Spectrum spectrum = stability(problem, at);
      const SpectrumEnclosure found = enclose_spectrum(problem, at, proof, spectrum);
      ASSERT_EQ(found.modes, spectrum.modes);
      for (std::size_t k = 0; k < static_cast<std::size_t>(found.modes); ++k) {
        const Mode& mode = spectrum.mode[k];
        const Interval own(mode.lambda_re - mode.lambda_error, mode.lambda_re + mode.lambda_error);
        EXPECT_FALSE(own.apart_from(found.lambda[k].re)) << J << ' ' << nu << ' ' << k;
      }
    }
  }
}

/// The wider the state, the less is decided, and nothing wrongly.
TEST(SpectrumEnclosure, WideStatesDecideNothing) {
  Random random(933);
  for (const auto& row : support::reference_table("equilibria.csv")) {
    const TableCase posed(row);
    const Problem& problem = posed.problem;
    const Spectrum spectrum = stability(problem, posed.at);
    const Certificate proof = certify(problem, posed.at);
    const Stretch& q = posed.at.q;
    const EnclosureFacts facts{problem.branch(), false, problem.body().symmetric(), proof.circle,
                               false};
    bool decided = true;
    for (const double width : {1e-14, 1e-8, 1e-4, 1e-2, 0.1, 0.5, 0.9}) {
      const auto about = [width](double x) { return x * Interval(1.0 - width, 1.0 + width); };
      const SpectrumEnclosure found = problem.potential().visit_parts([&](const auto& model) {
        const Body& J = problem.body();
        return enclose_spectrum(
            facts,
            straight_state<Interval>({about(J.J1), about(J.J2), about(J.J3)},
                                     with_coefficients(model, about), about(q.xi), about(q.zeta),
                                     about(q.rho), about(posed.at.nu[axis(problem.branch())])),
            spectrum);
      });
      decided = found.verdict.has_value() || found.negative.has_value();
      if (!facts.material_symmetry) {
        const SpectrumEnclosure whole = leaf_spectrum_of(posed, about, spectrum);
        if (whole.verdict) {
          EXPECT_EQ(name(*whole.verdict), name(spectrum.verdict)) << row.where() << " " << width;
        }
        if (whole.negative) {
          EXPECT_EQ(*whole.negative, spectrum.negative) << row.where() << " " << width;
        }
        decided = decided || whole.verdict || whole.negative;
      }
      if (found.verdict) {
        EXPECT_EQ(name(*found.verdict), name(spectrum.verdict)) << row.where() << " " << width;
      }
      if (found.negative) {
        EXPECT_EQ(*found.negative, spectrum.negative) << row.where() << " " << width;
      }
    }
    EXPECT_FALSE(decided) << row.where();
  }
}

}  // namespace
}  // namespace stationary
