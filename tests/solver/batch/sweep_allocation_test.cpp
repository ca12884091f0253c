// A sweep allocates nothing after its construction: counted by this executable's own operator new.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "solver/batch/sweep.hpp"
#include "tests/support/bodies/random_problem.hpp"

namespace {
long allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void* counted(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto a = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(a, (size + a - 1) / a * a)) return memory;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void* operator new(std::size_t size, std::align_val_t a) { return counted(size, a); }
void* operator new[](std::size_t size, std::align_val_t a) { return counted(size, a); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace stationary {
namespace {

TEST(SweepAllocation, TheCountCounts) {
  const long before = allocations;
  const auto kept = std::make_unique<double>(1.0);
  const std::vector<double> more(100, *kept);
  EXPECT_EQ(allocations, before + 2);
  EXPECT_EQ(more.back(), 1.0);
}

TEST(SweepAllocation, NoneAfterConstruction) {
  auto models = testing::planar_models();
  models.push_back("neo-hookean-3d");
  for (const std::string_view model : models) {
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
      for (const bool bound : {true, false}) {
        const Problem problem(Body(1.0, 1.7, 0.6), testing::make_potential(model, {1.0, 2.0}),
                              branch);
        const Equilibrium start = solve(problem, 0.0);
        std::vector<double> nu;
        // To beyond the end of most sheets, so that halved and given-up steps are counted too.
        for (int k = 0; k < 300; ++k) nu.push_back(0.01 * k);
        std::vector<SweepPoint> points(nu.size());
        Sweep sweep(problem, start, {.error_bound = bound});
        const long before = allocations;
        sweep.run(nu, points);
        EXPECT_EQ(allocations, before) << model << " " << name(branch);
        EXPECT_EQ(points[10].status, SolveStatus::solved);
      }
    }
  }
}

}  // namespace
}  // namespace stationary
