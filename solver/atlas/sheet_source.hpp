// What an atlas (atlas.hpp) asks of one kind of motion, about one of the material axes, oblique or tilted:
// all its motions at one nu, the families that its sheets belong to, and where its sheets leave
// others.
//
// A motion is a place: S and, oblique, the axis. Of a place and its mirror image (of the material's
// own symmetry) one is kept, the canonical one.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "solver/atlas/sheet_kind.hpp"
#include "solver/family/axis_family.hpp"
#include "solver/kind/kind.hpp"
#include "solver/motion/event.hpp"
#include "solver/search/search.hpp"
#include "solver/solve/solve.hpp"
#include "solver/tube/kind_cover.hpp"

namespace stationary {

struct Place {
  Stretch q;
  double axis = 0.0;  ///< oblique: angle from axis 1, that of a line; else 0
};

/// Nearer than this two places are the same: sheets of one kind meet only at branch points.
constexpr double same_place = 1e-6;

/// Of S and its mirror image, alpha and the axis' angle reversed, that with alpha > 0; alpha = 0 to
/// rounding: exactly.
Place mirrored_upwards(const Place& at);

/// The largest difference of the ln of xi, zeta, rho and of the angles: atanh of
/// alpha/sqrt(xi zeta), and the axis'.
double distance(const Place& a, const Place& b);

/// A motion a little way along a sheet that leaves another, or why none was found.
struct Departure {
  Place at;
  double nu;
};
using DepartureResult = std::variant<Departure, std::string>;

/// Those of solve() at nu = 0.
std::vector<Place> places_at_rest(const Problem& problem, const SolveOptions& options);

/// By the decimals of the case, which hold its doubles.
std::optional<StabilityClass> proven_class_of(const Kind& kind, const Equilibrium& at);
std::optional<StabilityClass> proven_class_of(const Problem& problem, const Equilibrium& at,
                                              Inputs inputs);

class SheetSource {
 public:
  SheetSource() = default;
  SheetSource(const SheetSource&) = delete;
  SheetSource& operator=(const SheetSource&) = delete;
  virtual ~SheetSource() = default;

  virtual Branch branch() const = 0;
  virtual bool oblique() const { return false; }
  virtual std::optional<TiltPlane> plane() const { return std::nullopt; }
  SheetKind kind() const { return {branch(), oblique(), plane()}; }

  /// Every motion at nu > 0, mirror images among them. May be called by several threads.
  virtual SearchResult search(double nu, const SearchOptions& options) const = 0;
  /// For every nu in a range, with their classes if they are wanted; nothing of kinds whose curves are
  /// not covered.
  virtual std::optional<KindCover> cover(double /*from*/, double /*to*/, const SearchOptions&,
                                         bool /*classes*/) const {
    return std::nullopt;
  }
  /// Whether it is proven that no motion at any nu of a range is outside the box (kind_cover.hpp).
  virtual bool none_outside(double /*from*/, double /*to*/, const SearchOptions&) const {
    return false;
  }
  /// Of a motion found by a search with these inputs; nothing where it is not proven.
  virtual std::optional<StabilityClass> proven_class(const Equilibrium&, Inputs) const = 0;
  /// Where sheets begin at nu = 0; none where the rest state is not found.
  virtual std::vector<Place> at_rest(const SolveOptions& options) const = 0;

  /// The families its sheets are followed in, by number, and which one a place is of.
  virtual int families() const { return 1; }
  virtual int family_of(const Place&) const { return 0; }
  virtual AnyFamily family(int which, bool spectrum) const = 0;

  Place place(const Stretch& q, const Vector3<double>& nu) const;
  virtual Place canonical(const Place& at) const { return at; }
  /// In whose plane an ellipse is told as that which is drawn out along the first of its two axes.
  virtual Circle mirror() const { return Circle::none; }

  /// The event on other sheets at which sheets of this kind begin, or none.
  virtual EventType leaves_by() const { return EventType::none; }
  /// Whether, at that event, this is a place where they do.
  virtual bool leaves_at(const Member&) const { return false; }
  /// The nu of that event at a place where they do, proven; nothing where it is not.
  virtual std::optional<Interval> proven_parting(const Member&, Inputs) const {
    return std::nullopt;
  }
  /// parent: the branch of the sheet left. range: of nu, for the scale.
  virtual DepartureResult departure(Branch parent, const Member& at, double range) const = 0;

 protected:
  /// By the family with alpha != 0 that begins at an event of a sheet with alpha = 0.
  DepartureResult leave_mirror(const AnyFamily& family, const Member& at, Branch parent) const;
};

/// Of an isotropic V about a material axis; about axis 3 those with alpha != 0 among them.
std::unique_ptr<SheetSource> axis_sheets(const Problem& problem);

/// Of another V; about axis 1 or 2 of a shear-free one (else there are no sheets: throws
/// std::invalid_argument).
std::unique_ptr<SheetSource> anisotropic_sheets(const Problem& problem);
std::unique_ptr<SheetSource> oblique_sheets(const Body& body, const Potential& potential);

/// Of an isotropic V, tilted in a plane. They leave others at their tilts: there an atlas enters them.
std::unique_ptr<SheetSource> tilted_sheets(const Body& body, const Potential& potential,
                                           TiltPlane plane);

/// Oblique ones of an isotropic V with gravity (Potential::may_shear()).
std::unique_ptr<SheetSource> sheared_sheets(const Body& body, const Potential& potential);

}  // namespace stationary
