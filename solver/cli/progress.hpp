// A bar on standard error while long work runs, only where that is a terminal.
#pragma once

#include <chrono>
#include <string>

namespace stationary::cli {

class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Whether there is a terminal to show it on.
  bool shown() const { return terminal_; }
  /// fraction in [0, 1], and what is being done; at most ten times a second.
  void show(double fraction, const std::string& text);
  /// Leaves the line empty.
  void clear();

 private:
  bool terminal_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace stationary::cli
