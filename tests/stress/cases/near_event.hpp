// Cases a given distance from where a motion changes: folds, and zeros and collisions of the
// spectrum. The events are those of sheets drawn at random (connected to rest or not) and followed;
// a fold's nu is found again in 50 digits, from
//
//   G(x; nu) = 0,   det dG/d ln x = 0,
//
// so that its distance means what it says down to 1e-14.
#pragma once

#include <array>
#include <initializer_list>

#include "solver/motion/event.hpp"
#include "tests/stress/judge/hard_case.hpp"

namespace stationary::stress {

struct LocatedEvent {
  Ingredients family;  ///< nu: the event's
  EventType type;
  Stretch q;
};

/// A fold-nu: on the curve q exp(a along) nearby, ln |nu| is that of the fold + bend a^2.
struct LocatedFold {
  Ingredients family;  ///< nu: the fold's, to the last place
  Stretch q;
  std::array<double, 3> along;  ///< of ln (xi, zeta, rho); length 1
  double bend;
};

/// The next event of one of the types on a sheet drawn at random.
LocatedEvent random_event(Random& random, std::initializer_list<EventType> types);

/// The next fold-nu; every other one of a model that is not hencky, which has most of them.
LocatedFold random_fold(Random& random);

/// nu at a relative distance (1e-14 ... 1e-2) from a fold, where its two solutions are; the start
/// is one of them to leading order.
HardCase beside_fold(Random& random, const LocatedFold& fold, double distance);

/// nu at a relative distance from the event, on either side; the start is the event's stretch.
HardCase beside_event(Random& random, const LocatedEvent& event, double distance);

// At distances of 1e-14 ... 1e-4:
HardCase near_fold(Random& random);       ///< a turn of nu; half of them not of hencky
HardCase near_collision(Random& random);  ///< two pairs of eigenvalues meet and leave an axis
HardCase near_pass(Random& random);       ///< two pairs of opposite signature meet and pass
HardCase near_zero(Random& random);       ///< a pair of eigenvalues is zero

}  // namespace stationary::stress
