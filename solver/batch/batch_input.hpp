// The numbers of many families at once (batch.hpp): each lane is a body and potential of its own,
// all of one branch and the same models.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "solver/motion/family_parameter.hpp"
#include "solver/motion/problem.hpp"

namespace stationary {

/// One number of every lane: the same in all of them, or one each.
class LaneValues {
 public:
  LaneValues(double all) : values_{all} {}  // NOLINT(google-explicit-constructor)
  LaneValues(std::vector<double> each)
      : values_(std::move(each)) {}  // NOLINT(google-explicit-constructor)
  double operator[](std::size_t lane) const {
    return values_.size() == 1 ? values_[0] : values_[lane];
  }
  /// 1 or the number of lanes.
  std::size_t size() const { return values_.size(); }

 private:
  std::vector<double> values_;
};

struct BatchInput {
  /// All lanes as the problem is; then put numbers of their own where they differ.
  BatchInput(const Problem& problem, std::size_t lane_count, std::vector<double> nu_values);

  Branch branch;
  Potential potential;  ///< which models; the coefficients are those below
  std::size_t lanes;
  std::array<LaneValues, 3> inertia;  ///< J1, J2, J3
  std::vector<LaneValues> plane;      ///< coefficients of the planar, or of the coupled, model
  std::vector<LaneValues> thickness;  ///< of a separable potential's thickness
  std::vector<LaneValues> fibres;     ///< k and degrees of each of an anisotropic potential's
  LaneValues speed = 1.0;             ///< nu = speed nu_k (rounded)
  std::vector<double> nu;             ///< in any order, of any sign: nu and -nu are one

  /// The number that a family's parameter names, of its own in every lane; not nu.
  void vary(const FamilyParameter& what, std::vector<double> values);

  Potential potential_at(std::size_t lane) const;
  Problem problem(std::size_t lane) const;
};

/// Whether its lanes go in packs (batch.hpp): built in and separable. Others take the scalar path.
inline bool marches(const Potential& potential) {
  return potential.is_built_in() && potential.is_separable();
}

/// Throws std::invalid_argument: a nu that is not finite, a body or coefficient outside its domain
/// (with the violated inequality), numbers of lanes that do not fit.
void require_valid(const BatchInput& input);

}  // namespace stationary
