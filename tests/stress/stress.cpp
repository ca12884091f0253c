// Solves every category of hard cases, holds each answer against 50 digits, and writes what became
// of them:
//
//   stress DIRECTORY [SHARE] [PART]
//
// SHARE of the cases, by default 1: all. PART is one of
//   categories   hard solves                                  stress.csv
//   formulas     random formulas
//   followed     rows of followed sheets
//   fold         solves ever closer to a fold                 stress_fold.csv, .svg, .png
//   curves       stability along random families
// and by default every one of them.
//
// Exit code 0: every claim was true, and of random formulas enough were tried; 1: the untrue ones
// are listed on standard error; 2: usage.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <thread>

#include "solver/program/plot/gnuplot.hpp"
#include "solver/program/table/atomic_file.hpp"
#include "tests/stress/cases/curve_survey.hpp"
#include "tests/stress/cases/followed_rows.hpp"
#include "tests/stress/categories.hpp"
#include "tests/stress/fold_figure.hpp"
#include "tests/stress/formulas/formula_judge.hpp"

namespace {

using namespace stationary;
using namespace stationary::stress;

constexpr long ladder_folds = 2000;
constexpr long formulas = 3000;
constexpr long surveyed_curves = 500;
constexpr long followed_sheets = 2000;

void write(const std::filesystem::path& path, const std::string& text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

void draw(const std::filesystem::path& path, const std::string& script) {
  AtomicFile file(path);
  file.write(run_gnuplot(script));
  file.commit();
}

/// Whether all claims were true.
bool report(std::string_view name, const Tally& tally) {
  std::fprintf(stderr, "%-20s %ld cases, %ld solved, %zu untrue\n", std::string(name).c_str(),
               tally.tried, tally.solved, tally.faults.size());
  for (const std::string& fault : tally.faults) std::fprintf(stderr, "  %s\n", fault.c_str());
  return tally.faults.empty() && tally.reported() == tally.tried;
}

/// Likewise, and whether so many claims of each kind were tried, but for the chance of a share of them; the faults are
/// listed by now.
bool report(const FormulaTally& tally, double share) {
  std::fprintf(stderr, "random formulas      %s\n", text_of(tally).c_str());
  bool enough = true;
  const auto require = [&](const char* what, long count, double wanted) {
    if (static_cast<double>(count) >= wanted) return;
    enough = false;
    std::fprintf(stderr, "  too few %s to tell: %ld, expected at least %.0f\n", what, count,
                 wanted);
  };
  const auto of_all = [&](double wanted) {
    return share * wanted - 2.0 * std::sqrt(share * wanted);
  };
  const auto taken = static_cast<double>(tally.cases - tally.refused);
  require("solutions proven", tally.proven, of_all(2000.0));
  require("cases that are proven to have none", tally.none, of_all(300.0));
  require("ends `domain`", tally.domain_ends, of_all(200.0));
  require("anisotropic formulas", tally.anisotropic, 0.3 * taken);
  require("formulas with poles", tally.poles, 0.2 * taken);
  return tally.faults.empty() && enough;
}

bool report(const CurveSurvey& survey) {
  std::fprintf(stderr,
               "%-20s %ld families, %ld followed, %ld rows, %ld changes of stability, %ld events "
               "located, %ld not resolved, %zu untrue\n",
               "curves", survey.tried, survey.followed, survey.rows, survey.changes, survey.events,
               survey.unresolved, survey.faults.size());
  for (const std::string& fault : survey.faults) std::fprintf(stderr, "  %s\n", fault.c_str());
  return survey.faults.empty();
}

long share_of(double share, long all) { return std::lround(share * static_cast<double>(all)); }

bool categories_hold(const std::filesystem::path& into, double share) {
  bool all_true = true;
  std::string table = tally_header();
  for (const Category& category : categories()) {
    const Tally tally = tried(category, share_of(share, category.cases));
    all_true = report(category.name, tally) && all_true;
    table += tally_line(category.name, tally);
  }
  write(into / "stress.csv", table);
  return all_true;
}

/// In hundreds, each of its own seed, with what became of them so far after each.
bool formulas_hold(const std::filesystem::path&, double share) {
  constexpr std::uint64_t seed = 2026;
  constexpr long at_once = 100;
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const long all = share_of(share, formulas);
  FormulaTally out;
  for (long done = 0; done < all; done += at_once) {
    const FormulaTally hundred =
        judged_formulas(std::min(at_once, all - done),
                        seed + static_cast<std::uint64_t>(done / at_once), {}, threads);
    for (const std::string& fault : hundred.faults) std::fprintf(stderr, "  %s\n", fault.c_str());
    out += hundred;
    std::fprintf(stderr, "                     %s\n", text_of(out).c_str());
  }
  return report(out, share);
}

bool followed_hold(const std::filesystem::path&, double share) {
  const FollowedRows rows = followed_rows(share_of(share, followed_sheets));
  std::fprintf(stderr, "%-20s %ld sheets, %ld rows, %ld events, %zu untrue\n", "followed",
               rows.sheets, rows.rows, rows.events, rows.faults.size());
  for (const std::string& fault : rows.faults) std::fprintf(stderr, "  %s\n", fault.c_str());
  return rows.faults.empty();
}

bool fold_holds(const std::filesystem::path& into, double share) {
  bool all_true = true;
  const auto ladder = fold_ladder(share_of(share, ladder_folds));
  for (const Rung& rung : ladder) all_true = report("beside a fold", rung.tally) && all_true;
  write(into / "stress_fold.csv", ladder_table(ladder));
  draw(into / "stress_fold.svg", fold_script(ladder, ImageFormat::svg));
  draw(into / "stress_fold.png", fold_script(ladder, ImageFormat::png));
  return all_true;
}

bool curves_hold(const std::filesystem::path&, double share) {
  return report(survey_curves(0, share_of(share, surveyed_curves)));
}

struct Part {
  std::string_view name;
  bool (*holds)(const std::filesystem::path& into, double share);
};
constexpr Part parts[] = {{"categories", categories_hold},
                          {"formulas", formulas_hold},
                          {"followed", followed_hold},
                          {"fold", fold_holds},
                          {"curves", curves_hold}};

}  // namespace

int main(int count, char** arguments) {
  try {
    const double share = count >= 3 ? std::stod(arguments[2]) : 1.0;
    const std::string_view wanted = count == 4 ? arguments[3] : "";
    const bool known = wanted.empty() || std::ranges::count(parts, wanted, &Part::name) == 1;
    const bool named = count >= 2 && *arguments[1] != '-';  // a directory, not an option
    if (!named || count > 4 || !(share > 0.0 && share <= 1.0) || !known) {
      std::fputs(
          "usage: stress DIRECTORY [SHARE] [PART]\n"
          "0 < SHARE <= 1; PART: categories | formulas | followed | fold | curves\n",
          stderr);
      return 2;
    }
    bool all_true = true;
    for (const Part& part : parts)
      if (wanted.empty() || part.name == wanted)
        all_true = part.holds(arguments[1], share) && all_true;
    return all_true ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stress: %s\n", error.what());
    return 2;
  }
}
