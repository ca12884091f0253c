#include "solver/program/session/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <utility>

#include "solver/program/text/terminal.hpp"

namespace stationary::cli {
namespace {

constexpr std::string_view erase_line = "\r\x1b[K";

void put(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) == 1) {}

void TimeLeft::at(double fraction, Clock::time_point now) {
  if (fraction < fraction_) {
    begin_ = now;
    begin_fraction_ = fraction;
  }
  fraction_ = fraction;
}

std::string TimeLeft::text(Clock::time_point now) const {
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  const double done = fraction_ - begin_fraction_;
  if (elapsed < 1.0 || done <= 0.0 || fraction_ > 1.0) return {};
  return fmt::format(", about {} left", rough_duration(elapsed * (1.0 - fraction_) / done));
}

void ProgressBar::show(double fraction, const std::string& text) {
  if (!terminal_) return;
  const auto now = std::chrono::steady_clock::now();
  left_.at(fraction, now);
  if (drawn_ && now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  drawn_ = true;
  constexpr int width = 30;
  const int full = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * width);
  put(fmt::format("{}[{:#<{}}{:<{}}] {}{}", erase_line, "", full, "", width - full, text,
                  left_.text(now)));
}

void ProgressLines::show(double fraction, const std::string& text) {
  const auto now = TimeLeft::Clock::now();
  left_.at(fraction, now);
  if (now - last_ < std::chrono::seconds(30)) return;
  last_ = now;
  put(fmt::format("stationary: {:.1f}% of {}{}\n", 100.0 * fraction, text, left_.text(now)));
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
