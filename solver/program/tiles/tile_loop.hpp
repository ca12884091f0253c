// Work in tiles, numbered from 0: threads take the next one each, and what they make of it is handed on
// in the order of the tiles. So nothing that is written depends on the number of threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace stationary::cli {

struct TileLoop {
  std::size_t tiles = 0;
  int threads = 1;
  const std::atomic<bool>* stop = nullptr;  ///< becomes true: no tile is begun from then on
  /// Of a tile known before, which is not computed again.
  std::function<std::optional<std::string>(std::size_t)> known;
  /// Called by several threads; nothing where it was interrupted.
  std::function<std::optional<std::string>(std::size_t)> compute;
  /// A tile just computed, by one thread at a time, in the order in which they end.
  std::function<void(std::size_t, const std::string&)> done;
  /// Every tile known or computed, by one thread at a time, in the tiles' order; after an interruption
  /// some are left out.
  std::function<void(std::size_t, const std::string&)> take;
};

/// Whether all tiles were taken. What a thread throws is thrown here.
bool run(const TileLoop& loop);

}  // namespace stationary::cli
