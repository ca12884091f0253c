// Interrupted tables of continue and what --resume makes of them: the whole table, or a refusal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "solver/program/rows/resume_table.hpp"
#include "solver/program/table/column_file.hpp"
#include "tests/program/needs_gnuplot.hpp"
#include "tests/program/needs_hdf5.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// Both ways from rest through two folds and two tilts, to two escapes.
const char* const two_sided = R"([body]
J = [1.0, 1.7, 0.6]
[potential]
plane     = { model = "hencky", mu = 1.1, lambda = 0.8 }
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }
[motion]
branch = "i"
nu = 0.0
[continuation]
parameter = "nu"
from = -1.0
to = 1.0
tolerance = 1e-7
)";

double nu(const Row& row) { return number(row.at("nu1")); }

class Resume : public ::testing::Test {
 protected:
  Outcome run(const std::vector<std::string>& more = {}, const RunOptions& options = {}) const {
    std::vector<std::string> arguments{"continue", case_file_, "-o", table_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments, options);
  }
  Outcome resume(std::vector<std::string> more = {}, const RunOptions& options = {}) const {
    more.emplace_back("--resume");
    return run(more, options);
  }
  /// A table that ended open after so many points.
  void stop_after(int points, const std::vector<std::string>& more = {}) const {
    auto all = more;
    all.insert(all.end(), {"--set", "continuation.max_points=" + std::to_string(points)});
    ASSERT_EQ(run(all).code, 0);
  }
  std::vector<Row> rows() const { return rows_of(text_of(table_)); }
  nlohmann::json metadata() const { return nlohmann::json::parse(text_of(metadata_)); }
  std::vector<Row> uninterrupted(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"continue", case_file_, "-o", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return rows_of(run_program(arguments).out);
  }
  void expect_whole(const std::vector<Row>& expected) const {
    const auto found = rows();
    const auto old = events_of(expected);
    const auto events = events_of(found);
    ASSERT_EQ(events.size(), old.size());
    std::size_t inner = 0;
    for (std::size_t k = 0; k < events.size(); ++k) {
      EXPECT_EQ(events[k].at("event"), old[k].at("event"));
      if (events[k].at("event") == "escape") continue;  // the first point beyond the bounds
      ++inner;
      EXPECT_NEAR(nu(events[k]), nu(old[k]), 1e-12 * std::abs(nu(old[k])));
    }
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].at("point"), std::to_string(k));
      EXPECT_EQ(found[k].at("sheet"), "1");
      if (k == 0) continue;
      EXPECT_NE(found[k].at("zeta"), found[k - 1].at("zeta")) << "a row twice, " << k;
    }
    EXPECT_NEAR(static_cast<double>(found.size()), static_cast<double>(expected.size()), 8.0);
    const auto told = metadata();
    EXPECT_EQ(told["status"], "done");
    EXPECT_EQ(told["rows"], found.size());
    for (const auto& [key, row] :
         {std::pair{"first_end", found.front()}, {"last_end", found.back()}})
      EXPECT_THAT(told[key].get<std::string>(), StartsWith(row.at("event") + " at nu = "));
    std::size_t k = 0;
    for (const Row& row : events) {
      if (row.at("event") == "limit" || row.at("event") == "escape") continue;
      ASSERT_LT(k, told["events"].size());
      EXPECT_EQ(told["events"][k]["event"], row.at("event"));
      EXPECT_EQ(told["events"][k]["parameter"].get<double>(), nu(row));
      ++k;
    }
    EXPECT_EQ(k, told["events"].size());
  }
  void expect_refused(const std::string& message) const {
    const std::string table = text_of(table_);
    const std::string beside = text_of(metadata_);
    const Outcome outcome = resume();
    EXPECT_EQ(outcome.code, 2) << message;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_TRUE(text_of(table_) == table);
    EXPECT_TRUE(text_of(metadata_) == beside);
  }

  TemporaryDirectory directory_;
  std::string case_file_ = directory_.file("case.toml", two_sided);
  std::string table_ = directory_ / "x.csv";
  std::string metadata_ = directory_ / "x.meta.json";
};

TEST_F(Resume, FromAnyNumberOfPoints) {
  const auto whole = uninterrupted();
  const int size = static_cast<int>(whole.size());
  ASSERT_EQ(events_of(whole).size(), 6U);
  for (const int points : {2, 3, 10, size / 4, size / 2, size / 2 + 10, 3 * size / 4, size - 2}) {
    stop_after(points);
    ASSERT_LT(rows().size(), whole.size());
    const Outcome outcome = resume();
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, IsEmpty());
    expect_whole(whole);
  }
}

/// A family of ellipses ends at a circle, whose class is that of another sheet: its cell is empty.
TEST(ResumeATwoPolarFamily, ThatHasComeToACircle) {
  const TemporaryDirectory directory;
  const std::string path = directory / "x.csv";
  const std::vector<std::string> whole{
      "continue", std::string(STATIONARY_CASES) + "/two_polar.toml", "--quiet", "-o", path};
  std::vector<std::string> cut = whole;
  cut.insert(cut.end(), {"--set", "continuation.max_points=488"});
  ASSERT_EQ(run_program(cut).code, 0);
  const std::size_t before = rows_of(text_of(path)).size();
  std::vector<std::string> resumed = whole;
  resumed.push_back("--resume");
  const Outcome outcome = run_program(resumed);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_GE(rows_of(text_of(path)).size(), before);
}

TEST_F(Resume, OverAndOver) {
  const auto whole = uninterrupted();
  stop_after(2);
  std::size_t before = rows().size();
  for (std::size_t points = 20; points < 2 * whole.size(); points += 20) {
    ASSERT_EQ(resume({"--set", "continuation.max_points=" + std::to_string(points)}).code, 0);
    EXPECT_GE(rows().size(), before);
    before = rows().size();
    if (!rows().front().at("event").empty() && !rows().back().at("event").empty()) break;
  }
  const auto found = events_of(rows());
  const auto expected = events_of(whole);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    EXPECT_EQ(found[k].at("event"), expected[k].at("event"));
}

TEST_F(Resume, KeepsTheRowsThereAre) {
  stop_after(100);
  const auto old = rows();
  ASSERT_EQ(resume().code, 0);
  const auto now = rows();
  std::size_t at = 0;
  while (at < now.size() && now[at].at("zeta") != old.front().at("zeta")) ++at;
  ASSERT_LE(at + old.size(), now.size());
  for (std::size_t k = 0; k < old.size(); ++k) {
    Row same = now[at + k];
    same["point"] = std::to_string(k);
    same["segment"] = old[k].at("segment");  // counted from the other end of the table
    EXPECT_EQ(same, old[k]);
  }
}

TEST_F(Resume, AlongAnotherParameter) {
  const std::vector<std::string> other{"--set", "continuation.parameter=potential.plane.mu",
                                       "--set", "continuation.from=0.9",
                                       "--set", "continuation.to=4",
                                       "--set", "motion.nu=0.5"};
  const auto whole = uninterrupted(other);
  for (const int points : {2, 9, static_cast<int>(whole.size()) - 2}) {
    stop_after(points, other);
    ASSERT_EQ(resume(other).code, 0);
    const auto found = rows();
    ASSERT_EQ(events_of(found).size(), events_of(whole).size());
    for (std::size_t k = 0; k < events_of(whole).size(); ++k) {
      const Row a = events_of(found)[k];
      const Row b = events_of(whole)[k];
      EXPECT_EQ(a.at("event"), b.at("event"));
      EXPECT_NEAR(number(a.at("potential.plane.mu")), number(b.at("potential.plane.mu")), 1e-12);
    }
  }
}

/// An axis that has turned by more than a half turn is written on from where it was.
TEST_F(Resume, AnAxisGoesOnTurning) {
  const char* const turning_fibre = R"([body]
J = [1.0, 1.0, 0.6]
[potential]
plane     = { model = "neo-hookean", mu = 1.0, lambda = 2.0 }
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }
fibre     = { k = 0.4, degrees = 10.0 }
[motion]
branch = "oblique"
axis = "2"
nu = 0.5
[continuation]
parameter = "potential.fibre.degrees"
from = 10.0
to = 300.0
tolerance = 1e-7
)";
  case_file_ = directory_.file("turning.toml", turning_fibre);
  const std::size_t length = uninterrupted().size();
  for (const std::size_t points : {length / 3, length / 2, length - 3}) {
    stop_after(static_cast<int>(points));
    ASSERT_EQ(resume().code, 0);
    const auto found = rows();
    EXPECT_EQ(found.back().at("event"), "limit");
    EXPECT_EQ(number(found.back().at("potential.fibre.degrees")), 300.0);
    double before = 0.0;
    for (const Row& row : found) {
      const double fibre = number(row.at("potential.fibre.degrees")) * std::acos(-1.0) / 180.0;
      const double sense =
          -number(row.at("nu1")) * std::sin(fibre) + number(row.at("nu2")) * std::cos(fibre);
      EXPECT_NEAR(std::abs(sense), 0.5, 1e-12);
      EXPECT_GE(sense * before, 0.0) << row.at("potential.fibre.degrees");
      before = sense;
    }
  }
}

TEST_F(Resume, ACompleteTableStays) {
  ASSERT_EQ(run().code, 0);
  const std::string table = text_of(table_);
  const std::string beside = text_of(metadata_);
  const Outcome outcome = resume();
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("x.csv is complete"));
  EXPECT_EQ(text_of(table_), table);
  EXPECT_EQ(text_of(metadata_), beside);
  EXPECT_THAT(resume({"--quiet"}).out, IsEmpty());
}

/// Interrupted after its first row, which is the end behind it: the other is open.
TEST_F(Resume, OneRowThatIsAnEnd) {
  const std::vector<std::string> from_rest{"--set", "continuation.from=0"};
  stop_after(2, from_rest);
  const std::string text = text_of(table_);
  const std::size_t second = text.find('\n', text.find('\n') + 1) + 1;
  directory_.file("x.csv", text.substr(0, second));
  std::vector<Column> columns;
  for (std::istringstream header(text.substr(0, text.find('\n'))); header.good();) {
    std::string each;
    std::getline(header, each, ',');
    columns.push_back(
        static_cast<Column>(std::ranges::find(column_names, each) - std::begin(column_names)));
  }
  const ResumedTable one = read_resumed(table_, columns, std::nullopt, "i", true);
  ASSERT_EQ(one.rows.size(), 1U);
  EXPECT_EQ(one.rows[0].event, "limit");
  EXPECT_FALSE(one.first);
  EXPECT_TRUE(one.last);
  EXPECT_FALSE(read_resumed(table_, columns, std::nullopt, "i").last);
  TableChecksum checksum;
  checksum.add(one.rows[0], columns, 0);
  auto told = metadata();
  told["rows"] = 1;
  told["checksum"] = checksum.text();
  told["status"] = "interrupted";
  directory_.file("x.meta.json", told.dump());
  const Outcome outcome = resume(from_rest);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  expect_whole(uninterrupted(from_rest));
}

/// The last row lies on an event to the last places: it is gone on from itself, not from beside.
TEST_F(Resume, FromARowOnAnEvent) {
  const std::string input = directory_.file("tilt.toml", R"([body]
J = [1.42825, 2.69933, 2.11892]
[potential]
plane     = { model = "biot-log", mu = 1.15634, lambda = 0.033237 }
thickness = { model = "reciprocal-quadratic", a = 2.21176, b = 1.97421 }
[motion]
branch = "ii"
nu = 0.4489284874959108
[continuation]
from = 0.4489284874959108
to = 0.6
step = 1e-3
tolerance = 1e-6
)");
  const std::vector<std::string> follow{"continue", input, "-o", table_};
  auto stopped = follow;
  stopped.insert(stopped.end(), {"--set", "continuation.max_points=2"});
  ASSERT_EQ(run_program(stopped).code, 0);
  auto on = follow;
  on.emplace_back("--resume");
  const Outcome outcome = run_program(on);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_GT(rows().size(), 10U);
}

TEST_F(Resume, InterruptedAtOnceKeepsTheTable) {
  stop_after(50);
  const std::string table = text_of(table_);
  for (const int signal : {SIGINT, SIGTERM}) {
    const Outcome outcome = resume({}, {.pending_signal = signal});
    EXPECT_EQ(outcome.code, 130);
    EXPECT_EQ(text_of(table_), table);
    EXPECT_EQ(metadata()["status"], "interrupted");
  }
  ASSERT_EQ(resume().code, 0);
  expect_whole(uninterrupted());
}

TEST_F(Resume, InterruptedBeforeTheFirstPointLeavesNothing) {
  const Outcome outcome = run({}, {.pending_signal = SIGINT});
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(outcome.err, HasSubstr("interrupted, nothing written"));
  EXPECT_THAT(directory_.names(), ElementsAre("case.toml"));
}

/// The signal may come too late: then the table is whole.
TEST_F(Resume, InterruptedRunsLeaveRowsThatAreGoneOnWith) {
  const std::vector<std::string> fine{"--set", "continuation.tolerance=1e-13"};
  const auto whole = uninterrupted(fine);
  int interrupted = 0;
  for (int k = 0; k < 100 && interrupted < 3; ++k) {
    const Outcome outcome = run(fine, {.interrupt_once_written = table_});
    ASSERT_THAT(outcome.code, AnyOf(0, 130)) << outcome.err;
    EXPECT_THAT(directory_.names(), ElementsAre("case.toml", "x.csv", "x.meta.json"));
    if (outcome.code == 0) {
      expect_whole(whole);
      continue;
    }
    ++interrupted;
    EXPECT_THAT(outcome.err, HasSubstr("interrupted after "));
    EXPECT_TRUE(text_of(table_).ends_with("\n"));
    const auto part = rows();
    ASSERT_GE(part.size(), 2U);
    ASSERT_LT(part.size(), whole.size());
    EXPECT_EQ(part.back().at("event"), "");
    EXPECT_EQ(metadata()["status"], "interrupted");
    EXPECT_EQ(metadata()["rows"], part.size());
    EXPECT_THAT(metadata()["last_end"].get<std::string>(), HasSubstr("interrupted"));
    const Outcome finished = resume(fine);
    ASSERT_EQ(finished.code, 0) << finished.err;
    expect_whole(whole);
  }
  EXPECT_GT(interrupted, 0);
}

// What is refused, and left as it is.

TEST_F(Resume, NoTableToGoOnWith) {
  const Outcome summary = run_program({"continue", case_file_, "--resume"});
  EXPECT_EQ(summary.code, 2);
  EXPECT_THAT(summary.err, HasSubstr("--resume: found no file; expected -o FILE"));
  EXPECT_EQ(run_program({"continue", case_file_, "--resume", "-o", "-"}).code, 2);
  const Outcome nothing = resume();
  EXPECT_EQ(nothing.code, 2);
  EXPECT_THAT(nothing.err, HasSubstr("x.meta.json"));
  EXPECT_THAT(directory_.names(), ElementsAre("case.toml"));
}

TEST_F(Resume, AnotherCase) {
  stop_after(50);
  for (const char* other :
       {"body.J.0=1.1", "motion.nu=0.1", "continuation.to=0.9", "continuation.tolerance=1e-6",
        "potential.plane.mu=1.2", "output.spectrum=false", "continuation.parameter=body.J.1"}) {
    std::vector<std::string> changed{"--set", other};
    if (std::string(other).ends_with("J.1"))
      changed.insert(changed.end(), {"--set", "continuation.from=0.5"});
    const Outcome outcome = resume(changed);
    EXPECT_EQ(outcome.code, 2) << other;
    EXPECT_THAT(outcome.err, HasSubstr("x.meta.json is of another case")) << other;
  }
  // How far and how finely it is followed may differ.
  EXPECT_EQ(resume({"--set", "continuation.step=0.02"}).code, 0);
}

TEST_F(Resume, MetadataThatAreNoneOfContinue) {
  stop_after(50);
  const auto good = metadata();
  std::filesystem::remove(metadata_);
  expect_refused("cannot read ");
  // A directory of that name is none to be read either, and no figure needs it.
  std::filesystem::create_directory(directory_ / "x.meta.json");
  expect_refused("cannot read ");
  if (has_gnuplot()) {
    const Outcome plotted = run_program({"plot", directory_ / "x.csv", "-o", directory_ / "x.svg"});
    EXPECT_EQ(plotted.code, 0) << plotted.err;
  }
  std::filesystem::remove(directory_ / "x.meta.json");
  for (const char* text :
       {"", "{", "[]", "{\"case\": 1}", R"({"case": {"continuation": 1}})", "\xff\xfe"}) {
    directory_.file("x.meta.json", text);
    expect_refused("x.meta.json is no metadata of this program");
  }
  auto changed = good;
  changed.erase("rows");
  directory_.file("x.meta.json", changed.dump());
  expect_refused("does not say what rows and events the table has");
  for (const char* events : {"1", "[1]", "[{\"event\": \"tilt\"}]",
                             R"([{"event": "party", "parameter": 1, "bracket": [1, 1],
                                  "status": "located"}])",
                             R"([{"event": "tilt", "parameter": 1, "bracket": [1],
                                  "status": "located"}])"}) {
    changed = good;
    changed["events"] = nlohmann::json::parse(events);
    directory_.file("x.meta.json", changed.dump());
    expect_refused("does not say what rows and events the table has");
  }
}

TEST_F(Resume, TablesCutShortOrChanged) {
  stop_after(50);
  const std::string good = text_of(table_);
  const std::size_t last = good.rfind('\n', good.size() - 2) + 1;
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string out = good;
    const std::size_t at = out.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return out.replace(at, from.size(), to);
  };
  const std::pair<std::string, const char*> all[] = {
      {good.substr(0, last), "has 49 rows, 50 by its metadata"},
      {good + good.substr(last), "has 51 rows, 50 by its metadata"},
      {good.substr(0, good.size() - 1), "found its last line cut short"},
      {good.substr(0, good.size() - 2), "found its last line cut short"},
      {good.substr(0, last + 30), ""},
      {good.substr(0, good.find('\n') + 1), "found no rows"},
      {good.substr(0, 40), "found other columns"},
      {"", "found an empty file"},
      {"\n", ""},
      {changed(",zeta,", ",eta,"), "found other columns than this case's"},
      {changed(",side\n", ",side,body.J.0\n"), "found other columns than this case's"},
      {changed("\ni,1,0,", "\nii,1,0,"), "branch"},
      {changed("\ni,1,0,,", "\ni,1,0,party,"), "event"},
      {changed("\ni,1,0,,-", "\ni,1,0,,x"), "nu1"},
      {changed("unstable", "unstabel"), "class"},
      {std::string(1000, '\0'), ""},
  };
  for (const auto& [text, message] : all) {
    directory_.file("x.csv", text);
    expect_refused(message);
  }
}

/// Both ends say why the curve ends, whichever of them was reached before.
TEST_F(Resume, EndsSayWhatTheySaid) {
  ASSERT_EQ(run().code, 0);
  const auto told = metadata();
  const int size = static_cast<int>(rows().size());
  for (const int points : {size / 4, size - 2}) {
    stop_after(points);
    ASSERT_EQ(resume().code, 0);
    const auto now = metadata();
    for (const std::size_t k : {0U, 1U})
      for (const char* const key : {"side", "event", "reason"})
        EXPECT_EQ(now["ends"][k][key], told["ends"][k][key]) << points;
    EXPECT_EQ(now["events"].size(), told["events"].size());
  }
}

/// Its own metadata are needed to go on: x, x.csv and x.h5 have one x.meta.json.
TEST_F(Resume, AnotherTableLeavesTheMetadata) {
  stop_after(50);
  const std::string beside = text_of(metadata_);
  for (const char* const name : {"x", "x.h5"}) {
    const Outcome outcome = run_program({"continue", case_file_, "-o", directory_ / name});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("x.csv, which is not whole yet"));
    EXPECT_EQ(text_of(metadata_), beside);
  }
  ASSERT_EQ(resume().code, 0);
  // Once it is whole they are free.
  EXPECT_EQ(run_program({"continue", case_file_, "-o", directory_ / "x"}).code, 0);
}

TEST_F(Resume, TablesOfAnotherVersion) {
  stop_after(50);
  const nlohmann::json own = metadata();
  for (const auto& [key, value, message] :
       {std::tuple{"version", nlohmann::json("0.0.1"), "what version \"0.0.1\" wrote"},
        {"schema", nlohmann::json(1), "metadata of schema 1"}}) {
    nlohmann::json other = own;
    other[key] = value;
    directory_.file("x.meta.json", other.dump());
    expect_refused(message);
  }
}

/// Any cell that is another, any two rows exchanged: the metadata's checksum tells.
TEST_F(Resume, TablesWithOtherValues) {
  stop_after(50);
  const std::string good = text_of(table_);
  std::vector<std::string> lines;
  std::istringstream stream(good);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  const auto joined = [&] {
    std::string out;
    for (const std::string& line : lines) out += line + '\n';
    return out;
  };
  const std::string message = "was changed since it was written";
  for (const std::size_t k : {1U, 7U, 30U, 49U}) {
    std::swap(lines[k], lines[k + 1]);
    directory_.file("x.csv", joined());
    expect_refused(message);
    std::swap(lines[k], lines[k + 1]);
    const std::string line = lines[k];
    for (std::size_t at = 0; at < line.size(); at += 11) {
      if (line[at] < '1' || line[at] > '9') continue;
      lines[k][at] = line[at] == '1' ? '2' : static_cast<char>(line[at] - 1);
      directory_.file("x.csv", joined());
      const Outcome outcome = resume();
      EXPECT_EQ(outcome.code, 2) << lines[k];
      lines[k] = line;
    }
  }
  auto beside = metadata();
  beside.erase("checksum");
  directory_.file("x.csv", good);
  directory_.file("x.meta.json", beside.dump());
  expect_refused("does not say what rows and events the table has");
}

TEST_F(Resume, FromHdf5) {
  NEEDS_HDF5();
  table_ = directory_ / "x.h5";
  stop_after(60);
  const Outcome outcome = resume();
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::ostringstream text;
  text << column_file_table(table_, {})->rdbuf();
  EXPECT_EQ(events_of(rows_of(text.str())).size(), 6U);
}

TEST_F(Resume, TablesWithoutAPlace) {
  const std::vector<std::string> few{"--set", R"(output.columns=["event", "nu1", "xi", "zeta"])"};
  stop_after(50, few);
  const Outcome outcome = resume(few);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("found no column rho"));
  const std::vector<std::string> enough{
      "--set", R"(output.columns=["event", "nu1", "xi", "zeta", "rho", "class"])"};
  stop_after(50, enough);
  EXPECT_EQ(resume(enough).code, 0);
  EXPECT_EQ(events_of(rows()).size(), 6U);
}

/// A row of another curve is nowhere to go on from.
TEST_F(Resume, RowsThatAreNoEquilibrium) {
  stop_after(50);
  const Row last = rows().back();
  std::string text = text_of(table_);
  const std::string place = ',' + last.at("zeta") + ',' + last.at("rho") + ',';
  for (const char* zeta : {"77.5", "1.0001", "-1"}) {
    std::string changed = text;
    changed.replace(changed.rfind(place), place.size(),
                    ',' + std::string(zeta) + ',' + last.at("rho") + ',');
    directory_.file("x.csv", changed);
    const Outcome outcome = resume();
    EXPECT_THAT(outcome.code, AnyOf(2, 4)) << outcome.err;
    EXPECT_TRUE(text_of(table_) == changed);
  }
}

}  // namespace
}  // namespace stationary::testing
