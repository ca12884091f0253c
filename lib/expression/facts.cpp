#include "lib/expression/facts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "lib/expression/differentiate.hpp"
#include "lib/expression/pairs.hpp"
#include "lib/expression/tape_run.hpp"

namespace stationary::expression {
namespace {

/// Numbers in [0, 1) that are the same everywhere (Knuth's 64-bit generator).
class Points {
 public:
  double next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_ = 20101131;
};

struct Point {
  std::array<double, 4> stretch;
  std::array<double, largest_parameter_count> parameters;
};

Point random_point(Points& points) {
  Point out;
  const double xi = 0.3 + 2.5 * points.next();
  const double zeta = 0.3 + 2.5 * points.next();
  const double alpha = (1.8 * points.next() - 0.9) * std::sqrt(xi * zeta);
  out.stretch = {alpha, xi, zeta, 0.3 + 2.5 * points.next()};
  for (double& parameter : out.parameters) parameter = 0.2 + 2.0 * points.next();
  return out;
}

/// The one result of a program at a point.
template <class R, class Input>
R value_at(const Program& program, const Coefficients& coefficients, const Point& at,
           const Input& input) {
  std::array<R, largest_parameter_count> parameters;
  std::array<R, largest_constant_count> constants;
  Workspace<R, largest_place_count> workspace;
  std::ranges::transform(at.parameters, parameters.begin(), input);
  compute_constants<R>(coefficients, parameters.data(), constants.data());
  std::ranges::transform(at.stretch, workspace.data(), input);
  run<R>(program, coefficients.literals.data(), constants.data(), workspace.data());
  const Result result = program.results[0];
  return result.constant ? constants[result.at] : workspace.data()[result.at];
}

std::string sentence(const char* what, Verdict verdict) {
  switch (verdict) {
    case Verdict::term_by_term:
      return std::string(what) + ": holds term by term";
    case Verdict::at_points:
      return std::string(what) + ": holds at pseudo-random points to 20 digits";
    case Verdict::refuted:
      return std::string(what) + ": does not hold";
    case Verdict::undecided:
      break;
  }
  return std::string(what) + ": undecided, taken as not holding";
}

Verdict separability(Expression& e) {
  Graph& g = e.graph;
  const NodeId force = Differentiation(g, Coordinate::rho)(in_stretch(e));
  Verdict out = Verdict::term_by_term;
  for (const Coordinate c : {Coordinate::alpha, Coordinate::xi, Coordinate::zeta}) {
    const Verdict verdict =
        vanishes(g, g.expanded(Differentiation(g, c)(force)), e.parameters.size());
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

Verdict vanishes(const Graph& graph, NodeId x, std::size_t parameter_count) {
  if (graph.is_zero(x)) return Verdict::term_by_term;
  if (parameter_count > largest_parameter_count) return Verdict::undecided;
  TapeWriter writer(graph);
  const std::array<NodeId, 1> root{x};
  const Program program = writer.program(anisotropic_inputs, root);
  Points points;
  int defined = 0;
  constexpr int tried = 64;
  constexpr int enough = 12;
  for (int k = 0; k < tried && defined < enough; ++k) {
    const Point at = random_point(points);
    const auto value = double(value_at<DoubleDouble>(program, writer.coefficients(), at,
                                                     [](double c) { return DoubleDouble(c); }));
    const Conditioned size =
        value_at<Conditioned>(program, writer.coefficients(), at, Conditioned::input);
    if (!std::isfinite(value) || !std::isfinite(size.condition)) continue;
    ++defined;
    if (std::abs(value) > 0x1p-66 * size.condition) return Verdict::refuted;
  }
  return defined >= 4 ? Verdict::at_points : Verdict::undecided;
}

NodeId without_principal_stretches(Expression& e) {
  Graph& g = e.graph;
  if (!occurs(g, e.root, {Variable::lambda, Variable::mu})) return e.root;
  const EvenOdd parts = split_at_circle(g, e.root);
  Expression odd = e;
  odd.root = parts.odd;
  const NodeId in_q = in_stretch(odd);
  if (!Facts::holds(vanishes(odd.graph, in_q, e.parameters.size())))
    throw Unsuitable(
        "lambda and mu_ must enter symmetrically (exchanging them must change nothing): only then "
        "is the potential smooth at the circle lambda = mu_");
  return parts.even;
}

Verdict isotropy(Expression& e) {
  Graph& g = e.graph;
  if (!occurs(g, e.root, {Variable::alpha, Variable::xi, Variable::zeta}))
    return Verdict::term_by_term;
  const NodeId v = in_stretch(e);
  const NodeId alpha = g.variable(Variable::alpha);
  const NodeId difference = g.subtract(g.variable(Variable::xi), g.variable(Variable::zeta));
  const NodeId shear = Differentiation(g, Coordinate::alpha)(v);
  const NodeId stretch =
      g.subtract(Differentiation(g, Coordinate::zeta)(v), Differentiation(g, Coordinate::xi)(v));
  const NodeId along_rotation =
      g.add(g.multiply(shear, difference), g.multiply(g.multiply(g.number(2.0), alpha), stretch));
  return vanishes(g, g.expanded(along_rotation), e.parameters.size());
}

Verdict shear_freedom(Expression& e) {
  Graph& g = e.graph;
  const NodeId shear = Differentiation(g, Coordinate::alpha)(in_stretch(e));
  return vanishes(g, g.expanded(substitute(g, shear, {{Variable::alpha, g.zero()}})),
                  e.parameters.size());
}

Verdict evenness(Expression& e) {
  Graph& g = e.graph;
  const NodeId v = in_stretch(e);
  const NodeId opposite = g.multiply(g.number(-1.0), g.variable(Variable::alpha));
  const NodeId mirrored = substitute(g, v, {{Variable::alpha, opposite}});
  return vanishes(g, g.expanded(g.subtract(v, mirrored)), e.parameters.size());
}

Facts facts(Expression e, Slot slot) {
  Facts out;
  std::string names;
  for (const auto& [variable, word] : words) {
    if (!occurs(e.graph, e.root, {variable})) continue;
    out.variables.push_back(variable);
    names += names.empty() ? word : std::string(", ") + word;
  }
  out.sentences.push_back(names.empty() ? "a constant: no variable occurs" : "made of " + names);
  if (slot == Slot::thickness) return out;
  out.symmetric = Verdict::term_by_term;
  if (occurs(e.graph, e.root, {Variable::lambda, Variable::mu})) {
    without_principal_stretches(e);
    const NodeId odd = split_at_circle(e.graph, e.root).odd;
    if (!e.graph.is_zero(odd)) out.symmetric = Verdict::at_points;
    out.sentences.push_back(
        sentence("symmetric in lambda and mu_, so smooth at the circle", out.symmetric));
  }
  out.isotropic = isotropy(e);
  out.sentences.push_back(sentence("isotropic (a function of t, d and rho)", out.isotropic));
  if (out.is_isotropic()) {
    out.shear_free = out.even = out.isotropic;
  } else {
    out.shear_free = shear_freedom(e);
    out.sentences.push_back(sentence("V_alpha = 0 at alpha = 0", out.shear_free));
    if (out.is_shear_free()) {
      out.even = evenness(e);
      out.sentences.push_back(sentence("even in alpha: V(-alpha) = V(alpha)", out.even));
    } else {
      out.even = out.shear_free;  // even implies shear-free
    }
  }
  if (slot == Slot::plane) {
    out.separable = Verdict::term_by_term;
  } else {
    out.separable = separability(e);
    out.sentences.push_back(
        sentence("separable (a potential of the plane and one of the thickness)", out.separable));
  }
  return out;
}

}  // namespace stationary::expression
