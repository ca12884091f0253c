#include "solver/program/tiles/tile_loop.hpp"

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace stationary::cli {
namespace {

class Loop {
 public:
  explicit Loop(const TileLoop& loop) : loop_(loop) {}

  bool run() {
    const auto threads =
        std::min(static_cast<std::size_t>(std::max(1, loop_.threads)), loop_.tiles);
    {
      std::vector<std::jthread> others;
      for (std::size_t k = 1; k < threads; ++k) others.emplace_back([this] { work(); });
      work();
    }
    if (failure_) std::rethrow_exception(failure_);
    for (const auto& [tile, text] : waiting_) hand_on(tile, text);
    return taken_ == loop_.tiles;
  }

 private:
  bool stopped() const {
    return failed_ || (loop_.stop != nullptr && loop_.stop->load(std::memory_order_relaxed));
  }

  void work() {
    try {
      while (!stopped()) {
        const std::size_t tile = next_++;
        if (tile >= loop_.tiles) return;
        if (auto known = loop_.known ? loop_.known(tile) : std::nullopt) {
          keep(tile, std::move(*known), false);
        } else if (auto text = loop_.compute(tile)) {
          keep(tile, std::move(*text), true);
        }
      }
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      failed_ = true;
    }
  }

  void keep(std::size_t tile, std::string text, bool is_new) {
    const std::scoped_lock lock(mutex_);
    if (is_new && loop_.done) loop_.done(tile, text);
    waiting_.emplace(tile, std::move(text));
    while (!waiting_.empty() && waiting_.begin()->first == taken_) {
      hand_on(taken_, waiting_.begin()->second);
      waiting_.erase(waiting_.begin());
    }
  }

  void hand_on(std::size_t tile, const std::string& text) {
    loop_.take(tile, text);
    ++taken_;
  }

  const TileLoop& loop_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;
  std::map<std::size_t, std::string> waiting_;  ///< for those before them
  std::size_t taken_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

bool run(const TileLoop& loop) { return Loop(loop).run(); }

}  // namespace stationary::cli
