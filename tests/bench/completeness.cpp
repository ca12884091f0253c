// How much work it is to prove how many sheets there are for every nu (atlas --complete):
//
//   completeness_bench CASE.toml... > results/completeness.csv
//
// A row for each case and branch, and each plane of tilted motions: boxes examined and tubes proven, the intervals of nu with a proven
// number of sheets (neighbours that differ in what is known outside the box as one), how much of the range
// is left between them; arcs whose class was asked for, the intervals with a proven number of motions of
// each class, what is left between these; and the seconds, which are of the machine.
// `cmake --build build/release --target completeness` makes the table.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "solver/atlas/atlas.hpp"
#include "solver/program/case/case_atlas.hpp"
#include "solver/program/case/case_file.hpp"

namespace {

using namespace stationary;

/// Covers what `how` asks for, and writes a row of each kind of motion.
void write_cover(const std::string& file, const Case& input, const AtlasOptions& how) {
  const auto begin = std::chrono::steady_clock::now();
  const Atlas found = atlas(input.body, input.potential, how);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  for (const Completeness& each : found.completeness) {
    const auto proven = std::ranges::count(each.joined(), true, &CompleteInterval::proven);
    const auto classes = std::ranges::count(each.classes, true, &ClassInterval::proven);
    std::printf("%s,%s,%s,%g,%g,%ld,%ld,%td,%.3g,%ld,%td,%.3g,%.2g\n",
                std::filesystem::path(file).stem().c_str(), std::string(kind_name(each)).c_str(),
                each.plane ? std::string(name(*each.plane)).c_str() : "", how.from, how.to,
                each.boxes, each.tubes, proven, each.unproven_length(), each.class_arcs, classes,
                each.unproven_class_length(), seconds.count());
  }
}

void write_rows(const std::string& file) {
  const Case input = read_case(file);
  AtlasOptions how = atlas_options(input, 1, false);
  how.complete = true;
  how.spectrum = true;
  how.tilted = false;
  for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
    if (branch == Branch::ii && input.body.symmetric()) continue;  // as (i)
    how.branches = {branch};
    how.oblique = branch == Branch::iii;
    write_cover(file, input, how);
  }
  how.branches = {};
  how.oblique = false;
  how.tilted = true;
  write_cover(file, input, how);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    std::puts(
        "case,branch,plane,from,to,boxes,tubes,proven_intervals,undecided_length,"
        "class_arcs,class_intervals,class_undecided_length,seconds");
    for (int k = 1; k < count; ++k) write_rows(arguments[k]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "completeness_bench: %s\n", e.what());
    return 1;
  }
  return 0;
}
