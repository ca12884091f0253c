// stationary study CASE --over TABLE --do solve|continue|atlas: the case with the values of each row of a
// table, as study_case.hpp does them.
#include <fmt/format.h>

#include <iterator>
#include <memory>
#include <optional>

#include "solver/program/commands/tile_options.hpp"
#include "solver/program/computation/study_case.hpp"
#include "solver/program/session/output_file.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary::cli {
namespace {

struct StudyOptions : ComputeOptions {
  std::string over;
  std::string task;
  std::optional<int> checkpoints;
  TileOptions tiles;
};

ExitCode run(const StudyOptions& options, const Session& session) {
  const bool merges = options.tiles.merges();
  const std::optional<StudyTask> task =
      options.task.empty() ? std::nullopt : study_task(options.task);
  if (options.over.empty() && !merges)
    throw InputError(Origin::of_option("study"), "", "found no table of rows",
                     "--over TABLE, a row for each case");
  if (options.over.empty() && options.checkpoints)
    throw InputError(Origin::of_option("--checkpoints"), "", "found it with --merge alone",
                     "what the parts were made with: --over, --do and --checkpoints, or none");
  const auto require_task = [&](bool given, const std::string& option, StudyTask only) {
    if (given && !merges && task.value_or(StudyTask::solve) != only)
      throw InputError(Origin::of_option(option), "",
                       fmt::format("found it with --do {}", name(task.value_or(StudyTask::solve))),
                       fmt::format("--do {}", name(only)));
  };
  require_task(options.checkpoints.has_value(), "--checkpoints", StudyTask::atlas);
  require_task(options.certify, "--certify", StudyTask::solve);
  std::optional<StudySource> source;
  if (!options.over.empty()) source.emplace(options.over);
  const CaseTree base = CaseTree::read(options.path);
  StudyRun asked{&base, options.overrides, source ? &*source : nullptr, {}};
  asked.plan.task = task.value_or(StudyTask::solve);
  asked.plan.checkpoints = options.checkpoints;
  asked.plan.certify = options.certify;
  asked.tiled = options.tiles.run(options, session);
  if (!options.output.empty() && source)
    refuse_to_replace_table(options.output, options.over, "the table of --over");
  return compute(options, session, [&](TableTarget* target, const Run& how) {
    if (!merges) return study_case(asked, target, how);
    return asked.tiled.serves() ? Outcome()
                                : merged_study_case(asked, task, options.tiles.merge, *target, how);
  });
}

}  // namespace

void add_study(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "study",
                  "The case with each row of a table: solved, followed or charted, in one table");
  const auto options = std::make_shared<StudyOptions>();
  options->threads = all_processors();
  options->add_to(command);
  command
      .add_option(
          "--over", options->over,
          "Table of the rows: columns are keys of the case (potential.plane.mu), or begin with "
          "_ and are carried through; an empty cell leaves the case's value. Required, unless "
          "--merge is given")
      ->type_name("TABLE")
      ->check(not_empty);
  command
      .add_option("--do", options->task,
                  "What is done of each row (default solve); a row that fails is a row with its "
                  "message")
      ->type_name("solve|continue|atlas")
      ->check(CLI::IsMember(
          std::vector<std::string>(std::begin(study_task_names), std::end(study_task_names))));
  command
      .add_option("--checkpoints", options->checkpoints, "Of each atlas, as of the command atlas")
      ->check(CLI::Range(1, most_checkpoints));
  options->tiles.add_to(command, "rows");
  command.callback([options, &session] {
    session.action = [options, &session] { return run(*options, session); };
  });
}

}  // namespace stationary::cli
