// A case's grid (case_grid.hpp) as a batch (batch.hpp), and its cells as rows of a table.
//
// Rows are numbered as they are written: x runs fastest. Lanes of the batch are the grid's other
// parameter, or every cell where neither is nu.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "solver/batch/batch.hpp"
#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/table/table.hpp"

namespace stationary {

/// What making rows took.
struct RowCounts {
  long potentials = 0;      ///< for energies
  long spectra = 0;         ///< with modes or without
  long scalar_spectra = 0;  ///< of these by the scalar path

  RowCounts& operator+=(const RowCounts& more) {
    potentials += more.potentials;
    spectra += more.spectra;
    scalar_spectra += more.scalar_spectra;
    return *this;
  }
};

class MapGrid {
 public:
  /// input: with a map, of an axis rotation (std::bad_optional_access, std::bad_variant_access
  /// otherwise). It must outlive this.
  explicit MapGrid(const Case& input);

  const BatchInput& batch() const { return batch_; }
  std::size_t size() const { return x_.size() * y_.size(); }

  /// Rows `first` ... `last` - 1 of a solved batch into out, those not run left out: point,
  /// motion, stretch, errors, status, both parameters; spectra and proofs if the parts have them,
  /// and of all of it what the wanted columns need. A cell whose residual, recomputed, is none of
  /// an equilibrium's is `failed`.
  RowCounts rows(const BatchResult& solved, std::size_t first, std::size_t last,
                 const RowParts& parts, const ColumnSet& wanted, std::vector<TableRow>& out) const;

 private:
  struct Place {
    std::size_t lane;
    std::size_t step;
  };
  Place place(std::size_t row) const;

  Branch branch_;
  std::vector<double> x_;
  std::vector<double> y_;  ///< one number where the grid has no y
  bool x_is_nu_;
  bool y_is_nu_;
  BatchInput batch_;
};

}  // namespace stationary
