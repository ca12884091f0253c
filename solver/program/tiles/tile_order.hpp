// Tiles as they end, handed on in their order: those that are known from before are read when their
// turn comes. May be told by several threads.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <string>

#include "solver/program/tiles/tile_loop.hpp"

namespace stationary::cli {

class TileOrder {
 public:
  explicit TileOrder(const TileLoop& loop) : loop_(loop) {}

  /// A tile just computed. What taking it throws is thrown here.
  void keep(std::size_t tile, std::string text, double seconds) {
    const std::scoped_lock lock(mutex_);
    if (loop_.done) loop_.done(tile, text, seconds);
    waiting_.emplace(tile, std::move(text));
    hand_on();
  }
  /// Hands on what is left, over the gaps of an interruption; whether there were none.
  bool finish() {
    const std::scoped_lock lock(mutex_);
    while (next_ < loop_.tiles) {
      hand_on();
      if (next_ < loop_.tiles) ++next_;
    }
    return taken_ == loop_.tiles;
  }

 private:
  void hand_on() {
    for (; next_ < loop_.tiles; ++next_) {
      if (const auto at = waiting_.find(next_); at != waiting_.end()) {
        loop_.take(next_, at->second);
        waiting_.erase(at);
      } else if (loop_.knows(next_)) {
        loop_.take(next_, loop_.known(next_));
      } else {
        return;
      }
      ++taken_;
    }
  }

  const TileLoop& loop_;
  std::mutex mutex_;
  std::map<std::size_t, std::string> waiting_;  ///< for those before them
  std::size_t next_ = 0;
  std::size_t taken_ = 0;
};

}  // namespace stationary::cli
