#include "solver/motion/body_circle.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/number/elementary.hpp"
#include "solver/motion/varied_balance.hpp"

namespace stationary {
namespace {

using Force = std::array<DoubleDouble, 3>;

/// Another value of a family's parameter, so far from its own.
DoubleDouble another(double value, double apart) {
  return value != 0.0 ? DoubleDouble(value) * (1.0 + apart) : DoubleDouble(apart);
}

/// V's part of the balance at x, with the family's parameter so far from its own value.
class Elastic {
 public:
  Elastic(const Potential& potential, const FamilyParameter& parameter, double apart)
      : potential_(potential), parameter_(parameter), apart_(apart) {}

  Force at(const std::array<DoubleDouble, 3>& x) const {
    const CentrifugalRates<DoubleDouble> at_rest{0.0, 0.0, 0.0};
    const auto number = [&](double value, FamilyParameter::Kind kind, int index) {
      const InputPlace place = input_place(potential_, kind, index);
      return varies(parameter_, place.kind, place.index) ? another(value, apart_)
                                                         : DoubleDouble(value);
    };
    const LogBalance<DoubleDouble> b =
        varied_balance(potential_, x[0], x[1], x[2], at_rest, number);
    return {b.g_xi, b.g_zeta, b.g_rho};
  }

 private:
  const Potential& potential_;
  FamilyParameter parameter_;
  double apart_;
};

enum class Answer { same, other, undefined };

/// Whether V's force at x is that at the exchanged x, exchanged: along directions that keep a held
/// volume.
Answer compare(const Elastic& V, const CirclePlaces& at, const std::array<DoubleDouble, 3>& x,
               bool volume_held) {
  std::array<DoubleDouble, 3> exchanged = x;
  const auto a = static_cast<std::size_t>(at.first);
  const auto b = static_cast<std::size_t>(at.second);
  const auto c = static_cast<std::size_t>(at.other);
  exchanged[a] = x[b];
  exchanged[b] = x[a];
  const Force here = V.at(x);
  const Force there = V.at(exchanged);
  double size = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    size += std::abs(double(here[k])) + std::abs(double(there[k]));
  if (!std::isfinite(size)) return Answer::undefined;
  const DoubleDouble across = (here[a] - here[b]) + (there[a] - there[b]);
  const DoubleDouble along =
      (2.0 * here[c] - here[a] - here[b]) - (2.0 * there[c] - there[a] - there[b]);
  const DoubleDouble all = (here[a] + here[b] + here[c]) - (there[a] + there[b] + there[c]);
  constexpr double rounding = 0x1p-70;
  double most = std::max(std::abs(double(across)), std::abs(double(along)));
  if (!volume_held) most = std::max(most, std::abs(double(all)));
  return most <= rounding * size ? Answer::same : Answer::other;
}

bool is_symmetric(const Potential& potential, const FamilyParameter& parameter,
                  const CirclePlaces& at) {
  const BodyModel<>* body = potential.body_model();
  const bool held = body != nullptr && body->volume;
  const double unit = held ? cube_root(*body->volume) : 1.0;
  int defined = 0;
  for (const double apart : {0.0, 0.375}) {
    const Elastic V(potential, parameter, apart);
    const bool volume_varies = held && varies(parameter, FamilyParameter::Kind::plane,
                                              static_cast<int>(BodyModel<>::volume_place));
    for (const double first : {0.83, 1.29, 2.17}) {
      for (const double second : {0.71, 1.13}) {
        std::array<DoubleDouble, 3> x;
        x[static_cast<std::size_t>(at.first)] = DoubleDouble(unit * first);
        x[static_cast<std::size_t>(at.second)] = DoubleDouble(unit * second);
        DoubleDouble& other = x[static_cast<std::size_t>(at.other)];
        other = DoubleDouble(0.93 * unit);
        if (held) {
          const DoubleDouble volume(*body->volume);
          other = volume * (volume_varies ? 1.0 + apart : 1.0) /
                  (DoubleDouble(unit * first) * DoubleDouble(unit * second));
        }
        switch (compare(V, at, x, held)) {
          case Answer::other:
            return false;
          case Answer::same:
            ++defined;
            break;
          case Answer::undefined:
            break;
        }
      }
    }
  }
  constexpr int enough = 6;
  return defined >= enough;
}

}  // namespace

Circle circle_of(const Problem& problem, const FamilyParameter& parameter) {
  const Potential& potential = problem.potential();
  if (!potential.is_isotropic()) return Circle::none;
  const Circle circle = problem.branch() == Branch::iii  ? Circle::xi_zeta
                        : problem.branch() == Branch::ii ? Circle::xi_rho
                                                         : Circle::zeta_rho;
  const CirclePlaces at = places(circle);
  const Body& body = problem.body();
  const double J[3] = {body.J1, body.J2, body.J3};
  const bool breaks = parameter.kind == FamilyParameter::Kind::inertia &&
                      (parameter.index == at.first || parameter.index == at.second);
  if (breaks || J[at.first] != J[at.second]) return Circle::none;
  if (circle == Circle::xi_zeta) return circle;
  return is_symmetric(potential, parameter, at) ? circle : Circle::none;
}

}  // namespace stationary
