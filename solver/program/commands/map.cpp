// stationary map CASE: its cells, as map_case.hpp solves them, as CSV or HDF5.
#include <memory>

#include "solver/program/commands/tile_options.hpp"
#include "solver/program/computation/map_case.hpp"

namespace stationary::cli {
namespace {

struct MapOptions : ComputeOptions {
  TileOptions tiles;
};

}  // namespace

void add_map(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "map", "Solve the case on a grid of one or two parameters: [map] x, y");
  const auto options = std::make_shared<MapOptions>();
  options->threads = all_processors();
  options->add_to(command);
  options->tiles.add_to(command, "cells");
  command.callback([options, &session] {
    session.action = [options, &session] {
      const TiledRun tiled = options->tiles.run(*options, session);
      return compute(*options, session, [&](TableTarget* target, const Run& run) {
        const Case input = options->read();
        if (!options->tiles.merges()) return tiled_map_case(input, tiled, target, run);
        return tiled.serves() ? Outcome()
                              : merged_map_case(input, options->tiles.merge, *target, run);
      });
    };
  });
}

}  // namespace stationary::cli
