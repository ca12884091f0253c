#include "solver/tube/kind_cover.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "solver/motion/body_circle.hpp"
#include "solver/tube/axis_curves.hpp"
#include "solver/tube/curve_cover.hpp"
#include "solver/tube/oriented_curves.hpp"

namespace stationary {
namespace {

CoverOptions cover_options(const SearchOptions& options, const Potential& potential) {
  CoverOptions out;
  out.stop = options.stop;
  const BodyModel<>* const body = potential.body_model();
  // An arc takes milliseconds then, not microseconds.
  if (body != nullptr && body->gravitates) out.max_arcs = 6'000;
  return out;
}

/// The places among their own stretches of those that stand for xi, zeta and rho.
using Places = std::array<std::size_t, 3>;
constexpr Places own_places{0, 1, 2};

struct AxisSought {
  Problem problem;
  SearchOptions options;
  Places places = own_places;
};

/// The same motions turning about axis 3, where their figures may be circles: V is symmetric in all
/// three stretches then, and circles and ellipses are taken apart (circle_curves.hpp). The stretch
/// that is the greater one of an ellipse listed stands for xi.
AxisSought with_circles_about_third_axis(const Problem& problem, const SearchOptions& options) {
  AxisSought out{problem, options};
  const Circle circle = circle_of(problem);
  if (circle == Circle::none || circle == Circle::xi_zeta) return out;
  const CirclePlaces of = places(circle);
  out.places = {static_cast<std::size_t>(of.first), static_cast<std::size_t>(of.second),
                static_cast<std::size_t>(of.other)};
  const auto placed = [&places = out.places](auto& inertia) {
    const std::array own{inertia.J1, inertia.J2, inertia.J3};
    inertia.J1 = own[places[0]];
    inertia.J2 = own[places[1]];
    inertia.J3 = own[places[2]];
  };
  Body body = problem.body();
  placed(body);
  std::array<Interval, 3> box;
  for (std::size_t k = 0; k < 3; ++k) box[k] = options.range(out.places[k]);
  out.options.box = box;
  const BodyModel<>* const model = problem.potential().body_model();
  if (model == nullptr) {
    out.problem = {body, problem.potential(), Branch::iii};
  } else {
    BodyModel<> moved = *model;
    placed(moved.J);
    out.problem = {body, Potential(moved), Branch::iii};
  }
  return out;
}

/// Their own stretches of motions whose axes stand in other places; those about axis 1 or 2 are no
/// circles of axis 3.
MotionArc in_own_places(MotionArc motions, const Places& places) {
  if (places == own_places) return motions;
  for (StretchBox* const at :
       {&motions.over.stretches, &motions.at.stretches, &motions.stretch_slope}) {
    const std::array found{at->xi, at->zeta, at->rho};
    Interval* const own[3] = {&at->xi, &at->zeta, &at->rho};
    for (std::size_t k = 0; k < 3; ++k) *own[places[k]] = found[k];
  }
  motions.over.circle = motions.at.circle = false;
  return motions;
}

template <int N>
std::unique_ptr<ProvenCurvesOf<N>> proven_curves(const CurveSet<N>& set,
                                                 const CoverOptions& options) {
  return std::make_unique<ProvenCurvesOf<N>>(*set.equations, set.region, options.tube);
}

std::vector<Interval> nu_of_all(const std::vector<Interval>& q, double to) {
  std::vector<Interval> out;
  for (const Interval& each : q) out.push_back(nu_of(each, to));
  return merged(std::move(out));
}

}  // namespace

KindCover cover_kind(const std::vector<CurveFactor>& factors, double to,
                     const CoverOptions& options, const ClassOver& class_over) {
  KindCover out;
  std::vector<NuGap> all;
  std::vector<std::vector<std::unique_ptr<ProvenCurves>>> proven;
  for (const CurveFactor& factor : factors) {
    proven.emplace_back();
    for (const AnyCurveSet& any : factor.sets) {
      const CurveCover cover = std::visit(
          [&](const auto& set) {
            auto curves = proven_curves(set, options);
            CurveCover found = cover_curves(*set.equations, set.region, options, curves->set());
            proven.back().push_back(std::move(curves));
            return found;
          },
          any);
      out.boxes += cover.boxes;
      out.tubes += cover.tubes;
      out.interrupted = out.interrupted || cover.interrupted;
      for (const CurveBreak& each : cover.breaks)
        all.push_back(
            {nu_of(each.q, to), each.turns, each.crosses, each.ends, each.mirrors, each.undecided});
      for (const Interval& q : cover.undecided)
        all.push_back({.nu = nu_of(q, to), .undecided = true});
    }
  }
  std::ranges::sort(all, {}, [](const NuGap& each) { return each.nu.lo; });
  for (const NuGap& each : all) {
    if (out.gaps.empty() || each.nu.lo > out.gaps.back().nu.hi) {
      out.gaps.push_back(each);
      continue;
    }
    NuGap& last = out.gaps.back();
    last.nu.hi = std::max(last.nu.hi, each.nu.hi);
    last.turns = last.turns || each.turns;
    last.crosses = last.crosses || each.crosses;
    last.ends = last.ends || each.ends;
    last.mirrors = last.mirrors || each.mirrors;
    last.undecided = last.undecided || each.undecided;
  }
  if (class_over && !out.interrupted) {
    const ClassGaps classes = class_gaps(proven, class_over, to, options.max_arcs, options.stop);
    out.class_gaps = nu_of_all(classes.gaps, to);
    out.class_arcs = classes.arcs;
    out.interrupted = classes.interrupted;
  }
  return out;
}

KindCover cover_axis(const Problem& problem, double from, double to, const SearchOptions& options,
                     bool classes) {
  const AxisSought sought = with_circles_about_third_axis(problem, options);
  const ClassOver class_over = [&](const MotionArc& motions) {
    return enclose_spectrum(problem, in_own_places(motions, sought.places), {}, options.inputs)
        .verdict;
  };
  const CoverOptions how = cover_options(options, problem.potential());
  return cover_kind(axis_curves(sought.problem, from, to, sought.options), to, how,
                    classes ? class_over : ClassOver());
}

KindCover cover_tilted(const Body& body, const Potential& potential, TiltPlane plane, double from,
                       double to, const SearchOptions& options, bool classes) {
  const ClassOver class_over = [&](const MotionArc& motions) {
    return enclose_tilted_spectrum(body, potential, plane, motions, {}, options.inputs).verdict;
  };
  CoverOptions how = cover_options(options, potential);
  how.max_arcs = std::min(how.max_arcs, 8'000L);  // each a tenth of a millisecond
  return cover_kind(tilted_curves(body, potential, plane, from, to, options), to, how,
                    classes ? class_over : ClassOver());
}

namespace {

/// No point of any of its curves.
bool is_empty(const CurveFactor& factor, const CoverOptions& options) {
  return std::ranges::all_of(factor.sets, [&](const AnyCurveSet& any) {
    const CurveCover cover = std::visit(
        [&](const auto& set) { return cover_curves(*set.equations, set.region, options); }, any);
    return cover.undecided.empty() && !cover.interrupted;
  });
}

}  // namespace

bool none_outside(const Problem& problem, double from, double to, const SearchOptions& options) {
  constexpr double farthest = 1e50;
  // A gravitating body's boxes take milliseconds.
  if (const auto* body = problem.potential().body_model(); body != nullptr && body->gravitates)
    return false;
  const AxisSought sought = with_circles_about_third_axis(problem, options);
  CoverOptions how = cover_options(options, problem.potential());
  how.follow = false;
  how.differences = true;
  how.max_boxes = 2'000;
  // Beyond one side of the box, the other stretches any.
  const auto none_in = [&](std::size_t k, const Interval& outside) {
    if (!(outside.lo < outside.hi)) return true;
    SearchOptions there = sought.options;
    there.box.emplace().fill({1.0 / farthest, farthest});
    (*there.box)[k] = outside;
    const std::vector<CurveFactor> factors = axis_curves(sought.problem, from, to, there);
    return std::ranges::any_of(factors, [&](const auto& each) { return is_empty(each, how); });
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const Interval inside = sought.options.range(k);
    if (!none_in(k, {1.0 / farthest, inside.lo}) || !none_in(k, {inside.hi, farthest}))
      return false;
  }
  return true;
}

std::optional<KindCover> cover_oriented(const Problem& problem, bool oblique, double from,
                                        double to, const SearchOptions& options, bool classes) {
  const Body& body = problem.body();
  const Potential& V = problem.potential();
  const auto factors =
      oriented_curves(body, V.anisotropic(), problem.branch(), oblique, from, to, options);
  if (factors.empty()) return std::nullopt;
  CoverOptions how = cover_options(options, V);
  // More unknowns; a box takes some 30 microseconds.
  how.max_boxes = 1'000'000;
  how.max_arcs = 20'000;
  const ClassOver class_over = [&](const MotionArc& motions) {
    return (oblique ? enclose_oblique_spectrum(body, V, motions.over, {}, options.inputs)
                    : enclose_spectrum(problem, motions, {}, options.inputs))
        .verdict;
  };
  return cover_kind(factors, to, how, classes ? class_over : ClassOver());
}

}  // namespace stationary
