#include "solver/program/tiles/tile_loop.hpp"

#include <algorithm>
#include <utility>

#include "solver/program/tiles/tile_workers.hpp"

namespace stationary::cli {

std::vector<std::size_t> TileLoop::missing() const {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < tiles; ++k)
    if (!knows(k)) out.push_back(k);
  return out;
}

bool run(const TileLoop& loop) {
  Dispatcher dispatcher(loop.missing(), 1);
  TileOrder order(loop);
  {
    TileWorkers workers(loop, dispatcher, order, loop.threads - 1);
    workers.work();
    workers.wait();
  }
  return order.finish();
}

}  // namespace stationary::cli
