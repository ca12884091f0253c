#include "solver/program/rows/map_cells.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/program/rows/map_grid.hpp"

namespace stationary {
namespace {

/// Which of the motion's own numbers it is that alone the cells of a row of the grid differ in.
std::optional<int> number_of_rows(const CaseMap& map, Motion motion) {
  const ParameterParts x = parts_of(map.x.parameter);
  if (!x.second.empty()) return std::nullopt;
  if (map.y && parts_of(map.y->parameter).second == x.first) return std::nullopt;
  const std::vector<MotionNumber> numbers = motion_numbers(motion);
  for (std::size_t k = 0; k < numbers.size(); ++k)
    if (numbers[k].parameter == x.first) return static_cast<int>(k);
  return std::nullopt;
}

/// Cells of any kind of motion: where a number of the motion is x, and the kind solves for many of its
/// values together, those of a row of the grid; else each by itself.
class KindCells final : public MapCells {
 public:
  explicit KindCells(const Case& input)
      : input_(input),
        x_(input.map.value().x.values()),
        y_(input.map->y ? input.map->y->values()
                        : std::vector<double>{std::numeric_limits<double>::quiet_NaN()}),
        number_(number_of_rows(*input.map, input.motion)),
        together_(rows_together(input)) {}

  std::size_t size() const override { return x_.size() * y_.size(); }
  std::size_t tile() const override { return together_ ? std::min(x_.size(), most_together) : 8; }
  bool marches() const override { return false; }

  RowCounts rows(std::size_t first, std::size_t last, const RowParts& parts,
                 const ColumnSet& wanted, const std::atomic<bool>* stop,
                 std::vector<TableRow>& out) const override {
    out.clear();
    RowCounts counts;
    const Asked asked{parts, wanted, stop};
    while (first < last) {
      const std::size_t row_end = (first / x_.size() + 1) * x_.size();
      const std::size_t end = together_ ? std::min(last, row_end) : first + 1;
      if (together_) {
        together(first, end, asked, out, counts);
        counts.scalar_lanes += first % x_.size() == 0;
      } else {
        counts.scalar_lanes += static_cast<long>(end - first);
        for (std::size_t k = first; k < end; ++k) alone(k, asked, out, counts);
      }
      first = end;
    }
    return counts;
  }

 private:
  static constexpr std::size_t most_together = 128;

  struct Asked {
    const RowParts& parts;
    const ColumnSet& wanted;
    const std::atomic<bool>* stop;
  };

  FamilyParameters at_cell(std::size_t k) const {
    return input_.map->cell(own_numbers(input_), x_[k % x_.size()], y_[k / x_.size()]);
  }

  /// Cells of one row of the grid, of a kind that solves for them together.
  void together(std::size_t first, std::size_t last, const Asked& asked, std::vector<TableRow>& out,
                RowCounts& counts) const {
    const FamilyParameters at = at_cell(first);
    const Potential potential = make_potential(at.models, at.body);
    const Alternatives kinds = alternatives(at.body, potential, at.motion, /*anywhere=*/false);
    SolveOptions how;
    how.stop = asked.stop;
    // At rest no axis is one of a spin.
    const std::size_t spins = first + (x_[first % x_.size()] == 0.0 ? 1 : 0);
    std::vector<AtValue> values;
    for (std::size_t k = spins; k < last; ++k) values.push_back({.value = x_[k % x_.size()]});
    std::vector<std::size_t> places(values.size());
    first_found_each(kinds, asked.parts.spectrum, how, {.values = x_, .number = *number_}, values,
                     places);
    for (std::size_t k = first; k < last; ++k) {
      if (asked.stop != nullptr && asked.stop->load(std::memory_order_relaxed)) break;
      const bool found = k >= spins && values[k - spins].solved();
      if (found) {
        const AtValue& at_value = values[k - spins];
        TableRow& row = begun(k, at.motion, CellStatus::solved, out);
        fill_row(row.branch, at.body, potential, at_value.equilibrium, asked.wanted, row);
        if (asked.parts.certificate) {
          const FamilyParameters here = at_cell(k);
          const Alternatives own = alternatives(here.body, potential, here.motion, false);
          const Kind& kind = *own.each[places[k - spins]].kind;
          finish(kind, at_value.equilibrium, at_value.spectrum, asked, row, counts);
        } else {
          finish(*kinds.each.front().kind, at_value.equilibrium, at_value.spectrum, asked, row,
                 counts);
        }
      } else if (k < spins || kinds.any) {
        alone(k, asked, out, counts);
      } else {
        const SolveStatus status = values[k - spins].equilibrium.status;
        const bool open = status == SolveStatus::not_run;
        (void)begun(k, at.motion, open ? CellStatus::not_found : cell_status(status), out);
      }
    }
  }

  void alone(std::size_t k, const Asked& asked, std::vector<TableRow>& out,
             RowCounts& counts) const {
    const FamilyParameters at = at_cell(k);
    const Alternatives kinds =
        alternatives(at.body, make_potential(at.models, at.body), at.motion, /*anywhere=*/false);
    SolveOptions how;
    how.stop = asked.stop;
    const auto [found, kind] = first_found(kinds, how);
    if (found.status == SolveStatus::interrupted) return;
    const CellStatus status = cell_status(found.status);
    TableRow& row = begun(k, at.motion, status, out);
    if (status != CellStatus::solved) return;
    fill_row(row.branch, at.body, kind->potential(), found, asked.wanted, row);
    std::optional<Spectrum> spectrum;
    if (asked.parts.spectrum) spectrum = kind->spectrum(found);
    finish(*kind, found, spectrum, asked, row, counts);
  }

  TableRow& begun(std::size_t k, const Motion& motion, CellStatus status,
                  std::vector<TableRow>& out) const {
    TableRow& row = out.emplace_back();
    row.branch = name(motion);
    row[Column::point] = static_cast<double>(k);
    row.parameter = x_[k % x_.size()];
    row.second_parameter = y_[k / x_.size()];
    row.status = name(status);
    return row;
  }

  /// What a solved cell has beside its motion.
  void finish(const Kind& kind, const Equilibrium& found, const std::optional<Spectrum>& spectrum,
              const Asked& asked, TableRow& row, RowCounts& counts) const {
    counts.potentials += asked.wanted.has(Column::energy);
    if (spectrum) fill_spectrum(*spectrum, row);
    counts.spectra += asked.parts.spectrum;
    counts.scalar_spectra += asked.parts.spectrum;
    if (asked.parts.certificate) (void)prove_row(kind, found, spectrum, row);
    tell_in(input_.coordinates, asked.wanted, row);
  }

  const Case& input_;
  std::vector<double> x_;
  std::vector<double> y_;  ///< one number where the grid has no y
  std::optional<int> number_;
  bool together_;
};

}  // namespace

CellStatus cell_status(SolveStatus status) {
  switch (status) {
    case SolveStatus::solved:
      return CellStatus::solved;
    case SolveStatus::none_exists:
      return CellStatus::none_exists;
    case SolveStatus::not_found:
      return CellStatus::not_found;
    default:
      return CellStatus::failed;
  }
}

std::optional<PlanItem> rows_together(const Case& input) {
  if (!number_of_rows(input.map.value(), input.motion)) return std::nullopt;
  return together(alternatives(input.body, input.potential, input.motion, /*anywhere=*/false));
}

std::unique_ptr<MapCells> map_cells(const Case& input) {
  if (has_lanes(input.motion) && MapGrid::takes(*input.map))
    return std::make_unique<MapGrid>(input);
  return std::make_unique<KindCells>(input);
}

}  // namespace stationary
