// stationary-mpi: the commands that work in tiles, by the ranks of mpirun or srun.
#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>

#include "solver/program/commands/mpi_crew.hpp"
#include "solver/program/commands/program.hpp"

namespace {

/// The rank that Open MPI or Slurm says this process will have; 0 where neither started it.
int coming_rank() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
    if (const char* const text = std::getenv(name)) return std::atoi(text);
  return 0;
}

/// Every rank reads the same arguments and the same case: what is wrong with them is said once.
void say_nothing() {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace stationary::cli;
  if (coming_rank() > 0) say_nothing();
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
  // With the first rank that fails mpirun ends the others: rank 0 is to say before what is wrong. Its
  // end wakes them.
  constexpr unsigned seconds = 10;
  if (coming_rank() > 0 && code != 0 && !crew.begun()) ::sleep(seconds);
  return code;
}
