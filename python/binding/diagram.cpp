#include "python/binding/diagram.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <sstream>
#include <utility>
#include <vector>

#include "solver/program/diagram/axis_name.hpp"
#include "solver/program/diagram/diagram_lines.hpp"
#include "solver/program/diagram/map_diagram.hpp"
#include "solver/program/diagram/rate_tracks.hpp"
#include "solver/program/plot/diagram_picture.hpp"
#include "solver/program/plot/plot_style.hpp"

namespace stationary::python {
namespace py = pybind11;

namespace {

TableReader reader(const std::string& csv) {
  return {std::make_unique<std::istringstream>(csv), "the table"};
}

py::array_t<double> numbers(const std::vector<double>& values) {
  return py::array_t<double>(static_cast<py::ssize_t>(values.size()), values.data());
}

/// (low, high, logarithmic); base: what the axis is less.
py::tuple axis(const Axis& of, double base = 0.0) {
  return py::make_tuple(of.range.low + base, of.range.high + base, of.logarithmic);
}

/// The colour of a curve; of energy and momentum, where there is one of each piece, its branch's.
std::size_t series_of(const Diagram& diagram, const DiagramPiece& piece, std::size_t ordinate) {
  return diagram.of_energy_and_momentum ? piece.branch : ordinate;
}

/// (series, class or None, abscissae, values).
void add_curves(const Diagram& diagram, const DiagramPiece& piece, const Axis& shown,
                py::list& out) {
  for (const DiagramLine& line : class_lines(diagram, piece, shown)) {
    const py::object verdict =
        line.verdict ? py::object(py::str(std::string(name(*line.verdict)))) : py::none();
    for (std::size_t k = 0; k < diagram.columns.size(); ++k) {
      std::vector<double> x;
      std::vector<double> y;
      for (const std::size_t point : line.points) {
        x.push_back(diagram.points[point].abscissa);
        y.push_back(diagram.points[point].ordinate[k]);
      }
      out.append(py::make_tuple(series_of(diagram, piece, k), verdict, numbers(x), numbers(y)));
    }
  }
}

/// (kind, abscissae, rates), a kind as in "rate_styles".
void add_rates(const Diagram& diagram, const DiagramPiece& piece, const Axis& shown,
               py::list& out) {
  const std::vector<std::size_t> rows = spectrum_rows(diagram, piece, shown);
  for (const RateTrack& track : rate_tracks(diagram, rows)) {
    std::vector<double> x;
    std::vector<double> y;
    for (const RatePoint& point : track.points) {
      x.push_back(diagram.points[point.row].abscissa);
      y.push_back(point.rate);
    }
    out.append(py::make_tuple(static_cast<int>(track.kind), numbers(x), numbers(y)));
  }
}

/// (name, abscissa, [(series, value), ...]).
void add_events(const Diagram& diagram, const DiagramPiece& piece, py::list& out) {
  for (const DiagramEvent& event : diagram.events) {
    if (event.point < piece.begin || event.point >= piece.end || !is_marked(event.name)) continue;
    const DiagramPoint& at = diagram.points[event.point];
    std::vector<std::pair<std::size_t, double>> values;
    for (std::size_t k = 0; k < diagram.columns.size(); ++k)
      values.emplace_back(series_of(diagram, piece, k), at.ordinate[k]);
    out.append(py::make_tuple(event.name, at.abscissa, values));
  }
}

py::dict panel(const Diagram& diagram, std::size_t branch, const DiagramPanel& drawn) {
  py::list curves;
  py::list rates;
  py::list events;
  for (const DiagramPiece& piece : diagram.pieces) {
    if (piece.branch != branch && !diagram.of_energy_and_momentum) continue;
    add_curves(diagram, piece, drawn.abscissa, curves);
    if (has_rates(diagram)) add_rates(diagram, piece, drawn.abscissa, rates);
    add_events(diagram, piece, events);
  }
  py::dict out;
  out["title"] = drawn.title;
  out["abscissa"] = drawn.abscissa_name;
  out["x"] = axis(drawn.abscissa);
  out["y"] = axis(drawn.ordinate, drawn.base);
  out["rate"] = axis(drawn.rate);
  out["curves"] = curves;
  out["rates"] = rates;
  out["events"] = events;
  return out;
}

py::dict map_axis(const MapDiagramAxis& of) {
  py::dict out;
  out["name"] = axis_name(of.parameter);
  out["values"] = numbers(of.values);
  out["log"] = of.scale == AxisScale::log;
  return out;
}

}  // namespace

py::dict diagram(const std::string& csv, const DiagramChoice& choice) {
  TableReader table = reader(csv);
  const Diagram found = read_diagram({&table}, choice);
  const DiagramPicture picture = diagram_picture(found);
  py::dict out;
  py::list panels;
  for (std::size_t k = 0; k < picture.panels.size(); ++k)
    panels.append(panel(found, k, picture.panels[k]));
  out["panels"] = panels;
  out["has_rates"] = has_rates(found);
  py::list ordinates;
  for (const std::string& column : found.columns) ordinates.append(axis_name(column));
  out["ordinates"] = ordinates;
  py::list series;
  for (std::size_t k = 0; k < picture.series.size(); ++k)
    series.append(
        py::make_tuple(picture.series[k], std::string(series_colours[k % series_colours.size()])));
  out["series"] = series;
  py::list rates;
  for (const RateStyle& each : rate_styles)
    rates.append(py::make_tuple(std::string(each.title), std::string(each.colour), each.width));
  out["rate_styles"] = rates;
  return out;
}

py::dict map_diagram(const std::string& csv, const std::optional<std::string>& quantity) {
  TableReader table = reader(csv);
  const MapDiagram found = read_map_diagram(table, quantity);
  py::dict out;
  out["quantity"] = found.quantity;
  out["name"] = axis_name(found.quantity);
  out["x"] = map_axis(found.x);
  out["y"] = map_axis(found.y);
  out["values"] =
      py::array_t<double>({found.y.values.size(), found.x.values.size()}, found.values.data());
  out["classes"] = std::vector<std::string>(std::begin(stability_names), std::end(stability_names));
  return out;
}

py::dict curve_diagram(const std::string& csv) {
  TableReader table = reader(csv);
  const MapDiagram found = read_curve_diagram({&table});
  py::list lines;
  py::list special;
  for (const EventLine& line : found.lines) {
    std::vector<double> x;
    std::vector<double> y;
    for (const auto& [first, second] : line.points) {
      x.push_back(first);
      y.push_back(second);
    }
    lines.append(py::make_tuple(line.event, numbers(x), numbers(y)));
    for (const EventLine::Special& each : line.special)
      special.append(py::make_tuple(std::string(name(each.type)), each.at[0], each.at[1]));
  }
  py::dict out;
  out["x"] = map_axis(found.x);
  out["y"] = map_axis(found.y);
  out["lines"] = lines;
  out["special"] = special;
  return out;
}

}  // namespace stationary::python
