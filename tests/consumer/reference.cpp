// The examples of docs/library.md, which has these lines: that they compile, and say what is written
// there.
#include <cmath>
#include <cstdio>
#include <stationary/solver/atlas/atlas.hpp>
#include <stationary/solver/batch/sweep.hpp>
#include <stationary/solver/batch_spectrum/batch_spectrum.hpp>
#include <stationary/solver/kind/kind.hpp>
#include <stationary/solver/solve/solve.hpp>
#include <stationary/solver/solve/stability.hpp>
#include <stdexcept>
#include <vector>
using namespace stationary;

namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}

struct Events : CurveSink {
  void row(const Member& member, EventType event) override {
    if (event != EventType::none && !is_end(event)) found.push_back({event, member.parameter});
  }
  struct Event {
    EventType type;
    double nu;
  };
  std::vector<Event> found;
};

void examples() {
  const double plane[] = {1.0, 2.0}, thickness[] = {1.0, 3.0};
  const Problem disc(Body(1.0, 1.7, 0.6),
                     Potential(Potential::planar("reciprocal-determinant", plane),
                               Potential::thickness("reciprocal-quadratic", thickness)),
                     Branch::i);
  const Equilibrium s = solve(disc, 0.5);     // s.q, s.error_bound, s.status, s.message
  const Spectrum modes = stability(disc, s);  // modes.verdict, modes.growth, modes.mode[k]
  require(s.status == SolveStatus::solved, "solve");
  require(modes.verdict == StabilityClass::unstable, "stability");

  const Certificate proof = certify(disc, s);    // proof.proven, proof.error_bound, proof.solution
  const SearchResult every = search(disc, 0.5);  // every.solutions, proven to be all in the box
  require(proof.proven && proof.error_bound < 1e-14, "certify");
  require(every.status == SearchStatus::complete && every.solutions.size() == 1, "search");

  std::vector<double> nu(1000);
  for (std::size_t k = 0; k < nu.size(); ++k) nu[k] = 0.5 + 1e-4 * static_cast<double>(k);
  std::vector<SweepPoint> points(nu.size());
  Sweep(disc, s).run(nu, points);  // points[k].xi, .zeta, .rho, .status
  require(points.back().status == SolveStatus::solved, "Sweep");

  BatchInput bodies(disc, 3, {0.1, 0.2, 0.3});     // three bodies at three nu
  bodies.inertia[1] = std::vector{1.5, 1.6, 1.7};  // that differ in J2
  BatchResult cells;
  solve_batch(bodies, {}, cells);  // cells.cell(lane, k).xi
  const CellPlace places[] = {{0, 2}, {2, 2}};
  CellSpectrum spectra[2];
  cell_spectra(bodies, cells, places, {}, spectra);  // spectra[0].verdict, .mode
  require(cells.cell(2, 2).status == SolveStatus::solved && spectra[0].modes == 5, "solve_batch");

  const auto tilted =
      kind_of(disc.body(), disc.potential(), TiltedMotion{TiltPlane::one_three, 1.07});
  const Equilibrium leaning = tilted->solve({});
  require(leaning.status == SolveStatus::solved, "kind_of");

  Events events;
  FollowOptions range;
  range.continuation.to = 1.2;
  const FollowReport report = follow(axis_family(disc, {}), s.q, 0.5, range, events);
  require(report.failure.empty() && !events.found.empty(), "follow");

  AtlasOptions where;
  where.to = 1.2;
  where.checkpoints = 16;
  const Atlas sheets = atlas(disc.body(), disc.potential(), where);  // sheets.sheets[k].rows
  require(sheets.sheets.size() >= 3, "atlas");
}

}  // namespace

int main() {
  try {
    examples();
  } catch (const std::exception& error) {
    std::printf("not as documented: %s\n", error.what());
    return 1;
  }
  return 0;
}
