// What the commands that work in tiles take beside: --resume, --part, --merge.
#pragma once

#include <string>
#include <vector>

#include "solver/program/session/command.hpp"
#include "solver/program/tiles/tiled_run.hpp"

namespace stationary::cli {

struct TileOptions {
  bool resume = false;
  std::string part;
  std::vector<std::string> merge;

  /// rows: what a part is a share of, "cells".
  void add_to(CLI::App& command, const std::string& rows);
  bool merges() const { return !merge.empty(); }
  /// Throws InputError: no number of a part, a part or a merged table without a file.
  TiledRun run(const ComputeOptions& options, const Session& session) const;
};

}  // namespace stationary::cli
