// Curves as chains of tubes (tube.hpp), each begun where the last ends: the point of the last one's
// end face is enclosed tightly, and this enclosure is shown to lie in the next tube too. So both are
// of one curve, and a chain is the proof of a piece of a curve from its first tube to its last. The
// tubes are fattened, so that a cover of the region (curve_cover.hpp) finds its boxes wholly inside.
#pragma once

#include <cstddef>
#include <vector>

#include "solver/tube/tube.hpp"

namespace stationary {

struct TubeOptions {
  double first = 0.02;     ///< half-length of the first tube tried
  double longest = 0.5;    ///< in y
  double shortest = 1e-7;  ///< below it a chain ends unproven
  std::size_t most = 5000;
};

/// The curve's point on the face of a at s = h or -h is proven to lie in b.
template <int N>
bool glued(const CurveEquations<N>& equations, const Tube<N>& a, double face, const Tube<N>& b);

template <int N>
class TubeSet {
 public:
  /// All must outlive this.
  TubeSet(const CurveEquations<N>& equations, const CurveRegion<N>& region,
          const TubeOptions& options = {})
      : equations_(equations), region_(region), options_(options) {}

  /// The curve through the point nearest to y, both ways until it leaves the region, meets a tube or
  /// cannot be proven further. False where nothing new was proven.
  bool follow(const TubePoint<N>& y);

  /// Whether one tube holds the place.
  bool holds(const CurveBox<N>& place) const { return holder(place, {}) != none; }
  const std::vector<Tube<N>>& tubes() const { return tubes_; }
  /// Where chains ended unproven.
  const std::vector<TubePoint<N>>& stuck() const { return stuck_; }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  struct But {
    std::size_t first = none;
    std::size_t second = none;
  };
  std::size_t holder(const CurveBox<N>& place, const But& but) const;
  std::size_t prove(const TubePoint<N>& y, const TubePoint<N>& tangent, double& h,
                    std::size_t before, double face);
  void follow_from(std::size_t tube, double side);

  const CurveEquations<N>& equations_;
  const CurveRegion<N>& region_;
  TubeOptions options_;
  std::vector<Tube<N>> tubes_;
  std::vector<TubePoint<N>> stuck_;
};

}  // namespace stationary
