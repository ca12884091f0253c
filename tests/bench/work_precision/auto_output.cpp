#include "tests/bench/work_precision/auto_output.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace stationary::bench {

std::vector<AutoPoint> auto_points(std::string_view text) {
  std::vector<AutoPoint> out;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    int branch = 0;
    if (!(words >> branch)) throw std::runtime_error("not a line of AUTO's: " + line);
    if (branch == 0) {  // of a header, which begins every run
      out.clear();
      continue;
    }
    int number = 0;
    int label = 0;
    double amplitude = 0.0;
    AutoPoint point{};
    if (!(words >> number >> point.type >> label >> point.parameter >> amplitude))
      throw std::runtime_error("not a point of AUTO's: " + line);
    for (double u = 0.0; words >> u;) point.unknowns.push_back(u);
    if (point.unknowns.empty() || !words.eof())
      throw std::runtime_error("not a point of AUTO's: " + line);
    out.push_back(std::move(point));
  }
  return out;
}

}  // namespace stationary::bench
