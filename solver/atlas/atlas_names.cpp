// What is said of an atlas, apart from how it is made.
#include "solver/atlas/atlas.hpp"

namespace stationary {

Motion AtlasSheet::motion(double nu) const {
  if (plane) return TiltedMotion{plane, nu};
  if (oblique) return ObliqueRotation{nu};
  return AxisRotation{branch, nu};
}

double Completeness::unproven_length() const {
  double out = 0.0;
  for (const CompleteInterval& each : intervals)
    if (!each.proven) out += each.to - each.from;
  return out;
}

std::string_view kind_name(Branch branch, bool oblique) {
  return oblique ? oblique_name : name(branch);
}

}  // namespace stationary
