// Spectra of a tile's cells (spectrum_tile.hpp) in packs: the blocks of linearization.hpp evaluated
//
//   class, negative   in working precision with running errors (lane_class.hpp): each sign that
//                     decides must be certain `slack` times over
//   modes, growth     in pairs of doubles at q corrected to them (lane_modes.hpp)
//
// A cell any of whose signs is not certain is left to the scalar path, whose own bounds are tighter
// than slack times these: what a lane claims the scalar path claims too. So are rest, where the
// leaf is another, and an ellipse of J1 = J2 in (iii).
#pragma once

#include "solver/batch_spectrum/lane_class.hpp"
#include "solver/batch_spectrum/lane_linearization.hpp"
#include "solver/batch_spectrum/lane_modes.hpp"

namespace stationary {

constexpr double lane_slack = 0x1p10;
/// Below it xi - zeta is too small for V_aa by the quotient above.
constexpr double least_ellipticity = 0x1p-21;

/// The branch's part, from the models' derivatives; (iii) where normal, else (i).
template <class V, bool normal>
[[gnu::flatten]] void lane_spectra(SpectrumTile& tile, bool modes) {
  using Mask = typename V::Mask;
  using Error = RunningError<V>;
  for (std::size_t i = 0; i < SpectrumTile::size; i += V::lanes) {
    const V nu = V::load(tile.nu + i);
    const V q[3] = {V::load(tile.q[0] + i), V::load(tile.q[1] + i), V::load(tile.q[2] + i)};
    const V J[3] = {V::load(tile.inertia[0] + i), V::load(tile.inertia[1] + i),
                    V::load(tile.inertia[2] + i)};
    const V uncertainty = V::load(tile.uncertainty + i);
    const auto uu = LaneDerivative<V>::load(tile.uu, i);
    const auto uv = LaneDerivative<V>::load(tile.uv, i);
    const auto vv = LaneDerivative<V>::load(tile.vv, i);
    const auto ww = LaneDerivative<V>::load(tile.ww, i);

    const Mask symmetric = J[0] == J[1];
    const V apart = abs(q[0] - q[1]);
    // A circle known only to its error is the circle (model_stability.hpp).
    const Mask circle =
        symmetric & (apart <= 4.0 * uncertainty * q[0]) & (normal ? nu == nu : ~(nu == nu));
    LaneVerdict<V> verdict;
    verdict.threshold = lane_slack * uncertainty;
    verdict.decided = (~(nu == V(0.0))) & (circle | (least_ellipticity * q[0] < apart));
    if constexpr (normal) verdict.decided = verdict.decided & (circle | ~symmetric);
    {
      const auto error = [](const LaneDerivative<V>& d) {
        return Error(leading(d.value), d.units);
      };
      const Error x[3] = {Error::input(q[0]), Error::input(q[1]), Error::input(q[2])};
      const auto s = lane_state<normal>(
          Inertia3<Error>{Error::input(J[0]), Error::input(J[1]), Error::input(J[2])}, x,
          Error::input(nu), error(uu), error(uv), error(vv), error(ww), circle);
      if constexpr (normal) {
        normal_verdict(s, circle, verdict);
      } else {
        in_plane_verdict(s, symmetric, verdict);
      }
    }
    if (modes && any(verdict.decided)) {
      const Pair<V> x[3] = {{q[0], V::load(tile.tail[0] + i)},
                            {q[1], V::load(tile.tail[1] + i)},
                            {q[2], V::load(tile.tail[2] + i)}};
      const auto s = lane_state<normal>(Inertia3<Pair<V>>{J[0], J[1], J[2]}, x, Pair<V>(nu),
                                        uu.value, uv.value, vv.value, ww.value, circle);
      LaneModes<V> all;
      if constexpr (normal) {
        all = normal_modes(s, circle, verdict.decided);
      } else {
        all = in_plane_modes(s, symmetric, verdict.decided);
      }
      all.sort();
      V growth = all.re[0];
      for (int k = 1; k < 5; ++k) growth = larger(growth, all.re[k]);
      select(verdict.real | verdict.complex, growth, V(0.0)).store(tile.growth + i);
      for (int k = 0; k < 5; ++k) {
        all.re[k].store(tile.re[k] + i);
        all.im[k].store(tile.im[k] + i);
        all.krein[k].store(tile.krein[k] + i);
      }
    }
    verdict.code().store(tile.verdict + i);
    verdict.negative.store(tile.negative + i);
  }
}

/// A kernel a model, in the order of its variant.
template <class Lanes, template <class> class... Model>
constexpr decltype(SpectrumKernels::plane) plane_kernels(const std::variant<Model<double>...>*) {
  return {&plane_derivatives<Lanes, Model>...};
}
template <class Lanes, template <class> class... Model>
constexpr decltype(SpectrumKernels::thickness) thickness_kernels(
    const std::variant<Model<double>...>*) {
  return {&thickness_derivatives<Lanes, Model>...};
}

/// All of them, and the branches', in packs of these lanes.
template <class Lanes>
const SpectrumKernels& spectrum_kernels() {
  static constexpr SpectrumKernels kernels{plane_kernels<Lanes>(models<PlanarPotential>),
                                           thickness_kernels<Lanes>(models<ThicknessPotential>),
                                           &lane_spectra<Lanes, false>, &lane_spectra<Lanes, true>};
  return kernels;
}

}  // namespace stationary
