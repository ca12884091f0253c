#include "solver/program/commands/mpi_launch.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

#include "solver/program/text/input_error.hpp"

namespace stationary::cli {

int coming_rank() {
  for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
    if (const char* const text = std::getenv(name)) return std::atoi(text);
  return 0;
}

void require_alone() {
  // The first that is there is of whoever started this process last. SLURM_NTASKS is of the whole job.
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"}) {
    const char* const text = std::getenv(name);
    if (text == nullptr) continue;
    if (std::atoi(text) > 1)
      throw InputError(Origin::of_option("stationary-mpi"), "",
                       fmt::format("found {} processes by {}, of which MPI sees this one alone",
                                   printable(text), name),
                       "processes that are ranks of one MPI",
                       "start them by \"srun --mpi=pmix\", or by the mpirun of the MPI that it was "
                       "built with (--version)");
    return;
  }
}

HeldMessages::HeldMessages() {
  std::fflush(nullptr);
  std::array<int, 2> ends{};
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  ::dup2(nowhere, STDOUT_FILENO);
  error_ = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (error_ >= 0 && ::pipe2(ends.data(), O_NONBLOCK | O_CLOEXEC) == 0) {
    said_ = ends[0];
    ::dup2(ends[1], STDERR_FILENO);
    ::close(ends[1]);
  } else {
    ::dup2(nowhere, STDERR_FILENO);
  }
  ::close(nowhere);
}

HeldMessages::~HeldMessages() {
  for (const int file : {error_, said_})
    if (file >= 0) ::close(file);
}

void HeldMessages::tell(int rank) const {
  if (said_ < 0) return;
  std::fflush(stderr);
  std::string text;
  std::array<char, 4096> some{};
  for (::ssize_t count = 0; (count = ::read(said_, some.data(), some.size())) > 0;)
    text.append(some.data(), static_cast<std::size_t>(count));
  std::istringstream lines(text);
  std::string out;
  for (std::string line; std::getline(lines, line);) {
    constexpr std::string_view name = "stationary: ";
    out += fmt::format("{}rank {}: {}\n", name, rank,
                       std::string_view(line).substr(line.starts_with(name) ? name.size() : 0));
  }
  (void)!::write(error_, out.data(), out.size());
}

}  // namespace stationary::cli
