#include "lib/number/elementary.hpp"
#include "solver/atlas/sheet_source.hpp"

namespace stationary {
namespace {

class ShearedSheets final : public SheetSource {
 public:
  ShearedSheets(const Body& body, const Potential& potential)
      : body_(body), potential_(potential) {}

  Branch branch() const override { return Branch::i; }
  bool oblique() const override { return true; }

  SearchResult search(double nu, const SearchOptions& options) const override {
    return at(nu)->search(options);
  }
  std::optional<StabilityClass> proven_class(const Equilibrium& motion, Inputs) const override {
    return proven_class_of(*at(hypotenuse(motion.nu[0], motion.nu[1])), motion);
  }

  /// They begin on (i) and (ii) alone.
  std::vector<Place> at_rest(const SolveOptions&) const override { return {}; }

  AnyFamily family(int, bool spectrum) const override {
    return at(1.0)->family({}, {.spectrum = spectrum}, {});
  }

  Place canonical(const Place& at) const override { return mirrored_upwards(at); }

  EventType leaves_by() const override { return EventType::oblique; }
  bool leaves_at(const Member& at) const override { return at.q.alpha == 0.0; }
  DepartureResult departure(Branch parent, const Member& at, double) const override {
    return leave_mirror(family(0, false), at, parent);
  }

 private:
  std::unique_ptr<Kind> at(double nu) const {
    return kind_of(body_, potential_, ObliqueRotation{nu});
  }

  Body body_;
  Potential potential_;
};

}  // namespace

std::unique_ptr<SheetSource> sheared_sheets(const Body& body, const Potential& potential) {
  return std::make_unique<ShearedSheets>(body, potential);
}

}  // namespace stationary
