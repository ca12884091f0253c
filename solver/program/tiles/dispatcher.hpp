// Hands out tiles in their order to whoever is free: so many at once that a batch takes about
// batch_seconds, one while the cost is not known, and towards the end fewer, that all end together:
//
//   n = min(batch_seconds / mean seconds of a tile, tiles left / (4 workers)), at least 1
//
// May be asked by several threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace stationary::cli {

constexpr double batch_seconds = 0.25;

/// Whether a process is given another batch: it has no more than its threads are at, so that it has
/// something to go on with when these are done.
constexpr bool wants_more(std::size_t given, std::size_t threads) { return given <= threads; }

class Dispatcher {
 public:
  /// workers: who ask, threads and processes.
  Dispatcher(std::vector<std::size_t> tiles, std::size_t workers)
      : tiles_(std::move(tiles)), workers_(std::max<std::size_t>(1, workers)) {}

  /// At most so many; none: all are handed out.
  std::span<const std::size_t> next(std::size_t most) {
    const std::scoped_lock lock(mutex_);
    const std::size_t left = tiles_.size() - given_;
    std::size_t count = 1;
    if (ended_ > 0) {
      const double in_time = batch_seconds * static_cast<double>(ended_) / seconds_;
      const double fair = static_cast<double>(left) / (4.0 * static_cast<double>(workers_));
      count = static_cast<std::size_t>(std::max(1.0, std::min({in_time, fair, 1e6})));
    }
    count = std::min({count, most, left});
    const std::span<const std::size_t> out(tiles_.data() + given_, count);
    given_ += count;
    return out;
  }
  /// One has ended that took so long.
  void ended(double seconds) {
    const std::scoped_lock lock(mutex_);
    ++ended_;
    seconds_ += std::max(seconds, 1e-9);
  }

 private:
  const std::vector<std::size_t> tiles_;
  const std::size_t workers_;
  std::mutex mutex_;
  std::size_t given_ = 0;
  std::size_t ended_ = 0;
  double seconds_ = 0.0;
};

}  // namespace stationary::cli
