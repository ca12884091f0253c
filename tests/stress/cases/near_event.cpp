#include "tests/stress/cases/near_event.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "solver/family/follow_sheet.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary::stress {
namespace {

using testing::Linearized50;
using testing::Number50;

double rounded(const Number50& x) { return x.convert_to<double>(); }

struct EventRow {
  EventType type;
  double nu;
  Stretch q;
};

/// The rows that are events of the types looked for.
class EventSink final : public CurveSink {
 public:
  explicit EventSink(std::initializer_list<EventType> types) : types_(types) {}
  void row(const Member& member, EventType event) override {
    if (std::ranges::find(types_, event) != types_.end())
      found.push_back({event, member.nu, member.q});
  }
  std::vector<EventRow> found;

 private:
  std::vector<EventType> types_;
};

Number50 determinant(const Linearized50<2>& at) {
  const auto& J = at.second;
  return J[0][0] * J[1][1] - J[0][1] * J[1][0];
}
Number50 determinant(const Linearized50<3>& at) {
  const auto& J = at.second;
  return J[0][0] * (J[1][1] * J[2][2] - J[1][2] * J[2][1]) -
         J[0][1] * (J[1][0] * J[2][2] - J[1][2] * J[2][0]) +
         J[0][2] * (J[1][0] * J[2][1] - J[1][1] * J[2][0]);
}

/// From a rough fold, by Newton on (G, det dG/d ln x) in (ln x, ln nu^2), its derivatives by
/// differences of 1e-25: exact enough for steps that shrink as 1e-25.
template <std::size_t N, class Balance>
LocatedFold exact_fold(const Ingredients& family, const EventRow& rough, const Balance& balance) {
  using Unknowns = std::array<Number50, N>;
  using Bordered = std::array<Number50, N + 1>;
  const auto split = [](const Bordered& y) {
    Unknowns x;
    std::copy_n(y.begin(), N, x.begin());
    return x;
  };
  const auto equations = [&](const Bordered& y) {
    const Linearized50<N> at = balance(y[N], split(y));
    Bordered out;
    std::copy_n(at.first.begin(), N, out.begin());
    out[N] = determinant(at);
    return out;
  };
  const double start[] = {rough.q.xi, rough.q.zeta, rough.q.rho};
  Bordered y;
  std::copy_n(std::begin(start), N, y.begin());
  y[N] = Number50(rough.nu) * Number50(rough.nu);
  y = testing::newton_50<N + 1>(y, [&](const Bordered& at) {
    const Number50 h("1e-25");
    Linearized50<N + 1> out;
    out.first = equations(at);
    for (std::size_t j = 0; j <= N; ++j) {
      Bordered shifted = at;
      shifted[j] *= 1 + h;
      const Bordered there = equations(shifted);
      for (std::size_t i = 0; i <= N; ++i) out.second[i][j] = (there[i] - out.first[i]) / h;
    }
    return out;
  });

  // The kernel of the symmetric J, by inverse iteration; G's curvature along it against its slope.
  Linearized50<N> at = balance(y[N], split(y));
  for (std::size_t i = 0; i < N; ++i) at.second[i][i] *= 1 + Number50("1e-25");
  Unknowns along = testing::solved<N>(at.second, Unknowns{Number50(1)});
  Number50 norm = 0;
  for (const Number50& c : along) norm += c * c;
  for (Number50& c : along) c /= sqrt(norm);
  const auto projected = [&](const Number50& arc, const Number50& factor) {
    Unknowns x = split(y);
    for (std::size_t i = 0; i < N; ++i) x[i] *= exp(Number50(arc * along[i]));
    const auto g = balance(Number50(y[N] * factor), x).first;
    Number50 sum = 0;
    for (std::size_t i = 0; i < N; ++i) sum += along[i] * g[i];
    return sum;
  };
  const Number50 h("1e-12");
  const Number50 curvature = (projected(h, 1) + projected(Number50(-h), 1)) / (h * h);
  const Number50 slope = projected(0, Number50(1 + h)) / h;
  LocatedFold out{family, rough.q, {}, rounded(-curvature / (4 * slope))};
  out.family.nu = std::copysign(rounded(sqrt(y[N])), rough.nu);
  double* const stretches[] = {&out.q.xi, &out.q.zeta, &out.q.rho};
  for (std::size_t i = 0; i < N; ++i) {
    *stretches[i] = rounded(y[i]);
    out.along[i] = rounded(along[i]);
  }
  return out;
}

LocatedFold exact_fold(const Ingredients& family, const EventRow& rough) {
  const Problem problem = family.posed().problem;
  if (problem.potential().is_separable())
    return exact_fold<2>(family, rough, [&](const Number50& s, const std::array<Number50, 2>& x) {
      return testing::planar_balance_50(problem, s, x);
    });
  return exact_fold<3>(family, rough, [&](const Number50& s, const std::array<Number50, 3>& x) {
    return testing::coupled_balance_50(problem, s, x);
  });
}

/// Events of one random sheet.
std::vector<EventRow> events_of(Random& random, const Ingredients& family,
                                std::initializer_list<EventType> types) {
  const HardCase c = family.posed();
  SolveOptions how;
  if (random.integer(0, 2) != 0) {
    how.method = Method::newton;
    how.start = random.diagonal_stretch(8.0);
  }
  const double nu = std::abs(family.nu);
  const Equilibrium start = solve(c.problem, nu, how);
  if (start.status != SolveStatus::solved) return {};
  FollowOptions options;
  options.continuation.from = 0.0;
  options.continuation.to = 2.0 * escape_speed(family);
  options.continuation.step.tolerance = 1e-4;
  options.max_points = 2000;
  EventSink sink(types);
  follow(axis_family(c.problem, {.nu = 0.0, .parameter = {}, .spectrum = true}), start.q, nu,
         options, sink);
  return sink.found;
}

double distance(Random& random) { return power_of_ten(random, -14.0, -4.0); }

/// only: the models to be drawn from; empty: any.
LocatedEvent event_of(Random& random, std::initializer_list<EventType> types,
                      std::initializer_list<std::string_view> only) {
  for (;;) {
    Ingredients family = random_ingredients(random, 1.0);
    if (only.size() != 0 && std::ranges::find(only, family.model.model) == only.end()) continue;
    if (random.integer(0, 3) == 0) family.J2 = family.J1 * (1.0 + 0.1 * random.uniform(-1.0, 1.0));
    if (random.integer(0, 5) == 0) family.J2 = family.J1;
    const auto events = events_of(random, family, types);
    if (events.empty()) continue;
    const EventRow& chosen =
        events[static_cast<std::size_t>(random.integer(0, static_cast<int>(events.size()) - 1))];
    family.nu = chosen.nu;
    return {family, chosen.type, chosen.q};
  }
}

}  // namespace

LocatedEvent random_event(Random& random, std::initializer_list<EventType> types) {
  return event_of(random, types, {});
}

LocatedFold random_fold(Random& random) {
  for (;;) {
    const LocatedEvent rough =
        random.integer(0, 1) == 0
            ? event_of(random, {EventType::fold_nu}, {})
            : event_of(random, {EventType::fold_nu}, {"biot-log", "neo-hookean"});
    try {
      return exact_fold(rough.family, {rough.type, rough.family.nu, rough.q});
    } catch (const std::runtime_error&) {
      // Newton left it: the fold is nearly a cusp. Another one.
    }
  }
}

HardCase beside_event(Random& random, const LocatedEvent& event, double distance) {
  Ingredients out = event.family;
  out.nu *= 1.0 + random.sign() * distance;
  out.start = event.q;
  return out.posed();
}

HardCase beside_fold(Random& random, const LocatedFold& fold, double distance) {
  Ingredients out = fold.family;
  out.nu *= 1.0 + std::copysign(distance, fold.bend);
  const double arc = random.sign() * std::sqrt(distance / std::abs(fold.bend));
  out.start = fold.q;
  out.start->xi *= std::exp(arc * fold.along[0]);
  out.start->zeta *= std::exp(arc * fold.along[1]);
  out.start->rho *= std::exp(arc * fold.along[2]);
  return out.posed();
}

HardCase near_fold(Random& random) {
  return beside_fold(random, random_fold(random), distance(random));
}

HardCase near_collision(Random& random) {
  const LocatedEvent event =
      random_event(random, {EventType::hamiltonian_hopf, EventType::real_collision});
  return beside_event(random, event, distance(random));
}

HardCase near_pass(Random& random) {
  return beside_event(random, random_event(random, {EventType::krein_pass}), distance(random));
}

HardCase near_zero(Random& random) {
  const LocatedEvent event =
      random_event(random, {EventType::tilt, EventType::fold_momentum, EventType::ellipse});
  return beside_event(random, event, distance(random));
}

}  // namespace stationary::stress
