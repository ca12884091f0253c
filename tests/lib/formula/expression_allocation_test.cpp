// An evaluation of a written potential allocates nothing, nor does making it with other
// coefficients: counted by this executable's own operator new.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "lib/number/dual.hpp"
#include "tests/support/bodies/written_potential.hpp"

namespace {
long allocations = 0;

void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace stationary {
namespace {

template <class F>
long counted_in(const F& f) {
  const long before = allocations;
  f();
  return allocations - before;
}

TEST(ExpressionAllocation, CountsAllocations) {
  int* volatile kept = nullptr;  // or a compiler may leave the pair out
  EXPECT_EQ(counted_in([&] { kept = new int(1); }), 1);
  delete kept;
}

TEST(ExpressionAllocation, NoneInAnEvaluation) {
  const std::vector<std::string> names{"p", "q"};
  const auto plane = support::written_plane(
      "p*(log(lambda)^2 + mu_^q + lambda^q + log(mu_)^2) + exp(t)*tanh(d)", names, {1.25, 0.75});
  const auto coupled = support::written_coupled("p*d^q*rho^2 + sin(t)/rho", names, {1.25, 0.75});
  const auto anisotropic =
      support::written_anisotropic("p*xi^q + alpha^2*rho", names, {1.25, 0.75});
  double sum = 0.0;
  EXPECT_EQ(counted_in([&] {
              const auto x = planar_invariants(1.5, 0.75);
              const auto extended = extended_invariants(1.5, 0.75);
              sum += plane.evaluate<2>(x).w_tt;
              sum += double(plane.evaluate<1>(extended).w_t);
              sum += plane.log_balance(1.5, 0.75, 0.25, 0.25).uv;
              sum += coupled.evaluate<2>(x, 1.25).w_rr;
              sum += anisotropic.derivatives<2>(Stretch{0.25, 1.5, 0.75, 1.0}).value;
              const auto dual = with_indexed_coefficients(
                  plane, [](double c, std::size_t) { return Dual<double, 8>(c); });
              sum += dual.evaluate<1>(x).w_t.value;
              const auto intervals = with_indexed_coefficients(
                  plane, [](double c, std::size_t) { return Interval(c); });
              sum +=
                  intervals.evaluate<2>(planar_invariants(Interval(1.5), Interval(0.75))).w.mid();
              sum += plane.rest_stretch();
            }),
            0);
  EXPECT_NE(sum, 0.0);
}

}  // namespace
}  // namespace stationary
