// Traced work (traced_work.hpp) by the ranks of MPI, for the test that kills them:
//
//   rank_tiles TABLE TRACE ROWS MILLISECONDS
//
// goes on with TABLE.journal where there is one, and writes TABLE.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <optional>

#include "solver/program/commands/mpi_crew.hpp"
#include "solver/program/table/atomic_file.hpp"
#include "tests/program/tiles/traced_work.hpp"

namespace {

using namespace stationary;

void run(char** words) {
  const std::string table = words[0];
  const testing::TracedWork work{.rows = std::strtoul(words[2], nullptr, 10),
                                 .trace = words[1],
                                 .milliseconds = std::atoi(words[3])};
  cli::MpiCrew crew;
  const cli::TiledRun tiled{.journal = table,
                            .resume = std::filesystem::exists(table + ".journal"),
                            .part = {},
                            .crew = &crew};
  const cli::Run run;
  const bool serves = tiled.serves();
  cli::TileRunner runner(work.work(), tiled, run);
  std::optional<AtomicFile> file;
  if (!serves) file.emplace(table);
  runner.run([&](const cli::Share&, const std::string& text) { file->write(text); });
  if (serves) return;
  file->commit(/*to_disk=*/true);
  runner.finish();
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int words = 5;
  if (argc != words) return 2;
  try {
    run(argv + 1);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 4;
  }
}
