// Folds of every kind of motion: at one value of what turns, the reduced energies of the two motions
// that are s to either side of the fold differ by 2/3 |F_vvv| s^3 + O(s^5).
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>

#include "lib/balance/two_polar.hpp"
#include "solver/kind/kind.hpp"
#include "solver/normal_form/normal_form.hpp"
#include "solver/solve/two_polar_equilibrium.hpp"
#include "tests/support/bodies/anisotropic_motions.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/followed.hpp"

namespace stationary::testing {
namespace {

using Coordinates = Eigen::Matrix<double, 5, 1>;

/// (ln xi, ln zeta, ln rho, a, the axis' angle).
Coordinates coordinates(const Stretch& q, const Vector3<double>& nu, bool tilted) {
  const double angle =
      tilted ? std::atan2(nu[2], std::hypot(nu[0], nu[1])) : std::atan2(nu[1], nu[0]);
  return {std::log(q.xi), std::log(q.zeta), std::log(q.rho),
          std::atanh(q.alpha / std::sqrt(q.xi * q.zeta)), angle};
}
Stretch moved(const Stretch& q, const Coordinates& by) {
  const double a = std::atanh(q.alpha / std::sqrt(q.xi * q.zeta)) + by[3];
  Stretch out{0.0, q.xi * std::exp(by[0]), q.zeta * std::exp(by[1]), q.rho * std::exp(by[2])};
  out.alpha = std::sqrt(out.xi * out.zeta) * std::tanh(a);
  return out;
}

/// A family, how a single motion of it is solved, and its reduced energy.
struct Subject {
  std::function<std::unique_ptr<Kind>(double)> at;  ///< the parameter given
  FamilyParameter parameter;
  std::function<double(const Equilibrium&, bool momentum)> energy;
  std::function<double(const Equilibrium&)> momentum;
  bool tilted = false;

  Equilibrium solve(double p, const Stretch& start) const {
    return at(p)->solve(without_search(start));
  }
};

double spin_energy(const Kind& kind, const Equilibrium& at, bool momentum) {
  const Vector3<double> nu = at.nu;
  const double twice = nu.dot(locked_inertia(kind.body(), at.q) * nu);
  const double V = kind.potential().value(at.q);
  return momentum ? V + 0.5 * twice : V - 0.5 * twice;
}

Subject spinning(const Body& body, const Potential& potential,
                 const std::function<Motion(double)>& motion, bool tilted) {
  Subject out;
  out.at = [=](double nu) { return kind_of(body, potential, motion(nu)); };
  const std::shared_ptr<Kind> any = out.at(1.0);
  out.energy = [any](const Equilibrium& at, bool momentum) {
    return spin_energy(*any, at, momentum);
  };
  out.momentum = [any](const Equilibrium& at) {
    return (locked_inertia(any->body(), at.q) * at.nu).norm();
  };
  out.tilted = tilted;
  return out;
}

/// Half the way between the two motions, and the coefficient that their energies give.
struct Measured {
  double half;
  double coefficient;
};

/// Beside the fold at rows[k], a part t of the way to the row before.
std::optional<Measured> measured(const Subject& of, const Followed& sheet, std::size_t k,
                                 double t) {
  const Member& fold = sheet.rows[k].member;
  const Member& before = sheet.rows[k - 1].member;
  const bool momentum = sheet.rows[k].event == EventType::fold_momentum;
  Coordinates way = coordinates(before.q, before.angular_velocity, of.tilted) -
                    coordinates(fold.q, fold.angular_velocity, of.tilted);
  way *= t;
  const double part = momentum ? t : t * t;
  const double rest = fold.parameter + part * (before.parameter - fold.parameter);
  const Equilibrium one = of.solve(rest, moved(fold.q, way));
  double p = momentum ? fold.parameter - (rest - fold.parameter) : rest;
  Equilibrium other = of.solve(p, moved(fold.q, -way));
  if (one.status != SolveStatus::solved || other.status != SolveStatus::solved) return std::nullopt;
  if (momentum) {  // to the same |pi|, by its secant
    const double wanted = of.momentum(one);
    double last = p * (1.0 + 1e-4);
    Equilibrium near = of.solve(last, other.q);
    for (int step = 0; step < 20; ++step) {
      if (near.status != SolveStatus::solved || other.status != SolveStatus::solved)
        return std::nullopt;
      const double here = of.momentum(other) - wanted;
      if (std::abs(here) <= 1e-15 * wanted) break;
      const double slope = (of.momentum(near) - of.momentum(other)) / (last - p);
      if (slope == 0.0) break;
      near = other;
      last = std::exchange(p, p - here / slope);
      if (p == last) break;
      other = of.solve(p, other.q);
    }
  }
  const double half =
      0.5 *
      (coordinates(one.q, one.nu, of.tilted) - coordinates(other.q, other.nu, of.tilted)).norm();
  const double gain = of.energy(one, momentum) - of.energy(other, momentum);
  return Measured{half, 1.5 * std::abs(gain) / (half * half * half)};
}

/// The number of folds compared.
int compare_folds(const Subject& of, const Followed& sheet) {
  int compared = 0;
  for (std::size_t k = 1; k + 1 < sheet.rows.size(); ++k) {
    const Member& fold = sheet.rows[k].member;
    const EventType event = sheet.rows[k].event;
    if (event != EventType::fold_nu && event != EventType::fold_parameter &&
        event != EventType::fold_momentum)
      continue;
    const auto form = of.at(fold.parameter)->normal_form(of.parameter, event, fold);
    if (!form) continue;
    const double size = (coordinates(sheet.rows[k - 1].member.q,
                                     sheet.rows[k - 1].member.angular_velocity, of.tilted) -
                         coordinates(fold.q, fold.angular_velocity, of.tilted))
                            .norm();
    const auto wide = measured(of, sheet, k, 0.04 / size);
    const auto narrow = measured(of, sheet, k, 0.02 / size);
    // A solve may have come to another motion.
    const auto near = [](const auto& at, double s) {
      return at && std::abs(at->half / s - 1.0) < 0.2;
    };
    if (!near(wide, 0.04) || !near(narrow, 0.02)) continue;
    // To the fourth order.
    const double w2 = wide->half * wide->half;
    const double n2 = narrow->half * narrow->half;
    const double expected = (narrow->coefficient * w2 - wide->coefficient * n2) / (w2 - n2);
    EXPECT_NEAR(std::abs(form->coefficient), expected, 0.02 * expected)
        << name(event) << " at " << fold.parameter << "; " << wide->coefficient << " "
        << narrow->coefficient;
    EXPECT_LE(form->error, 1e-5 * std::abs(form->coefficient));
    EXPECT_EQ(form->coefficient > 0.0, form->side == EventSide::after);
    const auto turning = [&](std::size_t row) {
      const Member& at = sheet.rows[row].member;
      if (event != EventType::fold_momentum) return at.parameter;
      return (locked_inertia(at.body, at.q) * at.angular_velocity).norm();
    };
    EXPECT_EQ(form->side, turning(k - 1) > turning(k) ? EventSide::after : EventSide::before);
    ++compared;
  }
  return compared;
}

TEST(FoldLaw, OfTiltedAxes) {
  support::Random random(77);
  int compared = 0;
  for (int k = 0; k < 250; ++k) {
    const Posed posed = random_problem(random, 1.0);
    const auto plane = random.integer(0, 1) == 0 ? TiltPlane::one_three : TiltPlane::two_three;
    const double nu = std::abs(posed.nu);
    const Subject of = spinning(
        posed.problem.body(), posed.problem.potential(),
        [plane](double at) {
          return TiltedMotion{plane, at};
        },
        true);
    const Equilibrium start = of.at(nu)->solve({});
    if (start.status != SolveStatus::solved) continue;
    SCOPED_TRACE(posed.text);
    compared += compare_folds(
        of, followed(of.at(nu)->family({}, {}, start.q), start.q, nu, range(0.0, 4.0 * nu, 1e-5)));
  }
  RecordProperty("compared", compared);
  EXPECT_GE(compared, 4);
}

TEST(FoldLaw, OfFibredBodies) {
  int compared = 0;
  for (const double degrees : {0.0, 30.0, 90.0}) {
    for (const double k : {0.05, 0.4}) {
      const Potential potential = fibred(Hencky<>{1.1, 0.8}, k, degrees);
      for (const Branch branch : {Branch::i, Branch::iii}) {
        if (branch == Branch::i && degrees == 30.0) continue;
        const Subject of = spinning(
            Body(1.0, 1.7, 0.6), potential,
            [branch](double at) {
              return AxisRotation{branch, at};
            },
            false);
        const Equilibrium rest = of.at(0.0)->solve({});
        SCOPED_TRACE(std::to_string(degrees) + " " + std::to_string(k));
        compared += compare_folds(
            of, followed(of.at(0.0)->family({}, {}, rest.q), rest.q, 0.0, range(0.0, 2.0)));
      }
    }
  }
  RecordProperty("compared", compared);
  EXPECT_GE(compared, 8);
}

/// Spins about each axis, and tilted ones.
TEST(FoldLaw, OfBodiesWhoseVolumeIsHeld) {
  support::Random random(41);
  int compared[2] = {0, 0};
  for (int k = 0; k < 80; ++k) {
    const Posed posed = random_problem(random, 1.0);
    BodyModel<> held;
    if (!posed.problem.potential().is_separable()) continue;
    held.elastic.plane = AnyPlane<>{posed.problem.potential().plane()};
    held.elastic.thickness = AnyThickness<>{posed.problem.potential().thickness()};
    held.volume = 0.8 + 0.005 * k;
    const Potential potential(held);
    const double nu = std::abs(posed.nu);
    for (const bool tilted : {false, true}) {
      const Branch branch = posed.problem.branch();
      const Subject of = spinning(
          posed.problem.body(), potential,
          [=](double at) {
            return tilted ? Motion(TiltedMotion{TiltPlane::one_three, at})
                          : Motion(AxisRotation{branch, at});
          },
          tilted);
      const double from = tilted ? nu : 0.0;
      const Equilibrium start = of.at(from)->solve({});
      if (start.status != SolveStatus::solved) continue;
      SCOPED_TRACE(posed.text + (tilted ? " tilted" : ""));
      compared[tilted] +=
          compare_folds(of, followed(of.at(from)->family({}, {.spectrum = false}, start.q), start.q,
                                     from, range(0.0, 3.0 * nu)));
    }
  }
  RecordProperty("spins", compared[0]);
  RecordProperty("tilted", compared[1]);
  EXPECT_GE(compared[0], 5);
}

/// The folds of a spin's sheet through rest, compared.
int compare_folds_from_rest(const Body& body, const Potential& potential, Branch branch) {
  const Subject of = spinning(
      body, potential,
      [branch](double at) {
        return AxisRotation{branch, at};
      },
      false);
  const Equilibrium rest = of.at(0.0)->solve({});
  EXPECT_EQ(rest.status, SolveStatus::solved) << rest.message;
  return compare_folds(of, followed(of.at(0.0)->family({}, {.spectrum = false}, rest.q), rest.q,
                                    0.0, range(0.0, 4.0)));
}

/// J1 = J2, about axis 3: the sheet keeps xi = zeta, and with the volume one stretch is left.
TEST(FoldLaw, OfCirclesWhoseVolumeIsHeld) {
  for (const double lambda : {4.0, 8.0}) {
    BodyModel<> held;
    held.elastic.plane = AnyPlane<>{Hencky<>{1.1, lambda}};
    held.elastic.thickness = AnyThickness<>{ReciprocalQuadratic<>{0.1, 0.3}};
    held.volume = 1.0;
    EXPECT_GE(compare_folds_from_rest(Body(1.0, 1.0, 0.6), Potential(held), Branch::iii), 1);
  }
}

/// Equal inertias, about an axis in the plane: Maclaurin's spheroids, a little elastic, turn back where
/// nu is largest.
TEST(FoldLaw, OfCirclesWithTheThickness) {
  const Body body(1.0, 1.0, 1.0);
  BodyModel<> held;
  held.elastic.coupled = NeoHookean3d<>{0.01, 1.0};
  held.volume = 1.0;
  held.gravitates = true;
  held.g = 1.0;
  held.J = {body.J1, body.J2, body.J3};
  for (const Branch branch : {Branch::i, Branch::ii})
    EXPECT_GE(compare_folds_from_rest(body, Potential(held), branch), 1) << name(branch);
}

TEST(FoldLaw, OfObliqueAxes) {
  support::Random random(5);
  int compared = 0;
  for (int k = 0; k < 120; ++k) {
    const OrientedBody at = random_oriented_body(random, k);
    for (const Branch near : {Branch::i, Branch::ii}) {
      const Subject of = spinning(
          at.body, at.potential(),
          [near](double nu) {
            return ObliqueRotation{nu, near};
          },
          false);
      const Equilibrium start = of.at(at.nu)->solve(without_search());
      if (start.status != SolveStatus::solved) continue;
      SCOPED_TRACE(at.text);
      compared += compare_folds(of, followed(of.at(at.nu)->family({}, {.spectrum = false}, start.q),
                                             start.q, at.nu, range(0.0, 3.0)));
    }
  }
  RecordProperty("compared", compared);
  EXPECT_GE(compared, 5);
}

/// Of what is held, one varies; |pi| is no number of these families.
Subject two_polar(const Body& body, const Potential& potential, const TwoPolarMotion& motion,
                  int index) {
  Subject out;
  out.parameter = {FamilyParameter::Kind::nu, index};
  out.at = [=](double p) {
    TwoPolarMotion varied = motion;
    std::visit(
        [&](auto& held) {
          auto& [first, second] = held;
          (index == 0 ? first : second) = p;
        },
        varied);
    return kind_of(body, potential, varied);
  };
  const bool by_momenta = std::holds_alternative<TwoPolarMomenta<double>>(motion);
  out.energy = [=](const Equilibrium& at, bool) {
    const Vector3<double> x(at.q.xi, at.q.zeta, at.q.rho);
    const double T = two_polar_kinetic_energy(body.J1, x, at.two_polar->rates);
    return potential.value(at.q) + (by_momenta ? T : -T);
  };
  return out;
}

TEST(FoldLaw, OfTwoPolarMotions) {
  support::Random random(78);
  const Body round(1.25, 1.25, 0.6);
  int compared = 0;
  for (int k = 0; k < 240; ++k) {
    const std::string_view model = k % 2 == 0 ? "saint-venant-kirchhoff" : "biot-log";
    const Potential potential =
        make_potential(model, {random.log_uniform(0.5, 2.0), random.log_uniform(0.5, 4.0)});
    // Of every other two, turned round: |pi| grows where s3 falls.
    const double turn = k % 4 < 2 ? 1.0 : -1.0;
    const TwoPolarRates<double> rates{turn * random.uniform(0.4, 1.3), random.uniform(-0.5, 0.5)};
    const Equilibrium start = solve_two_polar(round, potential, rates);
    if (start.status != SolveStatus::solved || start.circle) continue;
    for (const int index : {0, 1}) {
      for (const bool by_momenta : {false, true}) {
        const auto& momenta = start.two_polar->momenta;
        const TwoPolarMotion motion = by_momenta ? TwoPolarMotion(momenta) : TwoPolarMotion(rates);
        const double p = by_momenta ? (index == 0 ? momenta.s3 : momenta.p_theta)
                                    : (index == 0 ? rates.omega : rates.theta_dot);
        const Subject of = two_polar(round, potential, motion, index);
        FollowOptions how = range(p - 1.0, p + 1.0, 1e-6);
        how.max_points = 500;
        SCOPED_TRACE(std::string(model) + " " + std::to_string(k) + (by_momenta ? " pi" : " nu"));
        compared +=
            compare_folds(of, followed(of.at(p)->family(of.parameter, {.spectrum = false}, start.q),
                                       start.q, p, how));
      }
    }
  }
  RecordProperty("compared", compared);
  EXPECT_GE(compared, 5);
}

}  // namespace
}  // namespace stationary::testing
