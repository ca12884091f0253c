// SciPy as a peer (scipy_hybr.py): a child process, asked by lines of JSON, that solves and takes
// its own time.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/bench/work_precision/equilibria.hpp"

namespace stationary::bench {

class ScipyPeer {
 public:
  /// Runs `python3 script`.
  explicit ScipyPeer(const std::string& script);
  ~ScipyPeer();
  ScipyPeer(const ScipyPeer&) = delete;
  ScipyPeer& operator=(const ScipyPeer&) = delete;

  /// Of SciPy, NumPy and Python; empty where there is no python3 with SciPy, and then nothing else
  /// may be asked.
  const std::map<std::string, std::string>& versions() const { return versions_; }

  /// Sweeps (warm) or solves from rest; peer and equilibria must outlive the entries.
  void add(const Equilibria& of, const std::string& what, bool warm, std::vector<Entry>& out);

 private:
  struct Child;
  std::string line();
  std::unique_ptr<Child> child_;
  std::map<std::string, std::string> versions_;
};

}  // namespace stationary::bench
