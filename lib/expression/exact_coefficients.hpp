// The exact numbers that the coefficients of a graph are, for given parameters.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "lib/expression/exact_number.hpp"
#include "lib/expression/graph.hpp"
#include "lib/expression/residue.hpp"

namespace stationary::expression {

class ExactCoefficients {
 public:
  /// Of what the roots are made of; parameters: their values. Throws NotNormal.
  ExactCoefficients(const Graph& graph, std::span<const NodeId> roots,
                    std::span<const Interval> parameters);

  /// Throws NotNormal: one that is not bounded.
  ExactNumber operator()(NodeId coefficient);

 private:
  Interval value(NodeId coefficient);

  const Graph& graph_;
  std::vector<Interval> parameters_;
  std::optional<ResiduePoint> residues_;
  std::map<NodeId, Interval> values_;
};

}  // namespace stationary::expression
