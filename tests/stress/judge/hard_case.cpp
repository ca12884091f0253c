#include "tests/stress/judge/hard_case.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "lib/material/potential.hpp"

namespace stationary::stress {
namespace {

/// The centrifugal rate per nu^2 that pulls hardest in the plane.
double pulling_inertia(const Ingredients& of) {
  return of.branch == Branch::i ? of.J2 : of.branch == Branch::ii ? of.J1 : std::max(of.J1, of.J2);
}

/// Coefficients, J and nu for which S = (xi, zeta, rho) is stationary: the balance read backwards,
/// nothing where it would take one that is out of bounds.
std::optional<Ingredients> balanced_at(Ingredients out, const Stretch& q) {
  if (out.model.thickness.empty()) return std::nullopt;
  const auto gradient = [&] {
    const Potential potential = testing::named_potential(out.model, out.plane, out.axial);
    return potential.visit_parts(
        [&](const auto& model) { return potential_derivatives<1>(model, q).gradient; });
  };
  const double nu_squared = out.nu * out.nu;
  if (out.branch != Branch::iii) {
    // V is linear in its coefficients: the second one makes the free stretch balance.
    const Eigen::Index free = out.branch == Branch::i ? 1 : 2;
    const double probe = out.plane[1];
    const double with = gradient()[free];
    out.plane[1] = 2.0 * probe;
    const double slope = (gradient()[free] - with) / probe;
    out.plane[1] = probe - with / slope;
  }
  if (!(out.plane[1] > 0.0 && out.plane[1] < 1e12)) return std::nullopt;
  const auto pull = gradient();
  if (out.branch != Branch::ii) out.J2 = pull[2] / (q.zeta * nu_squared);
  if (out.branch != Branch::i) out.J1 = pull[1] / (q.xi * nu_squared);
  const double rate = out.branch == Branch::iii ? 0.0 : out.J3 * nu_squared;
  if (out.model.thickness == "harmonic") {
    out.axial[1] = q.rho * (1.0 - rate / out.axial[0]);  // the rest thickness
  } else {
    out.axial[0] = q.rho * q.rho * q.rho * (out.axial[1] - rate);
  }
  const double must_be_positive[] = {out.J1, out.J2, out.J3, out.axial[0], out.axial[1]};
  if (!std::ranges::all_of(must_be_positive, [](double p) { return p > 1e-60 && p < 1e60; }))
    return std::nullopt;
  out.start = q;
  return out;
}

/// S is given and the case is made for it; from near S, or from rest.
HardCase made_for(Random& random, const auto& stretch) {
  for (;;) {
    Ingredients raw = random_ingredients(random, 1.0);
    const auto made = balanced_at(raw, stretch(random));
    if (!made) continue;
    Ingredients out = *made;
    if (random.integer(0, 2) == 0) {
      out.start.reset();
    } else {
      for (double* each : {&out.start->xi, &out.start->zeta, &out.start->rho})
        *each *= 1.0 + 0.02 * random.uniform(-1.0, 1.0);
    }
    return out.posed();
  }
}

}  // namespace

HardCase Ingredients::posed() const {
  const Body body(J1, J2, J3);
  std::ostringstream text;
  text.precision(17);
  text << model.model << " " << plane[0] << " " << plane[1] << ", " << model.thickness << " "
       << axial[0] << " " << axial[1] << ", J (" << J1 << ", " << J2 << ", " << J3 << "), ("
       << name(branch) << "), nu " << nu;
  if (start) text << ", from (" << start->xi << ", " << start->zeta << ", " << start->rho << ")";
  HardCase out{
      Problem(body, testing::named_potential(model, plane, axial), branch), nu, {}, text.str()};
  out.options.start = start;
  return out;
}

Ingredients random_ingredients(Random& random, double orders) {
  const auto positive = [&] { return power_of_ten(random, -0.5 * orders, 0.5 * orders); };
  const auto& models = testing::potential_names();
  Ingredients out;
  out.model =
      models[static_cast<std::size_t>(random.integer(0, static_cast<int>(models.size()) - 1))];
  if (out.model.thickness == "reciprocal-quadratic" && random.integer(0, 3) == 0)
    out.model.thickness = "harmonic";
  out.plane = {positive(), positive()};
  out.axial = {positive(), positive()};
  out.J1 = positive();
  out.J2 = positive();
  out.J3 = positive();
  out.branch = static_cast<Branch>(random.integer(0, 2));
  out.nu = random.sign() * escape_speed(out) * random.log_uniform(1e-2, 1.2);
  return out;
}

double escape_speed(const Ingredients& of) {
  const bool reciprocal = of.model.model == "reciprocal-determinant";
  const bool linear = of.model.model == "biot" || of.model.model == "biot-log";
  const double stiffness = reciprocal ? of.plane[1] : (linear ? 2.0 : 1.0) * of.plane[0];
  return std::sqrt(stiffness / pulling_inertia(of));
}

double power_of_ten(Random& random, double low, double high) {
  return std::pow(10.0, random.uniform(low, high));
}

HardCase well_posed(Random& random) {
  Ingredients out = random_ingredients(random, 2.0);
  if (random.integer(0, 9) == 0) out.J2 = out.J1;
  return out.posed();
}

HardCase ratios(Random& random) { return random_ingredients(random, 8.0).posed(); }

HardCase slow(Random& random) {
  Ingredients out = random_ingredients(random, 2.0);
  out.nu *= power_of_ten(random, -12.0, -3.0);
  if (random.integer(0, 9) == 0) out.nu = 0.0;
  return out.posed();
}

HardCase near_escape(Random& random) {
  Ingredients out = random_ingredients(random, 2.0);
  const double short_of = power_of_ten(random, -12.0, -2.0);
  const double side = random.integer(0, 4) == 0 ? -1.0 : 1.0;
  out.nu = random.sign() * escape_speed(out) * (1.0 - side * short_of);
  if (out.model.thickness == "reciprocal-quadratic" && random.integer(0, 3) == 0) {
    // The thickness escapes instead: V_rho' = J3 nu^2 rho has rho^3 = a/(b - J3 nu^2).
    out.J3 = 4.0 * out.axial[1] / (out.nu * out.nu);
    out.nu = random.sign() * std::sqrt(out.axial[1] / out.J3) * (1.0 - side * short_of);
  }
  return out.posed();
}

HardCase equal_inertias(Random& random) {
  Ingredients out = random_ingredients(random, 2.0);
  const double apart = random.integer(0, 3) == 0 ? 0.0 : power_of_ten(random, -15.7, -3.0);
  out.J2 = out.J1 * (1.0 + random.sign() * apart);
  return out.posed();
}

HardCase thin_and_thick(Random& random) {
  Ingredients out = random_ingredients(random, 1.0);
  for (double* each : {&out.J3, &out.axial[0], &out.axial[1]})
    *each *= power_of_ten(random, -8.0, 8.0);
  if (random.integer(0, 1) == 0) out.nu = std::sqrt(out.axial[1] / out.J3) * random.uniform(0, 1);
  return out.posed();
}

// Other units have the same motions: J ~ mass, V ~ mass/time^2.
HardCase units(Random& random) {
  Ingredients out = random_ingredients(random, 1.0);
  const double mass = power_of_ten(random, -30.0, 30.0);
  const double time = power_of_ten(random, -15.0, 15.0);
  for (double* each : {&out.J1, &out.J2, &out.J3}) *each *= mass;
  for (double* each : {&out.plane[0], &out.plane[1]}) *each *= mass / (time * time);
  if (out.model.thickness == "harmonic") {
    out.axial[0] *= mass / (time * time);
  } else {
    for (double& each : out.axial) each *= mass / (time * time);
  }
  out.nu /= time;
  return out.posed();
}

HardCase collapse(Random& random) {
  return made_for(random, [](Random& r) {
    const double d = power_of_ten(r, -10.0, 0.0);
    const double ratio = power_of_ten(r, -4.0, 4.0);
    return Stretch{0.0, std::sqrt(d * ratio), std::sqrt(d / ratio), power_of_ten(r, -10.0, 0.0)};
  });
}

HardCase large_stretches(Random& random) {
  return made_for(random, [](Random& r) {
    return Stretch{0.0, power_of_ten(r, -2.0, 6.0), power_of_ten(r, -2.0, 6.0),
                   power_of_ten(r, -2.0, 6.0)};
  });
}

}  // namespace stationary::stress
