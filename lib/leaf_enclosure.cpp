#include "lib/leaf_enclosure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lib/enclosure_collector.hpp"

namespace stationary {
namespace {

/// Square, of the size a part has.
class Form {
 public:
  explicit Form(std::size_t size) : size_(size), entries_(size * size) {}
  std::size_t size() const { return size_; }
  Interval& operator()(std::size_t i, std::size_t j) { return entries_[i * size_ + j]; }
  const Interval& operator()(std::size_t i, std::size_t j) const { return entries_[i * size_ + j]; }

 private:
  std::size_t size_;
  std::vector<Interval> entries_;
};

/// E'' in (b1, alpha, xi, zeta, rho; b2, p_alpha, ...), without b1, b2 at rest:
///   (dm - N dq)^T M^-1 (dm - N dq) + dq^T (V_qq - C) dq - |nu| (db1^2 + db2^2).
Form second_variation(const EnclosedMotion& at) {
  const bool spins = at.speed.lo > 0.0;
  const std::size_t b = spins ? 1 : 0;
  const std::size_t n = 4 + b;
  const Vector3<Interval> nu{at.speed * at.axis[0], at.speed * at.axis[1], at.speed * at.axis[2]};
  const auto N = steady_momenta_jacobian(at.J, at.q, nu);
  // dm - N dq of each coordinate.
  std::vector<Vector7<Interval>> rate(2 * n, Vector7<Interval>::Constant(Interval(0.0)));
  for (std::size_t k = 0; k < 4; ++k) {
    for (int i = 0; i < 7; ++i) rate[b + k][i] = -N(i, static_cast<int>(k));
    rate[n + b + k][3 + static_cast<int>(k)] = Interval(1.0);
  }
  if (spins) {
    // (e1, e2, axis) right-handed, e1 in the plane of axes 1 and 2.
    const bool third = at.axis[2].lo > 0.0;
    const Vector3<Interval> e1 =
        third ? Vector3<Interval>{1.0, 0.0, 0.0} : Vector3<Interval>{-at.axis[1], at.axis[0], 0.0};
    const Vector3<Interval> e2 =
        third ? Vector3<Interval>{0.0, 1.0, 0.0} : Vector3<Interval>{0.0, 0.0, 1.0};
    const Matrix3<Interval> I = locked_inertia(at.J, at.q);
    Interval own;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) own += at.axis[i] * I(i, j) * at.axis[j];
    const Interval root = sqrt(own * at.speed);
    for (int i = 0; i < 3; ++i) {
      rate[0][i] = root * e1[i];
      rate[n][i] = root * e2[i];
    }
  }
  Form out(2 * n);
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const Vector7<Interval> v = inverse_legendre(at.J, at.q, rate[i]);
    for (std::size_t j = 0; j <= i; ++j) {
      Interval sum;
      for (int k = 0; k < 7; ++k) sum += v[k] * rate[j][k];
      out(i, j) = out(j, i) = sum;
    }
  }
  const Matrix4<Interval> C = centrifugal_matrix(
      at.J, SpinProducts<Interval>{square(nu[0]), square(nu[1]), square(nu[2]), nu[0] * nu[1]});
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const auto [row, column] = std::pair(static_cast<int>(i), static_cast<int>(j));
      out(b + i, b + j) += at.V_qq(row, column) - C(row, column);
    }
  }
  if (spins) {
    out(0, 0) -= at.speed;
    out(n, n) -= at.speed;
  }
  return out;
}

/// The part of some coordinates and their momenta, both diagonals alike in size: x_k -> c_k x_k,
/// p_k -> p_k/c_k with powers of two.
Form part_of(const Form& whole, const std::vector<std::size_t>& coordinates) {
  const std::size_t n = coordinates.size();
  const auto place = [&](std::size_t k) {
    return k < n ? coordinates[k] : coordinates[k - n] + whole.size() / 2;
  };
  std::vector<double> scale(2 * n, 1.0);
  for (std::size_t k = 0; k < n; ++k) {
    const double q = whole(place(k), place(k)).magnitude();
    const double p = whole(place(n + k), place(n + k)).magnitude();
    const double c = std::exp2(std::round(0.25 * std::log2(p / q)));
    if (!std::isfinite(c) || c == 0.0) continue;
    scale[k] = c;
    scale[n + k] = 1.0 / c;
  }
  Form out(2 * n);
  for (std::size_t i = 0; i < 2 * n; ++i)
    for (std::size_t j = 0; j < 2 * n; ++j)
      out(i, j) = (scale[i] * scale[j]) * whole(place(i), place(j));
  return out;
}

/// By Sylvester's law, the largest pivot first.
std::optional<int> negative_directions(Form F) {
  std::vector<std::size_t> left(F.size());
  for (std::size_t k = 0; k < left.size(); ++k) left[k] = k;
  int count = 0;
  while (!left.empty()) {
    const auto largest =
        std::ranges::max_element(left, {}, [&](std::size_t k) { return F(k, k).mignitude(); });
    const std::size_t k = *largest;
    const int sign = proven_sign(F(k, k));
    if (sign == unknown) return std::nullopt;
    count += sign < 0;
    left.erase(largest);
    for (const std::size_t i : left)
      for (const std::size_t j : left) F(i, j) -= F(i, k) * F(k, j) / F(k, k);
  }
  return count;
}

/// det(s - J E'') as a polynomial in s^2: its odd powers are exactly 0.
template <int D>
Polynomial<Interval, D> characteristic(const Form& E) {
  constexpr std::size_t n = D;
  Form H(2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < 2 * n; ++j) {
      H(i, j) = E(n + i, j);
      H(n + i, j) = -E(i, j);
    }
  }
  // N_k = H N_{k-1} + c_k, c_k = -tr(H N_{k-1})/k: p(s) = s^2n + c_1 s^(2n-1) + ...
  Polynomial<Interval, D> out;
  out.c[n] = 1.0;
  Form N(2 * n);
  for (std::size_t i = 0; i < 2 * n; ++i) N(i, i) = 1.0;
  for (std::size_t k = 1; k <= 2 * n; ++k) {
    Form next(2 * n);
    for (std::size_t i = 0; i < 2 * n; ++i)
      for (std::size_t j = 0; j < 2 * n; ++j)
        for (std::size_t l = 0; l < 2 * n; ++l) next(i, j) += H(i, l) * N(l, j);
    Interval trace;
    for (std::size_t i = 0; i < 2 * n; ++i) trace += next(i, i);
    const Interval c = k % 2 == 0 ? -trace / static_cast<double>(k) : Interval(0.0);
    if (k % 2 == 0) out.c[n - k / 2] = c;
    for (std::size_t i = 0; i < 2 * n; ++i) next(i, i) += c;
    N = next;
  }
  return out;
}

class Parts {
 public:
  explicit Parts(const Form& whole) : whole_(whole) {}

  void add(const std::vector<std::size_t>& coordinates) {
    const Form E = part_of(whole_, coordinates);
    const std::optional<int> negative = negative_directions(E);
    out_.negative.add(negative);
    if (negative.value_or(0) > 0) out_.set_indefinite();
    definite_ = definite_ && negative == 0;
    switch (coordinates.size()) {
      case 1:
        out_.add_real(square(E(0, 1)) - E(0, 0) * E(1, 1), proven_sign(E(0, 0)));
        break;
      case 3:
        add_roots(characteristic<3>(E), negative);
        break;
      case 4:
        add_roots(characteristic<4>(E), negative);
        break;
      default:
        add_roots(characteristic<5>(E), negative);
    }
  }

  SpectrumEnclosure finish(const Spectrum& approximate) {
    if (definite_) out_.set_definite();
    return out_.finish(approximate);
  }

 private:
  /// Imaginary all of them where E'' is definite.
  template <int D>
  void add_roots(const Polynomial<Interval, D>& p, std::optional<int> negative) {
    const bool definite = negative == 0;
    for (const RootEnclosure& root : enclose_roots(p, definite))
      out_.add(root, definite ? 1 : unknown, definite);
  }

  const Form& whole_;
  EnclosureCollector out_;
  bool definite_ = true;
};

}  // namespace

SpectrumEnclosure enclose_leaf_spectrum(const EnclosedMotion& motion, const Spectrum& approximate) {
  const Form whole = second_variation(motion);
  Parts parts(whole);
  const bool spins = motion.speed.lo > 0.0;
  if (spins && !(motion.axis[2].lo > 0.0)) {
    parts.add({0, 1, 2, 3, 4});
    return parts.finish(approximate);
  }
  const std::size_t alpha = spins ? 1 : 0;
  if (spins) parts.add({0});
  if (motion.rho_coupled) {
    parts.add({alpha, alpha + 1, alpha + 2, alpha + 3});
  } else {
    parts.add({alpha, alpha + 1, alpha + 2});
    parts.add({alpha + 3});
  }
  return parts.finish(approximate);
}

}  // namespace stationary
