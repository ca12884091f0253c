// The ranks of MPI as a crew (tiles/crew.hpp): rank 0 leads and computes too where there are few, the
// others compute. Messages, all between rank 0 and another, two-sided, of one thread:
//
//   to 0     hello   threads, the hash of the work      to others  work   numbers of tiles
//            result  tile, seconds, bytes                          stop   begin no more
//            failed  what a thread threw                           end    of this loop
//            idle    after stop: nothing is under way              leave  there is no other
//
// MPI is begun where the crew is first asked for, after the arguments and the case were read.
#pragma once

#include <memory>

#include "solver/program/tiles/crew.hpp"

namespace stationary::cli {

class MpiCrew final : public Crew {
 public:
  MpiCrew();
  /// Lets the others go and ends MPI, if it was begun.
  ~MpiCrew() override;

  /// Whether MPI was.
  bool begun() const { return begun_ != nullptr; }

  /// Throws InputError where MPI does not see the others (mpi_launch.hpp).
  bool leads() override;
  int ranks() override;
  bool run(const TileLoop& loop, const std::string& hash) override;
  void serve(const TileLoop& loop, const std::string& hash) override;

 private:
  struct Begun;
  std::unique_ptr<Begun> begun_;
};

}  // namespace stationary::cli
