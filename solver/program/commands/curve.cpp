// stationary curve CASE: the curves of an event in two numbers of the case, as curve_case.hpp follows
// them.
#include <memory>

#include "solver/program/computation/curve_case.hpp"
#include "solver/program/computation/row_start.hpp"
#include "solver/program/session/command.hpp"
#include "solver/program/session/output_file.hpp"

namespace stationary::cli {
namespace {

struct CurveOptions : ComputeOptions {
  std::string from;
};

}  // namespace

void add_curve(CLI::App& program, Session& session) {
  CLI::App& command = add_command(
      program, "curve", "Follow an event in two parameters: [curve] event, parameters, from, to");
  const auto options = std::make_shared<CurveOptions>();
  options->add_to(command);
  command
      .add_option("--from", options->from,
                  "Only the curve of an event that a table has: TABLE:N (data row N, the first is "
                  "1), TABLE:EVENT or TABLE:EVENT:K")
      ->type_name("TABLE:ROW")
      ->check(not_empty_row);
  command.callback([options, &session] {
    session.action = [options, &session] {
      if (!options->from.empty() && !options->output.empty())
        refuse_to_replace_table(options->output, table_of_row(options->from),
                                "the table of the event");
      return compute(*options, session, [&](TableTarget* target, const Run& run) {
        return curve_case(options->read(), options->from, target, run);
      });
    };
  });
}

}  // namespace stationary::cli
