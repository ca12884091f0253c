// The normal form (normal_form.hpp) of events of two-polar families. F is V - T at given rates, V + T
// at given momenta (lib/balance/two_polar.hpp), in ln (lambda, mu, rho).
#include <cmath>

#include "solver/family/two_polar_events.hpp"
#include "solver/motion/varied_balance.hpp"
#include "solver/normal_form/normal_form.hpp"
#include "solver/normal_form/reduction.hpp"

namespace stationary {
namespace {

using T = AlongLine;

template <template <class> class Held>
class TwoPolarGradient {
 public:
  TwoPolarGradient(const Body& body, const Potential& potential, const Held<double>& motion,
                   const FamilyParameter& parameter, const Member& member)
      : body_(body),
        potential_(potential),
        motion_(motion),
        parameter_(parameter),
        x_{about(member.q.xi, member), about(member.q.zeta, member), about(member.q.rho, member)},
        p_(member) {}

  std::vector<T> operator()(const IntervalVector& d, double c) const {
    using Kind = FamilyParameter::Kind;
    const T p = p_.along(c);
    std::array<T, 3> x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = T(x_[k]) * exp(T::along(Interval(0.0), d[k]));
    const auto number = [&](double value, Kind kind, int index) {
      const InputPlace at = input_place(potential_, kind, index);
      return varies(parameter_, at.kind, at.index) ? p : T(Interval(value));
    };
    const auto& [first, second] = motion_;
    const Held<T> motion{number(first, Kind::nu, 0), number(second, Kind::nu, 1)};
    const CentrifugalRates<T> none{T(0.0), T(0.0), T(0.0)};
    const LogBalance<T> V = varied_balance(potential_, x[0], x[1], x[2], none, number);
    const TwoPolarPull<T> pull = two_polar_pull(T(Interval(body_.J1)), x[0], x[1], motion);
    return {V.g_xi - pull.lambda, V.g_zeta - pull.mu, V.g_rho};
  }

 private:
  Body body_;
  Potential potential_;
  Held<double> motion_;
  FamilyParameter parameter_;
  std::array<Interval, 3> x_;
  NearParameter p_;
};

template <template <class> class Held>
std::optional<NormalForm> form(const TwoPolarGradient<Held>& gradient, bool circle,
                               TwoPolarVanishing what) {
  std::vector<IntervalVector> kept = along_coordinates({0, 1, 2}, 3);
  if (circle) {
    const Interval side = sqrt(Interval(0.5));
    kept = {{side, side, 0.0}, {0.0, 0.0, 1.0}};
  }
  if (what == TwoPolarVanishing::fold) return fold_form(gradient, kept);
  if (what == TwoPolarVanishing::ellipse) return breaking_form(gradient, {1.0, -1.0, 0.0}, kept);
  return std::nullopt;
}

}  // namespace

std::optional<NormalForm> two_polar_normal_form(const Body& body, const Potential& potential,
                                                const TwoPolarMotion& motion,
                                                const FamilyParameter& parameter, EventType type,
                                                const Member& member) {
  if (!is_known(member)) return std::nullopt;
  const bool circle = member.q.xi == member.q.zeta;
  const auto what = vanishing_at(type, circle, member);
  if (!what) return std::nullopt;
  auto out = std::visit(
      [&](const auto& held) -> std::optional<NormalForm> {
        return form(TwoPolarGradient(body, potential, held, parameter, member), circle, *what);
      },
      motion);
  // |pi| = |s3| grows where a negative s3 falls.
  const bool in_s3 = parameter.kind == FamilyParameter::Kind::nu && parameter.index == 0;
  if (out && in_s3 && type == EventType::fold_momentum && member.parameter < 0.0) {
    out->coefficient = -out->coefficient;
    out->side = out->side == EventSide::after ? EventSide::before : EventSide::after;
  }
  return out;
}

}  // namespace stationary
