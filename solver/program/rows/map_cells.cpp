#include "solver/program/rows/map_cells.hpp"

#include <limits>
#include <optional>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/program/rows/map_grid.hpp"

namespace stationary {
namespace {

/// Each cell by itself, of any kind of motion.
class SingleCells final : public MapCells {
 public:
  explicit SingleCells(const Case& input)
      : input_(input),
        x_(input.map.value().x.values()),
        y_(input.map->y ? input.map->y->values()
                        : std::vector<double>{std::numeric_limits<double>::quiet_NaN()}) {}

  std::size_t size() const override { return x_.size() * y_.size(); }
  std::size_t tile() const override { return 8; }
  bool marches() const override { return false; }

  RowCounts rows(std::size_t first, std::size_t last, const RowParts& parts,
                 const ColumnSet& wanted, const std::atomic<bool>* stop,
                 std::vector<TableRow>& out) const override {
    out.clear();
    RowCounts counts{.scalar_lanes = static_cast<long>(last - first)};
    for (std::size_t k = first; k < last; ++k) {
      const FamilyParameters at = at_cell(k);
      const Alternatives kinds =
          alternatives(at.body, make_potential(at.models, at.body), at.motion, /*anywhere=*/false);
      SolveOptions how;
      how.stop = stop;
      const auto [found, kind] = first_found(kinds, how);
      if (found.status == SolveStatus::interrupted) continue;
      TableRow& row = out.emplace_back();
      row.branch = name(at.motion);
      row[Column::point] = static_cast<double>(k);
      row.parameter = x_[k % x_.size()];
      row.second_parameter = y_[k / x_.size()];
      const CellStatus status = cell_status(found.status);
      row.status = name(status);
      if (status != CellStatus::solved) continue;
      fill_row(name(at.motion), at.body, kind->potential(), found, wanted, row);
      counts.potentials += wanted.has(Column::energy);
      std::optional<Spectrum> spectrum;
      if (parts.spectrum) spectrum = kind->spectrum(found);
      if (spectrum) fill_spectrum(*spectrum, row);
      counts.spectra += parts.spectrum;
      counts.scalar_spectra += parts.spectrum;
      if (parts.certificate) (void)prove_row(*kind, found, spectrum, row);
      tell_in(input_.coordinates, wanted, row);
    }
    return counts;
  }

 private:
  FamilyParameters at_cell(std::size_t k) const {
    return input_.map->cell({input_.body, input_.models, input_.motion}, x_[k % x_.size()],
                            y_[k / x_.size()]);
  }

  const Case& input_;
  std::vector<double> x_;
  std::vector<double> y_;  ///< one number where the grid has no y
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

std::unique_ptr<MapCells> map_cells(const Case& input) {
  if (has_lanes(input.motion) && MapGrid::takes(*input.map))
    return std::make_unique<MapGrid>(input);
  return std::make_unique<SingleCells>(input);
}

}  // namespace stationary
