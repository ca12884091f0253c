// Work in tiles that tells of every tile that is begun, a line each in a file, at once: whoever is killed,
// what was computed twice can be counted.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "solver/program/tiles/tiled_run.hpp"

namespace stationary::testing {

struct TracedWork {
  std::size_t rows = 400;
  std::size_t rows_a_tile = 3;
  std::string trace;     ///< the file
  int milliseconds = 0;  ///< of a tile

  std::size_t tiles() const { return (rows + rows_a_tile - 1) / rows_a_tile; }

  /// What a row says, of a length of its own.
  static std::string row_text(std::size_t row) {
    return std::to_string(row * row) + std::string(row % 7, '\n') + std::string(row % 3, '\0');
  }
  std::string whole_text() const {
    std::string out;
    for (std::size_t k = 0; k < rows; ++k) out += row_text(k);
    return out;
  }
  cli::TiledWork work() const {
    return {.hash = "0123456789abcdef",
            .share = {0, rows},
            .rows_a_tile = rows_a_tile,
            .unit = "rows",
            .compute = [*this](const cli::Share& of) -> std::optional<std::string> {
              tell(of.first / rows_a_tile);
              std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
              std::string out;
              for (std::size_t k = of.first; k < of.last; ++k) out += row_text(k);
              return out;
            }};
  }
  /// How often each tile was begun.
  std::map<std::size_t, int> begun() const {
    std::map<std::size_t, int> out;
    std::ifstream lines(trace);
    for (std::size_t tile = 0; lines >> tile;) ++out[tile];
    return out;
  }

 private:
  void tell(std::size_t tile) const {
    const std::string line = std::to_string(tile) + "\n";
    const int file = ::open(trace.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    const bool told = ::write(file, line.data(), line.size()) == static_cast<ssize_t>(line.size());
    ::close(file);
    if (!told) throw std::runtime_error("no trace");
  }
};

}  // namespace stationary::testing
