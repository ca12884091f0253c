#include "solver/program/rows/map_grid.hpp"

#include <limits>
#include <optional>
#include <variant>

#include "solver/batch_spectrum/batch_spectrum.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/solve/stability.hpp"

namespace stationary {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

double unit(const Case& input, const MapAxis& axis) {
  return parameter_unit({input.body, input.models, input.motion}, axis.parameter);
}

std::vector<double> times(std::vector<double> values, double factor) {
  for (double& each : values) each *= factor;
  return values;
}

}  // namespace

bool MapGrid::takes(const CaseMap& map) {
  const auto spin_over = [](const MapAxis& axis, const MapAxis& other) {
    const ParameterParts parts = parts_of(axis.parameter);
    return parts.first == "nu" && parts.second == parts_of(other.parameter).first;
  };
  return !map.y || !(spin_over(map.x, *map.y) || spin_over(*map.y, map.x));
}

MapGrid::MapGrid(const Case& input)
    : branch_(std::get<AxisRotation>(input.motion).branch),
      x_(input.map.value().x.values()),
      y_(input.map->y ? input.map->y->values() : std::vector<double>{not_a_number}),
      x_unit_(unit(input, input.map->x)),
      y_unit_(input.map->y ? unit(input, *input.map->y) : 1.0),
      x_is_nu_(parts_of(input.map->x.parameter).first == "nu"),
      y_is_nu_(input.map->y && parts_of(input.map->y->parameter).first == "nu"),
      batch_(input.problem(),
             x_is_nu_   ? y_.size()
             : y_is_nu_ ? x_.size()
                        : size(),
             x_is_nu_   ? times(x_, x_unit_)
             : y_is_nu_ ? times(y_, y_unit_)
                        : std::vector<double>{std::get<AxisRotation>(input.motion).nu}) {
  // Where one number is divided by the other, that one comes first.
  const auto divided_by = [&](const MapAxis& a, const MapAxis* b) {
    return b != nullptr && parts_of(a.parameter).second == parts_of(b->parameter).first;
  };
  const MapAxis* const y = input.map->y ? &*input.map->y : nullptr;
  const bool x_by_y = divided_by(input.map->x, y);
  const bool y_by_x = y != nullptr && divided_by(*y, &input.map->x);
  const auto value = [&](std::size_t row, bool is_x) {
    const double at_x = x_[row % x_.size()] * x_unit_;
    const double at_y = y_[row / x_.size()] * y_unit_;
    if (is_x) return x_by_y ? x_[row % x_.size()] * at_y : at_x;
    return y_by_x ? y_[row / x_.size()] * at_x : at_y;
  };
  const auto vary = [&](const MapAxis& axis, bool is_x) {
    std::vector<double> each(batch_.lanes);
    for (std::size_t row = 0; row < size(); ++row) each[place(row).lane] = value(row, is_x);
    const FamilyParameter what = family_parameter(axis.parameter, input.models);
    const auto k = static_cast<std::size_t>(what.index);
    switch (what.kind) {
      case FamilyParameter::Kind::inertia:
        batch_.inertia[k] = std::move(each);
        break;
      case FamilyParameter::Kind::plane:
        batch_.plane[k] = std::move(each);
        break;
      case FamilyParameter::Kind::thickness:
        batch_.thickness[k] = std::move(each);
        break;
      case FamilyParameter::Kind::shared:
        batch_.plane[k] = each;
        batch_.thickness[k] = std::move(each);
        break;
      case FamilyParameter::Kind::fibre:
        batch_.fibres[k] = std::move(each);
        break;
      case FamilyParameter::Kind::nu:  // the steps of every lane
        break;
    }
  };
  vary(input.map->x, true);
  if (input.map->y) vary(*input.map->y, false);
}

MapGrid::Place MapGrid::place(std::size_t row) const {
  const std::size_t x = row % x_.size();
  const std::size_t y = row / x_.size();
  if (x_is_nu_) return {y, x};
  if (y_is_nu_) return {x, y};
  return {row, 0};
}

RowCounts MapGrid::rows(std::size_t first, std::size_t last, const RowParts& parts,
                        const ColumnSet& wanted, std::vector<TableRow>& out) const {
  out.clear();
  RowCounts counts;
  std::optional<Problem> problem;
  std::size_t lane = 0;
  std::vector<CellPlace> places;  // whose spectra are made together, and which rows these are
  std::vector<std::size_t> rows;
  for (std::size_t k = first; k < last; ++k) {
    const Place at = place(k);
    const BatchCell cell = solved_.cell(at.lane, at.step);
    if (cell.status == SolveStatus::not_run) continue;
    TableRow& row = out.emplace_back();
    row.branch = name(branch_);
    row[Column::point] = static_cast<double>(k);
    row.parameter = x_[k % x_.size()];
    row.second_parameter = y_[k / x_.size()];
    Equilibrium found;
    found.nu = angular_velocity(branch_, batch_.nu[at.step]);
    row[Column::nu1] = found.nu[0];
    row[Column::nu2] = found.nu[1];
    row[Column::nu3] = found.nu[2];
    CellStatus status = cell_status(cell.status);
    if (status == CellStatus::solved) {
      if (!problem || lane != at.lane) problem.emplace(batch_.problem(lane = at.lane));
      found.status = SolveStatus::solved;
      found.q = {cell.alpha, cell.xi, cell.zeta, cell.rho};
      found.error_bound = cell.error_bound;
      const BalanceCheck check =
          check_balance(problem->body(), problem->potential(), found.q, found.nu);
      found.residual = check.residual;
      found.compatibility = check.compatibility;
      if (check.residual <= acceptable_residual) {
        fill_row(name(branch_), problem->body(), problem->potential(), found, wanted, row);
        counts.potentials += wanted.has(Column::energy);
        if (parts.certificate) {
          // A proof asks for all that is known of the spectrum.
          std::optional<Spectrum> spectrum;
          if (parts.spectrum) spectrum = stability(*problem, found);
          if (spectrum) fill_spectrum(*spectrum, row);
          counts.spectra += parts.spectrum;
          counts.scalar_spectra += parts.spectrum;
          const AxisRotation motion{branch_, batch_.nu[at.step]};
          (void)prove_row(*kind_of(problem->body(), problem->potential(), motion), found, spectrum,
                          row);
        } else if (parts.spectrum) {
          places.push_back({at.lane, at.step});
          rows.push_back(out.size() - 1);
        }
      } else {
        status = CellStatus::failed;
      }
    }
    row.status = name(status);
  }
  std::vector<CellSpectrum> spectra(places.size());
  const SpectrumOptions options{.modes = wanted.has(Column::growth) ||
                                         wanted.has_any(Column::re1, Column::krein5)};
  counts.spectra += static_cast<long>(places.size());
  counts.scalar_spectra +=
      static_cast<long>(cell_spectra(batch_, solved_, places, options, spectra));
  for (std::size_t i = 0; i < rows.size(); ++i) fill_spectrum(spectra[i], out[rows[i]]);
  return counts;
}

}  // namespace stationary
