// stationary plot TABLE... -o FILE: the bifurcation diagram of tables, and the spectrum along it; the
// energy against the momentum; of a map over two parameters the heat map of one of its columns, curves of
// events on top.
#include "solver/program/plot/plot.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "solver/motion/event.hpp"
#include "solver/program/diagram/same_body.hpp"
#include "solver/program/plot/gnuplot.hpp"
#include "solver/program/plot/map_plot.hpp"
#include "solver/program/plot/page_layout.hpp"
#include "solver/program/rows/metadata.hpp"
#include "solver/program/rows/metadata_reading.hpp"
#include "solver/program/session/command.hpp"
#include "solver/program/session/interrupt.hpp"
#include "solver/program/session/output_file.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/text/named.hpp"

namespace stationary::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view energy_momentum = "energy-momentum";

struct PlotOptions {
  std::vector<std::string> tables;
  std::string output;
  std::string script;
  std::string format;
  std::optional<std::string> title;
  std::string diagram = "parameter";
  DiagramChoice choice;
  std::vector<std::string> ranges;
  std::string size;
  bool quiet = false;
};

ImageFormat format_of(const PlotOptions& options) {
  if (!options.format.empty()) return *image_format("." + options.format);
  if (options.output.empty() || options.output == "-") return ImageFormat::svg;
  const std::string extension = fs::path(options.output).extension().string();
  if (const auto format = image_format(extension)) return *format;
  throw InputError(
      Origin::of_option("-o " + options.output), "",
      extension.empty() ? "found no extension" : "found the extension " + in_quotes(extension),
      ".svg, .png or .pdf");
}

/// A number that is all of a text.
std::optional<double> number(std::string_view text) {
  double out = 0.0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), out);
  if (end.ec != std::errc() || end.ptr != text.data() + text.size() || !std::isfinite(out))
    return std::nullopt;
  return out;
}

/// Two numbers with something between them.
std::optional<AxisRange> pair(std::string_view text, char between) {
  const std::size_t at = text.find(between);
  if (at == std::string_view::npos) return std::nullopt;
  const auto low = number(text.substr(0, at));
  const auto high = number(text.substr(at + 1));
  if (!low || !high) return std::nullopt;
  return AxisRange{*low, *high};
}

PageChoice page_choice(const PlotOptions& options) {
  PageChoice out;
  for (const std::string& asked : options.ranges) {
    const Origin origin = Origin::of_option("--range " + asked);
    const std::size_t equals = asked.find('=');
    const std::string axis = asked.substr(0, equals);
    std::optional<AxisRange>* const where = axis == "x"       ? &out.x
                                            : axis == "y"     ? &out.y
                                            : axis == "rate"  ? &out.rate
                                            : axis == "value" ? &out.value
                                                              : nullptr;
    if (where == nullptr || equals == std::string::npos)
      throw InputError(origin, "", "found the axis " + in_quotes(axis),
                       "x=, y=, rate= or value=, and LOW:HIGH");
    const auto range = pair(std::string_view(asked).substr(equals + 1), ':');
    if (!range || !(range->low < range->high) || range->low < -largest_drawn ||
        range->high > largest_drawn)
      throw InputError(origin, "", "found " + in_quotes(asked.substr(equals + 1)),
                       "LOW:HIGH, two numbers between -4e307 and 4e307, the lower one first");
    *where = range;
  }
  if (options.size.empty()) return out;
  const auto size = pair(options.size, 'x');
  constexpr double least = page::least_side;
  constexpr double most = 4000.0;
  if (!size || size->low < least || size->low > most || size->high < least || size->high > most)
    throw InputError(Origin::of_option("--size " + options.size), "", "found another size",
                     "WIDTHxHEIGHT, each from 300 to 4000, such as 800x600");
  out.size = PageSize{size->low, size->high};
  return out;
}

/// Of the case, from the metadata beside the table or in it; else the table's name.
std::string title_of(const std::string& table) {
  const std::string metadata = table_metadata(table);
  std::string title = case_title(metadata);
  if (!title.empty()) {  // a pipe, which is read once, has none
    TableReader rows = open_table(table);
    std::size_t count = 0;
    while (rows.next()) ++count;
    if (!is_of_table(metadata, count)) title.clear();
  }
  return title.empty() ? fs::path(table).filename().string() : title;
}

/// As asked; else what all tables are called, or each of them.
std::string title_of(const PlotOptions& options) {
  if (options.title) return *options.title;
  std::vector<std::string> titles;
  for (const std::string& each : options.tables) {
    std::string title = title_of(each);
    if (std::ranges::find(titles, title) == titles.end()) titles.push_back(std::move(title));
  }
  return fmt::format("{}", fmt::join(titles, ", "));
}

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

/// The script of a figure, and what is in it.
struct Figure {
  std::string script;
  std::string contents;
};

/// Refuses what only a diagram of rows has. columns: how many there may be to show.
void require_plane(const PlotOptions& options, const TableReader& table, std::string_view what,
                   std::size_t columns) {
  const DiagramChoice& choice = options.choice;
  if (choice.columns.size() <= columns && !choice.energy_momentum && choice.sheets.empty() &&
      choice.branches.empty())
    return;
  throw InputError(Origin::in_file(table.name()), "", "found " + std::string(what),
                   columns > 0
                       ? "at most one column to show, no sheet or branch, no energy-momentum"
                       : "no columns to show, no sheet or branch, no energy-momentum");
}

/// Refuses a range of what this figure does not have.
void refuse_range(const PlotOptions& options, std::string_view axis, std::string_view figure) {
  for (const std::string& asked : options.ranges)
    if (asked.starts_with(axis) && asked.substr(axis.size()).starts_with('='))
      throw InputError(Origin::of_option("--range " + asked), "",
                       fmt::format("found a range of {}", axis), fmt::format("{}", figure));
}

/// Refuses a range that an axis of logarithms cannot show.
void refuse_range_of_logarithms(const PlotOptions& options, const PageChoice& page,
                                const MapDiagram& map) {
  const auto is_refused = [](const MapDiagramAxis& axis, const std::optional<AxisRange>& asked) {
    return axis.scale == AxisScale::log && asked && !(asked->low > 0.0);
  };
  if (is_refused(map.x, page.x)) refuse_range(options, "x", "LOW > 0 on a logarithmic axis");
  if (is_refused(map.y, page.y)) refuse_range(options, "y", "LOW > 0 on a logarithmic axis");
}

/// Refuses an asked size on which the figure could not be read.
void require_room(const PlotOptions& options, const PageChoice& page, const PageSize& least) {
  if (!page.size || (page.size->width >= least.width && page.size->height >= least.height)) return;
  throw InputError(Origin::of_option("--size " + options.size), "",
                   "found too small a page for the panels and the legend of this figure",
                   fmt::format("at least {}x{}", std::max(least.width, page::least_side),
                               std::max(least.height, page::least_side)));
}

/// A map, and curves of events in its parameters.
Figure map_figure(const PlotOptions& options, TableReader& table,
                  const std::vector<TableReader*>& curves, ImageFormat format,
                  const PageChoice& page) {
  require_plane(options, table, "a map over two parameters", 1);
  refuse_range(options, "rate", "a diagram of families");
  const DiagramChoice& choice = options.choice;
  const auto column = choice.columns.empty() ? std::nullopt : std::optional(choice.columns.front());
  MapDiagram map = read_map_diagram(table, column);
  if (map.of_class()) refuse_range(options, "value", "a map of numbers");
  refuse_range_of_logarithms(options, page, map);
  for (TableReader* const each : curves) {
    std::ranges::move(read_event_lines(*each, map.x.parameter, map.y.parameter),
                      std::back_inserter(map.lines));
    if (!of_one_body(table_metadata(table.name()), table_metadata(each->name()),
                     {map.x.parameter, map.y.parameter}))
      complain(printable(each->name()) + ": its curves are of another body than the map's");
  }
  require_room(options, page, least_page(map));
  std::string contents =
      fmt::format("{} by {} cells, {}", map.x.values.size(), map.y.values.size(), map.quantity);
  if (!map.lines.empty()) contents += ", " + counted(map.lines.size(), "curve");
  return {gnuplot_script(map, format, title_of(options), page), std::move(contents)};
}

Figure curve_figure(const PlotOptions& options, const std::vector<TableReader*>& curves,
                    ImageFormat format, const PageChoice& page) {
  require_plane(options, *curves.front(), "curves of events", 0);
  refuse_range(options, "rate", "a diagram of families");
  refuse_range(options, "value", "a map");
  const MapDiagram diagram = read_curve_diagram(curves);
  require_room(options, page, least_page(diagram));
  return {gnuplot_script(diagram, format, title_of(options), page),
          counted(diagram.lines.size(), "curve")};
}

Figure figure(const PlotOptions& options, ImageFormat format) {
  const PageChoice page = page_choice(options);
  std::vector<std::unique_ptr<TableReader>> tables;
  std::vector<TableReader*> readers;
  for (const std::string& path : options.tables) {
    tables.emplace_back(new TableReader(open_table(path)));
    readers.push_back(tables.back().get());
    require_drawable(*readers.back());
  }
  const auto is_map = [](const TableReader* each) {
    return map_parameters(each->columns()).size() == 2;
  };
  if (const auto map = std::ranges::find_if(readers, is_map); map != readers.end()) {
    TableReader& cells = **map;
    readers.erase(map);
    return map_figure(options, cells, readers, format, page);
  }
  if (!curve_parameters(readers.front()->columns()).empty())
    return curve_figure(options, readers, format, page);
  for (const TableReader* const each : readers) {
    if (curve_parameters(each->columns()).empty()) continue;
    throw InputError(Origin::in_file(each->name()), "", "found curves of events beside a family",
                     "families alone; curves by themselves, or on a map of their parameters");
  }
  refuse_range(options, "value", "a map");
  if (options.choice.energy_momentum && !options.choice.columns.empty())
    throw InputError(
        Origin::of_option(fmt::format("--show {}", fmt::join(options.choice.columns, ","))), "",
        "found columns beside --diagram energy-momentum", "one of these options");
  const Diagram diagram = read_diagram(readers, options.choice);
  if (!has_rates(diagram))
    refuse_range(options, "rate", "a diagram with frequencies or growth rates");
  require_room(options, page, least_page(diagram));
  if (page.x && std::ranges::none_of(diagram.points, [&](const DiagramPoint& each) {
        return each.abscissa >= page.x->low && each.abscissa <= page.x->high;
      }))
    complain("no row is in the range of x asked for");
  const auto ends =
      static_cast<std::size_t>(std::ranges::count_if(diagram.events, [](const DiagramEvent& each) {
        return is_end(named<EventType>(event_names, each.name).value_or(EventType::none));
      }));
  return {gnuplot_script(diagram, format, title_of(options), page),
          fmt::format("{}, {}, {}, {}", counted(diagram.points.size(), "row"),
                      counted(diagram.pieces.size(), "sheet"),
                      counted(diagram.events.size() - ends, "event"), counted(ends, "end"))};
}

void write_script(const PlotOptions& options, const std::string& script) {
  if (options.script.empty()) return;
  if (options.script == "-") {
    print(script);
    return;
  }
  std::optional<AtomicFile> file;
  open_output(file, options.script, "--script");
  file->write(script);
  file->commit();
}

/// The image; nothing where a signal ended that.
std::optional<std::string> image_of(const std::string& script, ImageFormat format) {
  const std::atomic<bool>& stop = stop_on_signals();
  std::optional<std::string> out;
  // Ctrl-C reaches gnuplot as well: its end is then no failure.
  try {
    if (!stop) out = run_gnuplot(script);
  } catch (const std::runtime_error&) {
    if (!stop) throw;
  }
  if (!stop) return out && format == ImageFormat::svg ? finished_svg(std::move(*out)) : out;
  complain("interrupted, nothing written");
  return std::nullopt;
}

ExitCode plot_tables(const PlotOptions& options) {
  const ImageFormat format = format_of(options);
  if (options.output == "-" && options.script == "-")
    throw InputError(Origin::of_option("--script -"), "", "found standard output in use by -o -",
                     "a file for one of them");
  if (!options.script.empty() && options.script != "-" && !options.output.empty())
    refuse_to_share("--script", options.script, {options.output});
  for (const std::string& table : options.tables) {
    if (fs::path(table).extension() == ".toml")
      throw InputError(Origin::in_file(table), "", "found a case",
                       "tables of solve, continue, atlas, map or curve", "`explore` opens a case");
    refuse_to_replace_source("-o", options.output, table);
    refuse_to_replace_source("--script", options.script, table);
  }
  const Figure drawn = figure(options, format);
  (void)stop_on_signals();  // before a file is begun, which would be left behind
  if (options.output == "-") {
    const auto image = image_of(drawn.script, format);
    if (!image) return ExitCode::interrupted;
    print(*image);
    write_script(options, drawn.script);
    return ExitCode::done;
  }
  if (!options.output.empty()) {
    std::optional<AtomicFile> file;
    open_output(file, options.output);  // what cannot be written is told before it is drawn
    const auto image = image_of(drawn.script, format);
    if (!image) return ExitCode::interrupted;
    file->write(*image);
    file->commit();
  }
  write_script(options, drawn.script);
  const std::string& written = options.output.empty() ? options.script : options.output;
  if (!options.quiet && options.script != "-")
    print(fmt::format("{}: {}\n", printable(written), drawn.contents));
  return ExitCode::done;
}

}  // namespace

void add_plot(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "plot", "Draw the bifurcation diagram of tables (needs gnuplot)");
  const auto options = std::make_shared<PlotOptions>();
  command
      .add_option("TABLE", options->tables,
                  "Tables of solve, continue, atlas, map or curve (CSV or HDF5)")
      ->required();
  command
      .add_option("-o,--output", options->output,
                  "Write the image there: .svg, .png or .pdf; - is standard output")
      ->type_name("FILE")
      ->check(not_empty);
  command
      .add_option("--script", options->script,
                  "Write gnuplot's script there, data included; - is standard output")
      ->type_name("FILE")
      ->check(not_empty);
  command.add_option("--format", options->format, "Format of the image, whatever its name")
      ->type_name("svg|png|pdf")
      ->check(CLI::IsMember(std::vector<std::string>{"svg", "png", "pdf"}));
  command
      .add_option("--title", options->title,
                  "Title of the diagram; without it the case's, or the table's name")
      ->type_name("TEXT");
  command
      .add_option("--diagram", options->diagram,
                  "Against the family's parameter, or the energy against the size of the momentum")
      ->type_name("parameter|energy-momentum")
      ->check(CLI::IsMember(std::vector<std::string>{"parameter", std::string(energy_momentum)}));
  command
      .add_option("--show", options->choice.columns,
                  "Columns to show, up to three, instead of the stretches; of a map over two "
                  "parameters one, instead of the first there is of class, growth, lambda, xi")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->expected(1, static_cast<int>(most_ordinates))
      ->type_name("COLUMN");
  command.add_option("--sheet", options->choice.sheets, "Only these sheets, e.g. --sheet 1,3")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("N");
  command
      .add_option("--branch", options->choice.branches,
                  "Only these branches, e.g. --branch iii,tilted")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME");
  command
      .add_option("--range", options->ranges,
                  "What an axis shows: x=, y=, rate= or, of a map's colours, value=; repeatable, "
                  "e.g. --range y=0.5:2")
      ->allow_extra_args(false)
      ->type_name("AXIS=LOW:HIGH");
  command
      .add_option(
          "--size", options->size,
          "Size of the image, in pixels of an SVG (a PNG has twice as many); 100 are an inch "
          "of a PDF; refused where panels and legend need more")
      ->type_name("WIDTHxHEIGHT");
  command.add_flag("-q,--quiet", options->quiet, "Print nothing");
  command.callback([options, &session] {
    if (options->output.empty() && options->script.empty()) throw CLI::RequiredError("--output");
    options->choice.energy_momentum = options->diagram == energy_momentum;
    session.action = [options] { return plot_tables(*options); };
  });
}

}  // namespace stationary::cli
