// Every tilted motion, proven: against 25 digits, against Newton from random starts, where there is
// none, and beside the ends of a family; certificates of single ones, and fakes they refuse.
#include "solver/search/tilted_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "lib/balance/tilted_balance.hpp"
#include "solver/motion/tilted_system.hpp"
#include "solver/newton/newton.hpp"
#include "solver/proof/tilted_enclosure.hpp"
#include "solver/solve/tilted_equilibrium.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/numbers/high_precision.hpp"
#include "tests/support/reference_table.hpp"

namespace stationary {
namespace {

using namespace testing;
using support::Random;
using support::Real50;
using support::ReferenceRow;

std::string text(const SearchResult& found) {
  std::ostringstream out;
  out.precision(12);
  out << found.message << " (" << found.boxes << " boxes)";
  for (const Equilibrium& each : found.solutions)
    out << "\n  " << each.q.xi << " " << each.q.zeta << " " << each.q.rho << " nu "
        << each.nu.transpose() << " +- " << each.error_bound;
  return out.str();
}

const Body disc(1.0, 1.7, 0.6);
const Potential& disc_potential() {
  static const Potential potential = make_potential("reciprocal-determinant", {1.0, 2.0});
  return potential;
}

TEST(TiltedSearch, EveryRowOfTheTable) {
  for (const ReferenceRow& row : support::reference_table("tilted.csv")) {
    const auto nu = row.nu<Real50>();
    const auto exact = row.stretch<Real50>();
    const TiltedRotation motion{TiltPlane::one_three,
                                double(Real50(sqrt(nu[0] * nu[0] + nu[2] * nu[2])))};
    const SearchResult found = search_tilted(row.body(), row.potential(), motion);
    ASSERT_EQ(found.status, SearchStatus::complete) << row.where() << text(found);
    int matching = 0;
    for (const Equilibrium& each : found.solutions) {
      const double error = relative_error(each.q, {exact.xi, exact.zeta, exact.rho});
      EXPECT_TRUE(error <= each.error_bound || error > 1e-6) << row.where() << text(found);
      if (error > each.error_bound) continue;
      ++matching;
      EXPECT_LE(each.error_bound, 1e-13) << row.where();
      EXPECT_NEAR(each.nu[0], double(nu[0]), 1e-13) << row.where();
      EXPECT_NEAR(each.nu[2], double(nu[2]), 1e-13) << row.where();
      const Certificate proof = certify_tilted(row.body(), row.potential(), motion, each);
      EXPECT_TRUE(proof.proven) << row.where() << proof.reason;
      EXPECT_LE(error, proof.error_bound) << row.where();
      const auto modes = tilted_stability(row.body(), row.potential(), motion, each);
      ASSERT_TRUE(modes);
      const SpectrumEnclosure proven =
          enclose_spectrum(row.body(), row.potential(), motion, proof, *modes);
      ASSERT_EQ(proven.modes, 5);
      EXPECT_EQ(proven.verdict, modes->verdict) << row.where();
      EXPECT_EQ(proven.negative, modes->negative) << row.where();
      for (std::size_t k = 0; k < 5; ++k) {
        const auto re = row.number<Real50>("re" + std::to_string(k + 1));
        const auto im = row.number<Real50>("im" + std::to_string(k + 1));
        const double lambda = double(Real50(re * re - im * im));
        EXPECT_TRUE(proven.lambda[k].re.may_be(lambda)) << row.where() << " mode " << k + 1;
        EXPECT_LE(proven.lambda[k].re.width(), 1e-8) << row.where() << " mode " << k + 1;
      }
    }
    EXPECT_EQ(matching, 1) << row.where() << text(found);
    EXPECT_LE(found.boxes, 200) << row.where() << text(found);
  }
}

/// The 2-3 plane of a body is the 1-3 plane of the body with axes 1 and 2 exchanged.
TEST(TiltedSearch, ExchangedAxesExchangeThePlanes) {
  const Body exchanged(disc.J2, disc.J1, disc.J3);
  const SearchResult one = search_tilted(disc, disc_potential(), {TiltPlane::one_three, 1.07});
  const SearchResult other =
      search_tilted(exchanged, disc_potential(), {TiltPlane::two_three, 1.07});
  ASSERT_EQ(one.solutions.size(), 1U) << text(one);
  ASSERT_EQ(other.solutions.size(), 1U) << text(other);
  const Equilibrium& a = one.solutions[0];
  const Equilibrium& b = other.solutions[0];
  EXPECT_EQ(a.q.xi, b.q.zeta);
  EXPECT_EQ(a.q.zeta, b.q.xi);
  EXPECT_EQ(a.q.rho, b.q.rho);
  EXPECT_EQ(a.nu[0], b.nu[1]);
  EXPECT_EQ(a.nu[2], b.nu[2]);
  EXPECT_EQ(b.nu[0], 0.0);
}

/// The family of cases/tilted.toml lies between |nu| = 1.05486... and 1.08359....
TEST(TiltedSearch, NoneBeyondTheFamilysEnds) {
  for (const double nu : {0.3, 1.05, 1.0548, 1.0836, 1.2, 3.0}) {
    const SearchResult found = search_tilted(disc, disc_potential(), {TiltPlane::one_three, nu});
    EXPECT_EQ(found.status, SearchStatus::complete) << nu << text(found);
    EXPECT_TRUE(found.solutions.empty()) << nu << text(found);
    EXPECT_NE(found.message.find("proven that there is none"), std::string::npos);
  }
  for (const double nu : {1.0549, 1.07, 1.0835}) {
    const SearchResult found = search_tilted(disc, disc_potential(), {TiltPlane::one_three, nu});
    EXPECT_EQ(found.status, SearchStatus::complete) << nu << text(found);
    EXPECT_EQ(found.solutions.size(), 1U) << nu << text(found);
  }
}

TEST(TiltedSearch, OnlyWhatIsInTheBox) {
  const TiltedRotation motion{TiltPlane::one_three, 1.07};  // rho = 0.7366, zeta = 3.196
  SearchOptions options;
  options.max_stretch = 3.0;
  EXPECT_TRUE(search_tilted(disc, disc_potential(), motion, options).solutions.empty());
  // xi = 0.5705 lies in the box, and rho must.
  options.max_stretch = 1e3;
  options.min_stretch = 0.56;
  EXPECT_EQ(search_tilted(disc, disc_potential(), motion, options).solutions.size(), 1U);
  const Body exchanged(disc.J2, disc.J1, disc.J3);
  options.min_stretch = 0.58;
  EXPECT_TRUE(search_tilted(exchanged, disc_potential(), {TiltPlane::two_three, 1.07}, options)
                  .solutions.empty());
  // A body with J3 > J1 has rho < xi.
  const ReferenceRow row = support::reference_table("tilted.csv").front();
  const TiltedRotation thin{TiltPlane::one_three, row.nu<double>().norm()};
  options.min_stretch = 0.7;
  EXPECT_EQ(search_tilted(row.body(), row.potential(), thin, options).solutions.size(), 1U);
  options.min_stretch = 0.72;  // between rho = 0.711 and xi = 0.838
  EXPECT_TRUE(search_tilted(row.body(), row.potential(), thin, options).solutions.empty());
}

/// The same body, its volume held.
Potential with_volume(const Potential& elastic, double volume) {
  BodyModel<> out;
  if (elastic.is_separable()) {
    out.elastic.plane = AnyPlane<>{elastic.plane()};
    out.elastic.thickness = AnyThickness<>{elastic.thickness()};
  } else {
    std::visit([&](const auto& each) { out.elastic.coupled = each; }, elastic.coupled());
  }
  out.volume = volume;
  return Potential(out);
}

/// In either plane, the enclosures hold what the structure-preserving method computes, within its
/// own error bound; and the class, where both claim one, is the same. Of held volumes too.
TEST(TiltedSearch, SpectraAreEnclosed) {
  Random random(737);
  int claimed[2] = {0, 0};
  int motions[2] = {0, 0};
  for (int k = 0; k < 400; ++k) {
    const Posed posed = random_problem(random, 1.0);
    const Body& body = posed.problem.body();
    const bool held = k % 4 >= 2;
    const Potential potential =
        held ? with_volume(posed.problem.potential(), 0.8 + 0.001 * k) : posed.problem.potential();
    const TiltedRotation motion{k % 2 == 0 ? TiltPlane::one_three : TiltPlane::two_three,
                                std::abs(posed.nu)};
    for (const Equilibrium& each : search_tilted(body, potential, motion).solutions) {
      const Certificate proof = certify_tilted(body, potential, motion, each);
      ASSERT_TRUE(proof.proven) << posed.text << proof.reason;
      const auto modes = tilted_stability(body, potential, motion, each);
      ASSERT_TRUE(modes) << posed.text;
      const SpectrumEnclosure proven = enclose_spectrum(body, potential, motion, proof, *modes);
      ++motions[held];
      ASSERT_EQ(proven.modes, held ? 4 : 5) << posed.text;
      ASSERT_EQ(proven.modes, modes->modes) << posed.text;
      for (std::size_t m = 0; m < static_cast<std::size_t>(proven.modes); ++m) {
        const Mode& mode = modes->mode[m];
        const Interval near(mode.lambda_re - mode.lambda_error, mode.lambda_re + mode.lambda_error);
        EXPECT_FALSE(near.apart_from(proven.lambda[m].re)) << posed.text << " mode " << m;
      }
      if (!proven.verdict || modes->verdict == StabilityClass::marginal) continue;
      ++claimed[held];
      EXPECT_EQ(*proven.verdict, modes->verdict) << posed.text;
    }
  }
  for (const bool held : {false, true}) {
    EXPECT_GT(motions[held], 15) << held;
    EXPECT_GT(claimed[held], motions[held] / 2) << held;
  }
}

template <class Model>
std::optional<ReducedVector<2>> newton_from(const TiltedSystem<Model>& system, ReducedVector<2> x) {
  const bool done = newton(system, x).converged && refine<false>(system, x).converged;
  return done ? std::optional(x) : std::nullopt;
}

/// Random families: all that Newton finds from random starts is in the list or in an undecided box.
TEST(TiltedSearch, NewtonFindsNothingMore) {
  Random random(731);
  long hits = 0;
  long proven = 0;
  long undecided = 0;
  constexpr int cases = 120;
  for (int k = 0; k < cases; ++k) {
    const Posed posed = random_problem(random, 1.0);
    const Body& body = posed.problem.body();
    const Potential& potential = posed.problem.potential();
    const TiltedRotation motion{
        random.integer(0, 1) == 0 ? TiltPlane::one_three : TiltPlane::two_three,
        std::abs(posed.nu)};
    const SearchResult found = search_tilted(body, potential, motion);
    undecided += found.status != SearchStatus::complete;
    proven += static_cast<long>(found.solutions.size());
    for (const Equilibrium& each : found.solutions) {
      EXPECT_LE(each.residual, 1e-13) << posed.text;
      EXPECT_LE(each.compatibility, 1e-14) << posed.text;
      EXPECT_NEAR(each.nu.norm(), motion.nu, 1e-12 * motion.nu) << posed.text;
    }
    potential.visit_parts([&](const auto& model) {
      using Model = std::decay_t<decltype(model)>;
      const TiltedSystem<Model> system{
          model, body, motion.plane,
          axis_rates(body, Branch::iii, two_product(motion.nu, motion.nu))};
      for (int start = 0; start < 60; ++start) {
        const auto x =
            newton_from(system, {random.log_uniform(1e-3, 1e3), random.log_uniform(1e-3, 1e3)});
        if (!x) continue;
        const double rho = tilted_thickness(body, motion.plane, (*x)[0], (*x)[1]);
        if (std::min(x->minCoeff(), rho) < 1.001e-3 || std::max(x->maxCoeff(), rho) > 999.0)
          continue;
        const auto w = model.template evaluate<1>(planar_invariants((*x)[0], (*x)[1]), rho);
        const auto squares = tilt_squares(
            body, motion.plane,
            coupled_log_balance<1>(w, (*x)[0], (*x)[1], rho, CentrifugalRates<double>{0, 0, 0}),
            (*x)[0], (*x)[1], rho);
        const double margin = 1e-9 * motion.nu * motion.nu;
        const bool motion_there = squares.in_plane > margin && squares.normal > margin;
        hits += motion_there;
        const bool listed = std::ranges::any_of(found.solutions, [&](const Equilibrium& each) {
          return std::abs(each.q.xi / (*x)[0] - 1.0) < 1e-9 &&
                 std::abs(each.q.zeta / (*x)[1] - 1.0) < 1e-9;
        });
        const bool left = std::ranges::any_of(found.undecided, [&](const StretchBox& box) {
          return box.xi.may_be((*x)[0]) && box.zeta.may_be((*x)[1]);
        });
        EXPECT_TRUE(!motion_there || listed || left) << posed.text << text(found);
        EXPECT_TRUE(std::min(squares.in_plane, squares.normal) > -margin || !listed)
            << posed.text << text(found);
      }
    });
  }
  EXPECT_GT(proven, cases / 20);
  EXPECT_GT(hits, 200);
  EXPECT_LE(undecided, cases / 50);
}

class TiltedCertificate : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(found_.status, SolveStatus::solved) << found_.message; }
  Certificate certificate() const {
    return certify_tilted(disc, disc_potential(), motion_, found_);
  }
  const TiltedRotation motion_{TiltPlane::one_three, 1.07};
  Equilibrium found_ = solve_tilted(disc, disc_potential(), motion_);
};

TEST_F(TiltedCertificate, OfASolvedMotion) {
  const Certificate proof = certificate();
  ASSERT_TRUE(proof.proven) << proof.reason;
  EXPECT_LE(proof.error_bound, 1e-13);
  EXPECT_TRUE(proof.solution.xi.within(proof.unique.xi));
  EXPECT_TRUE(proof.solution.rho.within(proof.unique.rho));
  EXPECT_FALSE(proof.circle);
}

TEST_F(TiltedCertificate, FakesAreRefused) {
  const Equilibrium exact = found_;
  const auto refused = [&](const char* why) {
    const Certificate proof = certificate();
    EXPECT_FALSE(proof.proven) << why;
    EXPECT_FALSE(proof.reason.empty()) << why;
    EXPECT_TRUE(std::isnan(proof.error_bound)) << why;
    found_ = exact;
  };
  for (double* number :
       {&found_.q.xi, &found_.q.zeta, &found_.q.rho, &found_.nu[0], &found_.nu[2]}) {
    for (const double factor : {1.0 + 1e-9, 1.0 - 1e-9}) {
      *number *= factor;
      refused("one number off by 1e-9");
    }
  }
  found_.q.alpha = 1e-9;
  refused("alpha");
  found_.nu[1] = 1e-9;
  refused("nu2");
  found_.nu[2] = std::nan("");
  refused("NaN");
  found_.q.rho = -found_.q.rho;
  refused("rho < 0");
}

TEST_F(TiltedCertificate, NotWhereTheAxisIsAMaterialOne) {
  // Beside the family's end on branch (i), closer than rounding: nu3^2 has no proven sign.
  const auto family = tilted_family(disc, disc_potential(), TiltPlane::one_three, false);
  double inside = 1.07;
  double outside = 1.05;
  ReducedVector<2> x(found_.q.xi, found_.q.zeta);
  ReducedVector<2> tail;
  Equilibrium last;
  while (inside - outside > 1e-15) {
    const double nu = 0.5 * (inside + outside);
    if (nu == inside || nu == outside) break;
    ReducedVector<2> y = x;
    const Refined refined = family->refine_at(y, tail, nu);
    ASSERT_TRUE(refined.converged);
    const Member member = family->member(y, tail, nu, refined.error_bound);
    if (member.tilt_normal > 0.0) {
      inside = nu;
      x = y;
    } else {
      outside = nu;
      last.q = member.q;
      last.nu = {nu, 0.0, 0.0};
    }
  }
  const TiltedRotation motion{TiltPlane::one_three, outside};
  EXPECT_FALSE(certify_tilted(disc, disc_potential(), motion, last).proven);
  const SearchResult found = search_tilted(disc, disc_potential(), motion);
  EXPECT_EQ(found.status, SearchStatus::undecided) << text(found);
  EXPECT_TRUE(found.solutions.empty()) << text(found);
  EXPECT_NE(found.message.find("material one"), std::string::npos) << found.message;
}

TEST(TiltedSearch, MisuseAndInterruption) {
  for (const double nu : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(search_tilted(disc, disc_potential(), {TiltPlane::one_three, nu}),
                 std::invalid_argument);
  SearchOptions options;
  options.max_stretch = 1e-4;
  EXPECT_THROW(search_tilted(disc, disc_potential(), {TiltPlane::one_three, 1.0}, options),
               std::invalid_argument);
  const std::atomic<bool> stop = true;
  EXPECT_EQ(
      search_tilted(disc, disc_potential(), {TiltPlane::one_three, 1.07}, {.stop = &stop}).status,
      SearchStatus::interrupted);
}

}  // namespace
}  // namespace stationary
