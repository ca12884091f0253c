// The events inside one step of a curve, each located.
//
// Where a test function f (event.hpp) changes sign over the step, f = 0 and G = 0 are solved
// together: a bracketing root finder (TOMS 748) on f along the arc, the bordered corrector bringing
// each of its points onto the curve, and from there the event's own equations in extended
// precision, which say what it is known to. Where f does not change sign but a parabola through the
// last three points dips towards zero inside the step, its extremum is sought on the curve: two
// zeros in one step are found so. Lambdas that met in the step may show it by their signatures at its
// ends: then the meetings are sought however near each other they are. What remains of the change in
// the number of negative directions is reported as unexplained.
//
// A sign counts where it is certain (TestValues::sign). Where it is not at an end of the step, the
// curve is looked at a little before or beyond; where it is certain nowhere near, the last certain
// sign is remembered, and the next one tells whether there was an event: one that is then known to
// lie between two places and is not located.
#pragma once

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "solver/continuation/bracketed_changes.hpp"
#include "solver/continuation/count_changes.hpp"
#include "solver/continuation/dip.hpp"
#include "solver/continuation/hidden_zeros.hpp"
#include "solver/continuation/known_signs.hpp"
#include "solver/continuation/lambda_meetings.hpp"
#include "solver/continuation/located_event.hpp"
#include "solver/continuation/step_points.hpp"

namespace stationary {

template <int N>
class EventSearch {
 public:
  explicit EventSearch(const Curve<N>& curve)
      : points_(curve), explains_(curve.context().sought.has(EventType::unexplained)) {
    for (std::size_t k = 0; k < TestValues::count; ++k)
      if (curve.context().seeks(k)) sought_ |= bit_of(k);
  }

  /// Events between two points an arc apart, in order along it. earlier: the point before `from`
  /// and its distance, if there is one. starts: the curve starts at `from`, and functions that
  /// vanish there are none of this step's.
  std::vector<Event> run(const CurvePoint<N>& from, const CurvePoint<N>& to, const Arc<N>& arc,
                         const TestValues* earlier, double earlier_length, bool starts) {
    points_.enter(from, to, arc);
    found_.clear();
    unresolved_.clear();
    met_unseen_ = false;
    last_ = SignBits::of(to.tests);
    if (starts) {
      first_ = SignBits::of(from.tests);
      known_.set(all_functions, first_, from.member.parameter);
      // A curve that starts where its parameter passes J1 = J2 starts at that event
      // (follow_sheet.hpp).
      counts_.start(from.member, from.tests.value[TestValues::turn] == 0.0 || hides_zero(first_));
    }
    next_ = known_;
    find_zeros(sought_ & own_functions, earlier, earlier_length);
    if ((sought_ & all_crossings) != 0) find_crossings(earlier, earlier_length);
    if (met_unseen())
      add_unresolved(EventType::hamiltonian_hopf, ParameterRange::at(from.member.parameter));
    if (explains_) explain_counts();
    for_each_function(all_functions & last_.open(), [&](std::size_t k) {
      if (next_.sign(k) == known_.sign(k)) add_step(next_.since[k]);
    });
    std::ranges::sort(found_, {}, &FoundEvent::u);
    std::vector<Event> out;
    out.reserve(found_.size());
    for (FoundEvent& each : found_) out.push_back(std::move(each.event));
    return out;
  }

  /// Events known from the last run() to lie between an earlier point and `to`, and not located.
  const std::vector<Event>& unresolved() const { return unresolved_; }
  /// The step of the last run() is taken: the next begins where it ended.
  void settle() {
    known_ = next_;
    counts_.settle();
    first_ = last_;
  }

  /// Points evaluated so far.
  long evaluations() const { return points_.evaluations(); }

 private:
  using Sample = typename StepPoints<N>::Sample;

  const Curve<N>& curve() const { return points_.curve(); }
  const CurvePoint<N>& from() const { return points_.from(); }
  const CurvePoint<N>& to() const { return points_.to(); }
  const Arc<N>& arc() const { return points_.arc(); }

  /// Changes of sign of these functions, and two zeros of one inside the step.
  void find_zeros(FunctionBits functions, const TestValues* earlier, double earlier_length) {
    // At rest a round body's inertias are equal: where the curve ends that is no event.
    if (to().member.nu == 0.0)
      for_each_function(functions, [&](std::size_t k) {
        if (std::abs(to().tests.value[k]) <= 0x1p-50) functions &= ~bit_of(k);
      });
    const FunctionBits same = same_at_ends(functions);
    next_.set(same | (functions & last_.absent), last_, to().member.parameter);
    for_each_function(functions & ~(last_.absent & first_.absent), [&](std::size_t k) {
      if ((same & bit_of(k)) == 0) {
        compare_ends(k);
      } else if (k == TestValues::fold && curve().family().along_nu()) {
        fold_dip();
      } else if (k == TestValues::collision) {
        search_meetings(earlier, earlier_length);
      } else if (earlier != nullptr) {
        dip(k, earlier->value[k], earlier_length);
      }
    });
  }

  /// Those of the functions that have one certain sign at both ends, and had it before.
  FunctionBits same_at_ends(FunctionBits functions) const {
    return functions & first_.shared_with(last_) &
           last_.shared_with({known_.positive, known_.negative});
  }

  /// Locates a change of sign of function k over the step, where its signs are not certain and the
  /// same at both ends.
  void compare_ends(std::size_t k) {
    const double a = from().tests.value[k];
    const double b = to().tests.value[k];
    const int first = first_.of(k);
    const int last = last_.of(k);
    const int before = known_.sign(k);
    if (last != 0 || std::isnan(b)) next_.set(k, last, to().member.parameter);
    if (std::isnan(a) || std::isnan(b)) return;
    if ((first == 0 || last == 0) && a * b < 0.0 && k < TestValues::collision &&
        locate_known(k, a, b)) {
      next_.set(k, b < 0.0 ? -1 : 1, to().member.parameter);
      return;
    }
    if (before == 0) return;
    if (first != 0 && last != 0) {
      if (first != last) locate(k, {0.0, a}, {1.0, b}, from().tests, to().tests);
      return;
    }
    // Looked into where the numbers, uncertain as they are, suggest a change.
    const bool suggested = (a < 0.0) != (b < 0.0) || (a < 0.0) != (before < 0);
    std::optional<Sample> left;
    std::optional<Sample> right;
    if (suggested) left = first != 0 ? Sample{0.0, a} : points_.certain_from(k, 0.0, -1);
    if (left) right = last != 0 ? Sample{1.0, b} : points_.certain_from(k, 1.0, +1);
    if (left && right && (left->value > 0.0) == (before > 0) &&
        (left->value > 0.0) != (right->value > 0.0)) {
      // Beyond the step it is the next one's.
      if (locate(k, *left, *right, from().tests, to().tests))
        next_.set(k, -before, to().member.parameter);
    } else if (last == -before) {
      add_unresolved(unlocated(k, from().tests, to().tests), known_.since[k]);
    }
  }

  /// The type of a zero of function k somewhere between two places of the step.
  EventType unlocated(std::size_t k, const TestValues& first, const TestValues& last) const {
    const auto met =
        k == TestValues::collision ? met_between(first, last) : std::optional<EventType>();
    return met ? *met : event_type(k, curve().context(), last);
  }

  void add_unresolved(EventType type, ParameterRange since) {
    if (type == EventType::none) return;
    add_step(since);
    Event event;
    event.type = type;
    event.before = since.least;
    event.after = since.most;
    event.member.parameter = 0.5 * (event.before + event.after);
    event.status = EventStatus::unresolved;
    unresolved_.push_back(std::move(event));
  }

  /// With what the parameter was in this step: between its ends, and where it turned.
  void add_step(ParameterRange& since) const {
    since.add(to().member.parameter);
    for (const FoundEvent& each : found_) {
      if (!turns_parameter(each.event)) continue;
      since.add(each.event.before);
      since.add(each.event.after);
    }
  }

  /// Where a sign is not certain, the event's own equations may still lead to it.
  bool locate_known(std::size_t k, double a, double b) {
    std::uintmax_t evaluations = 20;
    const auto f = [&](double u) { return points_.value(k, u, a); };
    const auto close = [](double low, double high) { return high - low <= 0x1p-20; };
    const auto [low, high] =
        boost::math::tools::toms748_solve(f, 0.0, 1.0, a, b, close, evaluations);
    return add_known(k, low, high);
  }

  /// False where the zero lies beyond the step. One before it, where a sign was not certain then,
  /// is its beginning's.
  bool locate(std::size_t k, Sample a, Sample b, const TestValues& first, const TestValues& last) {
    std::uintmax_t evaluations = 80;
    const auto f = [&](double u) { return points_.value(k, u, a.value); };
    const auto close = [](double low, double high) { return high - low <= 0x1p-48; };
    const auto [low, high] =
        boost::math::tools::toms748_solve(f, a.u, b.u, a.value, b.value, close, evaluations);
    if (0.5 * (low + high) > 1.0) return false;
    if (add_known(k, low, high)) return true;
    // Where its sign is certain only farther apart, the function is known to vanish, and not where.
    constexpr double resolved = 1e-6;
    if (points_.uncertain_stretch(k, low, a.u) + points_.uncertain_stretch(k, high, b.u) +
            (high - low) <=
        resolved / arc().length) {
      add(k, low, high, std::min(low - a.u, b.u - high), unlocated(k, first, last));
    } else {
      add_unresolved(unlocated(k, first, last), known_.since[k]);
    }
    return true;
  }

  /// The event near a zero by its own equations, which tell more than its function's sign; false
  /// where it has none or they do not lead there.
  bool add_known(std::size_t k, double low, double high) {
    CurvePoint<N> point;
    for (const double u : {0.5 * (low + high), low, high}) {
      if (!points_.evaluate(u, point) || point.member.beyond_end()) continue;
      const EventType type = event_type(k, curve().context(), point.tests);
      constexpr double reach = 0.02;  // of the step
      auto known = curve().event_at(type, point.member, reach * arc().length + 1e-9);
      if (!known || known->member.beyond_end()) return false;
      points_.count();
      found_.push_back(
          {u, {type, std::move(known->member), known->before, known->after, EventStatus::located}});
      return true;
    }
    return false;
  }

  /// The event at a zero. reach: to the nearer end of where it was sought, beyond which there may be another;
  /// differences are taken within half of it. otherwise: its type, where no point near it tells.
  void add(std::size_t k, double low, double high, double reach, EventType otherwise) {
    const double apart = reach > 0.0 ? std::min(1e-3, 0.5 * reach) : 1e-3;
    CurvePoint<N> point;
    for (const double u : {0.5 * (low + high), low, high}) {
      if (!points_.evaluate(u, point) || point.member.beyond_end()) continue;
      const EventType type = event_type(k, curve().context(), point.tests);
      if (type == EventType::none) return;
      // The first order, widened until the sign of f is seen to be certain on either side.
      double along = 0.5 * (high - low) +
                     points_.noise(k, u, point, apart) / std::abs(points_.slope(k, u, apart));
      while (along < 0.5 && !points_.changes_between(k, u - along, u + along)) along *= 2.0;
      if (!(along < 0.5)) break;  // nowhere in the step is the sign of f certain
      const auto [before, after] = points_.around(u - along, u + along);
      FoundEvent out{u, {type, point.member, before, after, EventStatus::located}};
      const double own = curve().corrector().curve_error(point.arc);
      out.event.member.error_bound = 2.0 * (along * arc().length + own);
      found_.push_back(std::move(out));
      return;
    }
    // Known to be there, and no more.
    if (otherwise == EventType::none) return;
    const auto [before, after] = points_.around(0.0, 1.0);
    found_.push_back(
        {0.5 * (low + high), {otherwise, from().member, before, after, EventStatus::bracketed}});
  }

  /// Two zeros of function k inside the step? f at the earlier point, and its distance.
  void dip(std::size_t k, double earlier, double earlier_length) {
    const double a = from().tests.value[k];
    const double b = to().tests.value[k];
    if (std::isnan(earlier) || (earlier < 0.0) != (a < 0.0)) return;
    const double l = earlier_length / arc().length;
    if (may_touch_zero(parabola_through(l, earlier, a, b))) search_dip(k);
  }

  /// Two turns of the parameter inside the step? Its slopes at both ends and what it gained.
  void fold_dip() {
    const double a = arc().length * arc().from[N];
    const double b = arc().length * arc().to[N];
    if (!may_touch_zero(slope_of_cubic(a, b, arc().chord[N]))) return;
    search_dip(TestValues::fold);
  }

  /// Whether the family may end, or begin, at an end of the step: there a Lambda of its own is zero.
  bool ends_family() const {
    return curve().context().kind.end != EventType::none && from().tests.zeros != to().tests.zeros;
  }

  /// Zeros of function k between neighbouring places of certain and opposite signs.
  void locate_between(std::size_t k, std::vector<Tested> at) {
    std::erase_if(at, [k](const Tested& each) { return each.tests.sign(k) == 0; });
    std::ranges::sort(at, {}, &Tested::u);
    for (std::size_t place = 0; place + 1 < at.size(); ++place) {
      const auto& [low, first] = at[place];
      const auto& [high, last] = at[place + 1];
      if (first.sign(k) != last.sign(k))
        locate(k, {low, first.value[k]}, {high, last.value[k]}, first, last);
    }
  }

  std::vector<Tested> ends() const { return {{0.0, from().tests}, {1.0, to().tests}}; }

  /// Zeros of function k about its least size in the step, if it has any.
  void search_dip(std::size_t k) {
    std::vector<Tested> at = ends();
    add_least(points_, k, at);
    locate_between(k, std::move(at));
  }

  /// Lambdas that met and parted: their order tells of it, or their numbers, or how near they come. Where a
  /// family ends or begins its modes change fastest.
  void search_meetings(const TestValues* earlier, double earlier_length) {
    const TestValues& first = from().tests;
    const TestValues& last = to().tests;
    const bool reordered = order_changed(first, last);
    const bool looked_at = pairs_changed_sides(first, last) || ends_family();
    FunctionBits dips = 0;
    if (!looked_at && earlier != nullptr && same_pairs(*earlier, first) && same_pairs(first, last))
      dips = gaps_that_dip(*earlier, earlier_length);
    if (!reordered && !looked_at && dips == 0) return;
    std::vector<Tested> at = ends();
    const Tested begin = at[0];
    const Tested end = at[1];
    met_unseen_ = reordered && !add_by_order(points_, begin, end, at);
    if (looked_at) add_parts(points_, at);
    for_each_function(dips, [&](std::size_t gap) {
      if (at.size() == 2) add_meeting(points_, gap, begin, end, at);
    });
    locate_between(TestValues::collision, std::move(at));
  }

  /// Those of TestValues::gaps that may have come to zero in the step, a bit each.
  FunctionBits gaps_that_dip(const TestValues& earlier, double earlier_length) const {
    constexpr double beyond = 0.5;
    constexpr double share = 0.8;
    const double l = earlier_length / arc().length;
    FunctionBits out = 0;
    for (std::size_t gap = 0; gap < earlier.gaps.size(); ++gap)
      if (may_touch_zero(
              parabola_through(l, earlier.gaps[gap], from().tests.gaps[gap], to().tests.gaps[gap]),
              beyond, share))
        out |= bit_of(gap);
    return out;
  }

  /// Whether Lambdas that stand in another order have met unseen: no meeting is known in the step, and none has
  /// passed zero.
  bool met_unseen() const {
    return met_unseen_ && unresolved_.empty() &&
           std::ranges::none_of(found_, [this](const FoundEvent& each) {
             const EventType type = each.event.type;
             return type == EventType::hamiltonian_hopf || type == EventType::real_collision ||
                    negative_change(type, curve().context()) != 0;
           });
  }

  /// Crossings of different blocks: over stretches of the step where each block keeps its numbers
  /// of real and of negative Lambda.
  void find_crossings(const TestValues* earlier, double earlier_length) {
    const TestValues& first = from().tests;
    const TestValues& last = to().tests;
    // A pair may touch zero and come back: then its signature is another, in the same composition.
    const bool plain = first.composition == last.composition && found_.empty();
    const FunctionBits opposite = plain ? crossing_bits(first.opposite | last.opposite) : 0;
    // Others are no event of their own, whether they meet or not.
    const FunctionBits same = same_at_ends(opposite);
    next_.set((all_crossings & ~opposite) | same, last_, to().member.parameter);
    for_each_function(opposite, [&](std::size_t k) {
      if ((same & bit_of(k)) == 0) {
        compare_ends(k);
      } else if (earlier != nullptr && earlier->composition == first.composition &&
                 (crossing_bits(first.opposite) & bit_of(k)) != 0) {
        dip(k, earlier->value[k], earlier_length);
      }
    });
    if (plain) return;
    // The ends too: at rest the spin's own pair is missing.
    const std::vector<double> borders = parts_of_step();
    for (std::size_t k = 0; k + 1 < borders.size(); ++k)
      crossings_between(borders[k], borders[k + 1]);
  }

  /// The ends of the step and the events in it, ascending.
  std::vector<double> parts_of_step() const {
    std::vector<double> out{0.0, 1.0};
    for (const FoundEvent& each : found_) out.push_back(each.u);
    std::ranges::sort(out);
    return out;
  }

  /// Those of a part of the step without events. Beside an event a Lambda may be zero within its error, or
  /// two not be told apart: what is not certain there is compared farther inside.
  void crossings_between(double begin, double end) {
    constexpr double nearest = 1e-6;
    constexpr double farthest = 0.1;  // of the part
    FunctionBits done = 0;
    for (double aside = nearest; aside <= std::max(nearest, farthest * (end - begin));
         aside *= 4.0) {
      CurvePoint<N> a;
      CurvePoint<N> b;
      if (!(begin + aside < end - aside) || !points_.evaluate(begin + aside, a) ||
          !points_.evaluate(end - aside, b))
        return;
      const bool alike = a.tests.composition == b.tests.composition;
      FunctionBits open = 0;
      for_each_function(crossing_bits(a.tests.opposite | b.tests.opposite) & ~done,
                        [&](std::size_t k) {
                          const int signs = a.tests.sign(k) * b.tests.sign(k);
                          if (signs == 0 || !alike) {
                            open |= bit_of(k);
                            return;
                          }
                          done |= bit_of(k);
                          if (signs < 0)
                            locate(k, {begin + aside, a.tests.value[k]},
                                   {end - aside, b.tests.value[k]}, a.tests, b.tests);
                        });
      if (alike && open == 0) return;
    }
  }

  /// Whether events account for the changes of the counts; else brackets what is left of them.
  void explain_counts() {
    const CountChanges::Step step{from().member, to().member, curve().context(), hides_zero(last_),
                                  to().tests.value[TestValues::turn] == 0.0};
    counts_.enter(step);
    report(counts_.negative(step, found_));
    report(counts_.growing(step, !found_.empty() || !unresolved_.empty() || is_open()));
    const bool may_change = std::ranges::any_of(
        found_, [](const FoundEvent& each) { return may_change_class(each.event.type); });
    const bool excused = may_change || !unresolved_.empty() || is_open();
    report(counts_.definite(step, excused));
    if (excused && curve().context().circle != Circle::none)
      add_changes_of_definiteness(points_, parts_of_step(), found_);
    counts_.widen_remembered([this](ParameterRange& since) { add_step(since); });
  }

  /// Brackets a change of a count where it came in this step.
  void report(const std::optional<UnexplainedChange>& change) {
    if (!change) return;
    if (change->in_step) {
      found_.push_back(bracketed(points_, *change, 0.0, 1.0));
    } else {
      add_unresolved(EventType::unexplained, change->since);
    }
  }

  /// Whether a count at a point may be that of either side of an event: where J1 = J2 the energy of the symmetry's
  /// zero changes its sign, and no other Lambda is zero.
  bool hides_zero(const SignBits& at) const {
    return curve().context().material_symmetry && (at.open() & own_functions) != 0;
  }

  /// Whether at an end of the step the sign of some function that an event is a zero of is not
  /// certain.
  bool is_open() const { return ((first_.open() | last_.open()) & own_functions) != 0; }

  StepPoints<N> points_;
  FunctionBits sought_ = 0;
  bool explains_;   ///< what is left of the changes of counts
  SignBits first_;  ///< at from()
  SignBits last_;   ///< at to()
  CountChanges counts_;
  std::vector<FoundEvent> found_;
  std::vector<Event> unresolved_;
  bool met_unseen_ = false;  ///< Lambdas changed their order, and no place is seen where they met
  KnownSigns known_;         ///< at from()
  KnownSigns next_;          ///< at to()
};

}  // namespace stationary
