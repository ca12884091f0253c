// Work that several threads share, by TBB.
#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace stationary {

/// The arena of so many threads, threads > 0, one for the whole process: TBB keeps some memory of each that is made.
tbb::task_arena& arena_of(int threads);

/// f(0) ... f(count - 1) by so many threads; may throw what f throws.
template <class F>
void for_each_by(int threads, std::size_t count, const F& f) {
  arena_of(threads).execute([&] { tbb::parallel_for(std::size_t{0}, count, f); });
}

}  // namespace stationary
