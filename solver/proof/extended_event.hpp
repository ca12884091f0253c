// The equations of an event (event_system.hpp) at points in extended precision: they correct a
// located event, say how far its inputs move it, and are what a curve of events is followed by.
//
//   y = (xi, zeta, rho, p, Lambda)
//
// On circles the second equation is zeta = xi; where Lambda is no unknown, the last is Lambda = 1.
#pragma once

#include <memory>
#include <optional>

#include "solver/motion/event.hpp"
#include "solver/motion/extended_root.hpp"
#include "solver/motion/problem.hpp"
#include "solver/proof/sought_event.hpp"

namespace stationary {

class ExtendedEventEquations {
 public:
  static constexpr int dimension = 5;
  static constexpr int parameter = 3;  ///< the place of p in y
  static constexpr int lambda = 4;

  ExtendedEventEquations() = default;
  ExtendedEventEquations(const ExtendedEventEquations&) = delete;
  ExtendedEventEquations& operator=(const ExtendedEventEquations&) = delete;
  virtual ~ExtendedEventEquations() = default;

  /// The value of the number that the setting holds (EventSetting::held).
  virtual void hold(double value) = 0;
  virtual ExtendedVector<dimension> values(const ExtendedVector<dimension>& y) const = 0;
  /// The root near y; nothing where the equations are singular there.
  virtual std::optional<ExtendedRoot<dimension>> root(const ExtendedVector<dimension>& y) const = 0;
  /// Of each equation the sum of |c dG/dc| over the numbers of the problem and the unknowns.
  virtual std::array<double, dimension> conditions(const ExtendedVector<dimension>& y) const = 0;
};

std::unique_ptr<ExtendedEventEquations> extended_event_equations(const EventSetting& setting,
                                                                 const EventFunction& function);

/// Of a located member; its parameter is p.
ExtendedVector<ExtendedEventEquations::dimension> event_unknowns(const Member& member,
                                                                 const SoughtEvent& what);

}  // namespace stationary
