// A kind of stationary motion with the numbers that prescribe one, of one body and potential: what
// finds its ellipsoids, proves them, gives their spectrum and follows them. Everything that serves
// all kinds (rows, maps, proofs of tables, commands) asks a Kind, and never which kind it is.
//
// A new kind is a class of these questions and its place in alternatives().
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lib/body/motion.hpp"
#include "lib/material/potential.hpp"
#include "solver/family/follow_sheet.hpp"
#include "solver/normal_form/normal_form.hpp"
#include "solver/proof/event_enclosure.hpp"
#include "solver/search/search.hpp"
#include "solver/solve/at_values.hpp"
#include "solver/solve/solve.hpp"

namespace stationary {

/// What the members of a followed family are to carry.
struct FamilyOutputs {
  bool spectrum = true;
  bool errors = true;
  bool energy = true;
};

/// Where motions of a kind begin: one of them, with what the kind leaves open decided.
struct Beginning {
  Motion motion;
  Stretch q;
  bool at_event = false;  ///< it is the event's own, else a little way from it
};

class Kind {
 public:
  Kind(const Body& body, const Potential& potential) : body_(body), potential_(potential) {}
  Kind(const Kind&) = delete;
  Kind& operator=(const Kind&) = delete;
  virtual ~Kind() = default;

  const Body& body() const { return body_; }
  const Potential& potential() const { return potential_; }

  /// With what it leaves open decided: the plane, the axis.
  virtual Motion motion() const = 0;

  /// One ellipsoid, or why there is none.
  virtual Equilibrium solve(const SolveOptions& options) const = 0;
  /// For a person, how motions at many values of one of its numbers are had together; nothing where each
  /// is solved by itself.
  virtual std::optional<PlanItem> together() const { return std::nullopt; }
  /// Of a kind that has that: at each of these values without a motion what solve() would find there
  /// without a start, with spectra if asked for.
  virtual void solve_each(bool /*spectra*/, const SolveOptions&, const NumberRange&,
                          std::span<AtValue>) const {}
  /// All of them, with proof.
  virtual SearchResult search(const SearchOptions& options) const = 0;
  /// Why there is none, also beyond the search's box; nothing where that is not known.
  virtual std::optional<std::string> nonexistence() const { return std::nullopt; }

  /// Of a solved one; nothing where its last correction does not converge.
  virtual std::optional<Spectrum> spectrum(const Equilibrium& solved) const = 0;
  virtual Certificate certify(const Equilibrium& equilibrium) const = 0;
  /// Of a proven one; throws std::invalid_argument otherwise.
  virtual SpectrumEnclosure enclose(const Equilibrium& equilibrium, const Certificate& certificate,
                                    const Spectrum& spectrum) const = 0;

  /// For a person: the unknowns and where each comes from, how the spectrum is had, and what a solve
  /// without a start begins with.
  virtual std::vector<PlanItem> unknowns() const = 0;
  virtual PlanItem spectrum_plan() const = 0;
  virtual std::string_view default_start() const = 0;

  /// The family in a number of the problem; start: a motion of it.
  virtual AnyFamily family(const FamilyParameter& parameter, const FamilyOutputs& outputs,
                           const Stretch& start) const = 0;
  /// Whether the family in nu is followed from rest.
  virtual bool from_rest() const { return false; }
  /// Why there is no family in this number though there may be a motion; nothing where there is one.
  /// start: a motion of it.
  virtual std::optional<std::string> no_family(const FamilyParameter&, const Stretch&) const {
    return std::nullopt;
  }
  /// Whether a start on a continuum of motions is followed along it.
  virtual bool follows_continuum() const { return false; }
  /// A motion of this kind at an event of another's family (a spin about the axis of `branch`, or, without
  /// it, another kind) where such begin; within: |nu| that it is to have if one has. Nothing where none
  /// do, or none was found.
  virtual std::optional<Beginning> beginning(EventType, const Member& /*event*/,
                                             std::optional<Branch> /*branch*/,
                                             const Interval& /*within*/) const {
    return std::nullopt;
  }
  /// An event at a member of the family: nothing where it has no equations of its own.
  std::optional<EventEnclosure> enclose_event(const FamilyParameter& parameter, EventType event,
                                              const Member& member) const;
  /// How the motions begin that an event lets begin, at a member of the family: nothing where that
  /// is not known.
  virtual std::optional<NormalForm> normal_form(const FamilyParameter&, EventType,
                                                const Member&) const {
    return std::nullopt;
  }

 private:
  /// enclose_event(), whatever the potential takes for granted.
  virtual std::optional<EventEnclosure> event_enclosure(const FamilyParameter&, EventType,
                                                        const Member&) const {
    return std::nullopt;
  }

  Body body_;
  Potential potential_;
};

/// What a kind whose axis is no material one answers at |nu| = 0.
Equilibrium at_rest();

/// What a kind says whose motions at many |nu| are followed from rest.
PlanItem followed_together();

/// A member of a followed family as an equilibrium.
Equilibrium equilibrium_of(const Member& member);

/// The kinds that a motion may be one of: of a tilted one each plane, of an oblique one the families
/// of both axes.
struct Alternatives {
  struct Each {
    std::string label;  ///< of a message
    std::unique_ptr<Kind> kind;
  };
  std::vector<Each> each;
  /// Where none of several is found: any motion of the sort, wherever it comes from; may be null.
  std::unique_ptr<Kind> any;
  /// The key of the case that decides between them, and its values.
  std::string_view key;
  std::string_view values;
  std::string both;  ///< what is found where two have a motion
};

/// anywhere: all motions are asked for, or one near a start; no family has to be chosen for that.
Alternatives alternatives(const Body& body, const Potential& potential, const Motion& motion,
                          bool anywhere);

/// The only kind that it may be, or the first.
std::unique_ptr<Kind> kind_of(const Body& body, const Potential& potential, const Motion& motion);

/// How each of several alternatives is solved: a search would find the motion of any of them.
SolveOptions for_each_of(const Alternatives& kinds, const SolveOptions& options);

/// One motion, and the alternative that has it; else what was said of all.
struct Found {
  Equilibrium equilibrium;
  const Kind* kind;
};
/// Of the first alternative that has one.
Found first_found(const Alternatives& kinds, const SolveOptions& options);

/// How all alternatives have motions at many values together; nothing where one does not.
std::optional<PlanItem> together(const Alternatives& kinds);

/// As first_found() at many values of alternatives that have that, with spectra if asked for; places: in
/// kinds.each, of what has the motion. What none has is left to kinds.any, if there is one.
void first_found_each(const Alternatives& kinds, bool spectra, const SolveOptions& options,
                      const NumberRange& all, std::span<AtValue> at, std::span<std::size_t> places);

/// As first_found(), and whether another alternative has one too.
struct OnlyFound {
  Found first;
  bool several = false;
};
OnlyFound only_found(const Alternatives& kinds, const SolveOptions& options);

}  // namespace stationary
