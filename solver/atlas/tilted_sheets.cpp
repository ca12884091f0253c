#include "solver/atlas/sheet_source.hpp"
#include "solver/family/tilted_family.hpp"

namespace stationary {
namespace {

class TiltedSheets final : public SheetSource {
 public:
  TiltedSheets(const Body& body, const Potential& potential, TiltPlane plane)
      : body_(body), potential_(potential), plane_(plane) {}

  Branch branch() const override { return in_plane_branch(plane_); }
  std::optional<TiltPlane> plane() const override { return plane_; }

  SearchResult search(double nu, const SearchOptions& options) const override {
    return at(nu)->search(options);
  }
  std::optional<KindCover> cover(double from, double to, const SearchOptions& options,
                                 bool classes) const override {
    return cover_tilted(body_, potential_, plane_, from, to, options, classes);
  }
  std::optional<StabilityClass> proven_class(const Equilibrium& motion, Inputs) const override {
    return proven_class_of(*at(motion.nu.norm()), motion);
  }

  /// At rest nothing is tilted.
  std::vector<Place> at_rest(const SolveOptions&) const override { return {}; }
  AnyFamily family(int, bool spectrum) const override {
    return tilted_family(body_, potential_, plane_, spectrum);
  }
  DepartureResult departure(Branch, const Member&, double) const override {
    return "tilted sheets are entered from the tilts of others";
  }

 private:
  std::unique_ptr<Kind> at(double nu) const {
    return kind_of(body_, potential_, TiltedMotion{plane_, nu});
  }

  Body body_;
  Potential potential_;
  TiltPlane plane_;
};

}  // namespace

std::unique_ptr<SheetSource> tilted_sheets(const Body& body, const Potential& potential,
                                           TiltPlane plane) {
  return std::make_unique<TiltedSheets>(body, potential, plane);
}

}  // namespace stationary
