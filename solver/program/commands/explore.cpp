// stationary explore TABLE… -o PAGE.html: one self-contained page that shows the tables.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "solver/program/explore/page.hpp"
#include "solver/program/explore/page_template.hpp"
#include "solver/program/session/command.hpp"
#include "solver/program/session/output_file.hpp"

namespace stationary::cli {
namespace {

namespace fs = std::filesystem;

struct ExploreOptions {
  std::vector<std::string> tables;
  std::string output;
  std::optional<std::string> title;
  bool quiet = false;
};

void refuse_suffix(const std::string& output) {
  const std::string extension = fs::path(output).extension().string();
  if (extension == ".html" || extension == ".htm") return;
  throw InputError(
      Origin::of_option("-o " + output), "",
      extension.empty() ? "found no extension" : "found the extension " + in_quotes(extension),
      ".html");
}

void refuse_case(const std::string& path) {
  if (fs::path(path).extension() != ".toml") return;
  throw InputError(Origin::in_file(path), "", "found a case, and pages carry no solver",
                   "tables of solve, continue, atlas or map",
                   "make one of it with `stationary continue`");
}

ExitCode explore(const ExploreOptions& options) {
  refuse_suffix(options.output);
  for (const std::string& each : options.tables) {
    refuse_case(each);
    refuse_to_replace(options.output, options.output, each, "a table");
  }
  if (page_template().empty()) {
    throw std::runtime_error(
        "this program was built without the page: node and npm, or the packages that "
        "web/package-lock.json names, were missing; with them, configure and build it again");
  }
  std::vector<PageTable> tables;
  std::size_t rows = 0;
  for (const std::string& each : options.tables) {
    tables.push_back(read_page_table(each, options.title));
    rows += tables.back().rows;
  }
  const std::string& title = tables.front().title;
  const std::string text =
      page(page_template(), title, page_data(tables, title, STATIONARY_VERSION));
  std::optional<AtomicFile> file;
  open_output(file, options.output);
  file->write(text);
  file->commit();
  if (!options.quiet) {
    print(fmt::format("{}: {} table{}, {} row{}, {} kB\n", printable(options.output), tables.size(),
                      tables.size() == 1 ? "" : "s", rows, rows == 1 ? "" : "s",
                      (text.size() + 999) / 1000));
  }
  return ExitCode::done;
}

}  // namespace

void add_explore(CLI::App& program, Session& session) {
  CLI::App& command = add_command(
      program, "explore", "Make one self-contained page that shows tables, to open in a browser");
  const auto options = std::make_shared<ExploreOptions>();
  command
      .add_option("TABLE", options->tables,
                  "Tables of solve, continue, atlas, map or curve (CSV or HDF5)")
      ->required();
  command.add_option("-o,--output", options->output, "Write the page there: .html")
      ->type_name("FILE")
      ->check(not_empty)
      ->required();
  command
      .add_option("--title", options->title,
                  "Title of the page; without it the case's, or the table's name")
      ->type_name("TEXT");
  // Pages carry no solver yet: it is what every page is.
  command.add_flag("--no-live")
      ->description("Leave the solver out of the page (no page carries it so far)");
  command.add_flag("-q,--quiet", options->quiet, "Print nothing");
  command.callback(
      [options, &session] { session.action = [options] { return explore(*options); }; });
}

}  // namespace stationary::cli
