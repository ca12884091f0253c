#include "solver/newton/thread_arena.hpp"

#include <map>
#include <mutex>

namespace stationary {

tbb::task_arena& arena_of(int threads) {
  static std::mutex guard;
  // Never destroyed: TBB's own threads may outlive what is at the end of the process.
  static auto& arenas = *new std::map<int, tbb::task_arena>();
  const std::scoped_lock lock(guard);
  return arenas.try_emplace(threads, threads).first->second;
}

}  // namespace stationary
