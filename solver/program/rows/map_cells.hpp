// The cells of a map (case_grid.hpp), solved and as rows of a table. Rows are numbered as they are
// written: x runs fastest. What is found of a cell depends on no other row that is asked for.
//
// About a material axis cells of one body are solved together (map_grid.hpp). Of other kinds of
// motion each is what `solve` finds, on the sheet that is connected to rest where there is one: by
// itself, or, where x is a number of the motion and the kind has motions at many values together, for a
// row of the grid at once.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/table/table.hpp"

namespace stationary {

/// What making rows took.
struct RowCounts {
  long scalar_lanes = 0;    ///< that did not go in packs, of those whose first row is among them
  long potentials = 0;      ///< for energies
  long spectra = 0;         ///< with modes or without
  long scalar_spectra = 0;  ///< of these by the scalar path

  RowCounts& operator+=(const RowCounts& more) {
    scalar_lanes += more.scalar_lanes;
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
  /// How many rows are worth making together, from one multiple of it to the next.
  virtual std::size_t tile() const = 0;
  /// Whether they go in packs of lanes (batch.hpp).
  virtual bool marches() const = 0;

  /// Rows `first` ... `last` - 1 into out: point, motion, stretch, errors, status, both parameters;
  /// spectra and proofs if the parts have them, and of all of it what the wanted columns need. Once
  /// stop is true (it may be null) rows may be left out. May be called by several threads.
  virtual RowCounts rows(std::size_t first, std::size_t last, const RowParts& parts,
                         const ColumnSet& wanted, const std::atomic<bool>* stop,
                         std::vector<TableRow>& out) const = 0;
};

CellStatus cell_status(SolveStatus status);

/// For a person, how the cells of a row are had together; nothing where each is solved by itself. Not asked
/// about a material axis. input: with a map (std::bad_optional_access otherwise).
std::optional<PlanItem> rows_together(const Case& input);

/// input: with a map (std::bad_optional_access otherwise). It must outlive the cells.
std::unique_ptr<MapCells> map_cells(const Case& input);

}  // namespace stationary
