// Every two-polar motion, proven: against 25 digits by rates and by momenta, against Newton from
// random starts, circles, lines of solutions; certificates of single ones, and fakes they refuse.
#include "solver/search/two_polar_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "solver/newton/newton.hpp"
#include "solver/proof/two_polar_boxes.hpp"
#include "solver/proof/two_polar_enclosure.hpp"
#include "solver/solve/two_polar_equilibrium.hpp"
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

std::string text(const SearchResult& found) {
  std::ostringstream out;
  out.precision(12);
  out << found.message << " (" << found.boxes << " boxes)";
  for (const Equilibrium& each : found.solutions)
    out << "\n  " << diagonal(each.q).transpose() << (each.circle ? " circle" : "") << " +- "
        << each.error_bound;
  return out.str();
}

Body round_body(double J, double J3) { return {J, J, J3}; }

/// Is one of the solutions the row's, within its proven bound; and is each certified.
void expect_row(const ReferenceRow& row, const Body& body, const Potential& V,
                const TwoPolarMotion& motion) {
  const SearchResult found = search_two_polar(body, V, motion);
  ASSERT_EQ(found.status, SearchStatus::complete) << row.where() << text(found);
  const Real50 exact[] = {row.number<Real50>("lambda"), row.number<Real50>("mu"),
                          row.number<Real50>("rho")};
  int matching = 0;
  for (const Equilibrium& each : found.solutions) {
    double error = 0.0;
    for (int k = 0; k < 3; ++k)
      error = std::max(error, nearest(Real50(abs(Real50(diagonal(each.q)[k]) / exact[k] - 1))));
    const Certificate proof = certify_two_polar(body, V, motion, each);
    EXPECT_TRUE(proof.proven) << row.where() << proof.reason;
    EXPECT_EQ(proof.circle, each.circle) << row.where();
    EXPECT_LE(each.residual, 1e-14) << row.where();
    if (error > 1e-6) continue;
    ++matching;
    EXPECT_FALSE(each.circle);
    EXPECT_LE(error, each.error_bound) << row.where() << text(found);
    EXPECT_LE(error, proof.error_bound) << row.where() << text(found);
    const Spectrum modes = two_polar_stability(body, V, each);
    const SpectrumEnclosure proven = enclose_spectrum(body, V, motion, each, proof, modes);
    ASSERT_EQ(proven.modes, 4) << row.where();
    EXPECT_EQ(proven.verdict, modes.verdict) << row.where();
    EXPECT_EQ(proven.negative, modes.negative) << row.where();
    for (std::size_t k = 0; k < 4; ++k) {
      const auto re = row.number<Real50>("re" + std::to_string(k + 1));
      const auto im = row.number<Real50>("im" + std::to_string(k + 1));
      const double lambda = nearest(Real50(re * re - im * im));
      EXPECT_TRUE(proven.lambda[k].re.may_be(lambda)) << row.where() << " mode " << k + 1;
    }
  }
  EXPECT_EQ(matching, 1) << row.where() << text(found);
  EXPECT_LE(found.boxes, 600) << row.where() << text(found);
}

TEST(TwoPolarSearch, EveryRowOfTheTableByRates) {
  for (const ReferenceRow& row : support::reference_table("two_polar.csv")) {
    const auto value = [&](const char* column) { return row.number<double>(column); };
    expect_row(row, round_body(value("J"), value("J3")),
               make_potential(row.text("model"), {value("v1"), value("v2")}, "reciprocal-quadratic",
                              {value("a"), value("b")}),
               TwoPolarRates<double>{value("omega"), value("theta_dot")});
  }
}

/// What the rates have, their momenta have: the same ellipse is found, and none that Newton misses.
TEST(TwoPolarSearch, TheMomentaOfAnEllipseLeadToIt) {
  for (const ReferenceRow& row : support::reference_table("two_polar.csv")) {
    const auto value = [&](const char* column) { return row.number<double>(column); };
    const Body body = round_body(value("J"), value("J3"));
    const Potential V = make_potential(row.text("model"), {value("v1"), value("v2")},
                                       "reciprocal-quadratic", {value("a"), value("b")});
    const Vector3<double> x{value("lambda"), value("mu"), value("rho")};
    const TwoPolarMomenta<double> momenta =
        two_polar_momenta(body.J1, x, value("omega"), value("theta_dot"));
    const SearchResult found = search_two_polar(body, V, momenta);
    ASSERT_EQ(found.status, SearchStatus::complete) << row.where() << text(found);
    const auto same = std::ranges::count_if(found.solutions, [&](const auto& each) {
      return (diagonal(each.q) - x).cwiseAbs().maxCoeff() < 1e-12 * x.maxCoeff();
    });
    EXPECT_EQ(same, 1) << row.where() << text(found);
    for (const Equilibrium& each : found.solutions) {
      EXPECT_FALSE(each.circle);
      EXPECT_LE(each.residual, 1e-13) << row.where() << text(found);
      const Certificate proof = certify_two_polar(body, V, momenta, each);
      ASSERT_TRUE(proof.proven) << row.where() << proof.reason;
      const Spectrum modes = two_polar_stability(body, V, each);
      EXPECT_EQ(enclose_spectrum(body, V, momenta, each, proof, modes).verdict, modes.verdict);
    }
    EXPECT_LE(found.boxes, 4000) << row.where() << text(found);
  }
}

/// Newton on the balance from random starts, by rates and by momenta, finds nothing that is neither
/// in the list nor in an undecided box, a solution and its mirror image being one.
TEST(TwoPolarSearch, NewtonFindsNothingMore) {
  Random random(733);
  long hits = 0;
  long proven = 0;
  long undecided = 0;
  constexpr int cases = 80;
  for (int k = 0; k < cases; ++k) {
    const Posed posed = random_problem(random, 1.0);
    const Potential& V = posed.problem.potential();
    const Body body = round_body(posed.problem.body().J1, posed.problem.body().J3);
    const double omega = posed.nu;
    const double theta_dot = posed.nu * random.uniform(-0.9, 0.9);
    TwoPolarMotion motion = TwoPolarRates<double>{omega, theta_dot};
    if (k % 2 == 1)
      motion =
          two_polar_momenta(body.J1, {random.log_uniform(1.0, 3.0), 1.0, 1.0}, omega, theta_dot);
    const SearchResult found = search_two_polar(body, V, motion);
    undecided += found.status != SearchStatus::complete;
    proven += static_cast<long>(found.solutions.size());
    const auto listed = [&](double lambda, double mu) {
      return std::ranges::any_of(found.solutions,
                                 [&](const Equilibrium& each) {
                                   return std::abs(each.q.xi / lambda - 1.0) < 1e-8 &&
                                          std::abs(each.q.zeta / mu - 1.0) < 1e-8;
                                 }) ||
             std::ranges::any_of(found.undecided, [&](const StretchBox& box) {
               return box.xi.may_be(lambda) && box.zeta.may_be(mu);
             });
    };
    V.visit_parts([&](const auto& model) {
      visit_motion(motion, [&]<template <class> class Motion>(const Motion<double>& own) {
        const TwoPolarSystem<decltype(elastic_system(model)), Motion> system{elastic_system(model),
                                                                             body.J1, own};
        constexpr int N = decltype(system)::dimension;
        for (int start = 0; start < 60; ++start) {
          ReducedVector<N> x;
          for (int i = 0; i < N; ++i) x[i] = random.log_uniform(1e-3, 1e3);
          if (!newton(system, x).converged || !refine<false>(system, x).converged) continue;
          if (!(x.minCoeff() > 1.001e-3 && x.maxCoeff() < 999.0)) continue;
          ++hits;
          EXPECT_TRUE(listed(std::max(x[0], x[1]), std::min(x[0], x[1])))
              << posed.text << " theta_dot " << theta_dot << " momenta " << k % 2 << ": "
              << x.transpose() << "\n"
              << text(found);
        }
      });
    });
  }
  EXPECT_GT(proven, cases / 2);
  EXPECT_GT(hits, 500);
  EXPECT_LE(undecided, cases / 20);
}

TEST(TwoPolarSearch, ACircleByRatesAndByItsMomenta) {
  const Body body = round_body(1.0, 0.6);
  const Potential V = make_potential("biot-log", {1.0, 1.0});
  const TwoPolarMotion rates = TwoPolarRates<double>{0.3, 0.1};
  const SearchResult by_rates = search_two_polar(body, V, rates);
  ASSERT_EQ(by_rates.status, SearchStatus::complete) << text(by_rates);
  ASSERT_EQ(by_rates.solutions.size(), 1U) << text(by_rates);
  const Equilibrium& circle = by_rates.solutions[0];
  EXPECT_TRUE(circle.circle);
  EXPECT_EQ(circle.q.xi, circle.q.zeta);
  // Its momenta are equal but for rounding.
  const TwoPolarMotion momenta =
      TwoPolarMomenta<double>{circle.two_polar->momenta.s3, circle.two_polar->momenta.s3};
  const SearchResult by_momenta = search_two_polar(body, V, momenta);
  ASSERT_EQ(by_momenta.status, SearchStatus::complete) << text(by_momenta);
  ASSERT_GE(by_momenta.solutions.size(), 1U) << text(by_momenta);
  const Equilibrium& again = by_momenta.solutions.back();
  EXPECT_TRUE(again.circle);
  EXPECT_NEAR(again.q.xi, circle.q.xi, 1e-14);
  EXPECT_NEAR(again.two_polar->rates.omega + again.two_polar->rates.theta_dot, 0.4, 1e-14);
  EXPECT_LE(again.residual, 1e-14);
  for (const auto& [motion, at] : {std::pair{rates, circle}, {momenta, again}}) {
    const Certificate proof = certify_two_polar(body, V, motion, at);
    ASSERT_TRUE(proof.proven) << proof.reason;
    EXPECT_TRUE(proof.circle);
    const Spectrum modes = two_polar_stability(body, V, at);
    EXPECT_EQ(enclose_spectrum(body, V, motion, at, proof, modes).verdict, modes.verdict);
  }
  // The single solve returns the circle of given momenta too, and says that it is one.
  const Equilibrium solved = solve_two_polar(body, V, momenta);
  ASSERT_EQ(solved.status, SolveStatus::solved) << solved.message;
  EXPECT_TRUE(solved.circle);
  EXPECT_NE(solved.message.find("circle"), std::string::npos);
  EXPECT_LE((diagonal(solved.q) - diagonal(again.q)).cwiseAbs().maxCoeff(), 1e-15);
  // s3 = -p_theta is no circle's: there lambda^2 + mu^2 = -2 lambda mu would be asked for.
  const SearchResult none = search_two_polar(
      body, V,
      TwoPolarMomenta<double>{circle.two_polar->momenta.s3, -circle.two_polar->momenta.s3});
  EXPECT_EQ(none.status, SearchStatus::complete) << text(none);
  for (const Equilibrium& each : none.solutions) EXPECT_GT(each.q.xi, each.q.zeta);
}

/// lambda != mu has a whole line of solutions there, and none beside it.
TEST(TwoPolarSearch, LinesAreSaidByNameAndBesideThemThereIsTheCircle) {
  const Body body = round_body(1.0, 0.6);
  const TwoPolarRates<double> unit{1.0, 0.0};
  const TwoPolarRates<double> slip{1.5, -0.5};
  for (const auto& [V, rates] :
       {std::pair{make_potential("reciprocal-determinant", {1.0, 1.0}), unit},
        std::pair{make_potential("neo-hookean", {1.0, 2.0}), unit},
        std::pair{make_potential("biot", {2.0, 1.0}), slip}}) {
    const SearchResult line = search_two_polar(body, V, rates);
    EXPECT_TRUE(line.on_line);
    EXPECT_EQ(line.status, SearchStatus::undecided);
    EXPECT_TRUE(line.solutions.empty());
    EXPECT_NE(line.message.find("form a line"), std::string::npos) << line.message;
    const TwoPolarRates<double> beside{0.97 * rates.omega, 0.97 * rates.theta_dot};
    const SearchResult off = search_two_polar(body, V, beside);
    EXPECT_EQ(off.status, SearchStatus::complete) << text(off);
    for (const Equilibrium& each : off.solutions) EXPECT_TRUE(each.circle) << text(off);
    // By momenta an ellipse of the line is isolated.
    const TwoPolarMomenta<double> momenta =
        two_polar_momenta(1.0, Vector3<double>{1.5, 0.8, 1.0}, rates.omega, rates.theta_dot);
    const SearchResult isolated = search_two_polar(body, V, momenta);
    EXPECT_EQ(isolated.status, SearchStatus::complete) << text(isolated);
    EXPECT_EQ(isolated.solutions.size(), 1U) << text(isolated);
  }
}

TEST(TwoPolarCertificate, FakesAreRefused) {
  const Body body = round_body(0.8, 2.3);
  const Potential V =
      make_potential("saint-venant-kirchhoff", {0.9, 2.1}, "reciprocal-quadratic", {1.1, 1.5});
  const TwoPolarRates<double> rates{1.2, -0.35};
  const Equilibrium exact = solve_two_polar(body, V, rates);
  ASSERT_EQ(exact.status, SolveStatus::solved) << exact.message;
  for (const TwoPolarMotion& motion :
       {TwoPolarMotion(rates), TwoPolarMotion(exact.two_polar->momenta)}) {
    ASSERT_TRUE(certify_two_polar(body, V, motion, exact).proven);
    const auto refused = [&](const Equilibrium& fake) {
      const Certificate proof = certify_two_polar(body, V, motion, fake);
      EXPECT_FALSE(proof.proven);
      EXPECT_FALSE(proof.reason.empty());
      EXPECT_TRUE(std::isnan(proof.error_bound));
    };
    for (int k = 0; k < 3; ++k) {
      for (const double factor : {1.0 + 1e-9, 1.0 - 1e-9, -1.0, std::nan("")}) {
        Equilibrium fake = exact;
        (k == 0 ? fake.q.xi : k == 1 ? fake.q.zeta : fake.q.rho) *= factor;
        refused(fake);
      }
    }
    Equilibrium fake = exact;
    fake.circle = true;
    refused(fake);
    fake = exact;
    fake.two_polar->rates.omega *= 1.0 + 1e-9;
    fake.two_polar->momenta.s3 *= 1.0 + 1e-9;
    refused(fake);
    fake = exact;
    std::swap(fake.q.xi, fake.q.zeta);
    refused(fake);
  }
}

/// Blocks of values serve their motions, and each has what its own search finds: across circles that turn
/// into ellipses, equal momenta and lines of solutions too.
TEST(TwoPolarSearches, HaveWhatEachSearchHas) {
  const Body body = round_body(0.8, 2.3);
  const double whole[] = {1.0, 2.0};
  const std::pair<const char*, Potential> potentials[] = {
      {"saint-venant-kirchhoff", make_potential("saint-venant-kirchhoff", {0.9, 2.1})},
      {"hencky", make_potential("hencky", {0.9, 2.1})},
      {"biot", make_potential("biot", {1.0, 0.5})},
      {"neo-hookean-3d", Potential(Potential::coupled("neo-hookean-3d", whole))}};
  struct Row {
    TwoPolarMotion motion;
    int number;
    double from, to;
  };
  const Row rows[] = {{TwoPolarRates<double>{1.2, 0.0}, 1, -0.7, -0.05},
                      {TwoPolarRates<double>{0.0, -0.5}, 0, 0.7, 1.5},
                      {TwoPolarMomenta<double>{0.5, 0.0}, 1, -1.0, 1.0},
                      {TwoPolarMomenta<double>{0.0, -0.7}, 0, 0.2, 2.2}};
  long alone_boxes = 0;
  long together_boxes = 0;
  long shared = 0;
  long compared = 0;
  for (const auto& [label, V] : potentials)
    for (const Row& row : rows) {
      std::vector<double> values;
      for (int k = 0; k <= 80; ++k) values.push_back(row.from + (row.to - row.from) * k / 80.0);
      const NumberRange range{.values = values, .number = row.number};
      const SearchOptions options;
      TwoPolarSearches searches(body, V, row.motion, range, options);
      for (std::size_t k = 0; k < values.size(); ++k) {
        const TwoPolarMotion motion = searches.motion_at(values[k]);
        const SearchResult own = search_two_polar(body, V, motion);
        const SearchResult of_block = searches.at(values[k]);
        const std::string where = std::string(label) + " at " + std::to_string(values[k]);
        ASSERT_EQ(of_block.status, own.status) << where << text(own) << text(of_block);
        ASSERT_EQ(of_block.solutions.size(), own.solutions.size()) << where << text(own);
        for (std::size_t i = 0; i < own.solutions.size(); ++i) {
          EXPECT_EQ(of_block.solutions[i].q.xi, own.solutions[i].q.xi) << where;
          EXPECT_EQ(of_block.solutions[i].q.zeta, own.solutions[i].q.zeta) << where;
          EXPECT_EQ(of_block.solutions[i].q.rho, own.solutions[i].q.rho) << where;
          EXPECT_EQ(of_block.solutions[i].circle, own.solutions[i].circle) << where;
          EXPECT_EQ(of_block.solutions[i].error_bound, own.solutions[i].error_bound) << where;
          ++compared;
        }
        alone_boxes += own.boxes;
      }
      shared += searches.shared();
      together_boxes += searches.boxes();
      // Whatever was asked for before.
      TwoPolarSearches anew(body, V, row.motion, range, options);
      const SearchResult last = anew.at(values[77]);
      const SearchResult again = searches.at(values[77]);
      ASSERT_EQ(last.solutions.size(), again.solutions.size());
      EXPECT_EQ(last.boxes, again.boxes);
    }
  EXPECT_GE(compared, 1200);
  EXPECT_GE(shared, 900);
  EXPECT_LE(10 * together_boxes, 8 * alone_boxes);
}

TEST(TwoPolarSearches, MisuseAndInterruption) {
  const Potential V = make_potential("biot-log", {1.0, 1.0});
  const double values[] = {1.0, 1.1, 1.2};
  const TwoPolarRates<double> rates{1.1, -0.3};
  const SearchOptions plain;
  EXPECT_THROW(TwoPolarSearches(Body(1.0, 1.1, 1.0), V, rates, {.values = values}, plain),
               std::invalid_argument);
  const std::atomic<bool> stop = true;
  const SearchOptions stopped{.stop = &stop};
  const Body body = round_body(1.0, 1.0);
  TwoPolarSearches searches(body, V, rates, {.values = values}, stopped);
  EXPECT_EQ(searches.at(1.1).status, SearchStatus::interrupted);
  // A value that is none of the range has a search of its own.
  TwoPolarSearches others(body, V, rates, {.values = values}, plain);
  EXPECT_EQ(others.at(1.05).status, SearchStatus::complete);
  EXPECT_THROW((void)others.at(std::nan("")), std::invalid_argument);
  EXPECT_EQ(others.shared(), 0);
}

TEST(TwoPolarSearch, MisuseAndInterruption) {
  const Potential V = make_potential("biot-log", {1.0, 1.0});
  const TwoPolarRates<double> rates{1.1, -0.3};
  EXPECT_THROW(search_two_polar(Body(1.0, 1.1, 1.0), V, rates), std::invalid_argument);
  EXPECT_THROW(search_two_polar(round_body(1.0, 1.0), V, TwoPolarRates<double>{std::nan(""), 0.0}),
               std::invalid_argument);
  SearchOptions options;
  options.min_stretch = 2e3;
  EXPECT_THROW(search_two_polar(round_body(1.0, 1.0), V, rates, options), std::invalid_argument);
  const std::atomic<bool> stop = true;
  EXPECT_EQ(search_two_polar(round_body(1.0, 1.0), V, rates, {.stop = &stop}).status,
            SearchStatus::interrupted);
}

}  // namespace
}  // namespace stationary
