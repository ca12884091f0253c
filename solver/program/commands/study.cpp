// stationary study CASE --over TABLE --do solve|continue|atlas, as study_case.hpp does it.
#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>

#include "solver/program/computation/study_case.hpp"
#include "solver/program/session/command.hpp"
#include "solver/program/session/output_file.hpp"
#include "solver/program/tiles/journal.hpp"

namespace stationary::cli {
namespace {

struct StudyOptions : ComputeOptions {
  std::string over;
  std::string task = std::string(name(StudyTask::solve));
  std::optional<int> checkpoints;
  bool resume = false;
};

ExitCode study(const StudyOptions& options, const Session& session) {
  const StudySource source(options.over);
  const CaseTree base = CaseTree::read(options.path);
  StudyRun asked{&base, options.overrides, &source, {}, std::nullopt, options.resume};
  asked.plan.task = *study_task(options.task);
  asked.plan.checkpoints = options.checkpoints;
  asked.plan.certify = options.certify;
  if (options.resume || has_journal(options.output)) asked.journal = options.output;
  return compute(options, session, [&](TableTarget* target, const Run& run) {
    refuse_to_replace(options.output, options.output, options.over, "the table of --over");
    return study_case(asked, target, run);
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
          "_ and are carried through; an empty cell leaves the case's value")
      ->type_name("TABLE")
      ->check(not_empty)
      ->required();
  command
      .add_option("--do", options->task,
                  "What is done of each row; a row that fails is a row with its message")
      ->type_name("solve|continue|atlas")
      ->check(CLI::IsMember(
          std::vector<std::string>(std::begin(study_task_names), std::end(study_task_names))))
      ->capture_default_str();
  command
      .add_option("--checkpoints", options->checkpoints, "Of each atlas, as of the command atlas")
      ->check(CLI::Range(1, 1'000'000));
  command.add_flag("--resume", options->resume,
                   "Go on with the interrupted study at -o FILE: no row is computed twice");
  command.callback([options, &session] {
    session.action = [options, &session] { return study(*options, session); };
  });
}

}  // namespace stationary::cli
