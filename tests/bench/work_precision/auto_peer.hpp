// AUTO-07p as a peer: a curve of the panel "curve" by the continuation package, from the same
// equations (auto_balance.f90), in the logarithms of the stretches, with their Jacobian, as far as
// the library goes. Where AUTO is installed its own makefile builds its program when the benchmark
// runs. It is given what makes it fast and exact: three unknowns in (i) and two in (iii) instead of
// all four, few lines on the terminal, no restart points, Newton to 1e-10, where the eleven digits
// of its files are exact. The tolerance of an entry is its largest step (DSMAX), which is nearly
// all of its steps.
//   auto         points alone
//   auto-events  and folds and branch points, located
// Its time is that of its process in user mode, its output written: the system's share, a call for
// every line of that output, is left out.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/work_precision/curves.hpp"

namespace stationary::bench {

class AutoPeer {
 public:
  /// Looks for AUTO in AUTO_DIR, then where the command `auto` is, and builds the equations with it.
  explicit AutoPeer(const std::filesystem::path& equations);
  ~AutoPeer();
  AutoPeer(const AutoPeer&) = delete;
  AutoPeer& operator=(const AutoPeer&) = delete;

  /// Of AUTO; empty where there is none, and then nothing else may be asked.
  const std::string& version() const { return version_; }
  /// Why there is none.
  const std::string& missing() const { return missing_; }

  /// The panels "curve" and "curve-rows"; peer and curve must outlive the entries.
  void add(const Curve& of, std::vector<Entry>& out) const;

 private:
  std::filesystem::path directory_;  ///< of its program and its files, temporary
  std::string version_;
  std::string missing_;
};

}  // namespace stationary::bench
