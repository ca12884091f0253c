// stationary-mpi: the commands that work in tiles, by the ranks of mpirun or srun.
#include <unistd.h>

#include <cstdlib>
#include <optional>

#include "solver/program/commands/mpi_crew.hpp"
#include "solver/program/commands/mpi_launch.hpp"
#include "solver/program/commands/program.hpp"

int main(int argc, char** argv) {
  using namespace stationary::cli;
  // Rank 0 may have a terminal of mpirun's, whatever mpirun's own output is.
  ::setenv("NO_COLOR", "1", 1);
  const int rank = coming_rank();
  std::optional<HeldMessages> held;
  if (rank > 0) held.emplace();
  MpiCrew crew;
  const int code = run_program(
      {"stationary-mpi", "Maps, studies and grids of atlases by the ranks of mpirun or srun",
       [](CLI::App& program, Session& session) {
         add_map(program, session);
         add_study(program, session);
         add_atlas(program, session);
       },
       &crew},
      argc, argv);
  if (!held || code == 0) return code;
  // With the first rank that fails mpirun ends the others: rank 0 is to say before what is wrong. Its
  // end wakes them. Where it does not end, this rank alone knows.
  constexpr unsigned seconds = 10;
  if (!crew.begun() && ::sleep(seconds) > 0) return code;
  if (!crew.begun() || crew.ranks() > 1) held->tell(rank);
  return code;
}
