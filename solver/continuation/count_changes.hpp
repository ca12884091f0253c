// What is certain of the counts of a curve's spectra up to a point, and their changes in a step that no event
// accounts for:
//
//   negative   directions of the second variation; an event changes their number by no more than
//              negative_change() (event.hpp), and by an even number less
//   growing    real Lambda > 0; any event may change them
//   definite   whether the second variation is definite where nothing grows; an event that may change the class may
//
// A count is known where no Lambda may be zero. Where it is not known at the end of a step, the last
// one is remembered, and the next tells whether it has changed.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <span>
#include <utility>

#include "solver/continuation/known_signs.hpp"
#include "solver/continuation/located_event.hpp"
#include "solver/motion/event.hpp"

namespace stationary {

/// An event of a step, u of the way along it.
struct FoundEvent {
  double u;
  Event event;
};

/// Whether it is about the order of the locked inertias: where a spin's axis may turn.
constexpr bool is_of_axis(EventType type) {
  return type == EventType::tilt || type == EventType::oblique ||
         type == EventType::inertia_exchange;
}

inline int negative_directions(const Spectrum& spectrum) { return spectrum.negative; }
/// Real Lambda > 0.
inline int growing_modes(const Spectrum& spectrum) {
  return static_cast<int>(std::count_if(
      spectrum.mode.begin(), spectrum.mode.begin() + spectrum.modes, [](const Mode& mode) {
        return !mode.forced_zero && mode.lambda_im == 0.0 && mode.lambda_re > 0.0;
      }));
}
/// 1: the second variation is definite, with a second momentum's added where one is kept; 0: it is not, and
/// nothing grows; -1: neither.
inline int definite(const Spectrum& spectrum) {
  if (spectrum.verdict == StabilityClass::stable) return 1;
  return spectrum.verdict == StabilityClass::elliptic ? 0 : -1;
}

/// A count of the last spectrum that had it.
struct KnownCount {
  int modes;
  int count;
  ParameterRange since;
  int change = 0;  ///< negative directions: the most that events since can have changed them by
  bool exchange = false;   ///< J1 = J2 since
  bool explained = false;  ///< the others: an event since, or what may be one
};

struct KnownCounts {
  std::optional<KnownCount> negative;
  std::optional<KnownCount> growing;
  std::optional<KnownCount> definite;

  static KnownCounts at(const Member& member) {
    if (!member.spectrum || !member.spectrum->away_from_zero()) return {};
    const Spectrum& spectrum = *member.spectrum;
    const auto known = [&](int count) {
      return KnownCount{spectrum.modes, count, ParameterRange::at(member.parameter)};
    };
    KnownCounts out{known(negative_directions(spectrum)), known(growing_modes(spectrum)), {}};
    const int sign = stationary::definite(spectrum);
    if (sign >= 0) out.definite = known(sign);
    return out;
  }
};

/// A change of a count that no event accounts for.
struct UnexplainedChange {
  int (*count)(const Spectrum&);
  int before;
  ParameterRange since;
  bool in_step;  ///< the count was still that at the beginning of the step
};

class CountChanges {
 public:
  /// What a step is, for its counts.
  struct Step {
    const Member& from;
    const Member& to;
    const TestContext& context;
    /// At `to` the count of negative directions may be that of either side of an event.
    bool hides_zero;
    bool at_exchange;  ///< it ends where its parameter passes J1 = J2
  };

  /// The curve starts here. hides_zero: as of a step; or it starts where its parameter passes J1 = J2.
  void start(const Member& at, bool hides_zero) {
    known_ = KnownCounts::at(at);
    if (hides_zero) known_.negative.reset();
  }
  /// Takes the counts at the end of a step, to be compared below.
  void enter(const Step& step) {
    next_ = known_;
    now_ = KnownCounts::at(step.to);
  }
  /// What these events of the step leave of the change of the negative directions.
  std::optional<UnexplainedChange> negative(const Step& step, std::span<const FoundEvent> found) {
    // A circle's count is that of (iii), which its ellipses at other rates do not change.
    if (step.context.kind.circle_on_own_leaf && step.context.circle != Circle::none) return {};
    auto& known = next_.negative;
    // Where a range ends at J1 = J2 the curve ends at that event, as it starts at it.
    if (step.at_exchange) {
      known.reset();
      return {};
    }
    if (known) {
      for (const FoundEvent& each : found) {
        // At rest no axis is turned about.
        if (step.to.nu == 0.0 && is_of_axis(each.event.type)) continue;
        known->change += negative_change(each.event.type, step.context);
        // J1 = J2: the direction conjugate to the symmetry may change its sign there.
        known->exchange = known->exchange || each.event.type == EventType::inertia_exchange;
      }
    }
    if (step.hides_zero) now_.negative.reset();
    const auto before = arrive(&KnownCounts::negative, step);
    if (!before) return {};
    const int change = std::abs(before->count - known->count);
    if (change <= before->change && (before->change - change) % 2 == 0) return {};
    if (before->exchange && step.context.material_symmetry) return {};
    return unexplained(&KnownCounts::negative, negative_directions, *before, step);
  }
  /// Of the number of growing modes, which a second momentum that is kept lets pass zero with no other sign of it.
  /// explained: there is an event, or what may be one.
  std::optional<UnexplainedChange> growing(const Step& step, bool explained) {
    return change(&KnownCounts::growing, growing_modes, step, explained);
  }
  /// Of what is definite on a circle: with its second momentum some sum of the two is, or none any more, where no
  /// modes meet.
  std::optional<UnexplainedChange> definite(const Step& step, bool explained) {
    return change(&KnownCounts::definite, stationary::definite, step, explained);
  }
  /// widen(since) of each count that is remembered and not known at the end of the step.
  template <class Widen>
  void widen_remembered(const Widen& widen) {
    for (const auto which : {&KnownCounts::negative, &KnownCounts::growing, &KnownCounts::definite})
      if (next_.*which && !(now_.*which)) widen((next_.*which)->since);
  }
  /// The step is taken: the next begins where it ended.
  void settle() { known_ = next_; }

 private:
  using Which = std::optional<KnownCount> KnownCounts::*;

  /// Remembers the count at the end of the step, if it is known there; that before, if it was of as many modes.
  std::optional<KnownCount> arrive(Which which, const Step& step) {
    auto& known = next_.*which;
    const auto& now = now_.*which;
    if (!now) {
      if (!step.to.spectrum) known.reset();
      return {};
    }
    auto before = std::exchange(known, now);
    if (before && before->modes != now->modes) before.reset();
    return before;
  }
  std::optional<UnexplainedChange> change(Which which, int (*count)(const Spectrum&),
                                          const Step& step, bool explained) {
    auto& known = next_.*which;
    if (known && explained) known->explained = true;
    const auto before = arrive(which, step);
    if (!before || before->count == (now_.*which)->count || before->explained) return {};
    return unexplained(which, count, *before, step);
  }
  static UnexplainedChange unexplained(Which which, int (*count)(const Spectrum&),
                                       const KnownCount& before, const Step& step) {
    const auto first = KnownCounts::at(step.from).*which;
    return {count, before.count, before.since, first && first->count == before.count};
  }

  KnownCounts known_;  ///< at the beginning of the step
  KnownCounts next_;   ///< at its end
  KnownCounts now_;    ///< those of the spectrum at its end alone
};

}  // namespace stationary
