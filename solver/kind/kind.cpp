#include "solver/kind/kind.hpp"

#include <sstream>
#include <utility>
#include <variant>

#include "solver/kind/axis_kind.hpp"
#include "solver/kind/oblique_kind.hpp"
#include "solver/kind/sheared_kind.hpp"
#include "solver/kind/tilted_kind.hpp"
#include "solver/kind/two_polar_kind.hpp"
#include "solver/proof/certificate.hpp"

namespace stationary {
namespace {

std::string number(double x) {
  std::ostringstream out;
  out << x;
  return out.str();
}

Alternatives only(std::unique_ptr<Kind> kind) {
  Alternatives out;
  out.each.push_back({{}, std::move(kind)});
  return out;
}

/// The kinds of each motion.
struct Of {
  const Body& body;
  const Potential& potential;
  bool anywhere;

  Alternatives operator()(const AxisRotation& motion) const {
    return only(axis_kind(body, potential, motion));
  }
  Alternatives operator()(const TwoPolarMotion& motion) const {
    return only(two_polar_kind(body, potential, motion));
  }
  Alternatives operator()(const TiltedMotion& motion) const {
    Alternatives out;
    for (const TiltedRotation& each : motion.rotations())
      out.each.push_back({each.plane == TiltPlane::one_three ? "1-3 plane" : "2-3 plane",
                          tilted_kind(body, potential, each)});
    out.key = "motion.plane";
    out.values = "\"13\" or \"23\"";
    out.both = "tilted motions with |nu| = " + number(motion.nu) + " in both planes";
    return out;
  }
  Alternatives operator()(const SpatialRotation& motion) const {
    return only(sheared_kind(body, potential, ShearedAxis::in_no_plane, motion, motion.nu));
  }
  Alternatives operator()(const ObliqueRotation& motion) const {
    if (potential.is_isotropic())
      return only(sheared_kind(body, potential, ShearedAxis::oblique, ObliqueRotation{motion.nu},
                               motion.nu));
    if (anywhere || motion.near) return only(oblique_kind(body, potential, motion));
    Alternatives out;
    for (const Branch near : {Branch::i, Branch::ii})
      out.each.push_back({near == Branch::i ? "axis 1" : "axis 2",
                          oblique_kind(body, potential, {motion.nu, near})});
    out.any = oblique_kind(body, potential, motion);
    out.key = "motion.axis";
    out.values = "\"1\" or \"2\"";
    out.both = "oblique motions with |nu| = " + number(motion.nu) + " of the families of both axes";
    return out;
  }
};

OnlyFound found(const Alternatives& kinds, const SolveOptions& options, bool all_tried) {
  const SolveOptions how = for_each_of(kinds, options);
  OnlyFound out{{{}, kinds.each.front().kind.get()}};
  Equilibrium& first = out.first.equilibrium;
  std::string failures;
  bool open = false;  // of some nothing is known
  for (const auto& [label, kind] : kinds.each) {
    Equilibrium each = kind->solve(how);
    if (each.status == SolveStatus::interrupted) return {{std::move(each), kind.get()}};
    if (each.status == SolveStatus::solved) {
      out.several = first.status == SolveStatus::solved;
      if (!out.several) out.first = {std::move(each), kind.get()};
      if (out.several || !all_tried) return out;
      continue;
    }
    failures += (failures.empty() ? "" : "; ") + (label.empty() ? "" : label + ": ") + each.message;
    open = open || each.status == SolveStatus::not_found;
    if (first.status != SolveStatus::solved && first.status != SolveStatus::failed)
      out.first = {std::move(each), kind.get()};
  }
  if (first.status == SolveStatus::solved) return out;
  first.message = failures;
  if (open && first.status == SolveStatus::none_exists) first.status = SolveStatus::not_found;
  if (kinds.any && open && first.status != SolveStatus::failed)
    return {{kinds.any->solve(options), kinds.any.get()}};
  return out;
}

}  // namespace

std::optional<EventEnclosure> Kind::enclose_event(const FamilyParameter& parameter, EventType event,
                                                  const Member& member) const {
  std::optional<EventEnclosure> out = event_enclosure(parameter, event, member);
  if (!out) return out;
  out->assuming = potential_.assumptions();
  require_assumptions(potential_, Inputs::decimals, out->q, *out);
  return out;
}

Equilibrium at_rest() {
  Equilibrium out;
  out.status = SolveStatus::none_exists;
  out.message = "at rest no axis is one of a spin: |nu| > 0";
  return out;
}

Equilibrium equilibrium_of(const Member& member) {
  Equilibrium out;
  out.status = SolveStatus::solved;
  out.q = member.q;
  out.nu = member.angular_velocity;
  if (member.two_polar) {
    out.two_polar = *member.two_polar;
    out.circle = member.q.xi == member.q.zeta;
  }
  out.residual = member.residual;
  out.compatibility = member.compatibility;
  out.error_bound = member.error_bound;
  return out;
}

PlanItem followed_together() {
  return {"cells",
          "on the sheets that `solve` follows from rest, followed once for all nu of one body",
          "x is nu, and the motion is found by following others"};
}

Alternatives alternatives(const Body& body, const Potential& potential, const Motion& motion,
                          bool anywhere) {
  return std::visit(Of{body, potential, anywhere}, motion);
}

std::unique_ptr<Kind> kind_of(const Body& body, const Potential& potential, const Motion& motion) {
  return std::move(alternatives(body, potential, motion, true).each.front().kind);
}

SolveOptions for_each_of(const Alternatives& kinds, const SolveOptions& options) {
  SolveOptions out = options;
  if (kinds.any) out.search = false;
  return out;
}

Found first_found(const Alternatives& kinds, const SolveOptions& options) {
  return found(kinds, options, false).first;
}

std::optional<PlanItem> together(const Alternatives& kinds) {
  std::optional<PlanItem> out;
  for (const Alternatives::Each& each : kinds.each)
    if (out = each.kind->together(); !out) break;
  return out;
}

void first_found_each(const Alternatives& kinds, bool spectra, const SolveOptions& options,
                      const NumberRange& all, std::span<AtValue> at,
                      std::span<std::size_t> places) {
  const SolveOptions how = for_each_of(kinds, options);
  for (std::size_t k = 0; k < kinds.each.size(); ++k) {
    kinds.each[k].kind->solve_each(spectra, how, all, at);
    for (std::size_t i = 0; i < at.size(); ++i)
      if (!at[i].solved()) places[i] = k + 1;
  }
}

OnlyFound only_found(const Alternatives& kinds, const SolveOptions& options) {
  return found(kinds, options, true);
}

}  // namespace stationary
