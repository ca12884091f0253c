// The cells of a map about a material axis: a case's grid (case_grid.hpp) as a batch (batch.hpp).
//
// Lanes of the batch are the grid's other parameter than nu, or every cell where neither is nu.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "solver/batch/batch.hpp"
#include "solver/program/rows/map_cells.hpp"

namespace stationary {

class MapGrid final : public MapCells {
 public:
  /// input: with a map, of an axis rotation (std::bad_optional_access, std::bad_variant_access
  /// otherwise). It must outlive this.
  explicit MapGrid(const Case& input);
  /// Not a spin over a number that varies too: nu would be another in every lane.
  static bool takes(const CaseMap& map);

  std::size_t size() const override { return x_.size() * y_.size(); }
  std::size_t block() const override { return batch_.potential.is_isotropic() ? 512 : 32; }
  bool marches() const override { return stationary::marches(batch_.potential); }
  std::size_t scalar_lanes() const override { return solved_.fallbacks(); }
  void solve(const BatchOptions& options) override { solve_batch(batch_, options, solved_); }
  /// A cell whose residual, recomputed, is none of an equilibrium's is `failed`.
  RowCounts rows(std::size_t first, std::size_t last, const RowParts& parts,
                 const ColumnSet& wanted, std::vector<TableRow>& out) const override;

 private:
  struct Place {
    std::size_t lane;
    std::size_t step;
  };
  Place place(std::size_t row) const;

  Branch branch_;
  std::vector<double> x_;
  std::vector<double> y_;  ///< one number where the grid has no y
  double x_unit_;          ///< what x's number is at 1 (parameter_unit()), y held
  double y_unit_;
  bool x_is_nu_;
  bool y_is_nu_;
  BatchInput batch_;
  BatchResult solved_;
};

}  // namespace stationary
