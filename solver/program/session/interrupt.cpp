#include "solver/program/session/interrupt.hpp"

#include <csignal>
#include <cstdint>
#include <ctime>

namespace stationary::cli {
namespace {

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

/// Of the first signal, in nanoseconds; 0: none yet.
std::atomic<std::int64_t> first_signal{0};
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

/// A second one ends the program at once, but for one that comes with the first: `timeout` and batch
/// systems signal a process and then its group.
extern "C" void on_signal(int signal) {
  constexpr std::int64_t together = 500'000'000;
  std::timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const std::int64_t time = now.tv_sec * std::int64_t{1'000'000'000} + now.tv_nsec;
  std::int64_t first = 0;
  if (first_signal.compare_exchange_strong(first, time)) {
    stop.store(true, std::memory_order_relaxed);
  } else if (time - first > together) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);  // once this has returned
  }
}

}  // namespace

const std::atomic<bool>& stop_on_signals() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A parent may have left them blocked.
  sigset_t both;
  sigemptyset(&both);
  sigaddset(&both, SIGINT);
  sigaddset(&both, SIGTERM);
  pthread_sigmask(SIG_UNBLOCK, &both, nullptr);
  return stop;
}

}  // namespace stationary::cli
