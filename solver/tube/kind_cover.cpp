#include "solver/tube/kind_cover.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "solver/motion/body_circle.hpp"
#include "solver/tube/axis_curves.hpp"
#include "solver/tube/curve_cover.hpp"
#include "solver/tube/oriented_curves.hpp"

namespace stationary {
namespace {

/// nu of q, outward.
Interval nu_of(const Interval& q, double to) {
  const Interval bounded(std::max(q.lo, 0.0), std::min(std::max(q.hi, 0.0), 1.0));
  const Interval out = Interval(to) * sqrt(bounded);
  return {std::max(out.lo, 0.0), std::min(out.hi, to)};
}

CoverOptions cover_options(const SearchOptions& options) {
  CoverOptions out;
  out.stop = options.stop;
  return out;
}

struct AxisSought {
  Problem problem;
  SearchOptions options;
};

/// The same motions turning about axis 3, by an exchange of it with theirs, where their figures may be
/// circles: V is symmetric in all three stretches then, and circles and ellipses are taken apart
/// (circle_curves.hpp).
AxisSought with_circles_about_third_axis(const Problem& problem, const SearchOptions& options) {
  AxisSought out{problem, options};
  const Circle circle = circle_of(problem);
  if (circle == Circle::none || circle == Circle::xi_zeta) return out;
  const auto own = static_cast<std::size_t>(places(circle).other);
  const auto exchange = [own](auto& inertia) {
    std::swap(own == 0 ? inertia.J1 : inertia.J2, inertia.J3);
  };
  Body body = problem.body();
  exchange(body);
  std::array box{options.range(0), options.range(1), options.range(2)};
  std::swap(box[own], box[2]);
  out.options.box = box;
  const BodyModel<>* const model = problem.potential().body_model();
  if (model == nullptr) {
    out.problem = {body, problem.potential(), Branch::iii};
  } else {
    BodyModel<> exchanged = *model;
    exchange(exchanged.J);
    out.problem = {body, Potential(exchanged), Branch::iii};
  }
  return out;
}

}  // namespace

KindCover cover_kind(const std::vector<CurveFactor>& factors, double to,
                     const CoverOptions& options) {
  KindCover out;
  std::vector<NuGap> all;
  for (const CurveFactor& factor : factors) {
    for (const AnyCurveSet& any : factor.sets) {
      const CurveCover cover = std::visit(
          [&](const auto& set) { return cover_curves(*set.equations, set.region, options); }, any);
      out.boxes += cover.boxes;
      out.tubes += cover.tubes;
      out.interrupted = out.interrupted || cover.interrupted;
      for (const CurveBreak& each : cover.breaks)
        all.push_back({nu_of(each.q, to), each.turns, each.crosses, each.mirrors, each.undecided});
      for (const Interval& q : cover.undecided)
        all.push_back({nu_of(q, to), false, false, false, true});
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
    last.mirrors = last.mirrors || each.mirrors;
    last.undecided = last.undecided || each.undecided;
  }
  return out;
}

KindCover cover_axis(const Problem& problem, double from, double to, const SearchOptions& options) {
  const AxisSought sought = with_circles_about_third_axis(problem, options);
  return cover_kind(axis_curves(sought.problem, from, to, sought.options), to,
                    cover_options(options));
}

std::optional<KindCover> cover_oriented(const Body& body, const AnisotropicPotential& potential,
                                        Branch branch, bool oblique, double from, double to,
                                        const SearchOptions& options) {
  const auto factors = oriented_curves(body, potential, branch, oblique, from, to, options);
  if (factors.empty()) return std::nullopt;
  CoverOptions how = cover_options(options);
  // More unknowns; a box takes some 30 microseconds.
  how.max_boxes = 1'000'000;
  return cover_kind(factors, to, how);
}

}  // namespace stationary
