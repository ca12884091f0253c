// Processes that compute tiles together: one leads, hands them out and writes, the others compute. All of
// them have read the same arguments and the same case.
#pragma once

#include <string>

#include "solver/program/tiles/tile_loop.hpp"

namespace stationary::cli {

class Crew {
 public:
  Crew() = default;
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  virtual ~Crew() = default;

  /// Whether this process leads. The first call joins the others: all of them have to come to it.
  virtual bool leads() = 0;
  virtual int ranks() = 0;
  /// Of the one that leads, as run(loop); hash: of the work, which has to be that of all.
  virtual bool run(const TileLoop& loop, const std::string& hash) = 0;
  /// Of the others: computes what it is given until there is no more.
  virtual void serve(const TileLoop& loop, const std::string& hash) = 0;
};

}  // namespace stationary::cli
