#include "solver/kind/oriented_event_enclosure.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/number/elementary.hpp"
#include "solver/family/anisotropic_family.hpp"
#include "solver/family/oriented_events.hpp"
#include "solver/kind/leaf_meeting.hpp"
#include "solver/proof/enclosed_event.hpp"
#include "solver/proof/oriented_boxes.hpp"
#include "solver/proof/sought_event.hpp"

namespace stationary {
namespace {

/// One for all layouts, so that the potentials are compiled for it once: as many unknowns as an
/// oblique motion has with p and Lambda.
using OrientedBoxed = BoxDual<7>;

/// What all equations of a family's events are of.
struct Spin {
  const Body& body;
  const AnisotropicPotential& potential;
  Branch branch;  ///< where the axis is no unknown
  const FamilyParameter& parameter;
  Inputs inputs;

  VariedSpin varied(double nu) const {
    return {potential, body, nu, parameter, coefficient_place(potential, parameter)};
  }
};

/// One of TestValues vanishes.
template <class Layout>
class OrientedVanishing {
 public:
  static constexpr int dimension = Layout::dimension + 1;
  using BoxNumber = OrientedBoxed;

  OrientedVanishing(const Spin& spin, double nu, std::size_t function)
      : system_(spin.varied(nu), spin.branch, function) {}

  template <class Values>
  Values over_boxes(const Values& y, Inputs inputs) const {
    return system_.equations(
        y, [&](double x, std::size_t) { return OrientedBoxed(as_input(x, inputs)); });
  }

 private:
  OrientedEventSystem<Layout> system_;
};

/// Two modes meet.
template <class Layout>
class OrientedMeeting {
 public:
  static constexpr int dimension = Layout::dimension + 2;
  using BoxNumber = OrientedBoxed;

  OrientedMeeting(const Spin& spin, double nu, const MeetingModes& modes)
      : spin_(spin.varied(nu)),
        branch_(spin.branch),
        modes_(modes),
        parts_{.about_third = !Layout::axis && spin.branch == Branch::iii,
               .straight = !Layout::axis && spin.branch != Branch::iii,
               .coupled = !spin.potential.is_separable(),
               .volume_held = spin.potential.body().volume.has_value()} {}

  template <class Values>
  Values over_boxes(const Values& y, Inputs inputs) const {
    constexpr std::size_t unknowns = Layout::places.size();
    const auto [J, nu, model] = spin_.at(
        y[unknowns], [&](double x, std::size_t) { return OrientedBoxed(as_input(x, inputs)); });
    std::array<OrientedBoxed, unknowns> x;
    std::copy_n(y.begin(), unknowns, x.begin());
    const auto at = all_coordinates<Layout>(x, OrientedBoxed(1.0));
    const auto balance = balance_at<Layout, 1>(J, model, branch_, square(nu), at);
    BasicStretch<OrientedBoxed> q = oriented_stretch(at[0], at[1], at[2], at[3]).q;
    if constexpr (!Layout::alpha) q.alpha = OrientedBoxed(0.0);
    Vector3<OrientedBoxed> angular_velocity = stationary::angular_velocity(branch_, nu);
    if constexpr (Layout::axis) {
      const AxisAngle<OrientedBoxed> axis = axis_angle(at[4]);
      angular_velocity = {nu * axis.cosine, nu * axis.sine, OrientedBoxed(0.0)};
    }
    const auto meeting =
        leaf_meeting<OrientedBoxed>(modes_, parts_, J, q, angular_velocity,
                                    potential_derivatives<2>(model, q).hessian, y[unknowns + 1]);
    Values out;
    for (std::size_t i = 0; i < unknowns; ++i) out[i] = balance.g[Layout::places[i]];
    out[unknowns] = meeting[0];
    out[unknowns + 1] = meeting[1];
    return out;
  }

 private:
  VariedSpin spin_;
  Branch branch_;
  MeetingModes modes_;
  LeafParts parts_;
};

/// What was proven of the stretches and p, of alpha and the axis too.
template <class Layout>
void require_alike(const StretchBox& solution, const Interval& x_phi, const Member& member,
                   EventEnclosure& out) {
  double& bound = out.error_bound;
  if constexpr (Layout::alpha)
    bound = std::max(bound, shear_error(member.q.alpha, solution).magnitude());
  if constexpr (Layout::axis)
    bound = std::max(bound, axis_error(member.angular_velocity, axis_angle(x_phi)).magnitude());
  if (bound < 1e-4) return;
  out.proven = false;
  out.reason = "the event proven near by is not the one located";
}

template <class Layout, class System>
EventEnclosure enclose(const System& system, const Member& member, double lambda, Inputs inputs) {
  constexpr int N = System::dimension;
  constexpr int p = Layout::dimension;
  ReducedVector<N> y;
  y[0] = member.q.xi;
  y[1] = member.q.zeta;
  y[Layout::thickness_place] = member.q.rho;
  if constexpr (Layout::alpha) y[Layout::alpha_place] = shear_coordinate(member.q);
  if constexpr (Layout::axis)
    y[Layout::axis_place] =
        axis_coordinate(atan2(member.angular_velocity[1], member.angular_velocity[0]));
  y[p] = member.parameter;
  if constexpr (N > p + 1) y[N - 1] = lambda;
  StretchBox solution;
  Interval x_phi(1.0);
  EventEnclosure out =
      enclosed_event(EventBoxes(system, inputs), y, p, member, [&](const Box<N>& found) {
        std::array<Interval, Layout::places.size()> x;
        std::copy_n(found.begin(), x.size(), x.begin());
        const auto at = all_coordinates<Layout>(x, Interval(1.0));
        const auto q = oriented_stretch(at[0], at[1], at[2], at[3]).q;
        x_phi = at[4];
        return solution = {q.xi, q.zeta, q.rho, Layout::alpha ? q.alpha : Interval(0.0)};
      });
  if (out.proven) require_alike<Layout>(solution, x_phi, member, out);
  return out;
}

template <class Layout>
EventEnclosure enclose_in(const Spin& spin, EventType type, const Member& member) {
  EventEnclosure out;
  out.reason = "it has no equations to prove, or no spectrum was computed";
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Branch branch = Layout::axis ? Branch::i : spin.branch;
  const bool along_nu = spin.parameter.kind == FamilyParameter::Kind::nu;
  if (const auto function = vanishing_function<Layout>(type, branch, along_nu, member))
    return enclose<Layout>(OrientedVanishing<Layout>(spin, member.nu, *function), member, none,
                           spin.inputs);
  for (const SoughtEvent& what : sought_events(type, branch, member)) {
    if (!what.function.spectral() || member.nu == 0.0) continue;
    out = enclose<Layout>(OrientedMeeting<Layout>(spin, member.nu, what.function.meeting()), member,
                          what.lambda, spin.inputs);
    if (out.proven) break;
  }
  return out;
}

/// Where a family with alpha != 0 ends on the one with alpha = 0 that it branches off, that one's
/// own event.
EventEnclosure enclose_turn(const Spin& spin, const Member& member) {
  return enclose<StraightLayout>(
      OrientedVanishing<StraightLayout>(spin, member.nu, TestValues::turn), member, 0.0,
      spin.inputs);
}

}  // namespace

std::optional<EventEnclosure> enclose_oriented_event(const Problem& problem,
                                                     const FamilyParameter& parameter,
                                                     EventType type, const Member& member,
                                                     Inputs inputs) {
  if (!has_enclosure(type)) return std::nullopt;
  const AnisotropicPotential& V = problem.potential().anisotropic();
  const Spin spin{problem.body(), V, problem.branch(), parameter, inputs};
  const bool even = V.even_in_alpha() && keeps_shear_free(V, parameter);
  if (problem.branch() != Branch::iii || (even && member.q.alpha == 0.0)) {
    if (type == EventType::shear || type == EventType::oblique) return enclose_turn(spin, member);
    return enclose_in<StraightLayout>(spin, type, member);
  }
  return enclose_in<ShearedLayout>(spin, type, member);
}

std::optional<EventEnclosure> enclose_oblique_event(const Body& body,
                                                    const AnisotropicPotential& potential,
                                                    const FamilyParameter& parameter,
                                                    EventType type, const Member& member,
                                                    Inputs inputs) {
  if (!has_enclosure(type)) return std::nullopt;
  if (type == EventType::oblique) {
    const bool first = std::abs(member.angular_velocity[0]) > std::abs(member.angular_velocity[1]);
    return enclose_turn({body, potential, first ? Branch::i : Branch::ii, parameter, inputs},
                        member);
  }
  return enclose_in<ObliqueLayout>({body, potential, Branch::i, parameter, inputs}, type, member);
}

}  // namespace stationary
