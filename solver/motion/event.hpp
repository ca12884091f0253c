// Events along a family and the functions whose sign changes give them away (t the unit tangent,
// I_a the locked inertia about the spin's axis a, c the kernel of [dG/d ln x  dG/dnu]):
//
//   fold-nu            c_nu = 0: nu turns, V_nu'' singular in the family's symmetric subspace
//   fold-parameter     the same, of a family in any other number
//   fold-momentum      d(I_a nu) along c = 0: |pi| turns, a zero of the spectrum's symmetric block
//   tilt               I_a = I_b, b = 3 in (i), (ii), b = 1 or 2 in (iii); a tilted family ends
//                      there: nu along one of its two axes is 0
//   inertia-exchange   any other two locked inertias are equal
//   ellipse            J1 = J2: K_alpha,alpha = 0 on the circle
//   ellipse-23         (i), J2 = J3 and V symmetric in zeta and rho: the circle zeta = rho breaks,
//                      F_ss = 0 along s = ln(zeta/rho)/2; ellipse-13: (ii), likewise xi = rho
//   oblique            (i), (ii): K_alpha,alpha (I1 - I2) = h^2 omega^2; an oblique family of an
//                      even V ends there
//   shear              (iii): K_alpha,alpha = 0 on a sheet of ellipses; likewise. Of a tilted
//                      family W_t = 0: motions out of the plane of its axis begin. Of an isotropic
//                      V without gravity oblique and shear are there only where another parameter
//                      passes J1 = J2 (sheared_balance.hpp)
//   hamiltonian-hopf   two imaginary pairs of one block meet and leave the axis
//   real-collision     two real pairs of one block do
//   krein-pass         imaginary pairs of opposite signature, of two blocks, meet and pass
//   zero-momentum      two-polar: s3 = 0; the wobble's signature changes, and the count by two
//   unexplained        what is counted of the spectrum changes between two rows, and none of these in between
//                      accounts for it: the negative directions, the Lambda > 0, or, on a circle, whether the
//                      second variation is definite
//   collapse escape domain limit closed stalled   ends of a sheet: d or rho -> 0; a stretch ->
//                      infinity; where the potential ceases to be defined; the range asked for;
//                      back at the start; given up, the metadata say why
//
// Of a two-polar family: fold-parameter where a rate or another number turns at given rates;
// fold-momentum where its parameter turns at given momenta, or where, at given rates,
// the stiffness at fixed momenta is singular; tilt where omega = s3/I_1 or s3/I_2; ellipse where it leaves the circle.
//
// At a parameter other than nu the same functions are followed: where it turns nu would turn too.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "lib/body/stretch.hpp"
#include "solver/motion/family.hpp"

namespace stationary {

enum class EventType : std::uint8_t {
  none,
  fold_nu,
  fold_momentum,
  tilt,
  inertia_exchange,
  ellipse,
  oblique,
  shear,
  hamiltonian_hopf,
  real_collision,
  krein_pass,
  fold_parameter,
  ellipse_23,
  ellipse_13,
  zero_momentum,
  unexplained,
  collapse,
  escape,
  domain,
  limit,
  closed,
  stalled
};
constexpr std::string_view event_names[] = {"",
                                            "fold-nu",
                                            "fold-momentum",
                                            "tilt",
                                            "inertia-exchange",
                                            "ellipse",
                                            "oblique",
                                            "shear",
                                            "hamiltonian-hopf",
                                            "real-collision",
                                            "krein-pass",
                                            "fold-parameter",
                                            "ellipse-23",
                                            "ellipse-13",
                                            "zero-momentum",
                                            "unexplained",
                                            "collapse",
                                            "escape",
                                            "domain",
                                            "limit",
                                            "closed",
                                            "stalled"};
constexpr std::string_view name(EventType e) { return event_names[static_cast<int>(e)]; }
/// Types of events; all of them unless made of some.
class EventSet {
 public:
  constexpr EventSet() = default;
  static constexpr EventSet none() { return EventSet(0); }
  constexpr EventSet& add(EventType e) {
    bits_ |= bit(e);
    return *this;
  }
  constexpr bool has(EventType e) const { return (bits_ & bit(e)) != 0; }

 private:
  explicit constexpr EventSet(std::uint32_t bits) : bits_(bits) {}
  static constexpr std::uint32_t bit(EventType e) { return 1U << static_cast<unsigned>(e); }

  std::uint32_t bits_ = ~0U;
};
/// Those found among the Lambdas, or by what the rows count of the spectrum.
inline constexpr std::array spectral_events{EventType::hamiltonian_hopf, EventType::real_collision,
                                            EventType::krein_pass, EventType::unexplained};

constexpr bool is_end(EventType e) { return e >= EventType::collapse; }
/// Of the parameter, whatever it is.
constexpr bool is_fold(EventType e) {
  return e == EventType::fold_nu || e == EventType::fold_parameter;
}
/// Whether a class may change at such an event.
constexpr bool may_change_class(EventType event) {
  return event != EventType::krein_pass && event != EventType::inertia_exchange &&
         !is_fold(event) && event != EventType::none;
}
/// Where a circle breaks.
constexpr EventType ellipse_event(Circle circle) {
  switch (circle) {
    case Circle::zeta_rho:
      return EventType::ellipse_23;
    case Circle::xi_rho:
      return EventType::ellipse_13;
    default:
      return EventType::ellipse;
  }
}
/// The circle that breaks at such an event.
constexpr Circle broken_circle(EventType event) {
  switch (event) {
    case EventType::ellipse:
      return Circle::xi_zeta;
    case EventType::ellipse_23:
      return Circle::zeta_rho;
    case EventType::ellipse_13:
      return Circle::xi_rho;
    default:
      return Circle::none;
  }
}

/// The functions at one point, each of order one; NaN where it has no meaning.
struct TestValues {
  static constexpr std::size_t fold = 0;
  static constexpr std::size_t momentum = 1;
  static constexpr std::size_t inertia_12 = 2;
  static constexpr std::size_t inertia_13 = 3;
  static constexpr std::size_t inertia_23 = 4;
  static constexpr std::size_t ellipse = 5;
  static constexpr std::size_t turn = 6;           ///< in the plane: oblique, shear
  static constexpr std::size_t zero_momentum = 7;  ///< the momentum about the axis, two-polar
  /// ((Lambda_1 - Lambda_2)/2)^2 of the two that are nearest; < 0 of an odd number of quadruples.
  static constexpr std::size_t collision = 8;
  static constexpr std::size_t tilt_in_plane = 9;  ///< shares of nu^2, of a tilted family
  static constexpr std::size_t tilt_normal = 10;
  static constexpr std::size_t crossings = 11;  ///< Lambda_1 - Lambda_2 of two blocks
  static constexpr std::size_t count = crossings + 10;

  std::array<double, count> value;
  std::uint32_t opposite = 0;  ///< bit k: the pairs of crossing k have opposite signatures
  /// Of each block how many Lambda are real, and how many of these negative: crossings compare only
  /// where these are equal.
  std::array<std::array<std::uint8_t, 2>, 4> composition{};
  /// Of each block how many of the real ones may be 0, and count as not negative: where a family ends, one.
  std::array<std::uint8_t, 4> zeros{};
  /// Of each block whose Lambda may meet the signatures of the negative ones, ascending: bit i is set where
  /// that of the i-th is +1.
  std::array<std::uint8_t, 4> signatures{};
  std::uint8_t signed_blocks = 0;  ///< bit b: those of block b are all certain
  /// ((Lambda_1 - Lambda_2)/2)^2, relative, of each two neighbours of a block and of each complex pair (< 0), in
  /// one order while no block's number of real Lambda changes; `collision` is the nearest to zero, up to its sign.
  std::array<double, 4> gaps;
  bool collides_imaginary = false;  ///< the pair of `collision` has Lambda < 0
  /// Bit k: the errors of the point leave the sign of value k open.
  std::uint32_t uncertain = 0;

  /// The sign of a function where it is certain: +1, -1; else 0.
  int sign(std::size_t k) const {
    if (((uncertain >> static_cast<unsigned>(k)) & 1U) != 0) return 0;
    return (value[k] > 0.0) - (value[k] < 0.0);
  }
};

/// What the test functions need beside the member.
struct TestContext {
  Branch branch;
  bool material_symmetry;
  Circle circle = Circle::none;  ///< that the sheet keeps
  KindEvents kind = axis_events();
  EventSet sought = {};  ///< functions of no other events are evaluated or followed
  bool along_nu = true;  ///< else what turns is another parameter

  /// Those to look for so that the ones asked for are found: a turn of the parameter and the end of
  /// a tilted family end a sheet; between which zeros blocks keep their signs, all of them say.
  static EventSet sought_for(EventSet asked);
  bool seeks(std::size_t function) const;
};

/// fold, momentum: as the curve's geometry gives them. error: of the member as a point of the
/// curve, relative.
TestValues test_values(const Member& member, const TestContext& context, double fold,
                       double momentum, double error = 0.0);

/// What a zero of function k is; none where it is no event (equal signatures, say).
EventType event_type(std::size_t k, const TestContext& context, const TestValues& at);

/// Of the functions of x and p that events of this type are zeros of, the one nearest to zero; nothing
/// where none has a value.
std::optional<std::size_t> nearest_function(EventType type, const TestContext& context,
                                            const TestValues& at);

/// How many negative directions a crossing of this event changes at most, and with which parity.
int negative_change(EventType event, const TestContext& context);

}  // namespace stationary
