// Work by several threads: all of it is done, whoever asks at the same time, and no arena is made twice.
#include "solver/newton/thread_arena.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace stationary {
namespace {

TEST(ThreadArena, IsTheSameEachTime) {
  tbb::task_arena& two = arena_of(2);
  EXPECT_EQ(two.max_concurrency(), 2);
  EXPECT_NE(&arena_of(3), &two);
  EXPECT_EQ(&arena_of(2), &two);
}

TEST(ThreadArena, DoesAllThatSeveralThreadsAskFor) {
  std::atomic<long> sum = 0;
  std::vector<std::thread> askers;
  for (int k = 0; k < 4; ++k)
    askers.emplace_back([&sum, k] {
      for (int again = 0; again < 20; ++again)
        for_each_by(1 + k % 3, 100, [&](std::size_t i) { sum += static_cast<long>(i); });
    });
  for (std::thread& each : askers) each.join();
  EXPECT_EQ(sum, 4L * 20L * 4950L);
}

TEST(ThreadArena, ThrowsWhatTheWorkThrows) {
  EXPECT_THROW(for_each_by(2, 10, [](std::size_t) { throw std::domain_error("x"); }),
               std::domain_error);
  for_each_by(2, 0, [](std::size_t) { FAIL(); });
}

}  // namespace
}  // namespace stationary
