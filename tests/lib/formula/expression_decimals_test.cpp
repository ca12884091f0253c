// A number in a formula that is no double ("0.1") is an input: the error bound covers what it may
// have been, as it does for parameters.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "solver/program/case/case_file.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"
#include "solver/solve/solve.hpp"
#include "solver/solve/stability.hpp"

namespace stationary {
namespace {

struct Solved {
  Equilibrium at;
  Spectrum spectrum;
};

/// In (iii) at nu = 0.3, or (i).
Solved solved(const std::string& potential, const std::string& branch = "iii") {
  const Case input =
      make_case(CaseTree::parse("[body]\nJ = [1.0, 1.7, 0.6]\n[motion]\nbranch = \"" + branch +
                                    "\"\nnu = 0.3\n[potential]\n" + potential + "\n",
                                "decimals"));
  const Problem problem = input.problem();
  Solved out{solve(problem, 0.3), {}};
  EXPECT_EQ(out.at.status, SolveStatus::solved) << out.at.message;
  out.spectrum = problem.potential().is_isotropic()
                     ? stability(problem, out.at)
                     : anisotropic_stability(problem, out.at).value();
  return out;
}

/// Of the same motion, the second by a formula whose decimals cancel: apart by more than rounding,
/// and by no more than its bounds.
void expect_covered(const Solved& exact, const Solved& rough, const std::string& text) {
  const auto apart = [](double a, double b) { return std::abs(a / b - 1.0); };
  const double error =
      std::max({apart(rough.at.q.xi, exact.at.q.xi), apart(rough.at.q.zeta, exact.at.q.zeta),
                apart(rough.at.q.rho, exact.at.q.rho)});
  EXPECT_GT(error, 1e-13) << text;
  EXPECT_LE(error, rough.at.error_bound + exact.at.error_bound) << text;
  EXPECT_LE(rough.at.error_bound, 1e4 * error) << text;
  for (std::size_t k = 0; k < 5; ++k) {
    const Mode& a = rough.spectrum.mode[k];
    const Mode& b = exact.spectrum.mode[k];
    EXPECT_LE(std::hypot(a.lambda_re - b.lambda_re, a.lambda_im - b.lambda_im),
              a.lambda_error + b.lambda_error)
        << text << " mode " << k;
  }
}

const std::string plane = "(I1 - 2 - 2*log(d)) + log(d)^2";
const std::string harmonic_thickness =
    "\nthickness = { model = \"harmonic\", k = 3.0, rest = 1.0 }";

std::string slot_text(const std::string& slot, const std::string& formula) {
  return slot + " = { expression = \"" + formula + "\" }";
}

TEST(ExpressionDecimals, OfThePlane) {
  const Solved exact = solved(slot_text("plane", plane + " + 0.1*t") + harmonic_thickness);
  EXPECT_LE(exact.at.error_bound, 2e-15);
  for (const char* text : {" + 100000.1*t - 100000*t", " + 10000000.1*t - 10000000*t"})
    expect_covered(exact, solved(slot_text("plane", plane + text) + harmonic_thickness), text);
}

TEST(ExpressionDecimals, InPrincipalStretches) {
  const std::string base = "lambda^2 + mu_^2 - 2*log(d)";
  const Solved exact =
      solved(slot_text("plane", base + " + 0.1*(lambda + mu_)") + harmonic_thickness);
  const std::string text = base + " + 1000000.1*(lambda + mu_) - 1000000*(lambda + mu_)";
  expect_covered(exact, solved(slot_text("plane", text) + harmonic_thickness), text);
}

TEST(ExpressionDecimals, OfTheThickness) {
  const std::string other = slot_text("plane", plane) + "\n";
  const std::string base = "1/rho + rho^2";
  const Solved exact = solved(other + slot_text("thickness", base + " + 0.1*rho"), "i");
  const std::string text = base + " + 1000000.1*rho - 1000000*rho";
  expect_covered(exact, solved(other + slot_text("thickness", text), "i"), text);
}

TEST(ExpressionDecimals, OfBothTogether) {
  const std::string base = plane + " + (rho*d - 1)^2 + (rho - 1)^2";
  const Solved exact = solved(slot_text("coupled", base + " + 0.1*t*rho"));
  const std::string text = base + " + 1000000.1*t*rho - 1000000*t*rho";
  expect_covered(exact, solved(slot_text("coupled", text)), text);
}

TEST(ExpressionDecimals, OfAnAnisotropicOne) {
  const std::string base = plane + " + (xi*alpha + zeta^2)/4";
  const Solved exact = solved(slot_text("plane", base + " + 0.1*xi") + harmonic_thickness);
  const std::string text = base + " + 1000000.1*xi - 1000000*xi";
  expect_covered(exact, solved(slot_text("plane", text) + harmonic_thickness), text);
}

}  // namespace
}  // namespace stationary
