// stationary plot TABLE -o FILE: the bifurcation diagram of a table, and the spectrum along it; of
// a map over two parameters the heat map of one of its columns.
#include "solver/program/plot/plot.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

#include "solver/program/plot/gnuplot.hpp"
#include "solver/program/plot/map_plot.hpp"
#include "solver/program/rows/metadata.hpp"
#include "solver/program/session/command.hpp"
#include "solver/program/session/interrupt.hpp"
#include "solver/program/session/output_file.hpp"
#include "solver/program/table/column_file.hpp"

namespace stationary::cli {
namespace {

namespace fs = std::filesystem;

struct PlotOptions {
  std::string table;
  std::string output;
  std::optional<std::string> title;
  std::optional<std::string> quantity;
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
  std::string metadata{std::istreambuf_iterator<char>(file), {}};
  if (metadata.empty() && is_column_file(options.table))
    metadata = column_file_metadata(options.table);
  const std::string title = case_title(metadata);
  return title.empty() ? fs::path(options.table).filename().string() : title;
}

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// The script of a table's figure, and what is in it.
struct Figure {
  std::string script;
  std::string contents;
};

Figure figure(const PlotOptions& options, ImageFormat format) {
  TableReader table = is_column_file(options.table)
                          ? TableReader(column_file_table(options.table, {}), options.table)
                          : TableReader(options.table);
  if (map_parameters(table.columns()).size() == 2) {
    const MapDiagram map = read_map_diagram(table, options.quantity);
    return {
        gnuplot_script(map, format, title_of(options)),
        fmt::format("{} by {} cells, {}", map.x.values.size(), map.y.values.size(), map.quantity)};
  }
  if (options.quantity) {
    throw InputError(Origin::of_option("--show " + *options.quantity), "",
                     "found no map over two parameters in " + printable(options.table),
                     "a table of `map` with x and y");
  }
  const Diagram diagram = read_diagram(table);
  return {gnuplot_script(diagram, format, title_of(options)),
          fmt::format("{}, {}, {}", counted(diagram.points.size(), "row"),
                      counted(diagram.pieces.size(), "sheet"),
                      counted(diagram.events.size(), "event"))};
}

ExitCode plot_table(const PlotOptions& options) {
  const ImageFormat format = format_of(options.output);
  refuse_to_replace(options.output, options.output, options.table, "the table");
  const Figure drawn = figure(options, format);
  std::optional<AtomicFile> image;
  open_output(image, options.output);
  const std::atomic<bool>& stop = stop_on_signals();
  // Ctrl-C reaches gnuplot as well: its end is then no failure.
  try {
    if (!stop) run_gnuplot(drawn.script, image->descriptor());
  } catch (const std::runtime_error&) {
    if (!stop) throw;
  }
  if (stop) {
    complain("interrupted, nothing written");
    return ExitCode::interrupted;
  }
  image->commit();
  if (!options.quiet) print(fmt::format("{}: {}\n", printable(options.output), drawn.contents));
  return ExitCode::done;
}

}  // namespace

void add_plot(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "plot", "Draw the bifurcation diagram of a table (needs gnuplot)");
  const auto options = std::make_shared<PlotOptions>();
  command
      .add_option("TABLE", options->table,
                  "Table of solve, continue, atlas or map (CSV, or map's HDF5)")
      ->required();
  command.add_option("-o,--output", options->output, "Write the image there: .svg, .png or .pdf")
      ->type_name("FILE")
      ->check(not_empty)
      ->required();
  command
      .add_option("--title", options->title,
                  "Title of the diagram; without it the case's, or the table's name")
      ->type_name("TEXT");
  command
      .add_option("--show", options->quantity,
                  "Column of a map over two parameters to show; without it class, or growth, or "
                  "lambda")
      ->type_name("COLUMN");
  command.add_flag("-q,--quiet", options->quiet, "Print nothing");
  command.callback(
      [options, &session] { session.action = [options] { return plot_table(*options); }; });
}

}  // namespace stationary::cli
