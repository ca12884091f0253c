// stationary plot TABLE -o FILE: the bifurcation diagram of a table, and the spectrum along it.
#include "solver/plot.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

#include "solver/cli/command.hpp"
#include "solver/cli/interrupt.hpp"
#include "solver/cli/output_file.hpp"
#include "solver/gnuplot.hpp"
#include "solver/metadata.hpp"

namespace stationary::cli {
namespace {

namespace fs = std::filesystem;

struct PlotOptions {
  std::string table;
  std::string output;
  std::optional<std::string> title;
  bool quiet = false;
};

ImageFormat format_of(const std::string& output) {
  const std::string extension = fs::path(output).extension().string();
  if (const auto format = image_format(extension)) return *format;
  throw InputError(
      Origin::of_option("-o " + output), "",
      extension.empty() ? "found no extension" : "found the extension " + in_quotes(extension),
      ".svg, .png or .pdf");
}

/// As asked; else that of the case, from the metadata beside the table; else the table's name.
std::string title_of(const PlotOptions& options) {
  if (options.title) return *options.title;
  std::ifstream file(metadata_path(options.table), std::ios::binary);
  const std::string metadata{std::istreambuf_iterator<char>(file), {}};
  const std::string title = case_title(metadata);
  return title.empty() ? fs::path(options.table).filename().string() : title;
}

ExitCode plot_table(const PlotOptions& options) {
  const ImageFormat format = format_of(options.output);
  refuse_to_replace(options.output, options.output, options.table, "the table");
  TableReader table(options.table);
  const Diagram diagram = read_diagram(table);
  std::optional<AtomicFile> image;
  open_output(image, options.output);
  const std::atomic<bool>& stop = stop_on_signals();
  const std::string script = gnuplot_script(diagram, format, title_of(options));
  // Ctrl-C reaches gnuplot as well: its end is then no failure.
  try {
    if (!stop) run_gnuplot(script, image->descriptor());
  } catch (const std::runtime_error&) {
    if (!stop) throw;
  }
  if (stop) {
    complain("interrupted, nothing written");
    return ExitCode::interrupted;
  }
  image->commit();
  if (!options.quiet) {
    const auto counted = [](std::size_t count, std::string_view what) {
      return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
    };
    print(fmt::format(
        "{}: {}, {}, {}\n", printable(options.output), counted(diagram.points.size(), "row"),
        counted(diagram.pieces.size(), "sheet"), counted(diagram.events.size(), "event")));
  }
  return ExitCode::done;
}

}  // namespace

void add_plot(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "plot", "Draw the bifurcation diagram of a table (needs gnuplot)");
  const auto options = std::make_shared<PlotOptions>();
  command.add_option("TABLE", options->table, "Table (CSV) of solve, continue or atlas")
      ->required();
  command.add_option("-o,--output", options->output, "Write the image there: .svg, .png or .pdf")
      ->type_name("FILE")
      ->required();
  command
      .add_option("--title", options->title,
                  "Title of the diagram; without it the case's, or the table's name")
      ->type_name("TEXT");
  command.add_flag("-q,--quiet", options->quiet, "Print nothing");
  command.callback(
      [options, &session] { session.action = [options] { return plot_table(*options); }; });
}

}  // namespace stationary::cli
