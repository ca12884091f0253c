#include "solver/program/rows/map_grid.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <variant>

#include "solver/batch_spectrum/batch_spectrum.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/solve/stability.hpp"

namespace stationary {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

constexpr std::size_t cells_of_a_group = 1024;
constexpr std::size_t most_groups_kept = 256;

double unit(const Case& input, const MapAxis& axis) {
  return parameter_unit(own_numbers(input), axis.parameter);
}

std::vector<double> times(std::vector<double> values, double factor) {
  for (double& each : values) each *= factor;
  return values;
}

}  // namespace

bool MapGrid::takes(const CaseMap& map) {
  const auto over = [](const MapAxis& axis, const MapAxis& other) {
    const ParameterParts parts = parts_of(axis.parameter);
    const std::string_view first = parts_of(other.parameter).first;
    return parts.second == first && (parts.first == "nu" || first == "nu");
  };
  return !map.y || !(over(map.x, *map.y) || over(*map.y, map.x));
}

MapGrid::MapGrid(const Case& input)
    : input_(input),
      branch_(std::get<AxisRotation>(input.motion).branch),
      potential_(input.potential),
      x_(input.map.value().x.values()),
      y_(input.map->y ? input.map->y->values() : std::vector<double>{not_a_number}),
      x_unit_(unit(input, input.map->x)),
      y_unit_(input.map->y ? unit(input, *input.map->y) : 1.0),
      x_is_nu_(parts_of(input.map->x.parameter).first == "nu"),
      y_is_nu_(input.map->y && parts_of(input.map->y->parameter).first == "nu"),
      nu_(x_is_nu_   ? times(x_, x_unit_)
          : y_is_nu_ ? times(y_, y_unit_)
                     : std::vector<double>{std::get<AxisRotation>(input.motion).nu}) {
  // A lane that is followed takes milliseconds; the others go in packs.
  group_ = potential_.is_isotropic()
               ? BatchResult::tile *
                     std::max<std::size_t>(1, cells_of_a_group / (BatchResult::tile * nu_.size()))
               : 1;
  // Where nu is y a row of the grid needs every lane.
  most_groups_ = y_is_nu_ ? (lanes() + group_ - 1) / group_ : most_groups_kept;
}

std::size_t MapGrid::lanes() const { return x_is_nu_ ? y_.size() : y_is_nu_ ? x_.size() : size(); }

std::size_t MapGrid::tile() const {
  // The lane that is followed for one cell is followed for all its cells.
  if (!potential_.is_isotropic()) return x_is_nu_ && x_.size() <= 256 ? x_.size() : 32;
  return std::clamp<std::size_t>(size() / 128 / 512 * 512, 512, 16384);
}

double MapGrid::value(std::size_t row, bool of_x) const {
  // Where one number is divided by the other, that one comes first.
  const MapAxis& x = input_.map->x;
  const MapAxis* const y = input_.map->y ? &*input_.map->y : nullptr;
  const double at_x = x_[row % x_.size()] * x_unit_;
  const double at_y = y_[row / x_.size()] * y_unit_;
  if (of_x) return y != nullptr && is_divided_by(x, *y) ? x_[row % x_.size()] * at_y : at_x;
  return y != nullptr && is_divided_by(*y, x) ? y_[row / x_.size()] * at_x : at_y;
}

BatchInput MapGrid::batch(std::size_t group) const {
  const std::size_t first = group * group_;
  const std::size_t count = std::min(group_, lanes() - first);
  BatchInput out(input_.problem(), count, nu_);
  const auto vary = [&](const MapAxis& axis, bool is_x) {
    const FamilyParameter what = family_parameter(axis.parameter, input_.models);
    if (what.kind == FamilyParameter::Kind::nu) return;  // the steps of every lane
    std::vector<double> each(count);
    // As the lane's last row has it.
    for (std::size_t lane = 0; lane < count; ++lane)
      each[lane] = value(x_is_nu_   ? (first + lane) * x_.size() + x_.size() - 1
                         : y_is_nu_ ? (y_.size() - 1) * x_.size() + first + lane
                                    : first + lane,
                         is_x);
    out.vary(what, std::move(each));
  };
  vary(input_.map->x, true);
  if (input_.map->y) vary(*input_.map->y, false);
  return out;
}

std::shared_ptr<MapGrid::Group> MapGrid::known(std::size_t group) const {
  const std::scoped_lock lock(mutex_);
  auto& out = groups_[group];
  if (!out) out = std::make_shared<Group>();
  out->last_use = ++uses_;
  return out;
}

void MapGrid::forget() const {
  const std::scoped_lock lock(mutex_);
  while (groups_.size() > most_groups_) {
    const auto oldest = std::ranges::min_element(
        groups_, {}, [](const auto& each) { return each.second->last_use; });
    groups_.erase(oldest);
  }
}

MapGrid::Groups MapGrid::solved(std::size_t first, std::size_t last,
                                const std::atomic<bool>* stop) const {
  Groups out;
  for (std::size_t k = first; k <= last; ++k) out.push_back(known(k));
  const auto solve = [&](Group& group, std::size_t k) {
    if (group.batch) return;
    BatchOptions how;
    how.stop = stop;
    auto of = std::make_unique<BatchInput>(batch(k));
    solve_batch(*of, how, group.solved);
    group.batch = std::move(of);
  };
  // Those no other thread is at first; then these are waited for.
  for (std::size_t k = first; k <= last; ++k) {
    Group& group = *out[k - first];
    if (const std::unique_lock lock(group.solving, std::try_to_lock); lock) solve(group, k);
  }
  for (std::size_t k = first; k <= last; ++k) {
    Group& group = *out[k - first];
    const std::scoped_lock lock(group.solving);
    solve(group, k);
  }
  forget();
  return out;
}

MapGrid::Place MapGrid::place(std::size_t row) const {
  const std::size_t x = row % x_.size();
  const std::size_t y = row / x_.size();
  if (x_is_nu_) return {y, x};
  if (y_is_nu_) return {x, y};
  return {row, 0};
}

RowCounts MapGrid::rows(std::size_t first, std::size_t last, const RowParts& parts,
                        const ColumnSet& wanted, const std::atomic<bool>* stop,
                        std::vector<TableRow>& out) const {
  out.clear();
  RowCounts counts;
  if (first == last) return counts;
  std::size_t low = lanes();
  std::size_t high = 0;
  for (std::size_t k = first; k < last; ++k) {
    low = std::min(low, place(k).lane);
    high = std::max(high, place(k).lane);
  }
  const Groups groups = solved(low / group_, high / group_, stop);
  std::optional<Problem> problem;
  std::size_t lane = 0;
  std::vector<CellPlace> places;  // whose spectra are made together, and which rows these are
  std::vector<std::size_t> rows;
  const SpectrumOptions options{.modes = wanted.has(Column::growth) ||
                                         wanted.has_any(Column::re1, Column::krein5)};
  std::vector<CellSpectrum> spectra;
  const auto make_spectra = [&](const Group& group) {
    spectra.resize(places.size());
    counts.spectra += static_cast<long>(places.size());
    counts.scalar_spectra +=
        static_cast<long>(cell_spectra(*group.batch, group.solved, places, options, spectra));
    for (std::size_t i = 0; i < rows.size(); ++i) fill_spectrum(spectra[i], out[rows[i]]);
    places.clear();
    rows.clear();
  };
  const Group* group = nullptr;
  for (std::size_t k = first; k < last; ++k) {
    const Place grid_place = place(k);
    const Group* const of = groups[grid_place.lane / group_ - low / group_].get();
    if (group != nullptr && group != of) make_spectra(*group);
    group = of;
    const Place at{grid_place.lane % group_, grid_place.step};
    const bool first_of_lane = k == (x_is_nu_ ? grid_place.lane * x_.size() : grid_place.lane);
    if (first_of_lane && group->solved.fell_back(at.lane)) ++counts.scalar_lanes;
    const BatchCell cell = group->solved.cell(at.lane, at.step);
    if (cell.status == SolveStatus::not_run) continue;
    TableRow& row = out.emplace_back();
    row.branch = name(branch_);
    row[Column::point] = static_cast<double>(k);
    row.parameter = x_[k % x_.size()];
    row.second_parameter = y_[k / x_.size()];
    Equilibrium found;
    found.nu = angular_velocity(branch_, nu_[at.step]);
    row[Column::nu1] = found.nu[0];
    row[Column::nu2] = found.nu[1];
    row[Column::nu3] = found.nu[2];
    CellStatus status = cell_status(cell.status);
    if (status == CellStatus::solved) {
      if (!problem || lane != grid_place.lane) {
        lane = grid_place.lane;
        problem.emplace(group->batch->problem(at.lane));
      }
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
          const AxisRotation motion{branch_, nu_[at.step]};
          (void)prove_row(*kind_of(problem->body(), problem->potential(), motion), found, spectrum,
                          row);
        } else if (parts.spectrum) {
          places.push_back({at.lane, at.step});
          rows.push_back(out.size() - 1);
        }
        tell_in(input_.coordinates, wanted, row);
      } else {
        status = CellStatus::failed;
      }
    }
    row.status = name(status);
  }
  make_spectra(*group);
  return counts;
}

}  // namespace stationary
