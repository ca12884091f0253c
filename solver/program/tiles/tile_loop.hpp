// Work in tiles, numbered from 0: threads, and other processes where there is a crew, take the next ones,
// and what they make of them is handed on in the order of the tiles. So nothing that is written depends
// on who computed it.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stationary::cli {

struct TileLoop {
  std::size_t tiles = 0;
  int threads = 1;
  const std::atomic<bool>* stop = nullptr;  ///< becomes true: no tile is begun from then on
  /// Whether a tile is known from before, and is not computed again; empty: none is.
  std::function<bool(std::size_t)> has;
  /// What is known of it.
  std::function<std::string(std::size_t)> known;
  /// Called by several threads; nothing where it was interrupted.
  std::function<std::optional<std::string>(std::size_t)> compute;
  /// A tile just computed and the seconds it took, by one thread at a time, in the order in which they
  /// end.
  std::function<void(std::size_t, const std::string&, double)> done;
  /// Every tile known or computed, by one thread at a time, in the tiles' order; after an interruption
  /// some are left out.
  std::function<void(std::size_t, const std::string&)> take;

  bool knows(std::size_t tile) const { return has && has(tile); }
  /// Those to be computed.
  std::vector<std::size_t> missing() const;
  bool stopped() const { return stop != nullptr && stop->load(std::memory_order_relaxed); }
};

/// Whether all tiles were taken. What a thread throws is thrown here.
bool run(const TileLoop& loop);

}  // namespace stationary::cli
