// The cells of a map (case_grid.hpp), solved and as rows of a table. Rows are numbered as they are
// written: x runs fastest.
//
// About a material axis all cells are solved at once (map_grid.hpp). Of other kinds of motion each
// is solved by itself when its row is made, as `solve` does, on the sheet that is connected to rest
// where there is one.
#pragma once

#include <cstddef>
#include <memory>
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

class MapCells {
 public:
  MapCells() = default;
  MapCells(const MapCells&) = delete;
  MapCells& operator=(const MapCells&) = delete;
  virtual ~MapCells() = default;

  virtual std::size_t size() const = 0;
  /// How many rows are worth making together.
  virtual std::size_t block() const = 0;
  /// Whether they go in packs of lanes (batch.hpp).
  virtual bool marches() const = 0;
  /// Lanes that did not go in packs; all where there are no lanes.
  virtual std::size_t scalar_lanes() const = 0;

  /// What is done of all cells before their rows are made; a stop in the options holds for these
  /// too.
  virtual void solve(const BatchOptions& options) = 0;

  /// Rows `first` ... `last` - 1 into out, those not run left out: point, motion, stretch, errors,
  /// status, both parameters; spectra and proofs if the parts have them, and of all of it what the
  /// wanted columns need. May be called by several threads.
  virtual RowCounts rows(std::size_t first, std::size_t last, const RowParts& parts,
                         const ColumnSet& wanted, std::vector<TableRow>& out) const = 0;
};

CellStatus cell_status(SolveStatus status);

/// input: with a map (std::bad_optional_access otherwise). It must outlive the cells.
std::unique_ptr<MapCells> map_cells(const Case& input);

}  // namespace stationary
