// The equations of one event of a family, whose other numbers are held, at points in extended
// precision:
//
//   F(y) = 0,   y = (xi, zeta, rho, p[, what else the family or the event has unknown])
//
// the balance and what vanishes at the event. They correct a located event, say how far its inputs
// move it, and are what a curve of events is followed by. An unknown of y that the event's own
// system does without is 1; on the circle zeta is xi.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "solver/newton/extended_root.hpp"

namespace stationary {

/// How many y has, of a family with N unknowns.
template <int N>
inline constexpr int event_dimension = N < 4 ? 5 : N + 1;

/// The place in y of a family's unknown.
constexpr std::size_t event_place(std::size_t unknown) {
  return unknown < 3 ? unknown : unknown + 1;
}

template <int M>
class ExtendedEventEquations {
 public:
  static constexpr int dimension = M;
  static constexpr int parameter = 3;  ///< the place of p in y
  static constexpr int lambda = 4;     ///< of Lambda, where it is an unknown
  using Errors = std::array<double, static_cast<std::size_t>(M)>;

  ExtendedEventEquations() = default;
  ExtendedEventEquations(const ExtendedEventEquations&) = delete;
  ExtendedEventEquations& operator=(const ExtendedEventEquations&) = delete;
  virtual ~ExtendedEventEquations() = default;

  virtual ExtendedVector<M> values(const ExtendedVector<M>& y) const = 0;
  /// The root near y; nothing where the equations are singular there.
  virtual std::optional<ExtendedRoot<M>> root(const ExtendedVector<M>& y) const = 0;
  /// Of each equation the sum of |c dF/dc| over the numbers of the problem and the unknowns.
  virtual Errors conditions(const ExtendedVector<M>& y) const = 0;
  /// The relative error of the event's stretches, of a root with these errors.
  virtual double stretch_error(const Errors& error) const {
    return *std::max_element(error.begin(), error.begin() + parameter);
  }
};

/// One that holds one more number of the problem, at a value that changes: of a curve of events.
template <int M>
class HeldEventEquations : public ExtendedEventEquations<M> {
 public:
  virtual void hold(double value) = 0;
};

/// A system (extended_root.hpp) whose unknowns and equations stand at these places among M.
template <int M, class System>
struct EventSystemInPlaces {
  static constexpr auto K = static_cast<std::size_t>(System::dimension);
  using Places = std::array<std::size_t, K>;

  const System& system;
  const Places& places;
  bool circle = false;  ///< zeta is xi

  ExtendedVector<System::dimension> own(const ExtendedVector<M>& y) const {
    ExtendedVector<System::dimension> out;
    for (std::size_t k = 0; k < K; ++k) out[k] = y[places[k]];
    return out;
  }
  ExtendedVector<M> values(const ExtendedVector<M>& y) const {
    ExtendedVector<M> out;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = y[i] - DoubleDouble(1.0);
    if (circle) out[1] = y[1] - y[0];
    const auto at = system.values(own(y), {});
    for (std::size_t k = 0; k < K; ++k) out[places[k]] = at[k];
    return out;
  }
  std::optional<ExtendedRoot<M>> root(const ExtendedVector<M>& y) const {
    const auto found = extended_root(system, own(y));
    if (!found) return std::nullopt;
    ExtendedRoot<M> out{};
    out.y.fill(DoubleDouble(1.0));
    for (std::size_t k = 0; k < K; ++k) {
      out.y[places[k]] = found->y[k];
      out.error[places[k]] = found->error[k];
    }
    if (circle) {
      out.y[1] = out.y[0];
      out.error[1] = out.error[0];
    }
    return out;
  }
  std::array<double, static_cast<std::size_t>(M)> conditions(const ExtendedVector<M>& y) const {
    std::array<Conditioned, K> rounded;
    for (std::size_t k = 0; k < K; ++k) rounded[k] = Conditioned::input(double(y[places[k]]));
    const auto at = system.conditioned(rounded, false);
    std::array<double, static_cast<std::size_t>(M)> out{};
    for (std::size_t k = 0; k < K; ++k) out[places[k]] = at[k].condition;
    return out;
  }
};

/// How the error of the stretches comes from those of all unknowns but p.
struct StretchErrorRule {
  double factor = 1.0;
  double rounding = 0.0;  ///< of a stretch that is no unknown
};

/// Those of a family, of one system.
template <int M, class System>
class SystemEventEquations final : public ExtendedEventEquations<M> {
 public:
  using Base = ExtendedEventEquations<M>;
  using InPlaces = EventSystemInPlaces<M, System>;

  SystemEventEquations(System system, const typename InPlaces::Places& places, bool circle = false,
                       const StretchErrorRule& rule = {})
      : system_(std::move(system)), places_(places), circle_(circle), rule_(rule) {}

  ExtendedVector<M> values(const ExtendedVector<M>& y) const override {
    return in_places().values(y);
  }
  std::optional<ExtendedRoot<M>> root(const ExtendedVector<M>& y) const override {
    return in_places().root(y);
  }
  typename Base::Errors conditions(const ExtendedVector<M>& y) const override {
    return in_places().conditions(y);
  }
  double stretch_error(const typename Base::Errors& error) const override {
    double most = 0.0;
    for (std::size_t i = 0; i < error.size(); ++i)
      if (i != static_cast<std::size_t>(Base::parameter)) most = std::max(most, error[i]);
    return rule_.factor * most + rule_.rounding;
  }

 private:
  InPlaces in_places() const { return {system_, places_, circle_}; }

  System system_;
  typename InPlaces::Places places_;
  bool circle_;
  StretchErrorRule rule_;
};

}  // namespace stationary
