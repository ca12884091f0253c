// The events inside one step of a curve, each located.
//
// Where a test function f (event.hpp) changes sign over the step, f = 0 and G = 0 are solved
// together: a bracketing root finder (TOMS 748) on f along the arc, the bordered corrector bringing
// each of its points onto the curve, and from there the event's own equations in extended
// precision, which say what it is known to. Where f does not change sign but a parabola through the
// last three points dips towards zero inside the step, its extremum is sought on the curve: two
// zeros in one step are found so. What remains of the change in the number of negative directions
// is reported as unexplained.
//
// A sign counts where it is certain (TestValues::sign). Where it is not at an end of the step, the
// curve is looked at a little before or beyond; where it is certain nowhere near, the last certain
// sign is remembered, and the next one tells whether there was an event: one that is then known to
// lie between two places and is not located.
#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "lib/number/elementary.hpp"
#include "solver/continuation/curve.hpp"

namespace stationary {

enum class EventStatus {
  located,
  bracketed,  ///< the member is the bracket's middle
  unresolved  ///< the function's sign is certain at the bracket's ends only; no member
};
constexpr std::string_view event_status_names[] = {"located", "bracketed", "unresolved"};
constexpr std::string_view name(EventStatus s) { return event_status_names[static_cast<int>(s)]; }

struct Event {
  EventType type = EventType::none;
  Member member;      ///< error_bound: of the event's q
  double before = 0;  ///< bracket of the parameter, ascending
  double after = 0;
  EventStatus status = EventStatus::bracketed;
  /// The class on the curve between this event and the next in the same step, if there is one.
  std::optional<StabilityClass> between = std::nullopt;
};

template <int N>
class EventSearch {
 public:
  explicit EventSearch(const Curve<N>& curve) : curve_(&curve) {}

  /// Events between two points an arc apart, in order along it. earlier: the point before `from`
  /// and its distance, if there is one. starts: the curve starts at `from`, and functions that
  /// vanish there are none of this step's.
  std::vector<Event> run(const CurvePoint<N>& from, const CurvePoint<N>& to, const Arc<N>& arc,
                         const TestValues* earlier, double earlier_length, bool starts) {
    from_ = &from;
    to_ = &to;
    arc_ = &arc;
    found_.clear();
    unresolved_.clear();
    if (starts) known_ = known_at(from);
    // A curve that starts where its parameter passes J1 = J2 starts at that event (follow.cpp).
    if (starts && from.tests.value[TestValues::turn] == 0.0) known_.negative.reset();
    next_ = known_;
    for (std::size_t k = 0; k < TestValues::crossings; ++k) {
      if (!curve_->context().seeks(k)) continue;
      // At rest a round body's inertias are equal: where the curve ends that is no event.
      if (to.member.nu == 0.0 && std::abs(to.tests.value[k]) <= 0x1p-50) continue;
      if (!compare_ends(k)) continue;
      if (k == TestValues::fold && curve_->family().along_nu()) {
        fold_dip();
      } else if (k == TestValues::collision && pairs_changed_sides()) {
        search_dips(k);
      } else if (earlier != nullptr) {
        dip(k, earlier->value[k], earlier_length);
      }
    }
    if (curve_->context().seeks(TestValues::crossings)) find_crossings(earlier, earlier_length);
    if (curve_->context().sought.has(EventType::unexplained)) {
      explain_negative();
      explain_growing();
    }
    for (std::size_t k = 0; k < TestValues::count && to.tests.uncertain != 0; ++k)
      if (to.tests.sign(k) == 0 && next_.sign[k] == known_.sign[k]) add_step(next_.since[k]);
    if (next_.negative && !certain_negative(to.member)) add_step(next_.negative->since);
    if (next_.growing && !certain_growing(to.member)) add_step(next_.growing->since);
    std::ranges::sort(found_, {}, &Found::u);
    std::vector<Event> out;
    out.reserve(found_.size());
    for (std::size_t k = 0; k < found_.size(); ++k) {
      if (k + 1 < found_.size()) found_[k].event.between = class_between(found_[k], found_[k + 1]);
      out.push_back(std::move(found_[k].event));
    }
    return out;
  }

  /// Events known from the last run() to lie between an earlier point and `to`, and not located.
  const std::vector<Event>& unresolved() const { return unresolved_; }
  /// The step of the last run() is taken: the next begins where it ended.
  void settle() { known_ = next_; }

  /// Points evaluated so far.
  long evaluations() const { return evaluations_; }

 private:
  struct Found {
    double u;
    Event event;
  };
  struct Sample {
    double u;
    double value;
  };
  /// What the parameter was between on a part of the curve.
  struct ParameterRange {
    double least = 0.0;
    double most = 0.0;

    static ParameterRange at(double p) { return {p, p}; }
    void add(double p) {
      least = std::min(least, p);
      most = std::max(most, p);
    }
  };
  /// What is certain of the curve up to a point.
  struct Known {
    std::array<int, TestValues::count> sign{};  ///< the last that was; 0: none
    std::array<ParameterRange, TestValues::count> since{};
    struct Negative {
      int modes;
      int count;
      ParameterRange since;
      int change = 0;  ///< most that events since can have changed it by
      bool exchange = false;
    };
    std::optional<Negative> negative;
    struct Growing {
      int modes;
      int count;  ///< of real Lambda > 0
      ParameterRange since;
      bool explained = false;  ///< an event since, or what may be one
    };
    std::optional<Growing> growing;
  };

  static std::optional<typename Known::Negative> certain_negative(const Member& at) {
    if (!at.spectrum || !at.spectrum->away_from_zero()) return std::nullopt;
    return typename Known::Negative{at.spectrum->modes, at.spectrum->negative,
                                    ParameterRange::at(at.parameter)};
  }

  /// Of real Lambda > 0.
  static int growing_modes(const Spectrum& spectrum) {
    return static_cast<int>(std::count_if(
        spectrum.mode.begin(), spectrum.mode.begin() + spectrum.modes, [](const Mode& mode) {
          return !mode.forced_zero && mode.lambda_im == 0.0 && mode.lambda_re > 0.0;
        }));
  }
  static std::optional<typename Known::Growing> certain_growing(const Member& at) {
    if (!at.spectrum || !at.spectrum->away_from_zero()) return std::nullopt;
    return typename Known::Growing{at.spectrum->modes, growing_modes(*at.spectrum),
                                   ParameterRange::at(at.parameter)};
  }

  static Known known_at(const CurvePoint<N>& at) {
    Known out;
    for (std::size_t k = 0; k < TestValues::count; ++k) {
      out.sign[k] = at.tests.sign(k);
      out.since[k] = ParameterRange::at(at.member.parameter);
    }
    out.negative = certain_negative(at.member);
    out.growing = certain_growing(at.member);
    return out;
  }

  /// How far beyond an end of the step a sign is looked for, in arcs.
  static constexpr std::array aside_of_ends{1e-9, 1e-6, 1e-3, 0.03, 0.3, 1.0};

  /// The nearest place from u on in a direction where the sign of function k is certain.
  std::optional<Sample> certain_from(std::size_t k, double u, int direction) {
    for (const double aside : aside_of_ends) {
      CurvePoint<N> point;
      const double at = u + direction * aside;
      if (!evaluate(at, point) || point.member.beyond_end()) continue;
      if (point.tests.sign(k) != 0) return Sample{at, point.tests.value[k]};
    }
    return std::nullopt;
  }

  /// Locates a change of sign of function k over the step. True where there is none and both ends
  /// are certain.
  bool compare_ends(std::size_t k) {
    const double a = from_->tests.value[k];
    const double b = to_->tests.value[k];
    const int first = from_->tests.sign(k);
    const int last = to_->tests.sign(k);
    const int before = known_.sign[k];
    if (last != 0 || std::isnan(b)) {
      next_.sign[k] = last;
      next_.since[k] = ParameterRange::at(to_->member.parameter);
    }
    if (std::isnan(a) || std::isnan(b)) return false;
    if ((first == 0 || last == 0) && a * b < 0.0 && k < TestValues::collision &&
        locate_known(k, a, b)) {
      next_.sign[k] = b < 0.0 ? -1 : 1;
      next_.since[k] = ParameterRange::at(to_->member.parameter);
      return false;
    }
    if (before == 0) return false;
    if (first != 0 && last != 0) {
      if (first == last) return true;
      locate(k, {0.0, a}, {1.0, b});
      return false;
    }
    // Looked into where the numbers, uncertain as they are, suggest a change.
    const bool suggested = (a < 0.0) != (b < 0.0) || (a < 0.0) != (before < 0);
    std::optional<Sample> left;
    std::optional<Sample> right;
    if (suggested) left = first != 0 ? Sample{0.0, a} : certain_from(k, 0.0, -1);
    if (left) right = last != 0 ? Sample{1.0, b} : certain_from(k, 1.0, +1);
    if (left && right && (left->value > 0.0) == (before > 0) &&
        (left->value > 0.0) != (right->value > 0.0)) {
      // Beyond the step it is the next one's.
      if (locate(k, *left, *right)) {
        next_.sign[k] = -before;
        next_.since[k] = ParameterRange::at(to_->member.parameter);
      }
    } else if (last == -before) {
      add_unresolved(event_type(k, curve_->context(), to_->tests), known_.since[k]);
    }
    return false;
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
    since.add(to_->member.parameter);
    for (const Found& each : found_) {
      if (each.event.type != EventType::fold_nu && each.event.type != EventType::fold_parameter)
        continue;
      since.add(each.event.before);
      since.add(each.event.after);
    }
  }

  std::optional<StabilityClass> class_between(const Found& a, const Found& b) {
    CurvePoint<N> point;
    if (!a.event.member.spectrum || !evaluate(0.5 * (a.u + b.u), point)) return std::nullopt;
    if (!point.member.spectrum) return std::nullopt;
    return point.member.spectrum->verdict;
  }

  /// The completed point at u; false where the corrector fails.
  bool evaluate(double u, CurvePoint<N>& out) {
    ++evaluations_;
    const Corrected<N> corrected = curve_->at(from_->arc, *arc_, u);
    if (corrected.status != CorrectorStatus::converged) return false;
    out = curve_->complete(corrected.point);
    // The arc's own direction, as the two ends have it.
    if (out.arc.tangent.dot(arc_->direction(u)) < 0.0) return false;
    return true;
  }

  double value(std::size_t k, double u, double otherwise) {
    CurvePoint<N> point;
    if (!evaluate(u, point)) return otherwise;
    const double f = point.tests.value[k];
    return std::isnan(f) ? otherwise : f;
  }

  /// Where a sign is not certain, the event's own equations may still lead to it.
  bool locate_known(std::size_t k, double a, double b) {
    std::uintmax_t evaluations = 20;
    const auto f = [&](double u) { return value(k, u, a); };
    const auto close = [](double low, double high) { return high - low <= 0x1p-20; };
    const auto [low, high] =
        boost::math::tools::toms748_solve(f, 0.0, 1.0, a, b, close, evaluations);
    return add_known(k, low, high);
  }

  /// False where the zero lies beyond the step. One before it, where a sign was not certain then,
  /// is its beginning's.
  bool locate(std::size_t k, Sample a, Sample b) {
    std::uintmax_t evaluations = 80;
    const auto f = [&](double u) { return value(k, u, a.value); };
    const auto close = [](double low, double high) { return high - low <= 0x1p-48; };
    const auto [low, high] =
        boost::math::tools::toms748_solve(f, a.u, b.u, a.value, b.value, close, evaluations);
    if (0.5 * (low + high) > 1.0) return false;
    if (add_known(k, low, high)) return true;
    // Where its sign is certain only farther apart, the function is known to vanish, and not where.
    constexpr double resolved = 1e-6;
    if (uncertain_stretch(k, low, a.u) + uncertain_stretch(k, high, b.u) + (high - low) <=
        resolved / arc_->length) {
      add(k, low, high);
    } else {
      add_unresolved(event_type(k, curve_->context(), to_->tests), known_.since[k]);
    }
    return true;
  }

  /// How far from u, towards a place where the sign of function k is certain, it is not.
  double uncertain_stretch(std::size_t k, double u, double certain) {
    const double most = std::abs(certain - u);
    for (double aside = 0.0; aside < most; aside = std::max(8.0 * aside, 0x1p-48)) {
      CurvePoint<N> point;
      if (evaluate(u + std::copysign(aside, certain - u), point) && point.tests.sign(k) != 0)
        return aside;
    }
    return most;
  }

  /// The event near a zero by its own equations, which tell more than its function's sign; false
  /// where it has none or they do not lead there.
  bool add_known(std::size_t k, double low, double high) {
    CurvePoint<N> point;
    for (const double u : {0.5 * (low + high), low, high}) {
      if (!evaluate(u, point) || point.member.beyond_end()) continue;
      const EventType type = event_type(k, curve_->context(), point.tests);
      constexpr double reach = 0.02;  // of the step
      auto known = curve_->event_at(type, point.member, reach * arc_->length + 1e-9);
      if (!known || known->member.beyond_end()) return false;
      ++evaluations_;
      found_.push_back({u,
                        {type,
                         std::move(known->member),
                         known->before,
                         known->after,
                         EventStatus::located,
                         {}}});
      return true;
    }
    return false;
  }

  void add(std::size_t k, double low, double high) {
    CurvePoint<N> point;
    for (const double u : {0.5 * (low + high), low, high}) {
      if (!evaluate(u, point) || point.member.beyond_end()) continue;
      const EventType type = event_type(k, curve_->context(), point.tests);
      if (type == EventType::none) return;
      // The first order, widened until the sign of f is seen to be certain on either side.
      double along = 0.5 * (high - low) + noise(k, u, point) / std::abs(slope(k, u));
      while (along < 0.5 && !changes_between(k, u - along, u + along)) along *= 2.0;
      if (!(along < 0.5)) break;  // nowhere in the step is the sign of f certain
      const auto [before, after] = around(u - along, u + along);
      Found out{u, {type, point.member, before, after, EventStatus::located, {}}};
      const double own = curve_->corrector().curve_error(point.arc);
      out.event.member.error_bound = 2.0 * (along * arc_->length + own);
      found_.push_back(std::move(out));
      return;
    }
    // Known to be there, and no more.
    const EventType type = event_type(k, curve_->context(), from_->tests);
    if (type == EventType::none) return;
    const auto [before, after] = around(0.0, 1.0);
    found_.push_back(
        {0.5 * (low + high), {type, from_->member, before, after, EventStatus::bracketed, {}}});
  }

  /// Whether function k has certain and opposite signs at two places.
  bool changes_between(std::size_t k, double low, double high) {
    CurvePoint<N> first;
    CurvePoint<N> last;
    return evaluate(low, first) && evaluate(high, last) &&
           first.tests.sign(k) * last.tests.sign(k) < 0;
  }

  /// What the parameter is between on a part of the arc. Where it turns there, no farther than the
  /// tangents at both ends reach.
  std::pair<double, double> around(double low, double high) const {
    const double scale = curve_->corrector().scale();
    const double first = parameter(low);
    const double last = parameter(high);
    double least = std::min(first, last);
    double most = std::max(first, last);
    const double leaving = scale * arc_->direction(low)[N] * arc_->length;  // dp/du
    const double arriving = scale * arc_->direction(high)[N] * arc_->length;
    if ((leaving < 0.0) != (arriving < 0.0)) {
      const double beyond = (high - low) * std::max(std::abs(leaving), std::abs(arriving));
      (leaving < 0.0 ? least : most) += leaving < 0.0 ? -beyond : beyond;
    }
    constexpr double rounding = 0x1p-50;
    return {bracket_of(least, rounding * std::abs(least))[0],
            bracket_of(most, rounding * std::abs(most))[1]};
  }

  /// Of the curve itself; the arc's where the corrector fails.
  double parameter(double u) const {
    const Corrected<N> corrected = curve_->at(from_->arc, *arc_, u);
    if (corrected.status == CorrectorStatus::converged) return corrected.point.p;
    return from_->arc.p + curve_->corrector().scale() * arc_->at(u)[N];
  }

  /// Of function k along the arc.
  double slope(std::size_t k, double u) {
    constexpr double apart = 1e-3;
    return (value(k, u + apart, 0.0) - value(k, u - apart, 0.0)) / (2.0 * apart);
  }

  /// What function k is known to at u: what the point's errors make of it, and those of the
  /// Lambdas. Where two collide their own errors are roots of what their square's is: beside it.
  double noise(std::size_t k, double u, const CurvePoint<N>& point) {
    constexpr double errors = 32.0;
    constexpr double apart = 1e-3;
    const double own = errors * curve_->corrector().curve_error(point.arc);
    if (k >= TestValues::crossings) return std::max(own, mode_noise(point.member));
    if (k != TestValues::collision) return own;
    CurvePoint<N> beside;
    if (!evaluate(u + apart, beside) && !evaluate(u - apart, beside)) return own;
    const double root = std::sqrt(std::abs(beside.tests.value[k]));
    return std::max(own, 2.0 * root * mode_noise(beside.member));
  }

  /// The largest relative error of a Lambda that no symmetry forces.
  static double mode_noise(const Member& at) {
    double out = 0.0;
    for (int i = 0; at.spectrum && i < at.spectrum->modes; ++i) {
      const Mode& mode = at.spectrum->mode[static_cast<std::size_t>(i)];
      const double size = hypotenuse(mode.lambda_re, mode.lambda_im);
      if (!mode.forced_zero && size > 0.0) out = std::max(out, mode.lambda_error / size);
    }
    return out;
  }

  /// Two zeros of function k inside the step? f at the earlier point, and its distance.
  void dip(std::size_t k, double earlier, double earlier_length) {
    const double a = from_->tests.value[k];
    const double b = to_->tests.value[k];
    if (std::isnan(earlier) || (earlier < 0.0) != (a < 0.0)) return;
    // Newton's form through (-l, earlier), (0, a), (1, b), in units of the arc.
    const double l = earlier_length / arc_->length;
    const double d01 = b - a;
    const double d10 = (a - earlier) / l;
    const double curvature = (d01 - d10) / (1.0 + l);
    if (may_touch_zero({a, d01 - curvature, curvature}, b)) search_dip(k, a, b);
  }

  /// Two turns of the parameter inside the step? Its slopes at both ends and what it gained.
  void fold_dip() {
    const double a = arc_->length * arc_->from[N];
    const double b = arc_->length * arc_->to[N];
    const double gain = arc_->chord[N];
    const Parabola slope{a, 6.0 * gain - 4.0 * a - 2.0 * b, 3.0 * (a + b) - 6.0 * gain};
    if (!may_touch_zero(slope, b)) return;
    constexpr std::size_t k = TestValues::fold;
    search_dip(k, from_->tests.value[k], to_->tests.value[k]);
  }

  /// Whether two Lambdas of a block that are negative at one end of the step are positive at the other.
  /// One passes zero only where an event says so; two together went round it, as a complex pair.
  bool pairs_changed_sides() const {
    const auto& from = from_->tests.composition;
    const auto& to = to_->tests.composition;
    for (std::size_t block = 0; block < from.size(); ++block)
      if (from[block][0] == to[block][0] && std::abs(from[block][1] - to[block][1]) >= 2)
        return true;
    return false;
  }
  /// Where the step is looked at in between.
  void search_dips(std::size_t k) {
    constexpr int parts = 32;
    Sample last{0.0, from_->tests.value[k]};
    for (int part = 1; part <= parts; ++part) {
      Sample next{double(part) / parts, to_->tests.value[k]};
      if (part < parts) next.value = value(k, next.u, last.value);
      if ((next.value < 0.0) != (last.value < 0.0)) locate(k, last, next);
      last = next;
    }
  }

  /// a + u (slope + u curvature), 0 <= u <= 1
  struct Parabola {
    double a;
    double slope;
    double curvature;
  };

  /// Whether it comes near zero between its ends; b is what it should be at 1.
  static bool may_touch_zero(const Parabola& f, double b) {
    if (f.curvature * f.a <= 0.0) return false;  // bends away from zero
    const double vertex = -0.5 * f.slope / f.curvature;
    if (!(vertex > -0.1 && vertex < 1.1)) return false;
    const double least = f.a + vertex * (f.slope + vertex * f.curvature);
    return least * f.a <= 0.0 || std::abs(least) <= 0.3 * std::min(std::abs(f.a), std::abs(b));
  }

  void search_dip(std::size_t k, double a, double b) {
    const double sign = a < 0.0 ? -1.0 : 1.0;
    std::uintmax_t evaluations = 25;
    const auto [u, f] = boost::math::tools::brent_find_minima(
        [&](double s) { return sign * value(k, s, a); }, 0.0, 1.0, 20, evaluations);
    CurvePoint<N> lowest;
    if (!(f < 0.0) || !evaluate(u, lowest) || lowest.tests.sign(k) == 0) return;
    locate(k, {0.0, a}, {u, sign * f});
    locate(k, {u, sign * f}, {1.0, b});
  }

  /// Crossings of different blocks: over stretches of the step where each block keeps its numbers
  /// of real and of negative Lambda.
  void find_crossings(const TestValues* earlier, double earlier_length) {
    const TestValues& from = from_->tests;
    const TestValues& to = to_->tests;
    // A pair may touch zero and come back: then its signature is another, in the same composition.
    const bool plain = from.composition == to.composition && found_.empty();
    for (std::size_t k = TestValues::crossings; k < TestValues::count; ++k) {
      const bool opposite = is_opposite(from, k) || is_opposite(to, k);
      if (!plain || !opposite) {  // no event of its own, whether they meet or not
        next_.sign[k] = to.sign(k);
        next_.since[k] = ParameterRange::at(to_->member.parameter);
      } else if (compare_ends(k) && earlier != nullptr &&
                 earlier->composition == from.composition && is_opposite(from, k)) {
        dip(k, earlier->value[k], earlier_length);
      }
    }
    if (plain) return;
    std::vector<double> borders;
    for (const Found& each : found_) borders.push_back(each.u);
    std::ranges::sort(borders);
    borders.insert(borders.begin(), 0.0);  // the ends too: at rest the spin's own pair is missing
    borders.push_back(1.0);
    constexpr double aside = 1e-6;
    for (std::size_t k = 0; k + 1 < borders.size(); ++k) {
      const double begin = borders[k] + aside;
      const double end = borders[k + 1] - aside;
      CurvePoint<N> first;
      CurvePoint<N> last;
      if (begin < end && evaluate(begin, first) && evaluate(end, last))
        crossings_between({begin, first.tests}, {end, last.tests});
    }
  }

  struct Tested {
    double u;
    TestValues tests;
  };

  static bool is_opposite(const TestValues& tests, std::size_t k) {
    return (tests.opposite >> static_cast<unsigned>(k - TestValues::crossings)) & 1U;
  }

  void crossings_between(const Tested& a, const Tested& b) {
    if (a.tests.composition != b.tests.composition) return;
    for (std::size_t k = TestValues::crossings; k < TestValues::count; ++k) {
      if (a.tests.sign(k) * b.tests.sign(k) >= 0) continue;
      if (is_opposite(a.tests, k) || is_opposite(b.tests, k))
        locate(k, {a.u, a.tests.value[k]}, {b.u, b.tests.value[k]});
    }
  }

  /// Whether it is about the order of the locked inertias: where a spin's axis may turn.
  static bool is_of_axis(EventType type) {
    return type == EventType::tilt || type == EventType::oblique ||
           type == EventType::inertia_exchange;
  }

  /// Whether the located events account for the change of `negative`; else brackets the change.
  void explain_negative() {
    // A circle's count is that of (iii), which its ellipses at other rates do not change.
    if (curve_->context().kind.circle_on_own_leaf && curve_->context().circle != Circle::none)
      return;
    if (next_.negative) {
      for (const Found& each : found_) {
        // At rest no axis is turned about.
        if (to_->member.nu == 0.0 && is_of_axis(each.event.type)) continue;
        next_.negative->change += negative_change(each.event.type, curve_->context());
        // J1 = J2: the direction conjugate to the symmetry may change its sign there.
        next_.negative->exchange =
            next_.negative->exchange || each.event.type == EventType::inertia_exchange;
      }
    }
    const auto now = certain_negative(to_->member);
    if (!now) {
      if (!to_->member.spectrum) next_.negative.reset();
      return;
    }
    const auto before = std::exchange(next_.negative, now);
    if (!before || before->modes != now->modes) return;
    const int change = std::abs(before->count - now->count);
    if (change <= before->change && (before->change - change) % 2 == 0) return;
    if (before->exchange && curve_->context().material_symmetry) return;
    if (!certain_negative(from_->member)) {
      add_unresolved(EventType::unexplained, before->since);
      return;
    }
    bracket_unexplained([&](const Member& at) { return at.spectrum->negative == before->count; });
  }

  /// Whether the sign of some function that an event is a zero of is not certain.
  static bool is_open(const TestValues& tests) {
    for (std::size_t k = 0; k < TestValues::crossings; ++k)
      if (!std::isnan(tests.value[k]) && tests.sign(k) == 0) return true;
    return false;
  }

  /// Whether located events account for a change in the number of real Lambda > 0, which a second
  /// momentum that is kept lets pass zero with no other sign of it; else brackets the change.
  void explain_growing() {
    const bool may_be =
        !found_.empty() || !unresolved_.empty() || is_open(from_->tests) || is_open(to_->tests);
    if (next_.growing && may_be) next_.growing->explained = true;
    const auto now = certain_growing(to_->member);
    if (!now) {
      if (!to_->member.spectrum) next_.growing.reset();
      return;
    }
    const auto before = std::exchange(next_.growing, now);
    if (!before || before->modes != now->modes || before->count == now->count || before->explained)
      return;
    const auto earlier = certain_growing(from_->member);
    if (!earlier || earlier->count != before->count) {
      add_unresolved(EventType::unexplained, before->since);
      return;
    }
    bracket_unexplained(
        [&](const Member& at) { return growing_modes(*at.spectrum) == before->count; });
  }

  /// Between the ends of the step, of what is_before() tells.
  template <class IsBefore>
  void bracket_unexplained(const IsBefore& is_before) {
    double low = 0.0;
    double high = 1.0;
    CurvePoint<N> middle = *to_;
    for (int k = 0; k < 50; ++k) {
      const double u = 0.5 * (low + high);
      if (!evaluate(u, middle)) break;
      (is_before(middle.member) ? low : high) = u;
    }
    const auto [first, last] = around(low, high);
    found_.push_back(
        {0.5 * (low + high),
         {EventType::unexplained, middle.member, first, last, EventStatus::bracketed}});
  }

  const Curve<N>* curve_;
  const CurvePoint<N>* from_ = nullptr;
  const CurvePoint<N>* to_ = nullptr;
  const Arc<N>* arc_ = nullptr;
  std::vector<Found> found_;
  std::vector<Event> unresolved_;
  Known known_;  ///< at from_
  Known next_;   ///< at to_
  long evaluations_ = 0;
};

}  // namespace stationary
