#include "lib/stability/leaf_enclosure.hpp"

#include <array>
#include <cstddef>

#include "lib/stability/enclosure_collector.hpp"
#include "lib/stability/interval_form.hpp"
#include "lib/stability/symplectic_leaf.hpp"

namespace stationary {
namespace {

/// In (b1, alpha, xi, zeta, rho; b2, p_alpha, ...).
constexpr std::size_t pairs = 5;
using Whole = IntervalForm<2 * pairs>;

/// How rho follows the others along a held volume: its gradient b in (alpha, xi, zeta) and Hessian.
struct HeldThickness {
  std::array<Interval, 3> b;
  std::array<std::array<Interval, 3>, 3> curved;

  explicit HeldThickness(const BasicStretch<Interval>& q) {
    const Interval per_d = Interval(1.0) / planar_invariants(q).d;
    const std::array<Interval, 3> l{-2.0 * (q.alpha * per_d), q.zeta * per_d, q.xi * per_d};
    for (std::size_t i = 0; i < 3; ++i) {
      b[i] = -(q.rho * l[i]);
      for (std::size_t j = 0; j < 3; ++j) curved[i][j] = 2.0 * (q.rho * (l[i] * l[j]));
    }
    curved[0][0] += 2.0 * (q.rho * per_d);
    curved[1][2] -= q.rho * per_d;
    curved[2][1] -= q.rho * per_d;
  }
};

/// E'' = (dm - N dq)^T M^-1 (dm - N dq) + dq^T (V_qq - C) dq - |nu| (db1^2 + db2^2); at rest there
/// is no b, and what is in its place has no meaning, as rho's of a held volume.
Whole second_variation(const EnclosedMotion& at) {
  const Vector3<Interval> nu{at.speed * at.axis[0], at.speed * at.axis[1], at.speed * at.axis[2]};
  auto N = steady_momenta_jacobian(at.J, at.q, nu);
  const HeldThickness thickness(at.q);
  if (at.volume_held)
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 6; ++i) N(i, k) += N(i, 3) * thickness.b[static_cast<std::size_t>(k)];
  // dm - N dq of each coordinate.
  std::array<Vector7<Interval>, 2 * pairs> rate;
  rate.fill(Vector7<Interval>::Constant(Interval(0.0)));
  for (std::size_t k = 0; k < 4; ++k) {
    for (int i = 0; i < 7; ++i) rate[1 + k][i] = -N(i, static_cast<int>(k));
    rate[pairs + 1 + k][3 + static_cast<int>(k)] = Interval(1.0);
  }
  if (at.spins()) {
    // (e1, e2, axis) right-handed, e1 in the plane of axes 1 and 2.
    const bool third = at.about_third();
    const bool in_plane = at.axis[2].lo == 0.0 && at.axis[2].hi == 0.0;
    const Interval across =
        in_plane || third ? Interval(1.0) : sqrt(square(at.axis[0]) + square(at.axis[1]));
    const Vector3<Interval> e1 =
        third ? Vector3<Interval>{1.0, 0.0, 0.0}
              : Vector3<Interval>{-at.axis[1] / across, at.axis[0] / across, 0.0};
    const Vector3<Interval> e2 =
        third      ? Vector3<Interval>{0.0, 1.0, 0.0}
        : in_plane ? Vector3<Interval>{0.0, 0.0, 1.0}
                   : Vector3<Interval>{-(at.axis[2] * e1[1]), at.axis[2] * e1[0], across};
    const Matrix3<Interval> I = locked_inertia(at.J, at.q);
    Interval own;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) own += at.axis[i] * I(i, j) * at.axis[j];
    const Interval root = sqrt(own * at.speed);
    for (int i = 0; i < 3; ++i) {
      rate[0][i] = root * e1[i];
      rate[pairs][i] = root * e2[i];
    }
  }
  Whole out;
  for (std::size_t i = 0; i < 2 * pairs; ++i) {
    const Vector7<Interval> v = inverse_legendre(at.J, at.q, rate[i]);
    for (std::size_t j = 0; j <= i; ++j) {
      for (int k = 0; k < 7; ++k) out[i][j] += v[k] * rate[j][k];
      out[j][i] = out[i][j];
    }
  }
  if (at.volume_held) {  // the mass M + J3 b b^T
    Vector7<Interval> along = Vector7<Interval>::Constant(Interval(0.0));
    for (int k = 0; k < 3; ++k) along[3 + k] = thickness.b[static_cast<std::size_t>(k)];
    const Vector7<Interval> v = inverse_legendre(at.J, at.q, along);
    Interval size = Interval(1.0) / at.J.J3;
    for (int k = 0; k < 7; ++k) size += v[k] * along[k];
    std::array<Interval, 2 * pairs> share;
    for (std::size_t i = 0; i < 2 * pairs; ++i)
      for (int k = 0; k < 7; ++k) share[i] += v[k] * rate[i][k];
    for (std::size_t i = 0; i < 2 * pairs; ++i)
      for (std::size_t j = 0; j < 2 * pairs; ++j) out[i][j] -= share[i] * share[j] / size;
  }
  const Matrix4<Interval> C = centrifugal_matrix(
      at.J, SpinProducts<Interval>{square(nu[0]), square(nu[1]), square(nu[2]), nu[0] * nu[1]});
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j)
      out[1 + static_cast<std::size_t>(i)][1 + static_cast<std::size_t>(j)] +=
          at.V_qq(i, j) - C(i, j);
  }
  if (at.volume_held) {
    const Interval rate_of_rho = C(3, 3);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        out[1 + i][1 + j] -=
            rate_of_rho * (thickness.b[i] * thickness.b[j] + at.q.rho * thickness.curved[i][j]);
  }
  out[0][0] -= at.speed;
  out[pairs][pairs] -= at.speed;
  return out;
}

class Parts {
 public:
  explicit Parts(const Whole& whole) : whole_(whole) {}

  template <class... Places>
  void add(Places... coordinates) {
    constexpr std::size_t n = sizeof...(Places);
    const auto E = leaf_part<n>(whole_, pairs, {static_cast<std::size_t>(coordinates)...});
    const std::optional<int> negative = negative_directions(E);
    out_.negative.add(negative);
    if (negative.value_or(0) > 0) out_.set_indefinite();
    const bool definite = negative == 0;
    definite_ = definite_ && definite;
    if constexpr (n == 1) {
      out_.add_real(square(E[0][1]) - E[0][0] * E[1][1], proven_sign(E[0][0]));
    } else {  // imaginary all of them where E'' is definite
      for (const RootEnclosure& root : enclose_roots(in_squares<n>(E), definite))
        out_.add(root, definite ? 1 : unknown, definite);
    }
  }

  SpectrumEnclosure finish(const Spectrum& approximate) {
    if (definite_) out_.set_definite();
    return out_.finish(approximate);
  }

 private:
  const Whole& whole_;
  EnclosureCollector out_;
  bool definite_ = true;
};

}  // namespace

SpectrumEnclosure enclose_leaf_spectrum(const EnclosedMotion& motion, const Spectrum& approximate) {
  const Whole whole = second_variation(motion);
  Parts parts(whole);
  if (motion.spins() && !motion.about_third()) {
    if (motion.straight && motion.volume_held) {
      parts.add(0, 1);
      parts.add(2, 3);
    } else if (motion.volume_held) {
      parts.add(0, 1, 2, 3);
    } else {
      parts.add(0, 1, 2, 3, 4);
    }
    return parts.finish(approximate);
  }
  if (motion.spins()) parts.add(0);
  if (motion.volume_held) {
    parts.add(1, 2, 3);
  } else if (motion.rho_coupled) {
    parts.add(1, 2, 3, 4);
  } else {
    parts.add(1, 2, 3);
    parts.add(4);
  }
  return parts.finish(approximate);
}

}  // namespace stationary
