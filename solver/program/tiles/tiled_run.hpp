// A command's work in tiles: with its journal, its part of the whole, and other processes where there are
// some. Nothing that is found depends on it.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "solver/program/rows/metadata.hpp"
#include "solver/program/session/run.hpp"
#include "solver/program/tiles/crew.hpp"
#include "solver/program/tiles/journal.hpp"
#include "solver/program/tiles/part.hpp"

namespace stationary::cli {

/// How it is run, beside Run.
struct TiledRun {
  std::optional<std::string> journal;  ///< the table beside which finished tiles are kept
  bool resume = false;                 ///< goes on with these
  Part part;
  Crew* crew = nullptr;  ///< null: this process alone

  /// Whether another process writes: nothing is opened and nothing is said here.
  bool serves() const { return crew != nullptr && !crew->leads(); }
};

struct TiledWork {
  std::string hash;       ///< of all that decides the rows
  std::string kept = {};  ///< what a tile holds beside them
  /// Seconds from the beginning in which no tile is kept: for work that is done again in the time in
  /// which it would be written.
  double too_short = 0.0;
  Share share;  ///< rows
  std::size_t rows_a_tile = 1;
  std::string_view unit;  ///< "cells"
  /// Of rows; called by several threads; nothing where it was interrupted.
  std::function<std::optional<std::string>(const Share& rows)> compute;
};

/// While the work is done.
class TileRunner {
 public:
  /// Opens the journal and locks it: before the table is, so that a run refused for another one touches
  /// nothing of that.
  TileRunner(TiledWork work, const TiledRun& how, const Run& run);

  /// Whether it was whole; take: as TileLoop's. Of a process that serves: computes for the others.
  bool run(const std::function<void(const Share& rows, const std::string& tile)>& take);
  /// What the metadata tell of the run, and of the part.
  void describe(Metadata& metadata) const;
  /// What is said of a run that was interrupted after so many rows; written: they are in a table.
  std::string interruption(std::size_t rows, bool written) const;
  /// The table is in its place: what was kept of a whole run is not needed any more.
  void finish();

 private:
  void show(double seconds);
  /// What --resume will do; nothing where there is no journal.
  std::string resumption() const;

  TiledWork work_;
  const TiledRun& how_;
  const Run& run_;
  Tiles tiles_;
  std::optional<Journal> journal_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::size_t computed_ = 0;
  std::size_t kept_ = 0;
  std::size_t journaled_ = 0;  ///< of those computed
  bool whole_ = false;
};

/// Of a case and of what is asked of it, the program's version included.
std::string work_hash(std::string_view command, const CaseTree& tree,
                      std::initializer_list<std::string_view> asked);

}  // namespace stationary::cli
