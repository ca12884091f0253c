// In the place of the certificates of rows and events, a quarter of the program's code: a page asks for none
// (web/live/live.cpp). What an exhaustive search proves it proves here too.
#include <stdexcept>

#include "solver/kind/oriented_event_enclosure.hpp"
#include "solver/kind/sheared_certificate.hpp"
#include "solver/kind/tilted_event_enclosure.hpp"
#include "solver/kind/two_polar_event_enclosure.hpp"
#include "solver/proof/anisotropic_enclosure.hpp"
#include "solver/proof/certify.hpp"
#include "solver/proof/event_enclosure.hpp"
#include "solver/proof/tilted_enclosure.hpp"
#include "solver/proof/two_polar_enclosure.hpp"

namespace stationary {
namespace {

[[noreturn]] void refuse() { throw std::logic_error("a page has no certificates"); }

}  // namespace

Certificate certify(const Problem&, const Equilibrium&, Inputs) { refuse(); }
Certificate certify_tilted(const Body&, const Potential&, const TiltedRotation&, const Equilibrium&,
                           Inputs) {
  refuse();
}
Certificate certify_two_polar(const Body&, const Potential&, const TwoPolarMotion&,
                              const Equilibrium&, Inputs) {
  refuse();
}
Certificate certify_oblique(const Body&, const Potential&, const ObliqueRotation&,
                            const Equilibrium&, Inputs) {
  refuse();
}
template <int N>
Certificate certify_sheared(const ShearedEquations<N>&, double, const Equilibrium&) {
  refuse();
}
template Certificate certify_sheared(const ShearedEquations<3>&, double, const Equilibrium&);
template Certificate certify_sheared(const ShearedEquations<4>&, double, const Equilibrium&);
template <int N>
SpectrumEnclosure enclose_sheared_spectrum(const ShearedEquations<N>&, double, const Certificate&,
                                           const Spectrum&) {
  refuse();
}
template SpectrumEnclosure enclose_sheared_spectrum(const ShearedEquations<3>&, double,
                                                    const Certificate&, const Spectrum&);
template SpectrumEnclosure enclose_sheared_spectrum(const ShearedEquations<4>&, double,
                                                    const Certificate&, const Spectrum&);
SpectrumEnclosure enclose_spectrum(const Problem&, const Equilibrium&, const Certificate&,
                                   const Spectrum&, Inputs) {
  refuse();
}
SpectrumEnclosure enclose_spectrum(const Body&, const Potential&, const TiltedRotation&,
                                   const Certificate&, const Spectrum&, Inputs) {
  refuse();
}
SpectrumEnclosure enclose_spectrum(const Body&, const Potential&, const TwoPolarMotion&,
                                   const Equilibrium&, const Certificate&, const Spectrum&,
                                   Inputs) {
  refuse();
}
SpectrumEnclosure enclose_oblique_spectrum(const Body&, const Potential&, const ObliqueRotation&,
                                           const Certificate&, const Spectrum&, Inputs) {
  refuse();
}

bool has_enclosure(EventType) { return false; }
EventEnclosure enclose_event(const Problem&, const FamilyParameter&, Circle, EventType,
                             const Member&, Inputs) {
  refuse();
}
std::optional<EventEnclosure> enclose_oriented_event(const Problem&, const FamilyParameter&,
                                                     EventType, const Member&, Inputs) {
  refuse();
}
std::optional<EventEnclosure> enclose_oblique_event(const Body&, const AnisotropicPotential&,
                                                    const FamilyParameter&, EventType,
                                                    const Member&, Inputs) {
  refuse();
}
std::optional<EventEnclosure> enclose_tilted_event(const Body&, const Potential&, TiltPlane,
                                                   EventType, const Member&, Inputs) {
  refuse();
}
std::optional<EventEnclosure> enclose_two_polar_event(const Body&, const Potential&,
                                                      const TwoPolarMotion&, const FamilyParameter&,
                                                      EventType, const Member&, Inputs) {
  refuse();
}
std::optional<EventEnclosure> enclose_sheared_event(const Body&, const Potential&, ShearedAxis,
                                                    EventType, const Member&) {
  refuse();
}

}  // namespace stationary
