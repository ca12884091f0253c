// stationary map CASE: its cells, as map_case.hpp solves them, as CSV or HDF5.
#include <memory>

#include "solver/program/computation/map_case.hpp"
#include "solver/program/session/command.hpp"

namespace stationary::cli {

void add_map(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "map", "Solve the case on a grid of one or two parameters: [map] x, y");
  const auto options = std::make_shared<ComputeOptions>();
  options->threads = all_processors();
  options->add_to(command);
  command.callback([options, &session] {
    session.action = [options, &session] {
      return compute(*options, session, [&](TableTarget* target, const Run& run) {
        return map_case(options->read(), target, run);
      });
    };
  });
}

}  // namespace stationary::cli
