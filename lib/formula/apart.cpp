#include "lib/formula/apart.hpp"

#include "lib/formula/facts.hpp"

namespace stationary::expression {
namespace {

constexpr std::initializer_list<Variable> of_plane{
    Variable::alpha, Variable::xi,     Variable::zeta, Variable::t,
    Variable::d,     Variable::lambda, Variable::mu,   Variable::first_invariant};
constexpr std::initializer_list<Variable> of_thickness{Variable::rho};

class Division {
 public:
  explicit Division(Graph& graph)
      : graph_(graph),
        plane_(graph.zero()),
        thickness_(graph.zero()),
        at_unit_plane_{{Variable::alpha, graph.zero()}} {
    for (const Variable v :
         {Variable::xi, Variable::zeta, Variable::d, Variable::lambda, Variable::mu})
      at_unit_plane_[v] = graph.one();
    for (const Variable v : {Variable::t, Variable::first_invariant})
      at_unit_plane_[v] = graph.number(2.0);
  }

  void add(NodeId addend) {
    const bool has_plane = occurs(graph_, addend, of_plane);
    if (!occurs(graph_, addend, of_thickness)) {
      plane_ = graph_.add({plane_, addend});
    } else if (!has_plane) {
      thickness_ = graph_.add({thickness_, addend});
    } else {
      has_mixed_ = true;
      const NodeId at_one = substitute(graph_, addend, {{Variable::rho, graph_.one()}});
      plane_ = graph_.add({plane_, at_one});
      thickness_ =
          graph_.add({thickness_, graph_.subtract({substitute(graph_, addend, at_unit_plane_),
                                                   substitute(graph_, at_one, at_unit_plane_)})});
    }
  }

  NodeId plane() const { return plane_; }
  NodeId thickness() const { return thickness_; }
  /// Whether one of the addends was in both, and is divided by its values at the unit stretches.
  bool has_mixed() const { return has_mixed_; }

 private:
  Graph& graph_;
  NodeId plane_;
  NodeId thickness_;
  bool has_mixed_ = false;
  std::map<Variable, NodeId> at_unit_plane_;
};

}  // namespace

std::optional<PlaneAndThickness> taken_apart(const Expression& whole) {
  Expression e = whole;
  Graph& g = e.graph;
  const NodeId root = g.expanded(e.root);
  Division parts(g);
  if (!g.is_coefficient(root) && g[root].kind == Kind::sum) {
    const Node sum = g[root];
    parts.add(sum.a);
    for (const Term& term : sum.terms) parts.add(g.multiply({term.coefficient, term.node}));
  } else {
    parts.add(root);
  }
  // The unit stretches may be none of its domain.
  if (parts.has_mixed() && !e.conditions.empty()) return std::nullopt;
  if (!occurs(g, parts.plane(), of_plane) || !occurs(g, parts.thickness(), of_thickness))
    return std::nullopt;
  Expression rest = e;
  rest.root = rest.graph.subtract({root, rest.graph.add({parts.plane(), parts.thickness()})});
  const NodeId difference = rest.graph.expanded(in_stretch(rest));
  if (!Facts::holds(vanishes(rest.graph, difference, e.parameters.size()))) return std::nullopt;
  PlaneAndThickness out{e, e};
  out.plane.root = parts.plane();
  out.thickness.root = parts.thickness();
  for (Expression* part : {&out.plane, &out.thickness}) part->conditions.clear();
  for (const Condition& each : e.conditions) {
    const bool of_the_plane = occurs(g, each.node, of_plane);
    if (of_the_plane && occurs(g, each.node, of_thickness)) return std::nullopt;
    (of_the_plane ? out.plane : out.thickness).conditions.push_back(each);
  }
  return out;
}

}  // namespace stationary::expression
