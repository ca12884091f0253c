// Curves of events against the events of single families:
//
//   event_curves_bench > results/event_curves.csv
//
// Random bodies are followed in nu; of an event that they have, the curve in nu and in a second
// number of the body is followed. At points along it the family in nu of that value of the second
// number is followed anew, and its own event of the type is looked for. A row for each type: curves,
// values of the second number, at how many of them the family has the event, and the largest
// relative difference between the two nu. Of isotropic bodies, and of some with a fibre along a
// material axis. Which bodies they are, fixed seeds say.
//   cmake --build build/release --target event_curves
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "solver/event_curve/event_curve.hpp"
#include "solver/motion/body_circle.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/followed.hpp"

namespace {

using namespace stationary;

using Kind = FamilyParameter::Kind;

constexpr long enough = 50;
constexpr int most_bodies = 40'000;
constexpr long of_one_curve = 5;

struct Count {
  long curves = 0;
  long values = 0;
  long found = 0;
  double difference = 0.0;
};

/// Families in nu, a second number of theirs, and where one of them is followed.
struct Families {
  std::function<Problem(double second)> at;
  FamilyParameter second;
  double own;
  double to;  ///< of nu, from 0
  /// Whose sheet is followed, and at which nu; nothing: the rest state's.
  std::optional<Stretch> start{};
  double nu = 0.02 * to;
};

/// The event of the type of the family in nu that is nearest to the curve's point; nothing where
/// none is found beside it.
std::optional<double> own_event(const Families& families, const EventCurvePoint& point,
                                EventType type) {
  const double nu = point.member.parameter;
  const Problem problem = families.at(point.second);
  std::optional<double> nearest;
  for (const double beside : {1.0 - 1e-4, 1.0 + 1e-4, 1.0 - 1e-5, 1.0 + 1e-5}) {
    SolveOptions start;
    start.start = point.member.q;
    start.search = false;
    if (solve(problem, nu * beside, start).status != SolveStatus::solved) continue;
    const testing::Followed sheet =
        testing::followed(problem, nu * beside,
                          testing::range(nu * (1.0 - 2e-3), nu * (1.0 + 2e-3), 1e-6), true, start);
    for (const testing::FollowedRow& row : sheet.events({type}))
      if (!nearest || std::abs(row.member.parameter - nu) < std::abs(*nearest - nu))
        nearest = row.member.parameter;
    if (nearest) break;
  }
  return nearest;
}

void compare(const Families& families, std::map<EventType, Count>& counts) {
  const Problem own = families.at(families.own);
  SolveOptions start;
  if (families.start) {
    start.start = families.start;
    start.method = Method::newton;
    start.search = false;
  }
  if (solve(own, families.nu, start).status != SolveStatus::solved) return;
  const testing::Followed sheet =
      testing::followed(own, families.nu, testing::range(0.0, families.to, 1e-6), true, start);
  const bool isotropic = own.potential().is_isotropic();
  for (const testing::FollowedRow& row : sheet.events()) {
    Count& count = counts[row.event];
    if (!has_event_curve(row.event, true, isotropic) || count.values >= enough) continue;
    const auto at = [&](double nu, double second) {
      return SpinningProblem{families.at(second), nu};
    };
    const EventCurve curve =
        follow_event_curve(spin_setting(at, {}, families.second, row.event), row.member,
                           families.own, circle_of(own, families.second),
                           {.first_from = 0.0,
                            .first_to = families.to,
                            .second_from = 0.95 * families.own,
                            .second_to = 1.05 * families.own,
                            .tolerance = 1e-6,
                            .spectrum = false});
    if (!curve.failure.empty()) continue;
    ++count.curves;
    const auto all = static_cast<long>(curve.points.size());
    for (long k = 0; k < of_one_curve && k < all; ++k) {
      const EventCurvePoint& point =
          curve.points[static_cast<std::size_t>(k * (all - 1) / std::max(1L, of_one_curve - 1))];
      ++count.values;
      const auto nu = own_event(families, point, row.event);
      if (!nu) {
        std::fprintf(stderr, "no %.*s near nu = %.17g, %.17g\n",
                     static_cast<int>(name(row.event).size()), name(row.event).data(),
                     point.member.parameter, point.second);
        continue;
      }
      ++count.found;
      count.difference = std::max(count.difference, std::abs(point.member.parameter / *nu - 1.0));
    }
  }
}

Families isotropic_families(support::Random& random) {
  const auto posed = testing::random_problem(random, 1.0);
  const Body body = posed.problem.body();
  // What breaks a circle is none of its numbers.
  const int k = body.J1 == body.J2 ? 2 : random.integer(0, 2);
  const double own = k == 0 ? body.J1 : k == 1 ? body.J2 : body.J3;
  const auto at = [=](double J) {
    return Problem(Body(k == 0 ? J : body.J1, k == 1 ? J : body.J2, k == 2 ? J : body.J3),
                   posed.problem.potential(), posed.problem.branch());
  };
  Families out{at, {Kind::inertia, k}, own, 4.0 * std::abs(posed.nu)};
  if (random.integer(0, 1) == 1) {
    out.start = random.diagonal_stretch(8.0);
    out.nu = std::abs(posed.nu);
  }
  return out;
}

Families fibred_families(support::Random& random) {
  const double J1 = random.log_uniform(0.5, 2.0);
  const double J2 = J1 * random.log_uniform(0.7, 1.5);
  const Body body(J1, J2, random.log_uniform(0.3, 2.0));
  const double k = random.log_uniform(0.02, 0.6);
  const double degrees = 90.0 * random.integer(0, 1);
  const double mu = random.log_uniform(0.5, 2.0);
  const double lambda = random.log_uniform(0.5, 2.0);
  const auto branch = static_cast<Branch>(random.integer(0, 2));
  const bool hencky = random.integer(0, 1) == 1;
  const auto at = [=](double stiffness) {
    const AnisotropicPotential::Plane plane =
        hencky ? AnisotropicPotential::Plane(Hencky<>{mu, lambda})
               : AnisotropicPotential::Plane(NeoHookean<>{mu, lambda});
    return Problem(body,
                   Potential(AnisotropicPotential(plane, ReciprocalQuadratic<>{1.0, 3.0},
                                                  {{stiffness, degrees}})),
                   branch);
  };
  return {at, {Kind::fibre, 0}, k, 1.5};
}

bool complete(const std::map<EventType, Count>& counts) {
  for (const EventType type :
       {EventType::fold_nu, EventType::fold_momentum, EventType::tilt, EventType::inertia_exchange,
        EventType::ellipse, EventType::oblique, EventType::shear, EventType::hamiltonian_hopf,
        EventType::real_collision, EventType::krein_pass}) {
    const auto at = counts.find(type);
    if (at == counts.end() || at->second.values < enough) return false;
  }
  return true;
}

}  // namespace

int main() {
  support::Random random(20'261'125);
  std::map<EventType, Count> counts;
  int bodies = 0;
  for (; bodies < most_bodies && !complete(counts); ++bodies) {
    const Families families =
        bodies % 4 == 3 ? fibred_families(random) : isotropic_families(random);
    try {
      compare(families, counts);
    } catch (const std::exception& e) {
      std::fprintf(stderr, "%s\n", e.what());
    }
  }
  std::puts("event,curves,values,found,largest_difference");
  for (const auto& [type, count] : counts)
    if (count.values > 0)
      std::printf("%.*s,%ld,%ld,%ld,%.2g\n", static_cast<int>(name(type).size()), name(type).data(),
                  count.curves, count.values, count.found, count.difference);
  std::fprintf(stderr, "%d bodies\n", bodies);
  return 0;
}
