#include "solver/program/commands/tile_options.hpp"

#include <fmt/format.h>

#include "solver/program/session/output_file.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary::cli {

void TileOptions::add_to(CLI::App& command, const std::string& rows) {
  CLI::Option* const going_on = command.add_flag(
      "--resume", resume,
      fmt::format("Go on with what was interrupted at -o FILE: none of its {} is computed twice",
                  rows));
  CLI::Option* const share =
      command
          .add_option("--part", part,
                      fmt::format("Only part K = 1 ... N of N: a contiguous share of the {}, in "
                                  "their order, as a table of its own",
                                  rows))
          ->type_name("K/N")
          ->check(not_empty);
  command
      .add_option("--merge", merge,
                  "Compute nothing: the tables of all parts in one, as a whole run writes it")
      ->type_name("TABLE...")
      ->check(not_empty)
      ->excludes(share)
      ->excludes(going_on);
}

TiledRun TileOptions::run(const ComputeOptions& options, const Session& session) const {
  TiledRun out;
  out.resume = resume;
  out.crew = session.crew;
  if (!part.empty()) out.part = read_part(part);
  if (resume || has_journal(options.output)) out.journal = options.output;
  const std::string option = merges() ? "--merge" : "--part " + part;
  if ((merges() || out.part.asked) && !has_journal(options.output))
    throw InputError(Origin::of_option(option), "", "found no file for the table",
                     "-o FILE, a table with its metadata beside it");
  for (const std::string& each : merge) refuse_to_replace_table(options.output, each, "a part");
  return out;
}

}  // namespace stationary::cli
