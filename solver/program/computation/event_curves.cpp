#include "solver/program/computation/event_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "solver/event_curve/event_sides.hpp"
#include "solver/family/anisotropic_family.hpp"
#include "solver/kind/kind.hpp"
#include "solver/motion/body_circle.hpp"
#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/session/case_family.hpp"
#include "solver/program/text/input_error.hpp"
#include "solver/program/text/named.hpp"

namespace stationary::cli {
namespace {

/// What a parameter varies: of a ratio its first number.
std::string_view number_of(const Case& input, std::size_t k) {
  return parts_of(input.curve->parameters[k]).first;
}
double unit_of(const Case& input, std::size_t k) {
  return parameter_unit(own_numbers(input), input.curve->parameters[k]);
}

/// first, second: of the numbers that vary.
FamilyParameters numbers_of(const Case& input, double first, double second) {
  return with_parameters(own_numbers(input),
                         std::array{ParameterValue{number_of(input, 0), first},
                                    ParameterValue{number_of(input, 1), second}});
}

double own_number(const Case& input, std::size_t k) {
  return parameter_value(own_numbers(input), number_of(input, k));
}

FamilyParameter family_parameter_of(const Case& input, std::size_t k) {
  return family_parameter(input.curve->parameters[k], input.models);
}

/// A circle stays one only while two J are equal, and one of rho while V does not tell its stretches apart.
void require_circle(const Case& input, Circle circle) {
  const auto [first, second, other] = places(circle);
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const std::string_view key = number_of(input, k);
    const bool of_inertia =
        key == fmt::format("body.J.{}", first) || key == fmt::format("body.J.{}", second);
    const FamilyParameters own = own_numbers(input);
    const auto spin = spin_of(own.motion);
    if (!of_inertia &&
        (!spin || circle_of({own.body, make_potential(own.models, own.body), spin->branch},
                            family_parameter_of(input, k)) == circle))
      continue;
    throw fault_at(
        input.source, fmt::format("curve.parameters.{}", k),
        "found " + in_quotes(key) + ", and the event is on a circle", "another number of the case",
        of_inertia ? fmt::format("circles need J{} = J{}", first + 1, second + 1)
                   : fmt::format("circles of {} need a potential symmetric in the two",
                                 circle == Circle::zeta_rho ? "zeta and rho" : "xi and rho"));
  }
}

/// A turn has the name of what turns.
EventType sought_event(const Case& input) {
  const EventType asked = input.curve->event;
  return asked == EventType::fold_nu && number_of(input, 0) != "nu" ? EventType::fold_parameter
                                                                    : asked;
}

/// q: of the sheet, whose families it tells apart.
EventCurveSetting setting_of(const Case& input, const Stretch& q) {
  const FamilyParameter first_parameter = family_parameter_of(input, 0);
  EventCurveSetting out;
  out.family = [&input, q, first_parameter](double first, double second, bool spectrum) {
    return kind_of(numbers_of(input, first, second))
        ->family(first_parameter, {.spectrum = spectrum}, q);
  };
  out.first = first_parameter;
  out.second = family_parameter_of(input, 1);
  out.type = sought_event(input);
  if (spin_of(input.motion)) {
    out.spin = [&input](double first, double second) {
      const FamilyParameters numbers = numbers_of(input, first, second);
      const AxisRotation spin = *spin_of(numbers.motion);
      return SpinningProblem{
          Problem(numbers.body, make_potential(numbers.models, numbers.body), spin.branch),
          spin.nu};
    };
  }
  return out;
}

/// That the family keeps, where its event is on it; of an event where it breaks, that.
Circle circle_at(const Case& input, const AnyFamily& family, const Stretch& q) {
  if (const Circle broken = broken_circle(input.curve->event); broken != Circle::none)
    return broken;
  const Circle circle = std::visit([](const auto& own) { return own->circle(); }, family);
  return is_on(circle, q) ? circle : Circle::none;
}

class KeptEvents final : public CurveSink {
 public:
  explicit KeptEvents(EventType type) : type_(type) {}
  void row(const Member& member, EventType event) override {
    if (event == type_) events.push_back(member);
  }
  std::vector<Member> events;

 private:
  EventType type_;
};

/// Whether two points of one curve at the same p2 are one.
bool is_same(const Member& a, const Member& b) {
  constexpr double near = 1e-7;
  const auto close = [](double x, double y) {
    return std::abs(x - y) <= near * (std::abs(x) + std::abs(y));
  };
  return close(a.parameter, b.parameter) && close(a.q.xi, b.q.xi) && close(a.q.zeta, b.q.zeta) &&
         close(a.q.rho, b.q.rho);
}

bool passes(const EventCurve& curve, const Member& event) {
  return std::ranges::any_of(curve.crossings,
                             [&](const Member& each) { return is_same(each, event); });
}

/// Whether alpha = 0 at the event, and not along its curve.
bool leaves_alpha_zero(const Case& input, const Member& event) {
  if (!spin_of(input.motion) || input.potential.is_isotropic() || event.q.alpha != 0.0)
    return false;
  const AnisotropicPotential& V = input.potential.anisotropic();
  return !keeps_shear_free(V, family_parameter_of(input, 0)) ||
         !keeps_shear_free(V, family_parameter_of(input, 1));
}

EventCurve curve_of(const Case& input, const Member& event, bool spectrum, const Run& run) {
  const CaseCurve& asked = *input.curve;
  if (leaves_alpha_zero(input, event)) {
    EventCurve out;
    out.failure =
        "alpha = 0 there and at other values of the numbers is not; start at another value";
    return out;
  }
  if (input.potential.is_isotropic() && event.q.alpha != 0.0) {
    EventCurve out;
    out.failure = "events of motions with alpha != 0 of an isotropic body are not followed";
    return out;
  }
  const EventCurveSetting setting = setting_of(input, event.q);
  const double second = own_number(input, 1);
  const Circle circle = circle_at(input, setting.family(event.parameter, second, false), event.q);
  if (circle != Circle::none) require_circle(input, circle);
  return follow_event_curve(setting, event, second, circle,
                            {.first_from = asked.from[0] * unit_of(input, 0),
                             .first_to = asked.to[0] * unit_of(input, 0),
                             .second_from = asked.from[1] * unit_of(input, 1),
                             .second_to = asked.to[1] * unit_of(input, 1),
                             .tolerance = asked.tolerance,
                             .spectrum = spectrum,
                             .stop = run.stop});
}

void add_curve(EventCurves& out, const Case& input, const Member& event, bool spectrum,
               const Run& run) {
  EventCurve curve = curve_of(input, event, spectrum, run);
  out.interrupted = out.interrupted || curve.interrupted;
  if (curve.failure.empty()) {
    out.curves.push_back(std::move(curve));
  } else {
    out.failures.push_back(fmt::format("{} at {} = {:.12g}: {}", name(input.curve->event),
                                       input.curve->parameters[0],
                                       event.parameter / unit_of(input, 0), curve.failure));
  }
}

/// One that the family has no curves of.
[[noreturn]] void refuse_event(const Case& input, bool spin, bool isotropic) {
  const EventType event = input.curve->event;
  const bool of_circle = event == EventType::ellipse || event == EventType::ellipse_23 ||
                         event == EventType::ellipse_13;
  const bool fibred = of_circle && !isotropic;
  std::vector<std::string_view> allowed;
  for (const std::string_view each : event_names)
    if (has_event_curve(named<EventType>(event_names, each).value(), spin, isotropic))
      allowed.push_back(each);
  throw fault_at(
      input.source, "curve.event",
      fmt::format("found {} and {}", in_quotes(name(event)),
                  fibred ? "an anisotropic potential" : "branch " + in_quotes(input.branch_name())),
      "one of " + listed(allowed),
      fibred ? "ellipses leave circles of isotropic bodies alone"
      : event == EventType::zero_momentum
          ? "a spin about a material axis has no momentum at rest alone"
          : "it has curves of spins about a material axis with alpha = 0 alone");
}

}  // namespace

void require_curve(const Case& input) {
  if (!input.curve) {
    throw fault_at(input.source, "curve", "found no such key",
                   "a table with event, parameters, from and to",
                   "add [curve] with event = \"tilt\", parameters = [\"nu\", \"body.J.1\"]");
  }
  const bool isotropic = input.potential.is_isotropic();
  const bool spin = spin_of(input.motion).has_value();
  const std::vector<std::string> followed = followed_parameters(input.motion, input.models);
  if (std::ranges::find(followed, number_of(input, 0)) == followed.end()) {
    throw fault_at(
        input.source, "curve.parameters.0", fmt::format("found \"{}\"", input.curve->parameters[0]),
        "a number that families of this motion are followed in: " +
            fmt::format("{}", fmt::join(followed, ", ")),
        "events are of the family in the first number; the second may be any of the case");
  }
  // Of a spin about axis 1 or 2 compatibility asks for alpha = 0.
  const bool straight = spin && !isotropic && spin_of(input.motion)->branch != Branch::iii;
  for (std::size_t k = 0; straight && k < input.curve->parameters.size(); ++k) {
    if (keeps_shear_free(input.potential.anisotropic(), family_parameter_of(input, k))) continue;
    throw fault_at(input.source, fmt::format("curve.parameters.{}", k),
                   fmt::format("found \"{}\"", input.curve->parameters[k]),
                   "a number that leaves the potential even in alpha",
                   "where it is not, no motion about a material axis has alpha = 0");
  }
  if (!has_event_curve(input.curve->event, spin, isotropic)) refuse_event(input, spin, isotropic);
}

void require_second_in_range(const Case& input) {
  const double second = parameter_value(own_numbers(input), input.curve->parameters[1]);
  if (second < input.curve->from[1] || second > input.curve->to[1]) {
    throw fault_at(
        input.source, "curve.from.1",
        fmt::format("found {} = {} outside the range", input.curve->parameters[1], second),
        fmt::format("a range that holds {}", second), "curves start at the case's own value");
  }
}

EventCurves event_curves(const Case& input, bool spectrum, const Run& run) {
  const CaseCurve& asked = *input.curve;
  Case family_case = input;
  family_case.continuation = {.parameter = asked.parameters[0],
                              .from = asked.from[0],
                              .to = asked.to[0],
                              .tolerance = asked.tolerance,
                              .events = {std::string(name(sought_event(input)))}};
  EventCurves out;
  Start start = solved_start(family_case, run);
  // As `continue` does: the family through rest may turn before the case's own nu.
  if (start.found.status != SolveStatus::solved && asked.parameters[0] == "nu" &&
      !input.solve.start && asked.to[0] > 0.0 && kind_of(own_numbers(input))->from_rest()) {
    family_case.continuation->from = std::min(asked.from[0], 0.0);
    start = solved_start(family_case, run);
  }
  out.status = start.found.status;
  out.only_in_box = start.only_in_box;
  out.message = start.found.message;
  out.interrupted = out.status == SolveStatus::interrupted;
  if (out.status != SolveStatus::solved) return out;
  const AnyFamily family = family_of(family_case, start, true, false);
  KeptEvents kept(sought_event(input));
  const double unit = unit_of(input, 0);
  const FollowReport report =
      follow(family, start.found.q, start.p * unit, follow_options(family_case, unit, run), kept);
  if (!report.failure.empty()) {
    out.status = SolveStatus::failed;
    out.message = report.failure;
    return out;
  }
  out.interrupted = report.interrupted;
  for (const Member& event : kept.events) {
    if (out.interrupted) break;
    if (event.parameter < asked.from[0] * unit) continue;
    const bool again = std::ranges::any_of(
        out.curves, [&](const EventCurve& each) { return passes(each, event); });
    if (!again) add_curve(out, input, event, spectrum, run);
  }
  return out;
}

EventCurves event_curve_of_row(const Case& input, const Stretch& q, bool spectrum, const Run& run) {
  const double first = own_number(input, 0);
  const AnyFamily family = setting_of(input, q).family(first, own_number(input, 1), true);
  const Member event =
      member_at(family, place_of(family, q, first, 0x1p-48, circle_at(input, family, q)));
  EventCurves out;
  out.status = SolveStatus::solved;
  add_curve(out, input, event, spectrum, run);
  return out;
}

std::array<double, 2> curve_place(const Case& input, const EventCurvePoint& point) {
  return {point.member.parameter / unit_of(input, 0), point.second / unit_of(input, 1)};
}

TableRow curve_row(const Case& input, const EventCurvePoint& point, const ColumnSet& wanted) {
  TableRow row;
  fill_row(input.branch_name(), point.member, wanted, row);
  tell_in(input.coordinates, wanted, row);
  row.event = name(sought_event(input));
  const auto [first, second] = curve_place(input, point);
  row.parameter = first;
  row.second_parameter = second;
  return row;
}

EventEnclosure prove_curve_row(const Case& input, const EventCurvePoint& point, TableRow& row) {
  const std::unique_ptr<Kind> kind =
      kind_of(numbers_of(input, point.member.parameter, point.second));
  const auto proof =
      prove_event(*kind, family_parameter_of(input, 0), sought_event(input), point.member, row);
  if (proof) return *proof;
  EventEnclosure none;
  none.reason = "the event has no equations of its own here";
  row.certified = proof_word(false);
  return none;
}

}  // namespace stationary::cli
