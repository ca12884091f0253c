// Threads of this process that compute tiles.
#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "solver/program/tiles/dispatcher.hpp"
#include "solver/program/tiles/tile_order.hpp"

namespace stationary::cli {

/// What is said where the system begins no more threads.
std::string no_thread(const std::system_error& error);

class TileWorkers {
 public:
  /// Throws std::runtime_error where not all of them can be begun.
  TileWorkers(const TileLoop& loop, Dispatcher& dispatcher, TileOrder& order, int threads);
  TileWorkers(const TileWorkers&) = delete;
  TileWorkers& operator=(const TileWorkers&) = delete;

  /// Of the thread that calls it: tiles until none is left, or one fails somewhere.
  void work();
  /// Whether work is over for all threads begun here.
  bool over() const { return working_ == 0; }
  bool failed() const { return failed_; }
  /// Until it is; throws what a thread threw.
  void wait();

 private:
  const TileLoop& loop_;
  Dispatcher& dispatcher_;
  TileOrder& order_;
  std::atomic<bool> failed_ = false;
  std::atomic<int> working_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::vector<std::jthread> threads_;
};

}  // namespace stationary::cli
