// What is told on standard error while long work runs: a bar, only where that is a terminal, or lines.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace stationary::cli {

/// How long work will take at its rate so far; a fraction that falls begins another work.
class TimeLeft {
 public:
  using Clock = std::chrono::steady_clock;
  void at(double fraction, Clock::time_point now);
  /// ", about 40 s left", or nothing where that cannot be said yet.
  std::string text(Clock::time_point now) const;

 private:
  Clock::time_point begin_{};  ///< of the work, first shown
  double begin_fraction_ = 0.0;
  double fraction_ = 2.0;  ///< the last one shown; above any before there is one
};

class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Whether there is a terminal to show it on.
  bool shown() const { return terminal_; }
  /// fraction in [0, 1], and what is being done; at most ten times a second. From the first second
  /// on also how long it will take at the rate so far; a fraction that falls begins another work.
  void show(double fraction, const std::string& text);
  /// Leaves the line empty.
  void clear();

 private:
  bool terminal_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_{};
  TimeLeft left_;
};

/// The same as lines, one in half a minute, for where there is no terminal.
class ProgressLines {
 public:
  void show(double fraction, const std::string& text);

 private:
  TimeLeft::Clock::time_point last_ = TimeLeft::Clock::now();
  TimeLeft left_;
};

/// While it lives, of work that cannot say how far it is: what is done and for how long, on
/// standard error, from the first second on.
class WaitingSign {
 public:
  WaitingSign(std::string text, bool quiet);
  ~WaitingSign();
  WaitingSign(const WaitingSign&) = delete;
  WaitingSign& operator=(const WaitingSign&) = delete;

 private:
  void run();

  std::string text_;
  bool drawn_ = false;
  bool done_ = false;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::thread thread_;
};

}  // namespace stationary::cli
