// Every motion of an anisotropic body at one nu, against multistart Newton, and certificates.
#include "solver/search/anisotropic_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/proof/anisotropic_enclosure.hpp"
#include "tests/support/bodies/anisotropic_motions.hpp"

namespace stationary {
namespace {

using namespace testing;

bool same(const Equilibrium& a, const Equilibrium& b) {
  const double scale = std::sqrt(b.q.xi * b.q.zeta);
  return std::abs(a.q.xi / b.q.xi - 1.0) < 1e-9 && std::abs(a.q.zeta / b.q.zeta - 1.0) < 1e-9 &&
         std::abs(a.q.alpha - b.q.alpha) < 1e-9 * scale &&
         std::abs(std::abs(a.nu.dot(b.nu)) / b.nu.squaredNorm() - 1.0) < 1e-9;
}

/// Those Newton comes to from random starts, each once.
template <class Solve>
std::vector<Equilibrium> multistart(support::Random& random, int starts, const Solve& solve_from) {
  std::vector<Equilibrium> out;
  for (int k = 0; k < starts; ++k) {
    Equilibrium found = solve_from(random.stretch(3.0));
    if (found.status != SolveStatus::solved) continue;
    bool known = false;
    for (const Equilibrium& other : out) known = known || same(found, other);
    if (!known) out.push_back(std::move(found));
  }
  return out;
}

bool in_box(const Equilibrium& at) {
  return std::min({at.q.xi, at.q.zeta, at.q.rho}) > 1e-3 &&
         std::max({at.q.xi, at.q.zeta, at.q.rho}) < 1e3;
}

TEST(AnisotropicSearch, FindsWhatMultistartFinds) {
  support::Random random(431);
  int compared = 0;
  for (int k = 0; k < 10; ++k) {
    const OrientedBody at = random_oriented_body(random, k);
    SearchOptions how;
    how.max_boxes = 1000;  // kept light: what stays undecided says so
    for (const bool oblique : {false, true}) {
      const SearchResult all = oblique ? search_oblique(at.body, at.potential(), {at.nu}, how)
                                       : search(at.problem(Branch::iii), at.nu, how);
      const auto found = multistart(random, 25, [&](const Stretch& start) {
        return oblique ? solve_oblique(at.body, at.potential(), {at.nu}, without_search(start))
                       : solve(at.problem(Branch::iii), at.nu, without_search(start));
      });
      for (const Equilibrium& each : all.solutions) {
        EXPECT_LE(each.residual, 1e-13) << at.text;
        EXPECT_LE(each.error_bound, 1e-9) << at.text;
      }
      if (all.status != SearchStatus::complete) continue;
      ++compared;
      for (const Equilibrium& each : found) {
        // About a material axis it is no oblique motion.
        if (!in_box(each) || (oblique && std::abs(each.nu[0] * each.nu[1]) < 1e-12)) continue;
        bool listed = false;
        for (const Equilibrium& other : all.solutions) listed = listed || same(each, other);
        EXPECT_TRUE(listed) << at.text << ", xi " << each.q.xi << " zeta " << each.q.zeta;
      }
    }
  }
  EXPECT_GE(compared, 8);
}

TEST(AnisotropicSearch, TheMotionsFromRestAreAmongThem) {
  const Body disc(1.0, 1.7, 0.6);
  const Potential V = fibred(NeoHookean<>{1.0, 2.0}, 0.4, 30.0);
  const SearchResult all = search_oblique(disc, V, {0.3}, {});
  ASSERT_EQ(all.status, SearchStatus::complete) << all.message;
  EXPECT_EQ(all.solutions.size(), 2U);
  for (const Branch near : {Branch::i, Branch::ii}) {
    const Equilibrium from_rest = solve_oblique(disc, V, {0.3, near});
    bool listed = false;
    for (const Equilibrium& each : all.solutions) listed = listed || same(each, from_rest);
    EXPECT_TRUE(listed);
  }
}

/// Where a long thin S across the fibre is in balance but for a few hundredths of its forces: what
/// the principal forces exclude no row does, and some forty times the boxes would be needed.
TEST(AnisotropicSearch, ValleysAcrossAFibreTakeFewBoxes) {
  const Body disc(1.0, 1.7, 0.6);
  const Potential V = fibred(NeoHookean<>{1.0, 2.0}, 0.4, 30.0);
  const SearchResult about_three = search(Problem(disc, V, Branch::iii), 0.78);
  ASSERT_EQ(about_three.status, SearchStatus::complete) << about_three.message;
  EXPECT_EQ(about_three.solutions.size(), 1U);
  EXPECT_LE(about_three.boxes, 10000);
  const SearchResult oblique = search_oblique(disc, V, {0.78}, {});
  ASSERT_EQ(oblique.status, SearchStatus::complete) << oblique.message;
  EXPECT_EQ(oblique.solutions.size(), 2U);
  EXPECT_LE(oblique.boxes, 40000);
}

/// A held volume pulls rho as its thickness pushes it: each alone is as wide as the box, and two
/// million boxes told nothing.
TEST(AnisotropicSearch, ThicknessesOfHeldVolumesTakeFewBoxes) {
  const Body plate(0.5498, 1.351, 0.827);
  BodyTerms<double> terms;
  terms.volume = 0.5;
  const Potential V(
      AnisotropicPotential(OrthotropicSaintVenantKirchhoff<>{0.9378, 2.134, 0.1849, 0.3036},
                           ReciprocalQuadratic<>{2.183, 0.6789}, {})
          .with_body(terms));
  const SearchResult oblique = search_oblique(plate, V, {0.525}, {});
  ASSERT_EQ(oblique.status, SearchStatus::complete) << oblique.message;
  EXPECT_EQ(oblique.solutions.size(), 4U);
  EXPECT_LE(oblique.boxes, 400000);
  const SearchResult about_three = search(Problem(plate, V, Branch::iii), 0.525);
  ASSERT_EQ(about_three.status, SearchStatus::complete) << about_three.message;
  EXPECT_EQ(about_three.solutions.size(), 5U);
  EXPECT_LE(about_three.boxes, 60000);
}

/// The motions about material axes are no oblique ones, though they solve the same equations.
TEST(AnisotropicSearch, MaterialAxesOfAnEvenPotentialAreLeftOut) {
  const Body disc(1.0, 1.7, 0.6);
  const Potential V = fibred(NeoHookean<>{1.0, 2.0}, 0.4, 90.0);
  const SearchResult all = search_oblique(disc, V, {0.2}, {});
  EXPECT_EQ(all.status, SearchStatus::complete) << all.message;
  EXPECT_TRUE(all.solutions.empty());
  for (const Branch branch : {Branch::i, Branch::ii}) {
    const SearchResult about = search(Problem(disc, V, branch), 0.2);
    ASSERT_EQ(about.solutions.size(), 1U);
    EXPECT_EQ(about.solutions[0].q.alpha, 0.0);
  }
}

TEST(AnisotropicSearch, RefusesWhatHasNoObliqueMotions) {
  const Body disc(1.0, 1.7, 0.6);
  const Potential isotropic(PlanarPotential(NeoHookean<>{1.0, 2.0}),
                            ThicknessPotential(ReciprocalQuadratic<>{1.0, 3.0}));
  EXPECT_THROW(search_oblique(disc, isotropic, {0.3}, {}), std::invalid_argument);
  const Potential V = fibred(NeoHookean<>{1.0, 2.0}, 0.4, 30.0);
  EXPECT_THROW(search_oblique(disc, V, {0.0}, {}), std::invalid_argument);
}

TEST(AnisotropicCertificate, ProvesMotionsAndRefusesOthers) {
  support::Random random(432);
  for (int k = 0; k < 16; ++k) {
    const OrientedBody at = random_oriented_body(random, k);
    const Problem third = at.problem(Branch::iii);
    const Potential V = at.potential();
    const Equilibrium about_three = solve(third, at.nu, without_search());
    const Certificate proof = certify(third, about_three);
    EXPECT_TRUE(proof.proven) << at.text << "\n" << proof.reason;
    EXPECT_GE(proof.error_bound, about_three.error_bound * 0.5) << at.text;
    EXPECT_LE(proof.error_bound, 1e-12) << at.text;
    Equilibrium off = about_three;
    off.q.alpha += 1e-9;
    EXPECT_FALSE(certify(third, off).proven) << at.text;
    off = about_three;
    off.q.xi *= 1.0 + 1e-9;
    EXPECT_FALSE(certify(third, off).proven) << at.text;
    if (at.V.even_in_alpha()) continue;
    for (const Branch near : {Branch::i, Branch::ii}) {
      const Equilibrium found = solve_oblique(at.body, V, {at.nu, near}, without_search());
      const Certificate oblique = certify_oblique(at.body, V, {at.nu}, found);
      EXPECT_TRUE(oblique.proven) << at.text << "\n" << oblique.reason;
      Equilibrium turned = found;
      turned.nu[0] += 1e-9 * found.nu[1];
      turned.nu[1] -= 1e-9 * found.nu[0];
      EXPECT_FALSE(certify_oblique(at.body, V, {at.nu}, turned).proven) << at.text;
      Equilibrium faster = found;
      faster.nu *= 1.0 + 1e-9;
      EXPECT_FALSE(certify_oblique(at.body, V, {at.nu}, faster).proven) << at.text;
    }
  }
}

/// Where blocks are, the class is proven too.
TEST(AnisotropicCertificate, ClassOfAnEvenPotentialAtAlphaZero) {
  const Body disc(1.0, 1.7, 0.6);
  const Potential V = fibred(NeoHookean<>{1.0, 2.0}, 0.4, 0.0);
  for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
    const Problem problem(disc, V, branch);
    const Equilibrium found = solve(problem, 0.3);
    const Certificate proof = certify(problem, found);
    ASSERT_TRUE(proof.proven) << proof.reason;
    const auto spectrum = anisotropic_stability(problem, found);
    ASSERT_TRUE(spectrum);
    const SpectrumEnclosure enclosure = enclose_spectrum(problem, found, proof, *spectrum);
    ASSERT_TRUE(enclosure.verdict) << name(branch);
    EXPECT_EQ(*enclosure.verdict, spectrum->verdict);
    EXPECT_EQ(enclosure.negative, spectrum->negative);
  }
}

/// Where there are none, from the whole leaf: whatever is proven is what stability says, and nearly
/// always something is.
TEST(AnisotropicCertificate, ClassOfAnyMotion) {
  support::Random random(433);
  int claimed = 0;
  int proven = 0;
  const auto compare = [&](const SpectrumEnclosure& found, const Spectrum& spectrum,
                           const std::string& text) {
    ASSERT_EQ(found.modes, spectrum.modes) << text;
    for (int k = 0; k < found.modes; ++k) {
      const Mode& m = spectrum.mode[static_cast<std::size_t>(k)];
      const ComplexInterval& lambda = found.lambda[static_cast<std::size_t>(k)];
      const Interval error(-m.lambda_error, m.lambda_error);
      EXPECT_FALSE((m.lambda_re + error).apart_from(lambda.re)) << text << " mode " << k;
      EXPECT_FALSE((m.lambda_im + error).apart_from(lambda.im)) << text << " mode " << k;
    }
    if (found.negative) {
      EXPECT_EQ(*found.negative, spectrum.negative) << text;
    }
    if (spectrum.verdict == StabilityClass::marginal) return;
    ++claimed;
    if (!found.verdict) return;
    ++proven;
    EXPECT_EQ(name(*found.verdict), name(spectrum.verdict)) << text;
  };
  for (int k = 0; k < 60; ++k) {
    OrientedBody at = random_oriented_body(random, k);
    if (k % 10 == 9) at.nu = 0.0;
    const Problem third = at.problem(Branch::iii);
    const Potential V = at.potential();
    const Equilibrium found = solve(third, at.nu, without_search());
    const Certificate proof = certify(third, found);
    if (!proof.proven) continue;
    const Spectrum spectrum = anisotropic_stability(third, found).value();
    compare(enclose_spectrum(third, found, proof, spectrum), spectrum, at.text);
    if (at.V.even_in_alpha() || at.nu == 0.0) continue;
    for (const Branch near : {Branch::i, Branch::ii}) {
      const Equilibrium oblique = solve_oblique(at.body, V, {at.nu, near}, without_search());
      const Certificate axis = certify_oblique(at.body, V, {at.nu}, oblique);
      if (!axis.proven) continue;
      const Spectrum modes = oblique_stability(at.body, V, oblique).value();
      compare(enclose_oblique_spectrum(at.body, V, {at.nu}, axis, modes), modes, at.text);
    }
  }
  EXPECT_GT(claimed, 80);
  EXPECT_GT(proven, claimed * 9 / 10);
}

}  // namespace
}  // namespace stationary
