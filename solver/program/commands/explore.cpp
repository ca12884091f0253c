// stationary explore FILE… -o PAGE.html: one self-contained page that shows tables, or opens a case, and computes.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>

#include "solver/program/case/case_file.hpp"
#include "solver/program/diagram/same_body.hpp"
#include "solver/program/explore/live_solver.hpp"
#include "solver/program/explore/page.hpp"
#include "solver/program/explore/page_data.hpp"
#include "solver/program/explore/page_template.hpp"
#include "solver/program/session/command.hpp"
#include "solver/program/session/interrupt.hpp"
#include "solver/program/session/output_file.hpp"

namespace stationary::cli {
namespace {

namespace fs = std::filesystem;

struct ExploreOptions {
  std::vector<std::string> files;
  std::string output;
  std::optional<std::string> title;
  bool no_live = false;
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

bool is_case(const std::string& path) { return fs::path(path).extension() == ".toml"; }

/// A case is opened by itself, by a page that computes.
void refuse_beside_case(const ExploreOptions& options, const std::string& path) {
  if (!is_case(path)) return;
  if (options.files.size() > 1)
    throw InputError(Origin::in_file(path), "", "found a case among several files",
                     "tables, or one case by itself");
  if (options.no_live)
    throw InputError(Origin::of_option("--no-live"), "", "found a case, " + printable(path),
                     "tables of solve, continue, atlas, map or curve",
                     "without its solver a page cannot open a case");
}

constexpr std::string_view missing_page =
    "this program was built without the page: node and npm, or the packages that "
    "web/package-lock.json names, were missing; with them, configure and build it again";
constexpr std::string_view no_solver =
    "this program was built without the solver for pages: clang 19 or what it needs for "
    "WebAssembly was missing (Debian: clang-19, lld-19, libc++-19-dev-wasm32, "
    "libc++abi-19-dev-wasm32, libclang-rt-19-dev-wasm32, wasi-libc); with them, configure and "
    "build it again";

PageCase read_page_case(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {fs::path(path).filename().string(), {std::istreambuf_iterator<char>(file), {}}};
}

bool has_column(const PageTable& table, std::string_view name) {
  return std::ranges::find(table.columns, name, &PageColumn::name) != table.columns.end();
}

/// Of curves of events that the page draws over a map: where they are of another body.
void tell_other_bodies(std::span<const PageTable> tables) {
  for (const PageTable& map : tables) {
    if (map.parameters.size() != 2 || !has_column(map, "status")) continue;
    for (const PageTable& curves : tables) {
      const bool drawn = curves.parameters.size() == 2 && has_column(curves, "curve") &&
                         std::ranges::all_of(map.parameters, [&](const std::string& each) {
                           return has_column(curves, each);
                         });
      if (drawn && !of_one_body(map.metadata, curves.metadata, map.parameters))
        complain(fmt::format("{}: its curves are of another body than the map's, {}",
                             printable(curves.file), printable(map.file)));
    }
  }
}

ExitCode explore(const ExploreOptions& options) {
  refuse_suffix(options.output);
  for (const std::string& each : options.files) {
    refuse_beside_case(options, each);
    refuse_to_replace(options.output, options.output, each, "a file it is made of");
  }
  if (page_template().empty()) throw std::runtime_error(std::string(missing_page));
  const std::span<const std::string_view> live =
      options.no_live ? std::span<const std::string_view>() : live_solver();
  std::vector<PageTable> tables;
  std::optional<PageCase> opened;
  std::string title;
  std::size_t rows = 0;
  if (is_case(options.files.front())) {
    const std::string& path = options.files.front();
    const Case input = read_case(path);  // told what is wrong with it here, not by the page
    if (live.empty()) throw std::runtime_error(std::string(no_solver));
    opened = read_page_case(path);
    title = options.title.value_or(input.title.empty() ? opened->file : input.title);
  } else {
    for (const std::string& each : options.files) {
      tables.push_back(read_page_table(each, options.title));
      rows += tables.back().rows;
      if (!tables.back().warning.empty()) complain(tables.back().warning);
    }
    title = tables.front().title;
    tell_other_bodies(tables);
  }
  const std::string text = filled_page(
      page_template(),
      {.title = title, .data = page_data(tables, title, STATIONARY_VERSION, opened), .live = live});
  (void)stop_on_signals();  // before a file is begun, which would be left behind
  std::optional<AtomicFile> file;
  open_output(file, options.output);
  file->write(text);
  file->commit();
  if (options.quiet) return ExitCode::done;
  const std::string what =
      opened ? "a case"
             : fmt::format("{} table{}, {} row{}", tables.size(), tables.size() == 1 ? "" : "s",
                           rows, rows == 1 ? "" : "s");
  print(
      fmt::format("{}: {}, {} kB\n", printable(options.output), what, (text.size() + 999) / 1000));
  if (live.empty() && !options.no_live)
    print("The page shows its tables and computes nothing: " + std::string(no_solver) + "\n");
  return ExitCode::done;
}

}  // namespace

void add_explore(CLI::App& program, Session& session) {
  CLI::App& command = add_command(
      program, "explore",
      "Make one self-contained page that shows tables, or opens a case, and computes in a browser");
  const auto options = std::make_shared<ExploreOptions>();
  command
      .add_option("FILE", options->files,
                  "Tables of solve, continue, atlas, map or curve (CSV or HDF5), or one case")
      ->required();
  command.add_option("-o,--output", options->output, "Write the page there: .html")
      ->type_name("FILE")
      ->check(not_empty)
      ->required();
  command
      .add_option("--title", options->title,
                  "Title of the page; without it the case's, or the table's name")
      ->type_name("TEXT");
  command.add_flag("--no-live", options->no_live,
                   "Leave the solver out: the page shows its tables and computes nothing");
  command.add_flag("-q,--quiet", options->quiet, "Print nothing");
  command.callback(
      [options, &session] { session.action = [options] { return explore(*options); }; });
}

}  // namespace stationary::cli
