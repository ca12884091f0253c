// What a journal of tiles (tiles/journal.hpp) has, read by its form alone.
#pragma once

#include <set>
#include <sstream>
#include <string>

namespace stationary::testing {

/// The tiles whose records are whole, up to the first that is not.
inline std::set<std::size_t> kept_tiles(const std::string& journal) {
  std::set<std::size_t> out;
  std::size_t at = journal.find('\n');
  while (at != std::string::npos) {
    const std::size_t end = journal.find('\n', ++at);
    if (end == std::string::npos) break;
    std::istringstream line(journal.substr(at, end - at));
    std::string word;
    std::size_t tile = 0;
    std::size_t bytes = 0;
    if (!(line >> word >> tile >> bytes) || word != "tile") break;
    at = end + 1 + bytes;  // of the record's own end
    if (at >= journal.size()) break;
    out.insert(tile);
  }
  return out;
}

}  // namespace stationary::testing
