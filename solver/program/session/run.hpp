// How a computation of a case runs, and what it comes to beside its table. Nothing that is found
// depends on it.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "solver/program/session/exit_code.hpp"

namespace stationary::cli {

struct Run {
  std::vector<std::string> command_line;  ///< for the metadata
  int threads = 1;
  const std::atomic<bool>* stop = nullptr;  ///< becomes true: it is to end; null: it never does
  bool summary = true;                      ///< somebody reads one
  /// A line for a person, as soon as it is known; if it ends in another code than done, the last
  /// one says why.
  std::function<void(const std::string& line)> complain = [](const std::string&) {};
  /// What of long work is done, a fraction of it; empty: nobody looks.
  std::function<void(double fraction, const std::string& what)> progress = {};
  /// While what it returns lives, `what` is being done, which cannot say how far it is.
  std::function<std::shared_ptr<void>(const std::string& what)> waiting =
      [](const std::string&) -> std::shared_ptr<void> { return nullptr; };

  bool stopped() const { return stop != nullptr && *stop; }
};

struct Outcome {
  ExitCode code = ExitCode::done;
  std::string summary;  ///< for a person; empty: not asked for, or nothing is to be told
};

}  // namespace stationary::cli
