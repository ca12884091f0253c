#include "solver/program/plot/event_labels.hpp"

#include <algorithm>
#include <cstddef>
#include <map>

namespace stationary {
namespace {

/// One label for events of a name within a distance of its first; events in order of place.
std::vector<EventLabel> shared(const std::vector<NamedPlace>& events, double distance) {
  std::vector<EventLabel> out;
  std::map<std::string, std::size_t> latest;
  for (const NamedPlace& event : events) {
    const auto [at, is_new] = latest.try_emplace(event.name, out.size());
    if (!is_new && event.place - out[at->second].anchor < distance) {
      ++out[at->second].count;
      continue;
    }
    at->second = out.size();
    out.push_back({event.name, 1, event.place, event.place});
  }
  return out;
}

/// The places nearest the anchors, in the sense of least squares, that keep order and distance:
/// place k less k pitches may not fall, so neighbours where it would are averaged.
void spread(std::vector<EventLabel>& labels, const AxisRange& edge, double pitch) {
  struct Block {
    double mean;
    std::size_t size;
  };
  std::vector<Block> blocks;
  for (std::size_t k = 0; k < labels.size(); ++k) {
    Block last{labels[k].anchor - static_cast<double>(k) * pitch, 1};
    while (!blocks.empty() && blocks.back().mean >= last.mean) {
      const Block& before = blocks.back();
      const std::size_t size = before.size + last.size;
      last.mean = (before.mean * static_cast<double>(before.size) +
                   last.mean * static_cast<double>(last.size)) /
                  static_cast<double>(size);
      last.size = size;
      blocks.pop_back();
    }
    blocks.push_back(last);
  }
  const double span = pitch * (static_cast<double>(labels.size()) - 1.0);
  const double highest = std::max(edge.low, edge.high - span);
  std::size_t k = 0;
  for (const Block& block : blocks) {
    for (std::size_t j = 0; j < block.size; ++j, ++k) {
      labels[k].place = std::clamp(block.mean, edge.low, highest) + static_cast<double>(k) * pitch;
    }
  }
}

}  // namespace

std::vector<EventLabel> event_labels(std::vector<NamedPlace> events, const AxisRange& edge,
                                     double pitch) {
  if (events.empty()) return {};
  std::ranges::stable_sort(events, {}, &NamedPlace::place);
  const double length = edge.high - edge.low;
  double distance = 0.5 * pitch;
  std::vector<EventLabel> out = shared(events, distance);
  while (pitch * (static_cast<double>(out.size()) - 1.0) > length && distance <= length) {
    distance *= 2.0;
    out = shared(events, distance);
  }
  spread(out, edge, pitch);
  return out;
}

}  // namespace stationary
