#include "solver/program/tiles/tile_workers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace stationary::cli {

std::string no_thread(const std::system_error& error) {
  return fmt::format("cannot begin a thread: {}; ask for fewer by --threads",
                     error.code().message());
}

TileWorkers::TileWorkers(const TileLoop& loop, Dispatcher& dispatcher, TileOrder& order,
                         int threads)
    : loop_(loop), dispatcher_(dispatcher), order_(order) {
  const int count = std::min(threads, static_cast<int>(std::min<std::size_t>(loop.tiles, 1024)));
  for (int k = 0; k < count; ++k) {
    ++working_;
    try {
      threads_.emplace_back([this] {
        work();
        --working_;
      });
    } catch (const std::system_error& error) {
      failed_ = true;  // those that were begun end
      throw std::runtime_error(no_thread(error));
    }
  }
}

void TileWorkers::work() {
  using Clock = std::chrono::steady_clock;
  try {
    while (!failed_ && !loop_.stopped()) {
      const auto given = dispatcher_.next(1);
      if (given.empty()) return;
      const auto begin = Clock::now();
      auto text = loop_.compute(given.front());
      if (!text) continue;
      const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
      dispatcher_.ended(seconds);
      order_.keep(given.front(), std::move(*text), seconds);
    }
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
    failed_ = true;
  }
}

void TileWorkers::wait() {
  threads_.clear();
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace stationary::cli
