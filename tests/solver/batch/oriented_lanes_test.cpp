// Corrections of a lane's points in packs: against Newton's method in pairs of doubles, and the same
// bits by every instruction set.
#include "solver/batch/oriented_lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "solver/batch/batch.hpp"
#include "solver/motion/problem.hpp"
#include "solver/solve/solve.hpp"
#include "tests/support/bodies/anisotropic_motions.hpp"
#include "tests/support/bodies/plate.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary {
namespace {

using namespace testing;

std::vector<const OrientedKernels*> all_kernels() {
  std::vector<const OrientedKernels*> out{&OrientedKernels::baseline()};
#ifdef __x86_64__
  if (has_instruction_set(InstructionSet::avx2)) out.push_back(&OrientedKernels::avx2());
  if (has_instruction_set(InstructionSet::avx512)) out.push_back(&OrientedKernels::avx512());
#endif
  return out;
}

/// In pairs throughout, from a good approximation.
template <class Layout>
std::array<DoubleDouble, Layout::dimension> exact_solution(
    const OrientedSystem<Layout>& system, const ReducedVector<Layout::dimension>& near) {
  const Inertia3<DoubleDouble> J{system.body.J1, system.body.J2, system.body.J3};
  const auto at = system.linearize(near);
  const auto inverse = at.jacobian.inverse();
  std::array<DoubleDouble, Layout::dimension> x;
  for (int i = 0; i < Layout::dimension; ++i) x[static_cast<std::size_t>(i)] = near[i];
  for (int pass = 0; pass < 6; ++pass) {
    const auto b = balance_at<Layout, 1>(J, system.models->extended, system.branch,
                                         two_product(system.nu, system.nu),
                                         all_coordinates<Layout>(x, DoubleDouble(1.0)));
    ReducedVector<Layout::dimension> g;
    for (int i = 0; i < Layout::dimension; ++i)
      g[i] = double(b.g[OrientedSystem<Layout>::place(i)]) * at.scale[i];
    const ReducedVector<Layout::dimension> step = inverse * g;
    for (int i = 0; i < Layout::dimension; ++i) {
      DoubleDouble& each = x[static_cast<std::size_t>(i)];
      each = renormalized(DoubleDouble(each - each * step[i]));
    }
  }
  return x;
}

struct LaneCounts {
  int points = 0;
  int accepted = 0;
};

/// Points near solutions at some nu.
template <class Layout>
void expect_corrected(const Potential& V, Branch branch, support::Random& random,
                      const std::string& what, LaneCounts& counts) {
  constexpr int N = Layout::dimension;
  const OrientedModels models(V.anisotropic());
  const auto lane = oriented_lane(plate, branch, V.anisotropic());
  ASSERT_TRUE(lane) << what;
  OrientedPoints given{};
  std::vector<ReducedVector<N>> near;
  std::vector<double> nu;
  for (std::size_t i = 0; i < OrientedPoints::size; ++i) {
    given.nu[i] = std::nan("");
    const double at = 0.01 + 0.015 * static_cast<double>(i);
    const Equilibrium found = solve(Problem(plate, V, branch), at, without_search());
    if (found.status != SolveStatus::solved) continue;
    ReducedVector<N> x;
    x[0] = found.q.xi;
    x[1] = found.q.zeta;
    x[2] = found.q.rho;
    if constexpr (N == 4) x[3] = shear_coordinate(found.q);
    for (int k = 0; k < N; ++k) x[k] *= 1.0 + 1e-7 * random.uniform(-1.0, 1.0);
    given.nu[near.size()] = at;
    for (int k = 0; k < N; ++k) given.x[static_cast<std::size_t>(k)][near.size()] = x[k];
    if constexpr (N == 3) given.x[3][near.size()] = 1.0;
    near.push_back(x);
    nu.push_back(at);
  }
  std::vector<OrientedPoints> by_kernel;
  for (const OrientedKernels* kernels : all_kernels()) {
    const auto kernel = (N == 4 ? kernels->sheared : kernels->straight)[lane->plane_model];
    ASSERT_NE(kernel, nullptr) << what;
    by_kernel.push_back(given);
    kernel(*lane, by_kernel.back());
  }
  for (std::size_t i = 0; i < near.size(); ++i) {
    const OrientedPoints& out = by_kernel.front();
    for (const OrientedPoints& other : by_kernel) {
      ASSERT_EQ(out.accepted[i], other.accepted[i]);
      if (out.accepted[i] == 0.0) continue;
      for (int k = 0; k < N; ++k)
        EXPECT_EQ(out.x[static_cast<std::size_t>(k)][i], other.x[static_cast<std::size_t>(k)][i]);
      EXPECT_EQ(out.alpha[i], other.alpha[i]);
      EXPECT_EQ(out.error_bound[i], other.error_bound[i]);
      EXPECT_EQ(out.positive[i], other.positive[i]);
    }
    ++counts.points;
    if (out.accepted[i] == 0.0) continue;
    ++counts.accepted;
    const OrientedSystem<Layout> system{&models, plate, branch, nu[i]};
    const auto exact = exact_solution(system, near[i]);
    ReducedVector<N> refined = near[i];
    const Refined alone = refine(system, refined);
    ASSERT_TRUE(alone.converged) << what;
    EXPECT_EQ(out.positive[i] != 0.0, alone.positive) << what;
    EXPECT_LE(out.error_bound[i], 1.1 * alone.error_bound) << what;
    for (std::size_t k = 0; k < static_cast<std::size_t>(N); ++k) {
      const double off = std::abs(double(DoubleDouble(out.x[k][i]) - exact[k]) / double(exact[k]));
      EXPECT_LE(off, out.error_bound[i]) << what << ", nu " << nu[i];
      EXPECT_LE(off, 0x1p-53 + 0x1p-59) << what << ", nu " << nu[i];
    }
    const auto y = all_coordinates<Layout>(exact, DoubleDouble(1.0));
    const auto at = oriented_stretch(y[0], y[1], y[2], y[3]);
    const double off_alpha = std::abs(double(DoubleDouble(out.alpha[i]) - at.q.alpha));
    EXPECT_LE(off_alpha, 0x1p-53 * (1.0 + 0x1p-6) * std::abs(out.alpha[i])) << what;
  }
}

TEST(OrientedLanes, AreCorrectedAsAloneByEveryInstructionSet) {
  support::Random random(2029);
  LaneCounts counts;
  const AnisotropicPotential::Plane planes[] = {NeoHookean<>{1.0, 2.0}, BiotLog<>{1.0, 0.6},
                                                Biot<>{1.0, 0.6}, SaintVenantKirchhoff<>{1.0, 0.6},
                                                ReciprocalDeterminant<>{1.0, 2.0}};
  for (const auto& plane : planes) {
    for (const bool harmonic : {false, true}) {
      const auto V = [&](double degrees) {
        const std::vector<Fibre> fibres{{0.4, degrees}, {0.2, 90.0 - degrees}};
        return harmonic ? Potential(AnisotropicPotential(plane, Harmonic<>{2.0, 1.1}, fibres))
                        : Potential(AnisotropicPotential(plane, plate_thickness, fibres));
      };
      const std::string what = "plane " + std::to_string(plane.index());
      expect_corrected<ShearedLayout>(V(20.0), Branch::iii, random, what + " (iii)", counts);
      for (const Branch branch : {Branch::i, Branch::ii, Branch::iii})
        expect_corrected<StraightLayout>(V(0.0), branch, random,
                                         what + " (" + std::string(name(branch)) + ")", counts);
    }
  }
  EXPECT_GT(counts.points, 900);
  // Of those that the processor has each was one of the kernels.
  std::size_t sets = 0;
  for (const InstructionSet set :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512})
    sets += has_instruction_set(set);
  EXPECT_EQ(all_kernels().size(), sets);
  EXPECT_GT(counts.accepted, counts.points * 97 / 100);
}

TEST(OrientedLanes, TakeWhatIsMadeOfBuiltInModels) {
  const auto lane_of = [](const AnisotropicPotential& V) {
    return oriented_lane(plate, Branch::iii, V).has_value();
  };
  const AnisotropicPotential V(NeoHookean<>{1.0, 2.0}, plate_thickness, {{0.4, 20.0}});
  EXPECT_TRUE(lane_of(V));
  BodyTerms<double> heavy;
  heavy.gravitates = true;
  heavy.g = 0.5;
  heavy.J = {plate.J1, plate.J2, plate.J3};
  EXPECT_FALSE(lane_of(V.with_body(heavy))) << "gravity";
  BodyTerms<double> held;
  held.volume = 0.9;
  EXPECT_FALSE(lane_of(V.with_body(held))) << "a held volume";
  EXPECT_FALSE(lane_of(AnisotropicPotential(NeoHookean3d<>{1.0, 2.0}, {{0.4, 20.0}}))) << "coupled";
  const auto hencky = oriented_lane(
      plate, Branch::iii, AnisotropicPotential(Hencky<>{1.0, 0.6}, plate_thickness, {{0.4, 20.0}}));
  ASSERT_TRUE(hencky);
  EXPECT_EQ(OrientedKernels::baseline().sheared[hencky->plane_model], nullptr);
}

}  // namespace
}  // namespace stationary
