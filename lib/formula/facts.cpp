#include "lib/formula/facts.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "lib/expression/differentiate.hpp"
#include "lib/expression/principal_pairs.hpp"
#include "lib/formula/circle_smoothness.hpp"

namespace stationary::expression {
namespace {

std::string sentence(const std::string& what, Verdict verdict) {
  switch (verdict) {
    case Verdict::term_by_term:
      return what + ": holds term by term";
    case Verdict::exactly:
      return what + ": holds exactly";
    case Verdict::at_points:
      return what + ": holds at pseudo-random points to 20 digits";
    case Verdict::refuted:
      return what + ": does not hold";
    case Verdict::undecided:
      break;
  }
  return what + ": undecided, taken as not holding";
}

/// What the larger principal stretch is called: lambda may be a parameter.
std::string larger_stretch(const Expression& e) {
  return std::ranges::find(e.parameters, "lambda") == e.parameters.end() ? "lambda" : "lambda_";
}

Verdict separability(Expression& e, std::span<const double> values) {
  Graph& g = e.graph;
  const NodeId force = Differentiation(g, Coordinate::rho)(in_stretch(e));
  Verdict out = Verdict::term_by_term;
  for (const Coordinate c : {Coordinate::alpha, Coordinate::xi, Coordinate::zeta}) {
    const Verdict verdict =
        vanishes(g, g.expanded(Differentiation(g, c)(force)), e.parameters.size(), values);
    out = std::max(out, verdict);
  }
  return out;
}

constexpr std::array<std::pair<Variable, const char*>, 9> words{
    {{Variable::alpha, "alpha"},
     {Variable::xi, "xi"},
     {Variable::zeta, "zeta"},
     {Variable::rho, "rho"},
     {Variable::t, "t"},
     {Variable::d, "d"},
     {Variable::lambda, "lambda"},
     {Variable::mu, "mu_"},
     {Variable::first_invariant, "I1"}}};

}  // namespace

bool occurs(const Graph& graph, NodeId x, std::initializer_list<Variable> variables) {
  const std::array<NodeId, 1> root{x};
  return std::ranges::any_of(graph.parts(root), [&](NodeId id) {
    const Node& node = graph[id];
    return node.kind == Kind::variable &&
           std::ranges::find(variables, static_cast<Variable>(node.index)) != variables.end();
  });
}

NodeId without_principal_stretches(Expression& e, Verdict* how) {
  Graph& g = e.graph;
  if (how != nullptr) *how = Verdict::term_by_term;
  if (!occurs(g, e.root, {Variable::lambda, Variable::mu})) return e.root;
  const EvenOdd parts = split_at_circle(g, e.root);
  Expression odd = e;
  odd.root = parts.odd;
  const NodeId in_q = in_stretch(odd);
  const Verdict verdict = vanishes(odd.graph, in_q, e.parameters.size());
  if (how != nullptr) *how = verdict;
  if (Facts::holds(verdict)) return parts.even;
  const std::string lambda = larger_stretch(e);
  const std::string required =
      lambda +
      " and mu_ must enter symmetrically (exchanging them must change nothing): only then " +
      "is the potential smooth at the circle " + lambda + " = mu_";
  if (verdict == Verdict::refuted) throw Unsuitable(required);
  throw Unsuitable(
      required +
      ". Whether they do could not be decided: at nearly all of the points where it is tried "
      "(stretches and parameters of all sizes) what differs is not finite, or too small to tell. "
      "In t, d and I1 "
      "nothing is to be decided");
}

namespace {

/// Whether a function v of alpha, xi, zeta and rho is the same when the body's axes turn.
Verdict turns_with_body(Graph& g, NodeId v, std::size_t parameter_count,
                        std::span<const double> values) {
  const NodeId alpha = g.variable(Variable::alpha);
  const NodeId difference = g.subtract({g.variable(Variable::xi), g.variable(Variable::zeta)});
  const NodeId shear = Differentiation(g, Coordinate::alpha)(v);
  const NodeId stretch =
      g.subtract({Differentiation(g, Coordinate::zeta)(v), Differentiation(g, Coordinate::xi)(v)});
  const NodeId along_rotation = g.add(
      {g.multiply({shear, difference}), g.multiply({g.multiply({g.number(2.0), alpha}), stretch})});
  return vanishes(g, g.expanded(along_rotation), parameter_count, values);
}

bool has_axes(const Graph& g, NodeId x) {
  return occurs(g, x, {Variable::alpha, Variable::xi, Variable::zeta});
}

}  // namespace

Verdict isotropy(Expression& e, std::span<const double> values) {
  Graph& g = e.graph;
  const std::size_t count = e.parameters.size();
  Verdict out = Verdict::term_by_term;
  if (has_axes(g, e.root)) out = turns_with_body(g, in_stretch(e), count, values);
  for (const Condition& each : e.conditions)
    if (has_axes(g, each.node))
      out = std::max(out, turns_with_body(g, condition_in_stretch(g, each.node), count, values));
  return out;
}

Verdict shear_freedom(Expression& e, std::span<const double> values) {
  Graph& g = e.graph;
  const NodeId shear = Differentiation(g, Coordinate::alpha)(in_stretch(e));
  return vanishes(g, g.expanded(substitute(g, shear, {{Variable::alpha, g.zero()}})),
                  e.parameters.size(), values);
}

Verdict evenness(Expression& e, std::span<const double> values) {
  Graph& g = e.graph;
  const NodeId opposite = g.multiply({g.number(-1.0), g.variable(Variable::alpha)});
  const auto is_even = [&](NodeId v) {
    const NodeId mirrored = substitute(g, v, {{Variable::alpha, opposite}});
    return vanishes(g, g.expanded(g.subtract({v, mirrored})), e.parameters.size(), values);
  };
  const Verdict out = is_even(in_stretch(e));
  if (!Facts::holds(out)) return out;
  // A condition that is another one in the mirror does not say that the domain is: undecided.
  const bool all = std::ranges::all_of(e.conditions, [&](const Condition& each) {
    return !occurs(g, each.node, {Variable::alpha}) ||
           Facts::holds(is_even(condition_in_stretch(g, each.node)));
  });
  return all ? out : Verdict::undecided;
}

Facts facts(Expression e, Slot slot, std::span<const double> values) {
  Facts out;
  std::string names;
  for (const auto& [variable, word] : words) {
    if (!occurs(e.graph, e.root, {variable})) continue;
    if (!names.empty()) names += ", ";
    names += variable == Variable::lambda ? larger_stretch(e) : word;
  }
  out.sentences.push_back(names.empty() ? "a constant: no variable occurs" : "made of " + names);
  if (slot == Slot::thickness) return out;
  require_smooth_at_circle(e);
  const auto say = [&out](const std::string& what, Verdict verdict) {
    out.sentences.push_back(sentence(what, verdict));
    if (verdict == Verdict::at_points) out.assumed.push_back(what);
  };
  without_principal_stretches(e, &out.symmetric);
  if (occurs(e.graph, e.root, {Variable::lambda, Variable::mu}))
    say("symmetric in " + larger_stretch(e) + " and mu_, so smooth at the circle", out.symmetric);
  out.isotropic = isotropy(e, values);
  say("isotropic (a function of t, d and rho)", out.isotropic);
  if (out.is_isotropic()) {
    out.shear_free = out.even = out.isotropic;
  } else {
    out.shear_free = shear_freedom(e, values);
    say("V_alpha = 0 at alpha = 0", out.shear_free);
    if (out.is_shear_free()) {
      out.even = evenness(e, values);
      say("even in alpha: V(-alpha) = V(alpha)", out.even);
    } else {
      out.even = out.shear_free;  // even implies shear-free
    }
  }
  if (slot == Slot::plane) {
    out.separable = Verdict::term_by_term;
  } else {
    out.separable = separability(e, values);
    say("separable (a potential of the plane and one of the thickness)", out.separable);
  }
  return out;
}

}  // namespace stationary::expression
