// stationary continue CASE: the family followed as continue_case.hpp says.
#include <memory>

#include "solver/program/computation/continue_case.hpp"
#include "solver/program/computation/row_start.hpp"
#include "solver/program/session/command.hpp"
#include "solver/program/session/output_file.hpp"

namespace stationary::cli {
namespace {

struct ContinueOptions : ComputeOptions {
  bool resume = false;
  std::string from;  ///< a row of a table (row_start.hpp); empty: solved for
};

}  // namespace

void add_continue(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "continue",
                  "Follow the case's family in a parameter: bifurcation table, stability, events");
  const auto options = std::make_shared<ContinueOptions>();
  options->add_to(command);
  command
      .add_option(
          "--from", options->from,
          "Go on from a motion of a table: TABLE:N (data row N, the first is 1), TABLE:EVENT "
          "or TABLE:EVENT:K")
      ->type_name("TABLE:ROW")
      ->check(not_empty_row);
  command.add_flag("--resume", options->resume,
                   "Go on with the interrupted table at -o FILE (same case, same columns)");
  command.callback([options, &session] {
    session.action = [options, &session] {
      ContinueFrom from{options->from, {}};
      if (options->resume) from.resumed = options->output;
      const auto keep_table_of = [&](const std::string& row) {
        if (!row.empty() && !options->output.empty())
          refuse_to_replace_table(options->output, table_of_row(row),
                                  "the table of the row to start from");
      };
      keep_table_of(options->from);
      return compute(*options, session, [&](TableTarget* target, const Run& run) {
        const Case input = options->read();
        keep_table_of(start_row_of(input, options->from));
        return continue_case(input, from, target, run);
      });
    };
  });
}

}  // namespace stationary::cli
