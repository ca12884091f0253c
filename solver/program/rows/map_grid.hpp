// The cells of a map about a material axis: a case's grid (case_grid.hpp) as batches (batch.hpp).
//
// A lane is the grid's other parameter than nu, or every cell where neither is nu. Lanes are solved
// in groups, for all nu at once, when a row of theirs is first asked for; those not asked for any more
// are forgotten.
#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "solver/batch/batch.hpp"
#include "solver/program/rows/map_cells.hpp"

namespace stationary {

class MapGrid final : public MapCells {
 public:
  /// input: with a map, of an axis rotation (std::bad_optional_access, std::bad_variant_access
  /// otherwise). It must outlive this.
  explicit MapGrid(const Case& input);
  /// Not a spin over a number that varies too, nor that over the spin: nu would be another in every lane, the
  /// body another at every nu.
  static bool takes(const CaseMap& map);

  std::size_t size() const override { return x_.size() * y_.size(); }
  std::size_t tile() const override;
  bool marches() const override { return stationary::marches(potential_); }
  /// A cell whose residual, recomputed, is none of an equilibrium's is `failed`.
  RowCounts rows(std::size_t first, std::size_t last, const RowParts& parts,
                 const ColumnSet& wanted, const std::atomic<bool>* stop,
                 std::vector<TableRow>& out) const override;

 private:
  struct Place {
    std::size_t lane;
    std::size_t step;
  };
  /// Neighbouring lanes, solved.
  struct Group {
    std::mutex solving;
    std::unique_ptr<BatchInput> batch;  ///< none: not begun
    BatchResult solved;
    std::size_t last_use = 0;
  };
  using Groups = std::vector<std::shared_ptr<Group>>;

  Place place(std::size_t row) const;
  std::size_t lanes() const;
  /// Row's number of an axis, in the case's units.
  double value(std::size_t row, bool of_x) const;
  BatchInput batch(std::size_t group) const;
  /// All from one group to another, solved.
  Groups solved(std::size_t first, std::size_t last, const std::atomic<bool>* stop) const;
  std::shared_ptr<Group> known(std::size_t group) const;
  void forget() const;

  const Case& input_;
  Branch branch_;
  Potential potential_;
  std::vector<double> x_;
  std::vector<double> y_;  ///< one number where the grid has no y
  double x_unit_;          ///< what x's number is at 1 (parameter_unit()), y held
  double y_unit_;
  bool x_is_nu_;
  bool y_is_nu_;
  std::vector<double> nu_;
  std::size_t group_;  ///< lanes of one
  std::size_t most_groups_;

  mutable std::mutex mutex_;  ///< of what follows
  mutable std::map<std::size_t, std::shared_ptr<Group>> groups_;
  mutable std::size_t uses_ = 0;
};

}  // namespace stationary
