#include "tests/stress/fold_figure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace stationary::stress {
namespace {

struct Line {
  double Rung::*error;
  const char* title;
  const char* style;
};
constexpr Line lines[] = {
    {&Rung::worst_error, "S as it is returned", "linespoints lc rgb '#14213d' lw 2.4 pt 7 ps 0.7"},
    {&Rung::worst_plain_error, "Newton with its residual in double precision",
     "linespoints lc rgb '#c2410c' lw 1.6 pt 5 ps 0.7"},
    {&Rung::largest_error_bound, "what the decimals of the case determine (error bound)",
     "lines lc rgb '#58a6a6' lw 1.6 dt (13,7)"}};

}  // namespace

std::string fold_script(const std::vector<Rung>& ladder, ImageFormat format) {
  std::string out =
      page_head(format, "Digits of S beside a fold, the worst of " +
                            std::to_string(ladder.front().tally.tried) + " random folds");
  out +=
      "set logscale x\n"
      "set format x '%g'\n"
      "set xrange [2e-2:5e-15]\n"
      "set yrange [0:17]\n"
      "set ytics 2\n"
      "set grid ytics lc rgb '#d1d5db' lw 0.5\n"
      "set border 3\n"
      "set tics nomirror\n"
      "set xlabel 'distance of ν from the fold, relative'\n"
      "set ylabel 'correct decimal digits'\n"
      "set key bottom left Left reverse\n";
  std::string plots;
  int block = 0;
  for (const Line& line : lines) {
    const std::string name = "$line" + std::to_string(block++);
    out += name + " << EOD\n";
    for (const Rung& rung : ladder) {
      char text[64];
      std::snprintf(text, sizeof text, "%.1e %.4f\n", rung.distance,
                    std::max(0.0, -std::log10(rung.*line.error)));
      out += text;
    }
    out += "EOD\n";
    plots += (plots.empty() ? "plot " : ", ") + name + " with " + line.style + " title '" +
             line.title + "'";
  }
  return out + plots + "\n";
}

}  // namespace stationary::stress
