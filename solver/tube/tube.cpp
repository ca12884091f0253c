#include "solver/tube/tube.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace stationary {
namespace {

constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

template <int N>
Eigen::Matrix<double, N, N + 1> middle_slopes(const CurveLinearized<N>& linearized) {
  Eigen::Matrix<double, N, N + 1> out;
  for (int i = 0; i < N; ++i)
    for (int j = 0; j <= N; ++j) out(i, j) = linearized.slope[at(i)][at(j)].mid();
  return out;
}

template <int N>
Box<N> symmetric(const Box<N>& d, double factor) {
  Box<N> out;
  for (std::size_t i = 0; i < d.size(); ++i) {
    const double radius = factor * d[i].magnitude() + 0x1p-60;
    out[i] = {-radius, radius};
  }
  return out;
}

}  // namespace

double fixed_point_bound(double along, double rest) {
  return (Interval(along) / (Interval(1.0) - Interval(rest))).hi;
}

template <int N>
TubePoint<N> tangent_of(const CurveLinearized<N>& linearized) {
  // Reflections take the rows to the first axes, the longest of what is left of them first; what they
  // take to the last axis is across all rows. Eigen's decomposition, which does the same,
  // took half of this file's time in the compiler.
  auto rows = middle_slopes<N>(linearized);
  std::array<TubePoint<N>, at(N)> mirrors;
  TubePoint<N> weights = TubePoint<N>::Zero();  // 2/|mirror|^2; 0: none is needed
  for (int k = 0; k < N; ++k) {
    int longest = k;
    double most = 0.0;
    for (int i = k; i < N; ++i) {
      double length = 0.0;
      for (int j = k; j <= N; ++j) length += rows(i, j) * rows(i, j);
      if (length > most) {
        most = length;
        longest = i;
      }
    }
    TubePoint<N>& mirror = mirrors[at(k)];
    mirror.setZero();
    double beyond = 0.0;  // what is not along axis k
    for (int j = k; j <= N; ++j) {
      std::swap(rows(k, j), rows(longest, j));
      mirror[j] = rows(k, j);
      if (j > k) beyond += mirror[j] * mirror[j];
    }
    if (beyond == 0.0) continue;
    mirror[k] += std::copysign(std::sqrt(most), mirror[k]);
    weights[k] = 2.0 / (mirror[k] * mirror[k] + beyond);
    for (int i = k + 1; i < N; ++i) {
      double along = 0.0;
      for (int j = k; j <= N; ++j) along += rows(i, j) * mirror[j];
      for (int j = k; j <= N; ++j) rows(i, j) -= weights[k] * along * mirror[j];
    }
  }
  TubePoint<N> out = TubePoint<N>::Unit(N);
  for (int k = N - 1; k >= 0; --k) {
    if (weights[k] == 0.0) continue;
    double along = 0.0;
    for (int j = k; j <= N; ++j) along += out[j] * mirrors[at(k)][j];
    for (int j = k; j <= N; ++j) out[j] -= weights[k] * along * mirrors[at(k)][j];
  }
  return out;
}

template <int N>
std::optional<TubePoint<N>> corrected_point(const CurveEquations<N>& equations, TubePoint<N> y) {
  constexpr int most = 20;
  constexpr double far = 1.0;
  double before = far;
  for (int step = 0; step < most; ++step) {
    const auto linearized = equations.linearize(point_box<N>(y));
    const auto slopes = middle_slopes<N>(linearized);
    Eigen::Matrix<double, N, 1> g;
    for (int i = 0; i < N; ++i) g[i] = linearized.g[at(i)].mid();
    const Eigen::Matrix<double, N, N> normal = slopes * slopes.transpose();
    const TubePoint<N> move = -(slopes.transpose() * normal.fullPivLu().solve(g));
    const double size = move.cwiseAbs().maxCoeff();
    if (!(size < far)) return std::nullopt;
    y += move;
    if (size < 1e-14 || (size < 1e-10 && size >= 0.5 * before)) return y;
    before = size;
  }
  return std::nullopt;
}

template <int N>
Tube<N>::Tube(const Point& y0, const Point& tangent) : center_(y0) {
  // Across it the coordinates themselves but the one that it follows most: G may be far stiffer along
  // one of them than along another, and a section is as wide as it is along each.
  int along = 0;
  tangent.cwiseAbs().maxCoeff(&along);
  axes_.setZero();
  axes_.col(0) = tangent;
  for (int j = 0, column = 1; j <= N; ++j)
    if (j != along) axes_(j, column++) = 1.0;
  inverse_ = axes_.inverse();
  inverse_error_ = 0.0;
  for (int i = 0; i <= N; ++i) {
    double row = 0.0;
    for (int j = 0; j <= N; ++j) {
      Interval entry(i == j ? -1.0 : 0.0);
      for (int k = 0; k <= N; ++k) entry += inverse_(i, k) * Interval(axes_(k, j));
      row = above(row + entry.magnitude());
    }
    if (!(row <= inverse_error_)) inverse_error_ = row;
  }
}

template <int N>
CurveBox<N> Tube<N>::place(const Interval& s, const Box<N>& d) const {
  CurveBox<N> out;
  for (int i = 0; i <= N; ++i) {
    IntervalSum sum(center_[i]);
    sum.add_product(axes_(i, 0), s);
    for (int j = 0; j < N; ++j) sum.add_product(axes_(i, j + 1), d[at(j)]);
    out[at(i)] = sum.value();
  }
  return out;
}

template <int N>
auto Tube<N>::image(const Equations& equations, const Square& Y, double s0, const Box<N>& d0,
                    const Interval& s, const Box<N>& d) const -> Image {
  const auto g = equations.forces(place(Interval(s0), d0)).g;
  const auto over = equations.linearize(place(s, d));
  std::array<Box<N>, at(N)> across;
  Box<N> along;
  for (int i = 0; i < N; ++i) {
    const auto& row = over.slope[at(i)];
    const auto by_axis = [&](int axis) {
      IntervalSum sum;
      for (int k = 0; k <= N; ++k) sum.add_product(axes_(k, axis), row[at(k)]);
      return sum.value();
    };
    along[at(i)] = by_axis(0);
    for (int j = 0; j < N; ++j) across[at(i)][at(j)] = by_axis(j + 1);
  }
  Image out;
  const Interval step = s - Interval(s0);
  for (int i = 0; i < N; ++i) {
    IntervalSum moved(d0[at(i)]);
    IntervalSum by_step;
    for (int k = 0; k < N; ++k) {
      moved.add_product(-Y(i, k), g[at(k)]);
      by_step.add_product(-Y(i, k), along[at(k)]);
    }
    out.along[at(i)] = by_step.value();
    moved.add_product(out.along[at(i)], step);
    for (int j = 0; j < N; ++j) {
      IntervalSum entry(i == j ? 1.0 : 0.0);
      for (int k = 0; k < N; ++k) entry.add_product(-Y(i, k), across[at(k)][at(j)]);
      out.rest[at(i)][at(j)] = entry.value();
      moved.add_product(out.rest[at(i)][at(j)], d[at(j)] - d0[at(j)]);
    }
    out.d[at(i)] = moved.value();
  }
  return out;
}

template <int N>
bool Tube<N>::maps_inside(const Equations& equations, const Box<N>& d) const {
  const Image mapped = image(equations, precondition_, 0.0, {}, {-half_length_, half_length_}, d);
  for (std::size_t i = 0; i < d.size(); ++i)
    if (!mapped.d[i].inside(d[i])) return false;
  return true;
}

/// The frame and Y, or nothing where they are not regular.
template <int N>
std::optional<Tube<N>> Tube<N>::prepared(const Equations& equations, const Point& y0,
                                         const Point& tangent, double h) {
  Tube out(y0, tangent);
  out.half_length_ = h;
  const auto slopes = middle_slopes<N>(equations.linearize(point_box<N>(y0)));
  out.precondition_ = (slopes * out.axes_.template rightCols<N>()).inverse();
  if (!(out.inverse_error_ < 0.5) || !std::isfinite(out.precondition_.sum())) return std::nullopt;
  return out;
}

template <int N>
std::optional<Tube<N>> Tube<N>::claimed(const Equations& equations, const Point& y0,
                                        const Point& tangent, double h, double radius) {
  auto out = prepared(equations, y0, tangent, h);
  if (!out) return std::nullopt;
  out->section_.fill({-radius, radius});
  out->core_ = out->section_;
  if (!out->maps_inside(equations, out->section_)) return std::nullopt;
  out->set_hull();
  return out;
}

template <int N>
std::optional<Tube<N>> Tube<N>::proven(const Equations& equations, const Point& y0,
                                       const Point& tangent, double h) {
  auto out = prepared(equations, y0, tangent, h);
  if (!out) return std::nullopt;
  constexpr int attempts = 8;
  constexpr double widening = 1.25;
  constexpr double widest = 0.5;
  const Interval all(-h, h);
  const auto mapped = [&](const Box<N>& d) {
    return out->image(equations, out->precondition_, 0.0, {}, all, d).d;
  };
  Box<N> d = symmetric<N>(mapped({}), widening);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    for (const Interval& side : d)
      if (!(side.hi < widest)) return std::nullopt;
    const Box<N> image = mapped(d);
    bool inside = true;
    for (std::size_t i = 0; i < d.size(); ++i) inside = inside && image[i].inside(d[i]);
    if (inside) {
      out->section_ = out->core_ = d;
      out->set_hull();
      return out;
    }
    const Box<N> next = symmetric<N>(image, widening);
    for (std::size_t i = 0; i < d.size(); ++i) d[i] = hull(d[i], next[i]);
  }
  return std::nullopt;
}

template <int N>
void Tube<N>::set_hull() {
  hull_ = place({-half_length_, half_length_}, section_);
}

template <int N>
void Tube<N>::fatten(const Equations& equations) {
  // Where G is nearly linear the section begins as thin as rounding.
  constexpr double fastest = 16.0;
  constexpr double slowest = 1.1;
  constexpr double widest = 0.5;
  std::array<double, at(N)> factor;
  factor.fill(fastest);
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t i = 0; i < at(N); ++i) {
      if (factor[i] < slowest) continue;
      grows = true;
      Box<N> d = section_;
      const double radius = factor[i] * d[i].hi;
      d[i] = {-radius, radius};
      if (radius < widest && maps_inside(equations, d)) {
        section_ = d;
      } else {
        factor[i] = std::sqrt(factor[i]);
      }
    }
  }
  set_hull();
}

template <int N>
bool Tube<N>::holds(const CurveBox<N>& place) const {
  CurveBox<N> offset;
  for (int i = 0; i <= N; ++i) {
    if (!place[at(i)].within(hull_[at(i)])) return false;
    offset[at(i)] = place[at(i)] - center_[i];
  }
  // z = axes^-1 offset is inverse offset + (1 - inverse axes) z.
  CurveBox<N> z;
  double largest = 0.0;
  for (int i = 0; i <= N; ++i) {
    for (int k = 0; k <= N; ++k) z[at(i)] += inverse_(i, k) * offset[at(k)];
    largest = std::max(largest, z[at(i)].magnitude());
  }
  const double rest = above(2.0 * above(inverse_error_ * largest));  // inverse_error_ < 1/2
  const Interval around(-rest, rest);
  if (!(z[0] + around).within({-half_length_, half_length_})) return false;
  for (int i = 0; i < N; ++i)
    if (!(z[at(i + 1)] + around).within(section_[at(i)])) return false;
  return true;
}

/// Y that fits in the middle.
template <int N>
auto Tube<N>::precondition_at(const Equations& equations, const Interval& s, const Box<N>& d) const
    -> Square {
  Box<N> middle;
  for (std::size_t i = 0; i < d.size(); ++i) middle[i] = d[i].mid();
  const auto slopes = middle_slopes<N>(equations.linearize(place(Interval(s.mid()), middle)));
  const Square out = (slopes * axes_.template rightCols<N>()).inverse();
  return std::isfinite(out.sum()) ? out : precondition_;
}

/// D with what Krawczyk's operator leaves of it, for sections s.
template <int N>
Box<N> Tube<N>::narrowed(const Equations& equations, const Square& Y, const Interval& s,
                         Box<N> d) const {
  constexpr int passes = 30;
  for (int pass = 0; pass < passes; ++pass) {
    Box<N> middle;
    for (std::size_t i = 0; i < d.size(); ++i) middle[i] = d[i].mid();
    const Box<N> mapped = image(equations, Y, s.mid(), middle, s, d).d;
    bool narrower = false;
    for (std::size_t i = 0; i < d.size(); ++i) {
      if (!mapped[i].bounded() || mapped[i].apart_from(d[i])) continue;
      const double before = d[i].hi - d[i].lo;
      d[i] = common(d[i], mapped[i]);
      narrower = narrower || d[i].hi - d[i].lo < 0.8 * before;
    }
    if (!narrower) break;
  }
  return d;
}

template <int N>
auto Tube<N>::slice(const Equations& equations, const Interval& s) const -> Slice {
  const Interval middle(s.mid());
  // Of the whole section's middle the curve may be far; in its own middle Y fits.
  const Box<N> about = narrowed(equations, precondition_, middle, core_);
  const Square Y = precondition_at(equations, middle, about);
  const Box<N> d_middle = narrowed(equations, Y, middle, about);
  const Box<N> d = narrowed(equations, Y, s, narrowed(equations, precondition_, s, core_));
  // d' = -(Y A B)^-1 Y A tau: d' = along + rest d', so |d'| <= |along|/(1 - |rest|), in the norm
  // max |d_i|/r_i, in which |rest| < 1 on all of the tube.
  Box<N> centers;
  for (std::size_t i = 0; i < d.size(); ++i) centers[i] = d[i].mid();
  const Image over = image(equations, Y, middle.lo, centers, s, d);
  double along = 0.0;
  double rest = 0.0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    const Interval own(core_[i].hi);
    along = std::max(along, (over.along[i] / own).magnitude());
    double row = 0.0;
    for (std::size_t j = 0; j < d.size(); ++j)
      row = above(row + (over.rest[i][j] * core_[j].hi / own).magnitude());
    rest = std::max(rest, row);
  }
  Slice out;
  out.y = place(s, d);
  out.velocity.fill(Interval::entire());
  if (!(rest < 0.9)) return out;
  const double bound = fixed_point_bound(along, rest);
  Box<N> slope;
  for (std::size_t i = 0; i < d.size(); ++i) slope[i] = Interval(-bound, bound) * core_[i].hi;
  constexpr int passes = 3;
  for (int pass = 0; pass < passes; ++pass) {
    Box<N> next = over.along;
    for (std::size_t i = 0; i < d.size(); ++i)
      for (std::size_t j = 0; j < d.size(); ++j) next[i] += over.rest[i][j] * slope[j];
    slope = next;
  }
  const CurveBox<N> there = place(middle, d_middle);
  for (int i = 0; i <= N; ++i) {
    Interval& velocity = out.velocity[at(i)];
    velocity = Interval(axes_(i, 0));
    for (int j = 0; j < N; ++j) velocity += axes_(i, j + 1) * slope[at(j)];
    const Interval by_slope = there[at(i)] + velocity * (s - middle);
    if (!by_slope.apart_from(out.y[at(i)])) out.y[at(i)] = common(out.y[at(i)], by_slope);
  }
  return out;
}

#define STATIONARY_TUBE(N)                                        \
  template class Tube<N>;                                         \
  template TubePoint<N> tangent_of<N>(const CurveLinearized<N>&); \
  template std::optional<TubePoint<N>> corrected_point<N>(const CurveEquations<N>&, TubePoint<N>);
STATIONARY_TUBE(1)
STATIONARY_TUBE(2)
STATIONARY_TUBE(3)
STATIONARY_TUBE(4)
#undef STATIONARY_TUBE

}  // namespace stationary
