#include "tests/stress/cases/curve_survey.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "solver/family/anisotropic_family.hpp"
#include "solver/family/follow_sheet.hpp"
#include "solver/family/tilted_family.hpp"
#include "solver/family/two_polar_family.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"
#include "solver/solve/tilted_equilibrium.hpp"
#include "solver/solve/two_polar_equilibrium.hpp"
#include "tests/stress/judge/hard_case.hpp"
#include "tests/support/bodies/random_anisotropic.hpp"

namespace stationary::stress {
namespace {

/// A family and a motion of it.
struct Begun {
  AnyFamily family;
  Stretch q;
  double p;
  std::string text;
};

std::optional<Begun> about_an_axis(const Problem& problem, double nu, const std::string& text) {
  const Equilibrium at = solve(problem, nu);
  if (at.status != SolveStatus::solved) return std::nullopt;
  return Begun{axis_family(problem, {.nu = 0.0, .parameter = {}, .spectrum = true}), at.q, nu,
               text};
}

/// Few speeds have one: as many bodies are drawn as it takes.
std::optional<Begun> tilted(Random& random) {
  constexpr int draws = 60;
  for (int k = 0; k < draws; ++k) {
    const Ingredients of = random_ingredients(random, 1.0);
    const HardCase c = of.posed();
    const auto plane = random.integer(0, 1) == 0 ? TiltPlane::one_three : TiltPlane::two_three;
    const double nu = std::abs(of.nu);
    const Body& body = c.problem.body();
    const Equilibrium at = solve_tilted(body, c.problem.potential(), {plane, nu});
    if (at.status != SolveStatus::solved) continue;
    return Begun{AnyFamily(tilted_family(body, c.problem.potential(), plane, true)), at.q, nu,
                 "tilted " + std::string(name(plane)) + ", " + c.text};
  }
  return std::nullopt;
}

std::optional<Begun> two_polar(Random& random) {
  Ingredients of = random_ingredients(random, 0.6);
  of.J2 = of.J1;
  of.branch = Branch::iii;
  const HardCase c = of.posed();
  const double speed = std::abs(of.nu);
  const TwoPolarRates<double> rates{speed * random.uniform(0.2, 1.0),
                                    speed * random.uniform(-1.0, 1.0)};
  const Body& body = c.problem.body();
  const Equilibrium at = solve_two_polar(body, c.problem.potential(), rates);
  if (at.status != SolveStatus::solved) return std::nullopt;
  std::ostringstream text;
  text.precision(17);
  text << "two-polar, omega " << rates.omega << ", theta' " << rates.theta_dot << ", " << c.text;
  TwoPolarFamilyOptions options{rates, {}, true};
  return Begun{two_polar_family(body, c.problem.potential(), options), at.q, rates.omega,
               text.str()};
}

std::optional<Begun> anisotropic(Random& random) {
  const auto [V, name_of] = support::random_anisotropic(random, random.integer(0, 7));
  const Body body = random.body(2.0);
  const double nu = random.uniform(0.1, 0.6);
  std::ostringstream text;
  text.precision(17);
  text << name_of << ", J (" << body.J1 << ", " << body.J2 << ", " << body.J3 << "), nu " << nu;
  if (random.integer(0, 1) == 0)
    return about_an_axis(Problem(body, Potential(V), Branch::iii), nu, text.str() + ", (iii)");
  const Branch near = random.integer(0, 1) == 0 ? Branch::i : Branch::ii;
  const Equilibrium at = solve_oblique(body, Potential(V), {nu, near});
  if (at.status != SolveStatus::solved) return std::nullopt;
  return Begun{
      AnyFamily(oblique_family(body, V, {.nu = 0.0, .parameter = {}, .spectrum = true}, near)),
      at.q, nu, text.str() + ", oblique"};
}

std::optional<Begun> begun(Random& random, std::size_t kind) {
  if (kind == 3) return tilted(random);
  if (kind == 4) return two_polar(random);
  if (kind == 5) return anisotropic(random);
  Ingredients of = random_ingredients(random, 2.0);
  if (kind == 0) of.branch = random.integer(0, 1) == 0 ? Branch::i : Branch::ii;
  if (kind == 1) of.branch = Branch::iii;
  if (kind == 2) of.J2 = of.J1;
  const HardCase c = of.posed();
  return about_an_axis(c.problem, of.nu, c.text);
}

struct Row {
  Member member;
  EventType event;
};

class Kept final : public CurveSink {
 public:
  void row(const Member& member, EventType event) override { rows.push_back({member, event}); }
  std::vector<Row> rows;
};

struct Sweep {
  FollowReport report;
  std::vector<Row> rows;
};

Sweep swept(const Begun& from, double tolerance) {
  FollowOptions options;
  const double reach = 3.0 * std::abs(from.p);
  options.continuation.from = from.p < 0.0 ? -reach : 0.0;
  options.continuation.to = from.p < 0.0 ? 0.0 : reach;
  options.continuation.step.tolerance = tolerance;
  options.max_points = 2'000;
  Kept kept;
  Sweep out;
  out.report = follow(from.family, from.q, from.p, options, kept);
  out.rows = std::move(kept.rows);
  return out;
}

bool is_event(EventType type) { return type != EventType::none && !is_end(type); }

/// Whether a row says what class the curve is of there.
bool tells(const Row& row) {
  return row.event == EventType::none && row.member.spectrum &&
         row.member.spectrum->verdict != StabilityClass::marginal &&
         (row.member.nu != 0.0 || row.member.two_polar);
}

/// Of a circle's motion with negative directions `stable` is told where energy and momentum together are
/// definite. That ends where no Lambda meets another: no event.
bool is_by_momentum(const Member& a, const Member& b) {
  const auto round = [](const Member& each) { return each.q.xi == each.q.zeta; };
  const auto of = [](const Member& each, StabilityClass verdict) {
    return each.spectrum->verdict == verdict;
  };
  constexpr auto stable = StabilityClass::stable;
  constexpr auto elliptic = StabilityClass::elliptic;
  return round(a) && round(b) && a.spectrum->negative > 0 &&
         a.spectrum->negative == b.spectrum->negative &&
         ((of(a, stable) && of(b, elliptic)) || (of(a, elliptic) && of(b, stable)));
}

/// Every change between two rows that tell has an event between them.
void judge_rows(const Begun& from, const Sweep& sweep, CurveSurvey& out) {
  const Row* before = nullptr;
  bool event = false;
  for (const Row& row : sweep.rows) {
    ++out.rows;
    event = event || is_event(row.event);
    if (!tells(row)) continue;
    if (before != nullptr) {
      const Spectrum& a = *before->member.spectrum;
      const Spectrum& b = *row.member.spectrum;
      const bool counted = a.away_from_zero() && b.away_from_zero() && a.negative != b.negative;
      if (counted || (a.verdict != b.verdict && !is_by_momentum(before->member, row.member))) {
        ++out.changes;
        const double low = std::min(before->member.parameter, row.member.parameter);
        const double high = std::max(before->member.parameter, row.member.parameter);
        const bool open = std::ranges::any_of(sweep.report.events, [&](const EventRecord& each) {
          return each.status == EventStatus::unresolved &&
                 std::min(each.before, each.after) <= high &&
                 std::max(each.before, each.after) >= low;
        });
        if (!event && !open) {
          std::ostringstream text;
          text.precision(17);
          text << from.text << ": between " << before->member.parameter << " (" << name(a.verdict)
               << ", " << a.negative << ") and " << row.member.parameter << " (" << name(b.verdict)
               << ", " << b.negative << ") there is no event";
          out.faults.push_back(text.str());
        }
      }
    }
    before = &row;
    event = false;
  }
}

std::vector<const EventRecord*> located(const Sweep& sweep) {
  std::vector<const EventRecord*> out;
  for (const EventRecord& each : sweep.report.events)
    if (each.status != EventStatus::unresolved) out.push_back(&each);
  return out;
}

std::string listed(const std::vector<const EventRecord*>& events) {
  std::ostringstream out;
  out.precision(12);
  for (const EventRecord* each : events) out << " " << name(each->type) << " " << each->parameter;
  return out.str();
}

/// The two sweeps have the same events, up to their order where two are at one place.
void judge_sweeps(const Begun& from, const Sweep& coarse, const Sweep& fine, CurveSurvey& out) {
  auto some = located(coarse);
  auto all = located(fine);
  const auto before = [](const EventRecord* a, const EventRecord* b) {
    return a->type != b->type ? a->type < b->type : a->parameter < b->parameter;
  };
  std::ranges::sort(some, before);
  std::ranges::sort(all, before);
  bool same = some.size() == all.size();
  for (std::size_t k = 0; same && k < some.size(); ++k) {
    const double off = std::abs(some[k]->parameter - all[k]->parameter);
    same = some[k]->type == all[k]->type && off <= 1e-6 * std::abs(from.p);
  }
  if (!same)
    out.faults.push_back(from.text + ": events" + listed(some) + "; in finer steps" + listed(all));
}

}  // namespace

CurveSurvey survey_curves(long first, long count) {
  CurveSurvey out;
  for (long k = first; k < first + count; ++k) {
    ++out.tried;
    Random random(0x5eed0000U + static_cast<std::uint64_t>(k));
    const auto kind = static_cast<std::size_t>(k) % surveyed_kinds.size();
    const std::optional<Begun> from = begun(random, kind);
    if (!from) continue;
    const Sweep coarse = swept(*from, std::pow(10.0, -random.uniform(4.0, 7.0)));
    const Sweep fine = swept(*from, 1e-10);
    if (!coarse.report.failure.empty() || !fine.report.failure.empty()) continue;
    ++out.followed;
    ++out.of_kind[kind];
    out.events += static_cast<long>(located(coarse).size());
    out.unresolved += static_cast<long>(coarse.report.events.size() - located(coarse).size());
    judge_rows(*from, coarse, out);
    judge_rows(*from, fine, out);
    const bool whole = !coarse.report.out_of_points && !fine.report.out_of_points;
    if (whole) judge_sweeps(*from, coarse, fine, out);
  }
  return out;
}

}  // namespace stationary::stress
