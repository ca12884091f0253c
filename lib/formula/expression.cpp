#include "lib/formula/expression.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include "lib/expression/differentiate.hpp"
#include "lib/expression/principal_pairs.hpp"
#include "lib/expression/slopes.hpp"
#include "lib/formula/circle_smoothness.hpp"
#include "lib/formula/facts.hpp"
#include "lib/tape/tape_run.hpp"

namespace stationary::expression {
namespace {

NodeId rebuilt(Graph& g, const Node& node, const std::map<NodeId, NodeId>& now) {
  switch (node.kind) {
    case Kind::sum: {
      NodeId out = node.a;
      for (const Term& term : node.terms)
        out = g.add({out, g.multiply({term.coefficient, now.at(term.node)})});
      return out;
    }
    case Kind::product: {
      NodeId out = g.one();
      for (const Term& factor : node.terms)
        out = g.multiply({out, g.power(now.at(factor.node), factor.exponent)});
      return out;
    }
    case Kind::function:
      return g.apply(node.function, now.at(node.a));
    case Kind::power:
      return g.power(now.at(node.a), node.b);
    case Kind::kernel:
      return g.kernel(node.function, node.index, now.at(node.a), now.at(node.b), now.at(node.c),
                      node.terms[0].node);
    default:
      throw std::logic_error("a leaf has nothing to rebuild");
  }
}

/// The exponent of v in a factor of a sum.
int exponent_of(const Graph& g, NodeId term, NodeId v) {
  if (term == v) return 1;
  if (g[term].kind != Kind::product) return 0;
  for (const Term& factor : g[term].terms)
    if (factor.node == v) return factor.exponent;
  return 0;
}

/// A sum with its powers of v as in Horner's rule, so that v stands in it as rarely as can be.
NodeId gathered(Graph& g, NodeId x, NodeId v) {
  if (g.is_coefficient(x) || g[x].kind != Kind::sum) return x;
  const Node sum = g[x];
  int lowest = Graph::largest_exponent;
  int count = 0;
  for (const Term& term : sum.terms) {
    const int n = exponent_of(g, term.node, v);
    if (n < 1) continue;
    lowest = std::min(lowest, n);
    ++count;
  }
  if (count < 2) return x;
  NodeId with = g.zero();
  NodeId without = sum.a;
  for (const Term& term : sum.terms) {
    NodeId part = g.multiply({term.coefficient, term.node});
    if (exponent_of(g, term.node, v) < 1) {
      without = g.add({without, part});
    } else {
      part = g.multiply({part, g.power(v, -lowest)});
      with = g.add({with, part});
    }
  }
  with = gathered(g, with, v);
  return g.add({without, g.multiply({with, g.power(v, lowest)})});
}

NodeId gathered(Graph& g, NodeId x) {
  NodeId out = g.expanded(x);
  for (const Variable v : {Variable::xi, Variable::zeta, Variable::rho})
    out = gathered(g, out, g.variable(v));
  return out;
}

/// lambda = (t + sqrt(t^2 - 4 d))/2 and mu = d/lambda, for conditions, which need not be smooth.
std::map<Variable, NodeId> ordered_stretches(Graph& g, NodeId t, NodeId d, NodeId discriminant) {
  const NodeId root = g.apply(Function::sqrt, discriminant);
  const NodeId lambda = g.multiply({g.number(0.5), g.add({t, root})});
  return {{Variable::lambda, lambda}, {Variable::mu, g.divide({d, lambda})}};
}

/// Conditions of an isotropic expression as its tape evaluates it.
NodeId condition_in_invariants(Graph& g, NodeId x) {
  const NodeId t = g.variable(Variable::t);
  const NodeId d = g.variable(Variable::d);
  auto by = ordered_stretches(g, t, d, g.variable(Variable::discriminant));
  by[Variable::first_invariant] = g.subtract({g.power(t, 2), g.multiply({g.number(2.0), d})});
  by[Variable::alpha] = g.zero();
  by[Variable::xi] = by[Variable::lambda];
  by[Variable::zeta] = by[Variable::mu];
  return substitute(g, x, by);
}

struct Direction {
  Coordinate coordinate;
  Variable stretch;
  Variable rate;
};

/// Gradient of V - (c x^2 + ...)/2 in the logarithms and its Hessian's upper triangle.
std::vector<NodeId> balance(Graph& g, NodeId potential, std::span<const Direction> directions) {
  std::vector<Differentiation> d;
  for (const Direction& direction : directions) d.emplace_back(g, direction.coordinate);
  const auto pull = [&](const Direction& direction) {
    return g.multiply({g.variable(direction.rate), g.power(g.variable(direction.stretch), 2)});
  };
  std::vector<NodeId> out;
  std::vector<NodeId> force;
  for (std::size_t i = 0; i < d.size(); ++i) {
    force.push_back(g.subtract({d[i](potential), pull(directions[i])}));
    out.push_back(gathered(g, force[i]));
  }
  for (std::size_t i = 0; i < d.size(); ++i)
    for (std::size_t j = i; j < d.size(); ++j) out.push_back(gathered(g, d[j](force[i])));
  return out;
}

/// Value, then the gradient, then the Hessian's upper triangle by rows.
std::vector<NodeId> with_derivatives(Graph& g, NodeId potential,
                                     std::span<const Coordinate> coordinates) {
  std::vector<Differentiation> d;
  for (const Coordinate coordinate : coordinates) d.emplace_back(g, coordinate);
  std::vector<NodeId> out{potential};
  for (Differentiation& by : d) out.push_back(g.expanded(by(potential)));
  for (std::size_t i = 0; i < d.size(); ++i)
    for (std::size_t j = i; j < d.size(); ++j) out.push_back(g.expanded(d[j](out[1 + i])));
  return out;
}

/// Where an expression that fits gets more than there is room for, it does without slopes. valued:
/// with the numbers themselves, first.
Program slopes(TapeWriter& writer, Graph& graph, std::span<const NodeId> of, bool valued,
               std::span<const Variable> inputs, const std::vector<std::string>& parameters) {
  std::vector<Variable> all(inputs.begin(), inputs.end());
  for (int k = 0; k < static_cast<int>(parameters.size()); ++k)
    all.push_back(parameter_variable(k));
  try {
    const auto results = parameter_slopes(graph, of, static_cast<int>(parameters.size()));
    const std::size_t values = valued || results.empty() ? 0 : of.size();
    return writer.program(all, std::span(results).subspan(values));
  } catch (const TooLarge&) {
    return {};
  }
}

/// The derivative by a factor of alpha, xi and zeta alike.
Program plane_pull(TapeWriter& writer, Graph& graph, NodeId potential,
                   std::span<const Variable> inputs) {
  const std::array<NodeId, 1> pull{Differentiation(graph, Coordinate::log_plane)(potential)};
  try {
    return writer.program(inputs, pull);
  } catch (const TooLarge&) {
    return {};
  }
}

/// A condition in what a program is given.
using ConditionForm = NodeId (*)(Graph& graph, NodeId x);

/// A tape to which the programs are added that its model reads.
class TapeInMaking {
 public:
  /// With value and derivatives.
  TapeInMaking(Expression& e, NodeId smooth, std::span<const Coordinate> coordinates,
               std::span<const Variable> inputs, ConditionForm form)
      : e_(e),
        inputs_(inputs),
        form_(form),
        derivatives_(with_derivatives(e.graph, smooth, coordinates)),
        gradient_size_(1 + coordinates.size()),
        writer_(e.graph) {
    note_conditions();
    const std::vector<NodeId> conditions = conditions_as(form);
    out_.evaluate[0] = program(inputs, std::span(derivatives_).first(1), conditions);
    out_.evaluate[1] = program(inputs, gradient(), conditions);
    out_.evaluate[2] = program(inputs, derivatives_, conditions);
    out_.has_principal_stretches = occurs(e.graph, smooth, {Variable::discriminant});
  }

  void keep_source(std::shared_ptr<const Expression> source) { out_.source = std::move(source); }

  void add_balance(std::span<const Direction> directions, std::span<const Variable> inputs) {
    balance_inputs_ = inputs;
    forces_ = balance(e_.graph, at_principal_axes(e_.graph, e_.root), directions);
    balance_conditions_ = conditions_as(condition_at_principal_axes);
    direction_count_ = directions.size();
    out_.balance = program(inputs, forces_, balance_conditions_);
  }
  void add_forces() {
    const std::vector<NodeId> conditions = conditions_as(form_);
    out_.forces[0] = program(inputs_, gradient().subspan(1), conditions);
    out_.forces[1] = program(inputs_, std::span(derivatives_).subspan(1), conditions);
  }
  /// After add_balance().
  void add_residual() { out_.residual = program(balance_inputs_, residual(), balance_conditions_); }
  void add_slopes() {
    out_.slopes = slopes(writer_, e_.graph, gradient(), true, inputs_, e_.parameters);
  }
  /// After add_balance().
  void add_residual_slopes() {
    out_.residual_slopes =
        slopes(writer_, e_.graph, residual(), false, balance_inputs_, e_.parameters);
  }
  /// Of an expression in alpha, xi, zeta and rho.
  void add_plane_pull() {
    out_.plane_pull = plane_pull(writer_, e_.graph, derivatives_[0], inputs_);
  }

  std::shared_ptr<const Tape> finished() {
    out_.coefficients = writer_.coefficients();
    out_.fixed_constants.resize(out_.coefficients.constants.size());
    std::array<double, largest_parameter_count> any_parameters;
    any_parameters.fill(1.0);
    compute_constants<double>(out_.coefficients, any_parameters.data(),
                              out_.fixed_constants.data());
    out_.text = e_.text;
    out_.parameters = e_.parameters;
    out_.assumed = e_.assumed;
    out_.whole = e_.whole;
    return std::make_shared<Tape>(std::move(out_));
  }

 private:
  std::span<const NodeId> gradient() const { return std::span(derivatives_).first(gradient_size_); }
  std::span<const NodeId> residual() const { return std::span(forces_).first(direction_count_); }

  void note_conditions() {
    for (const Condition& each : e_.conditions) {
      const TapeCondition condition{each.text, each.positive};
      if (e_.graph.is_coefficient(each.node)) {
        out_.coefficient_conditions.push_back({condition, writer_.constant(each.node)});
      } else {
        out_.conditions.push_back(condition);
      }
    }
    if (out_.conditions.size() > largest_tape_condition_count)
      throw TooLarge("a formula with at most " + std::to_string(largest_tape_condition_count) +
                     " conditions (logarithms, roots, powers and denominators that may vanish)");
  }
  std::vector<NodeId> conditions_as(ConditionForm form) {
    std::vector<NodeId> out;
    for (const Condition& each : e_.conditions)
      if (!e_.graph.is_coefficient(each.node)) out.push_back(form(e_.graph, each.node));
    return out;
  }
  Program program(std::span<const Variable> inputs, std::span<const NodeId> results,
                  std::span<const NodeId> conditions) {
    std::vector<NodeId> all(results.begin(), results.end());
    all.insert(all.end(), conditions.begin(), conditions.end());
    return writer_.program(inputs, all);
  }

  Expression& e_;
  std::span<const Variable> inputs_;
  ConditionForm form_;
  std::vector<NodeId> derivatives_;
  std::size_t gradient_size_;
  std::span<const Variable> balance_inputs_;
  std::vector<NodeId> forces_;
  std::vector<NodeId> balance_conditions_;
  std::size_t direction_count_ = 0;
  TapeWriter writer_;
  Tape out_;
};

/// Of models that are solved in (ln xi, ln zeta) and more, with error bounds.
std::shared_ptr<const Tape> balanced_tape(Expression& e, std::span<const Coordinate> coordinates,
                                          std::span<const Variable> inputs,
                                          std::span<const Direction> directions,
                                          std::span<const Variable> balance_inputs) {
  auto source = std::make_shared<const Expression>(e);
  TapeInMaking out(e, in_invariants(e), coordinates, inputs, condition_in_invariants);
  out.keep_source(std::move(source));
  out.add_forces();
  out.add_balance(directions, balance_inputs);
  out.add_residual();
  out.add_slopes();
  out.add_residual_slopes();
  return out.finished();
}

void require_room(const Expression& e) {
  const std::array<NodeId, 1> root{e.root};
  if (e.graph.parts(root).size() > largest_node_count)
    throw TooLarge("an expression of at most " + std::to_string(largest_node_count) +
                   " different parts");
  if (e.parameters.size() > largest_parameter_count)
    throw TooLarge("at most " + std::to_string(largest_parameter_count) + " parameters");
}

/// The terms of a sum without alpha, xi and zeta, and the others; false where either are none.
bool split_by_directions(Expression& e, NodeId& without, NodeId& with) {
  Graph& g = e.graph;
  if (g.is_coefficient(e.root) || g[e.root].kind != Kind::sum) return false;
  const Node sum = g[e.root];
  int of_invariants = 0;
  without = sum.a;
  with = g.zero();
  for (const Term& term : sum.terms) {
    const bool directed = occurs(g, term.node, {Variable::alpha, Variable::xi, Variable::zeta});
    NodeId& part = directed ? with : without;
    part = g.add({part, g.multiply({term.coefficient, term.node})});
    of_invariants += !directed;
  }
  return of_invariants > 0 && !g.is_zero(with);
}

constexpr Direction along_xi{Coordinate::log_xi, Variable::xi, Variable::rate_xi};
constexpr Direction along_zeta{Coordinate::log_zeta, Variable::zeta, Variable::rate_zeta};
constexpr Direction along_rho{Coordinate::log_rho, Variable::rho, Variable::rate_rho};

}  // namespace

NodeId substitute(Graph& g, NodeId x, const std::map<Variable, NodeId>& by) {
  const std::array<NodeId, 1> root{x};
  std::map<NodeId, NodeId> now;
  for (const NodeId id : g.parts(root)) {
    const Node node = g[id];
    NodeId out = id;
    if (node.kind == Kind::variable) {
      const auto found = by.find(static_cast<Variable>(node.index));
      if (found != by.end()) out = found->second;
    } else if (!g.is_coefficient(id)) {
      out = rebuilt(g, node, now);
    }
    now.emplace(id, out);
  }
  return now.at(x);
}

namespace {

/// The invariants in alpha, xi and zeta.
std::map<Variable, NodeId> invariants_in_stretch(Graph& g) {
  const NodeId alpha2 = g.power(g.variable(Variable::alpha), 2);
  const NodeId xi = g.variable(Variable::xi);
  const NodeId zeta = g.variable(Variable::zeta);
  const auto number = [&](double x) { return g.number(x); };
  return {{Variable::t, g.add({xi, zeta})},
          {Variable::d, g.subtract({g.multiply({xi, zeta}), alpha2})},
          {Variable::first_invariant,
           g.add({g.add({g.power(xi, 2), g.power(zeta, 2)}), g.multiply({number(2.0), alpha2})})},
          {Variable::discriminant,
           g.add({g.power(g.subtract({xi, zeta}), 2), g.multiply({number(4.0), alpha2})})}};
}

}  // namespace

NodeId in_stretch(Expression& e) {
  const NodeId smooth = without_principal_stretches(e);
  return substitute(e.graph, smooth, invariants_in_stretch(e.graph));
}

NodeId condition_in_stretch(Graph& g, NodeId x) {
  auto by = invariants_in_stretch(g);
  by.merge(ordered_stretches(g, by[Variable::t], by[Variable::d], by[Variable::discriminant]));
  return substitute(g, x, by);
}

NodeId at_principal_axes(Graph& g, NodeId x) {
  const NodeId xi = g.variable(Variable::xi);
  const NodeId zeta = g.variable(Variable::zeta);
  return substitute(g, x,
                    {{Variable::alpha, g.zero()},
                     {Variable::t, g.add({xi, zeta})},
                     {Variable::d, g.multiply({xi, zeta})},
                     {Variable::lambda, xi},
                     {Variable::mu, zeta},
                     {Variable::first_invariant, g.add({g.power(xi, 2), g.power(zeta, 2)})}});
}

NodeId condition_at_principal_axes(Graph& g, NodeId x) {
  const NodeId xi = g.variable(Variable::xi);
  const NodeId zeta = g.variable(Variable::zeta);
  const NodeId t = g.add({xi, zeta});
  const NodeId d = g.multiply({xi, zeta});
  const NodeId discriminant = g.power(g.subtract({xi, zeta}), 2);
  return at_principal_axes(g, substitute(g, x, ordered_stretches(g, t, d, discriminant)));
}

NodeId in_invariants(Expression& e) {
  Graph& g = e.graph;
  if (occurs(g, e.root, {Variable::alpha, Variable::xi, Variable::zeta})) {
    if (!Facts::holds(isotropy(e)))
      throw Unsuitable("not isotropic: it changes when the body's axes turn");
    // Then it is what it is in the principal axes.
    e.root = substitute(g, e.root,
                        {{Variable::alpha, g.zero()},
                         {Variable::xi, g.variable(Variable::lambda)},
                         {Variable::zeta, g.variable(Variable::mu)}});
  }
  require_smooth_at_circle(e);
  const NodeId t = g.variable(Variable::t);
  const NodeId d = g.variable(Variable::d);
  return substitute(
      g, without_principal_stretches(e),
      {{Variable::first_invariant, g.subtract({g.power(t, 2), g.multiply({g.number(2.0), d})})}});
}

std::shared_ptr<const Tape> planar_tape(Expression e) {
  require_room(e);
  constexpr std::array coordinates{Coordinate::t, Coordinate::log_d};
  constexpr std::array directions{along_xi, along_zeta};
  return balanced_tape(e, coordinates, planar_inputs, directions, planar_balance_inputs);
}

std::shared_ptr<const Tape> thickness_tape(Expression e) {
  require_room(e);
  constexpr std::array coordinates{Coordinate::log_rho};
  constexpr std::array directions{along_rho};
  auto source = std::make_shared<const Expression>(e);
  TapeInMaking out(e, e.root, coordinates, thickness_inputs, condition_in_invariants);
  out.keep_source(std::move(source));
  out.add_forces();
  out.add_balance(directions, thickness_balance_inputs);
  out.add_slopes();
  out.add_residual_slopes();
  return out.finished();
}

std::shared_ptr<const Tape> coupled_tape(Expression e) {
  require_room(e);
  constexpr std::array coordinates{Coordinate::t, Coordinate::log_d, Coordinate::log_rho};
  constexpr std::array directions{along_xi, along_zeta, along_rho};
  return balanced_tape(e, coordinates, coupled_inputs, directions, coupled_balance_inputs);
}

std::shared_ptr<const Tape> anisotropic_tape(Expression e) {
  require_room(e);
  require_smooth_at_circle(e);
  constexpr std::array coordinates{Coordinate::alpha, Coordinate::xi, Coordinate::zeta,
                                   Coordinate::rho};
  TapeInMaking out(e, in_stretch(e), coordinates, anisotropic_inputs, condition_in_stretch);
  out.add_plane_pull();
  return out.finished();
}

std::shared_ptr<const Tape> oriented_tape(Expression e) {
  require_room(e);
  const Verdict shear = shear_freedom(e);
  const bool shear_free = Facts::holds(shear);
  const bool even = shear_free && Facts::holds(evenness(e));
  const auto finished = [&](const Tape& directed, std::shared_ptr<const Tape> isotropic) {
    auto out = std::make_shared<Tape>(directed);
    out->text = e.text;
    out->isotropic_terms = std::move(isotropic);
    out->shear_free = shear_free;
    out->sheared = shear == Verdict::refuted;
    out->even = even;
    return out;
  };
  NodeId without = 0;
  NodeId with = 0;
  if (split_by_directions(e, without, with)) {
    Expression isotropic = e;
    Expression directed = e;  // with all of the conditions
    isotropic.conditions.clear();
    isotropic.root = without;
    directed.root = with;
    try {
      auto terms = coupled_tape(std::move(isotropic));
      return finished(*anisotropic_tape(std::move(directed)), std::move(terms));
    } catch (const Unsuitable&) {  // lambda and mu_ are symmetric in both parts together only
    }
  }
  return finished(*anisotropic_tape(e), nullptr);
}

}  // namespace stationary::expression
