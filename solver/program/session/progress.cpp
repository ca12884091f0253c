#include "solver/program/session/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <utility>

namespace stationary::cli {
namespace {

constexpr std::string_view erase_line = "\r\x1b[K";

void put(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressBar::show(double fraction, const std::string& text) {
  if (!terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  if (drawn_ && now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  drawn_ = true;
  constexpr int width = 30;
  const int full = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * width);
  put(fmt::format("{}[{:#<{}}{:<{}}] {}", erase_line, "", full, "", width - full, text));
}

void ProgressBar::clear() {
  if (drawn_) put(erase_line);
  drawn_ = false;
}

WaitingSign::WaitingSign(std::string text, bool quiet) : text_(std::move(text)) {
  if (!quiet && isatty(STDERR_FILENO) == 1) thread_ = std::thread([this] { run(); });
}

WaitingSign::~WaitingSign() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  ended_.notify_one();
  thread_.join();
}

void WaitingSign::run() {
  std::unique_lock lock(mutex_);
  for (int seconds = 1;; ++seconds) {
    if (ended_.wait_for(lock, std::chrono::seconds(1), [this] { return done_; })) break;
    put(fmt::format("{}{}, {} s", erase_line, text_, seconds));
    drawn_ = true;
  }
  if (drawn_) put(erase_line);
}

}  // namespace stationary::cli
