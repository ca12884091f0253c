// stationary atlas CASE: every sheet, as atlas_case.hpp finds them, or of every cell of a grid, as
// atlas_grid.hpp does.
#include "solver/atlas/atlas.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "solver/program/case/case_atlas.hpp"
#include "solver/program/commands/tile_options.hpp"
#include "solver/program/computation/atlas_case.hpp"
#include "solver/program/computation/atlas_grid.hpp"
#include "solver/program/session/output_file.hpp"
#include "solver/program/text/input_error.hpp"
#include "solver/program/tiles/journal.hpp"

namespace stationary::cli {
namespace {

struct AtlasCommand : ComputeOptions {
  std::optional<int> checkpoints;
  bool complete = false;
  bool grid = false;
  std::string tables;
  std::string least_energy;
  TileOptions tiles;
};

/// A second table of the command, which has no name yet that -o writes.
void require_own_file(const AtlasCommand& options, std::string_view option,
                      const std::string& path) {
  if (!path.empty() && !options.output.empty() && options.output != "-")
    refuse_to_share(option, path, {options.output, metadata_path(options.output)});
}

ExitCode run_grid(const AtlasCommand& options, const Session& session) {
  require_own_file(options, "--tables", options.tables);
  if (options.certify && options.tables.empty() && !options.tiles.merges())
    throw InputError(Origin::of_option("--certify"), "", "found it with --grid and no --tables",
                     "--tables FILE.h5 beside it", "it proves rows of the atlases' own tables");
  const TiledRun tiled = options.tiles.run(options, session);
  return compute(options, session, [&](TableTarget* target, const Run& run) {
    const Case input = options.read();
    const AtlasGridAsked asked{options.checkpoints, options.tables};
    if (!options.tiles.merges()) return atlas_grid(input, asked, tiled, target, run);
    return tiled.serves() ? Outcome()
                          : merged_atlas_grid(input, asked, options.tiles.merge, *target, run);
  });
}

ExitCode run_one(const AtlasCommand& options, const Session& session) {
  if (session.crew != nullptr)
    throw InputError(Origin::of_option("atlas"), "", "found no --grid",
                     "atlas --grid: one atlas is the work of one machine",
                     "`stationary atlas` uses all its processors");
  if (options.least_energy == "-")
    refuse_output("-", "found standard output", "the name of a file", "--least-energy");
  require_table_suffix(options.least_energy, "--least-energy");
  require_own_file(options, "--least-energy", options.least_energy);
  AtlasRun asked{options.checkpoints, std::nullopt, options.tiles.resume, options.complete,
                 options.least_energy};
  if (asked.resume || has_journal(options.output)) asked.journal = options.output;
  return compute(options, session, [&](TableTarget* target, const Run& run) {
    return atlas_case(options.read(), asked, target, run);
  });
}

}  // namespace

void add_atlas(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "atlas",
                  "Find and follow every sheet over the case's range of nu, connected or not");
  const auto options = std::make_shared<AtlasCommand>();
  options->threads = all_processors();
  options->add_to(command);
  command
      .add_option("--checkpoints", options->checkpoints,
                  fmt::format("Values of nu at which every solution is found, with proof (default "
                              "{}, of an anisotropic body {})",
                              AtlasOptions{}.checkpoints, few_checkpoints))
      ->check(CLI::Range(1, most_checkpoints));
  CLI::Option* const complete =
      command.add_flag("--complete", options->complete,
                       "Prove for every nu of the range how many sheets there are, and of which "
                       "classes, not at the checkpoints alone");
  CLI::Option* const grid = command.add_flag(
      "--grid", options->grid,
      "An atlas of every cell of [map], a row each: how many sheets and events, and the first");
  command
      .add_option("--tables", options->tables,
                  "With --grid: every atlas's own table in one HDF5 file, a group a cell by the "
                  "number of its row")
      ->type_name("FILE.h5")
      ->check(not_empty)
      ->needs(grid);
  grid->excludes(complete);
  command
      .add_option("--least-energy", options->least_energy,
                  "Also a table of which motion has the least energy at each |pi|, and where that "
                  "is another")
      ->type_name("FILE")
      ->check(not_empty)
      ->excludes(grid);
  options->tiles.add_to(command, "cells");
  command.get_option("--part")->needs(grid);
  command.get_option("--merge")->needs(grid);
  command.callback([options, &session] {
    session.action = [options, &session] {
      return options->grid ? run_grid(*options, session) : run_one(*options, session);
    };
  });
}

}  // namespace stationary::cli
