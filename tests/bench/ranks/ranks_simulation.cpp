#include "tests/bench/ranks/ranks_simulation.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <random>

#include "solver/program/tiles/dispatcher.hpp"

namespace stationary::bench {
namespace {

struct Event {
  double at;
  std::size_t rank;
  bool arrives;  ///< work at the rank; else a result at rank 0
  double cost;   ///< of the tile of a result
  std::size_t batch = 0;
  bool operator>(const Event& other) const { return at > other.at; }
};

struct Rank {
  std::size_t given = 0;  ///< as rank 0 knows it
  double free_at = 0.0;
};

}  // namespace

SimulatedEnd simulate(const SimulatedRun& of, const std::vector<double>& costs) {
  std::vector<std::size_t> tiles(of.tiles);
  std::iota(tiles.begin(), tiles.end(), std::size_t{0});
  std::mt19937 random(1);
  std::vector<double> cost(of.tiles);
  std::uniform_int_distribution<std::size_t> pick(0, costs.size() - 1);
  for (double& each : cost) each = costs[pick(random)];
  cli::Dispatcher dispatcher(std::move(tiles), of.ranks);
  SimulatedEnd out;
  out.work = std::accumulate(cost.begin(), cost.end(), 0.0);
  std::vector<Rank> ranks(of.ranks);
  std::vector<std::vector<double>> batches;  ///< on their way
  std::priority_queue<Event, std::vector<Event>, std::greater<>> events;
  double head = 0.0;  ///< when rank 0 is free
  bool left = true;
  const auto feed = [&](std::size_t k) {
    while (left && cli::wants_more(ranks[k].given, 1)) {
      const auto next = dispatcher.next(1024);
      left = !next.empty();
      if (!left) return;
      std::vector<double> batch;
      for (const std::size_t tile : next) batch.push_back(cost[tile]);
      ranks[k].given += batch.size();
      head += of.handing_out;
      out.busy += of.handing_out;
      out.batches += 1.0;
      batches.push_back(std::move(batch));
      events.push({head + of.latency, k, true, 0.0, batches.size() - 1});
    }
  };
  for (std::size_t k = 0; k < of.ranks; ++k) feed(k);
  while (!events.empty()) {
    const Event event = events.top();
    events.pop();
    Rank& rank = ranks[event.rank];
    if (event.arrives) {
      // One thread a rank: its tiles one after the other, a result as each ends.
      for (const double each : batches[event.batch]) {
        rank.free_at = std::max(rank.free_at, event.at) + each;
        events.push({rank.free_at + of.latency, event.rank, false, each});
      }
      batches[event.batch].clear();
    } else {
      head = std::max(head, event.at) + of.taking;
      out.busy += of.taking;
      --rank.given;
      dispatcher.ended(event.cost);
      out.seconds = head;
      feed(event.rank);
    }
  }
  out.busy /= out.seconds;
  return out;
}

}  // namespace stationary::bench
