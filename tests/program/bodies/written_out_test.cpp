// Every built-in model written out as an expression is the same potential to the whole program:
// equilibria, bounds, spectra, exhaustive search, certificates, events, families in a coefficient.
#include "tests/support/bodies/written_out.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/proof/certify.hpp"
#include "solver/search/search.hpp"
#include "solver/solve/solve.hpp"
#include "solver/solve/stability.hpp"
#include "tests/support/bodies/random_states.hpp"
#include "tests/support/followed.hpp"

namespace stationary::testing {
namespace {

std::string numbers_text(const std::vector<std::string_view>& names, const double (&values)[2]) {
  char out[128];
  std::snprintf(out, sizeof out, "%.*s = %.17g, %.*s = %.17g", static_cast<int>(names[0].size()),
                names[0].data(), values[0], static_cast<int>(names[1].size()), names[1].data(),
                values[1]);
  return out;
}

/// The same case twice: its models by name, and written out.
struct Twice {
  Case named;
  Case written;
};

/// Each followed by more text of its own.
Twice twice(const WrittenOut& each, support::Random& random, std::string_view branch,
            const std::string& more_named = "", const std::string& more_written = "") {
  const double plane[2] = {random.uniform(0.8, 1.6), random.uniform(0.5, 2.0)};
  const double axial[2] = {random.uniform(0.8, 1.6), random.uniform(2.0, 4.0)};
  const bool harmonic = random.integer(0, 1) == 1;
  char rest[512];
  std::snprintf(rest, sizeof rest,
                "[body]\nJ = [%.17g, %.17g, %.17g]\n[motion]\nbranch = \"%.*s\"\nnu = %.17g\n",
                random.uniform(0.8, 1.2), random.uniform(1.3, 1.8), random.uniform(0.4, 0.9),
                static_cast<int>(branch.size()), branch.data(), random.uniform(0.2, 0.45));
  const std::string slot = each.coupled ? "coupled" : "plane";
  std::string named = "[potential]\n" + slot + " = { model = \"" + std::string(each.model) +
                      "\", " + numbers_text(each.parameters, plane) + " }\n";
  std::string written = "[potential]\n" + slot + " = { expression = \"" +
                        std::string(each.expression) + "\", " + numbers_text(each.renamed, plane) +
                        " }\n";
  if (!each.coupled) {
    const std::vector<std::string_view> names = harmonic
                                                    ? std::vector<std::string_view>{"k", "rest"}
                                                    : std::vector<std::string_view>{"a", "b"};
    named += std::string("thickness = { model = \"") +
             (harmonic ? "harmonic" : "reciprocal-quadratic") + "\", " +
             numbers_text(names, axial) + " }\n";
    written += std::string("thickness = { expression = \"") +
               (harmonic ? "k/2*(rho - rest)^2" : "a/rho + b/2*rho^2") + "\", " +
               numbers_text(names, axial) + " }\n";
  }
  return {make_case(CaseTree::parse(named + rest + more_named, "named")),
          make_case(CaseTree::parse(written + rest + more_written, "written out"))};
}

double spin_of(const Case& input) { return std::get<AxisRotation>(input.motion).nu; }

void expect_same(const Stretch& a, const Stretch& b, double relative, const std::string& what) {
  EXPECT_NEAR(a.xi, b.xi, relative * a.xi) << what;
  EXPECT_NEAR(a.zeta, b.zeta, relative * a.zeta) << what;
  EXPECT_NEAR(a.rho, b.rho, relative * a.rho) << what;
}

template <class F>
void over_models(std::uint64_t seed, const F& f) {
  support::Random random(seed);
  for (const WrittenOut& each : written_out_models())
    for (const std::string_view branch : {"i", "ii", "iii"}) f(each, branch, random);
}

TEST(WrittenOut, SameEquilibriaBoundsAndSpectra) {
  over_models(71, [](const WrittenOut& each, std::string_view branch, support::Random& random) {
    const Twice both = twice(each, random, branch);
    const std::string what = std::string(each.model) + ", branch " + std::string(branch);
    const Problem named = both.named.problem();
    const Problem written = both.written.problem();
    const double nu = spin_of(both.named);
    const Equilibrium a = solve(named, nu);
    const Equilibrium b = solve(written, nu);
    ASSERT_EQ(a.status, SolveStatus::solved) << what << a.message;
    ASSERT_EQ(b.status, SolveStatus::solved) << what << b.message;
    EXPECT_EQ(b.connection, Connection::rest) << what;
    EXPECT_LE(b.error_bound, 20.0 * a.error_bound) << what;
    expect_same(a.q, b.q, 0x1p-52, what);

    const auto modes = stability(named, a);
    const auto again = stability(written, b);
    EXPECT_EQ(name(modes.verdict), name(again.verdict)) << what;
    EXPECT_EQ(modes.negative, again.negative) << what;
    EXPECT_NEAR(modes.growth, again.growth, 1e-13 * (1.0 + modes.growth)) << what;
  });
}

TEST(WrittenOut, SameSolutionsAndProofs) {
  over_models(72, [](const WrittenOut& each, std::string_view branch, support::Random& random) {
    const Twice both = twice(each, random, branch);
    const std::string what = std::string(each.model) + ", branch " + std::string(branch);
    const Problem written = both.written.problem();
    const double nu = spin_of(both.named);
    const SearchResult a = search(both.named.problem(), nu);
    const SearchResult b = search(written, nu);
    EXPECT_EQ(a.status, SearchStatus::complete) << what << a.message;
    EXPECT_EQ(b.status, SearchStatus::complete) << what << b.message;
    ASSERT_EQ(a.solutions.size(), b.solutions.size()) << what;
    for (std::size_t k = 0; k < a.solutions.size(); ++k) {
      expect_same(a.solutions[k].q, b.solutions[k].q,
                  a.solutions[k].error_bound + b.solutions[k].error_bound, what);
      EXPECT_LE(b.solutions[k].error_bound, 1e-13) << what;
    }
    const Equilibrium solved = solve(written, nu);
    const Certificate proof = certify(written, solved);
    EXPECT_TRUE(proof.proven) << what << proof.reason;
    EXPECT_LE(proof.error_bound, 20.0 * solved.error_bound) << what;
  });
}

TEST(WrittenOut, SameSheetsAndEvents) {
  over_models(73, [](const WrittenOut& each, std::string_view branch, support::Random& random) {
    const Twice both = twice(each, random, branch);
    const std::string what = std::string(each.model) + ", branch " + std::string(branch);
    const auto events = [&](const Case& input) {
      const Problem problem = input.problem();
      FollowOptions options;
      options.continuation.from = 0.05;
      options.continuation.to = 0.6;
      options.continuation.step.tolerance = 1e-8;
      const Equilibrium start = solve(problem, 0.05);
      const AnyFamily family = axis_family(problem, {.nu = 0.05, .parameter = {}});
      return followed(family, start.q, 0.05, options);
    };
    const Followed a = events(both.named);
    const Followed b = events(both.written);
    EXPECT_EQ(a.text(), b.text()) << what;
    const auto found = a.events();
    const auto again = b.events();
    ASSERT_EQ(found.size(), again.size()) << what;
    for (std::size_t k = 0; k < found.size(); ++k)
      EXPECT_NEAR(found[k].member.parameter, again[k].member.parameter, 1e-11) << what;
    EXPECT_NEAR(a.rows.back().member.parameter, b.rows.back().member.parameter, 1e-9) << what;
  });
}

TEST(WrittenOut, SameFamilyInACoefficient) {
  support::Random random(74);
  for (const WrittenOut& each : written_out_models()) {
    const std::string slot = each.coupled ? "coupled" : "plane";
    const auto more = [&](const std::vector<std::string_view>& names) {
      return "[continuation]\nparameter = \"potential." + slot + "." + std::string(names[1]) +
             "\"\nfrom = 0.5\nto = 2.5\n";
    };
    const Twice both = twice(each, random, "i", more(each.parameters), more(each.renamed));
    const auto end = [](const Case& input) {
      const Problem problem = input.problem();
      const auto& continuation = *input.continuation;
      const double nu = spin_of(input);
      const FamilyParameter parameter = family_parameter(continuation.parameter, input.models);
      const double at =
          parameter_value({input.body, input.models, input.motion}, continuation.parameter);
      FollowOptions options;
      options.continuation.from = continuation.from;
      options.continuation.to = continuation.to;
      const AnyFamily family = axis_family(problem, {.nu = nu, .parameter = parameter});
      return followed(family, solve(problem, nu).q, at, options).rows.back().member;
    };
    const Member a = end(both.named);
    const Member b = end(both.written);
    EXPECT_EQ(a.parameter, b.parameter) << each.model;
    expect_same(a.q, b.q, 1e-14, std::string(each.model));
  }
}

}  // namespace
}  // namespace stationary::testing
