// Cases that are hard on a solver: what they are made of, and by which rules they are drawn. Those
// near an event of a sheet are in near_event.hpp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "solver/motion/problem.hpp"
#include "solver/solve/solve.hpp"
#include "tests/support/bodies/motions.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary::stress {

using support::Random;

struct HardCase {
  Problem problem;
  double nu;
  SolveOptions options;  ///< a start, or none: from rest
  std::string text;      ///< all of it, for messages
};

/// What a case is made of: numbers to be pushed to extremes before it is posed.
struct Ingredients {
  testing::PotentialName model;
  std::array<double, 2> plane{1.0, 1.0};
  std::array<double, 2> axial{1.0, 3.0};
  double J1 = 1.0;
  double J2 = 1.0;
  double J3 = 1.0;
  Branch branch = Branch::i;
  double nu = 0.5;
  std::optional<Stretch> start;

  HardCase posed() const;
};

/// Every model, every branch; positive coefficients and J, each within 10^(-orders/2) ...
/// 10^(orders/2); nu from slow to somewhat beyond what the body can hold.
Ingredients random_ingredients(Random& random, double orders);

/// The least |nu| at which the model lets a stretch grow without bound on the way from rest (for
/// hencky: the speed of that order).
double escape_speed(const Ingredients& of);

/// A power of ten between 10^low and 10^high, every order alike.
double power_of_ten(Random& random, double low, double high);

HardCase well_posed(Random& random);       ///< coefficients over two orders
HardCase ratios(Random& random);           ///< over eight
HardCase collapse(Random& random);         ///< d and rho down to 1e-10
HardCase large_stretches(Random& random);  ///< up to 1e6
HardCase slow(Random& random);             ///< nu down to 1e-12 of the escape speed, and 0
HardCase near_escape(Random& random);      ///< of the plane or the thickness, within 1e-12 ... 1e-2
HardCase equal_inertias(Random& random);   ///< J1 = J2, and within 2e-16 ... 1e-3
HardCase thin_and_thick(Random& random);   ///< J3, a and b over sixteen orders
HardCase units(Random& random);            ///< masses over sixty orders, times over thirty

}  // namespace stationary::stress
