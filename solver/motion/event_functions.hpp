// What vanishes at an event, of numbers of any type.
#pragma once

#include <array>
#include <cstddef>

#include "lib/body/motion.hpp"
#include "lib/stability/held_linearization.hpp"
#include "lib/stability/linearization.hpp"
#include "lib/stability/spectrum.hpp"

namespace stationary {

template <class T, std::size_t N>
using SquareArray = std::array<std::array<T, N>, N>;

/// By the first row.
template <class T, std::size_t N>
T determinant(const SquareArray<T, N>& a) {
  if constexpr (N == 1) {
    return a[0][0];
  } else {
    T sum(0.0);
    for (std::size_t j = 0; j < N; ++j) {
      SquareArray<T, N - 1> minor;
      for (std::size_t row = 1; row < N; ++row)
        for (std::size_t column = 0, to = 0; column < N; ++column)
          if (column != j) minor[row - 1][to++] = a[row][column];
      const T term = a[0][j] * determinant(minor);
      sum = j % 2 == 0 ? sum + term : sum - term;
    }
    return sum;
  }
}

/// A matrix with a column, a row and a corner more.
template <class T, std::size_t N>
SquareArray<T, N + 1> bordered(const SquareArray<T, N>& a, const std::array<T, N>& column,
                               const std::array<T, N>& row, const T& corner) {
  SquareArray<T, N + 1> out;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) out[i][j] = a[i][j];
    out[i][N] = column[i];
    out[N][i] = row[i];
  }
  out[N][N] = corner;
  return out;
}

/// d(I nu) along the kernel of [dG/d ln x  dG/d ln nu], but for its length: zero where |pi| turns.
/// inertia_slope: dI/d ln x.
template <class T, std::size_t N>
T momentum_turn(const SquareArray<T, N>& jacobian, const std::array<T, N>& nu_slope,
                const std::array<T, N>& inertia_slope, const T& inertia) {
  return determinant(bordered(jacobian, nu_slope, inertia_slope, inertia));
}

/// What tells the blocks that the linearization at alpha = 0 falls into.
struct SpinBlocks {
  Branch branch;
  bool coupled;      ///< rho is not left to itself
  bool volume_held;  ///< the state's second derivatives are along it, the pull of rho among them
};

/// A block's characteristic polynomial at one Lambda.
template <class T>
struct CharacteristicValue {
  T value;
  T slope;
};
template <int D, class T>
CharacteristicValue<T> value_at(const Polynomial<T, D>& p, const T& Lambda) {
  return {p(Lambda), p.slope(Lambda)};
}

/// The shears of a circle, s = i (omega +- Omega): Lambda^2 + 2 (omega^2 + Omega^2) Lambda +
/// (Omega^2 - omega^2)^2, Omega^2 - omega^2 = K_aa/(2 J).
template <class T>
Polynomial<T, 2> circle_shears(const StraightState<T>& s) {
  const T omega2 = s.omega * s.omega;
  const T k = s.V_aa / (2.0 * s.J.J1) - omega2;
  return {{k * k, 2.0 * (2.0 * omega2 + k), 1.0}};
}

/// (iii), even, where the volume is held. circle: that of xi = zeta, but for its shears.
template <bool circle, class T>
CharacteristicValue<T> held_characteristic(const StraightState<T>& s, const T& Lambda) {
  const HeldGyroscopicBlock<T> even = held_even_iii(s);
  if constexpr (circle) {
    const PlanarPencil<T>& plane = even.plane;
    return {Lambda + (plane.K[0] + plane.K[1]) / (plane.mass[0] + plane.mass[1]), T(1.0)};
  } else {
    return value_at(even.characteristic(), Lambda);
  }
}

/// circle: xi = zeta, one number, in (iii).
template <bool circle, class T>
CharacteristicValue<T> characteristic(const SpinBlocks& of, const StraightState<T>& s, Block block,
                                      const T& Lambda) {
  if (of.branch != Branch::iii) {
    const StraightState<T> first = of.branch == Branch::ii ? s.exchanged() : s;
    if (block == Block::odd) return value_at(odd_forms_i(first).characteristic(), Lambda);
    return of.volume_held ? value_at(held_even_i(first).characteristic(), Lambda)
                          : value_at(even_pencil_i(first).characteristic(), Lambda);
  }
  switch (block) {
    case Block::odd:
      return {Lambda - odd_lambda_iii(s), T(1.0)};
    case Block::thickness:
      return {Lambda + s.V_rr / s.J.J3, T(1.0)};
    case Block::shear:
      return value_at(circle_shears(s), Lambda);
    default:
      break;
  }
  if (of.volume_held) return held_characteristic<circle>(s, Lambda);
  const GyroscopicBlock<T> even = even_block_iii(s);
  if constexpr (circle) {
    const T breathing = (even.rest.K[0][0] + even.rest.K[0][1]) / s.J.J1;
    if (!of.coupled) return {Lambda + breathing, T(1.0)};
    const T thickness = s.V_rr / s.J.J3;
    const T mixed = 2.0 * (s.V_xr * s.V_xr) / (s.J.J1 * s.J.J3);
    return value_at(Polynomial<T, 2>{{breathing * thickness - mixed, breathing + thickness, 1.0}},
                    Lambda);
  } else {
    return of.coupled ? value_at(even.characteristic_coupled(), Lambda)
                      : value_at(even.characteristic(), Lambda);
  }
}

/// What vanishes where two Lambdas meet: of one block its polynomial and the slope, of two blocks
/// the polynomial of each.
struct MeetingModes {
  bool within;  ///< one block, which is the first
  Block first;
  Block second;
};
template <bool circle, class T>
std::array<T, 2> meeting_equations(const MeetingModes& which, const SpinBlocks& of,
                                   const StraightState<T>& s, const T& Lambda) {
  const auto first = characteristic<circle>(of, s, which.first, Lambda);
  return {first.value,
          which.within ? first.slope : characteristic<circle>(of, s, which.second, Lambda).value};
}

}  // namespace stationary
