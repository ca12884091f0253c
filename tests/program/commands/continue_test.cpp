// continue from outside: the table and its events, other parameters, metadata, what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "solver/motion/event.hpp"
#include "solver/program/case/case_file.hpp"
#include "solver/program/case/case_motion.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* without_spectrum =
    "branch,sheet,point,event,nu1,nu2,nu3,alpha,xi,zeta,rho,lambda,mu,angle,pi1,pi2,pi3,energy,"
    "residual,compatibility,error_bound";
constexpr const char* spectral =
    ",class,growth,negative,re1,im1,krein1,re2,im2,krein2,re3,im3,krein3,re4,im4,krein4,re5,im5,"
    "krein5,segment";
constexpr const char* of_events = ",criticality,side";

/// "continue", a case and overrides of it.
std::vector<std::string> continue_command(const std::string& case_file,
                                          const std::vector<std::string>& overrides) {
  std::vector<std::string> out{"continue", case_file};
  for (const std::string& each : overrides) {
    out.emplace_back("--set");
    out.push_back(each);
  }
  return out;
}

Outcome continued(const std::string& case_file, const std::vector<std::string>& overrides = {},
                  const std::string& target = "-") {
  auto arguments = continue_command(case_file, overrides);
  arguments.insert(arguments.end(), {"-o", target});
  return run_program(arguments);
}

/// The case's range in nu, in place of whatever it has.
std::vector<std::string> along_nu(const std::string& from, const std::string& to) {
  return {"continuation.parameter=nu", "continuation.from=" + from, "continuation.to=" + to};
}

bool is_end_name(const std::string& event) {
  for (const EventType end : {EventType::collapse, EventType::escape, EventType::limit,
                              EventType::closed, EventType::stalled})
    if (event == name(end)) return true;
  return false;
}

/// "limit tilt ... escape"
std::string names_of_events(const std::vector<Row>& rows) {
  std::string out;
  for (const Row& row : rows)
    if (!row.at("event").empty()) out += (out.empty() ? "" : " ") + row.at("event");
  return out;
}

std::size_t index_of(const std::vector<Row>& rows, const std::string& event) {
  std::size_t k = 0;
  while (k < rows.size() && rows[k].at("event") != event) ++k;
  EXPECT_LT(k, rows.size()) << "no " << event;
  return k;
}

/// At rest no axis is turned about: where two locked inertias change their order nothing changes its count.
TEST(ContinueAtRest, NothingIsUnexplained) {
  for (const char* const branch : {"i", "ii", "iii"}) {
    for (const char* const parameter :
         {"body.J.0", "body.J.1", "body.J.2", "potential.thickness.a"}) {
      const Outcome outcome = run_program(
          {"continue", shipped("disc.toml"), "-o", "-", "--set", "motion.nu=0", "--set",
           std::string("motion.branch=") + branch, "--set",
           std::string("continuation={parameter=\"") + parameter + "\",from=0.5,to=3.0}"});
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      for (const Row& row : rows_of(outcome.out)) {
        EXPECT_NE(row.at("event"), "unexplained") << branch << " " << parameter;
        EXPECT_EQ(row.at("negative"), "0");
      }
    }
  }
}

TEST(Continue, ColumnsInTheirOrder) {
  const Outcome outcome = continued(shipped("disc.toml"));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_EQ(header_of(outcome.out), std::string(without_spectrum) + spectral + of_events);
  EXPECT_TRUE(outcome.out.ends_with("\n"));
  EXPECT_EQ(outcome.out.find('\r'), std::string::npos);
  const Outcome plain = continued(shipped("disc.toml"), {"output.spectrum=false"});
  EXPECT_EQ(header_of(plain.out), std::string(without_spectrum) + of_events);
  const Outcome other = continued(
      shipped("disc.toml"), {"continuation.parameter=potential.plane.c", "continuation.from=0.5"});
  EXPECT_EQ(header_of(other.out),
            std::string(without_spectrum) + spectral + of_events + ",potential.plane.c");
}

TEST(Continue, ChosenColumnsKeepTheirOrder) {
  const std::string columns = R"(output.columns=["class", "nu1", "omega", "event", "xi"])";
  const Outcome outcome = continued(shipped("disc.toml"), {columns});
  EXPECT_EQ(header_of(outcome.out), "event,nu1,xi,class");
  EXPECT_THAT(outcome.out, HasSubstr("\nlimit,0,0.8408964152537145,"));
  // The parameter that varies is always there.
  const Outcome other = continued(
      shipped("disc.toml"),
      {columns, "continuation.parameter=body.J.1", "continuation.from=1", "continuation.to=2"});
  EXPECT_EQ(header_of(other.out), "event,nu1,xi,class,body.J.1");
  const Outcome only = continued(
      shipped("disc.toml"),
      {R"(output.columns=["omega"])", "continuation.from=0.5", "continuation.parameter=body.J.1"});
  EXPECT_EQ(header_of(only.out), "body.J.1");
  const Outcome none = continued(shipped("disc.toml"), {R"(output.columns=["omega"])"});
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("output.columns: found no column that continue computes"));
}

/// An empty line is no row to many readers.
TEST(Continue, AColumnByItselfHasALineForEveryRow) {
  const TemporaryDirectory directory;
  const std::string target = directory / "x.csv";
  ASSERT_EQ(continued(shipped("fold.toml"), {"output.columns=[\"event\"]"}, target).code, 0);
  const std::string text = text_of(target);
  EXPECT_EQ(text.find("\n\n"), std::string::npos);
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  EXPECT_EQ(std::ranges::count(text, '\n'), metadata["rows"].get<long>() + 1);
  EXPECT_EQ(rows_of(text).size(), metadata["rows"]);
}

TEST(Continue, SpectrumOffChangesNoOtherCell) {
  const std::vector<std::string> quick{"continuation.tolerance=1e-6"};
  const auto with = rows_of(continued(shipped("disc.toml"), quick).out);
  const auto without =
      rows_of(continued(shipped("disc.toml"), {quick[0], "output.spectrum=false"}).out);
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t k = 0; k < with.size(); ++k)
    for (const auto& [column, cell] : without[k]) EXPECT_EQ(with[k].at(column), cell) << column;
}

/// Every shipped case with an axis of spin (a tilted one ends where its tilt does), from rest to
/// its end or nu = 3.
TEST(Continue, EveryCaseIsFollowedFromEndToEnd) {
  for (const auto& entry : std::filesystem::directory_iterator(STATIONARY_CASES)) {
    const Case input = read_case(entry.path().string());
    if (has_rates(input.motion)) continue;
    const bool own = input.continuation.has_value();
    const Outcome outcome =
        continued(entry.path().string(), own ? std::vector<std::string>() : along_nu("0", "3"));
    ASSERT_EQ(outcome.code, 0) << entry.path() << outcome.err;
    EXPECT_THAT(outcome.err, IsEmpty()) << entry.path();
    const auto rows = rows_of(outcome.out);
    ASSERT_GE(rows.size(), 2U);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const bool at_end = k == 0 || k + 1 == rows.size();
      const std::string& event = rows[k].at("event");
      // Tilted sheets end where they are no longer tilted, those in no plane where they come to one,
      // ellipses on their circle, sheared ones where alpha has come to 0.
      const bool meets_another =
          (input.branch_name() == tilted_name && event == "tilt") ||
          (std::holds_alternative<SpatialRotation>(input.motion) && event == "shear") ||
          (input.solve.start && input.solve.start->alpha != 0.0 && event == "shear" &&
           rows[k].at("alpha") == "0") ||
          (event == "ellipse" && rows[k].at("xi") == rows[k].at("zeta") && at_end);
      EXPECT_EQ(is_end_name(event) || meets_another, at_end) << entry.path() << " row " << k;
      EXPECT_EQ(rows[k].at("branch"), input.branch_name());
      EXPECT_EQ(rows[k].at("sheet"), "1");
      EXPECT_EQ(rows[k].at("point"), std::to_string(k));
      EXPECT_LE(number(rows[k], "residual"), 1e-14) << entry.path() << " row " << k;
    }
    EXPECT_EQ(names_of_events(rows).find("unexplained"), std::string::npos) << entry.path();
  }
}

/// alpha != 0: xi and zeta stay of order one where mu vanishes, and grow to less than the bound where lambda has
/// passed it.
TEST(Continue, EndsAreToldByThePrincipalStretches) {
  const TemporaryDirectory directory;
  const auto last_row = [&](const std::string& text) {
    const std::string table = directory / "x.csv";
    const Outcome outcome =
        run_program({"continue", directory.file("case.toml", text), "-o", table});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const std::vector<Row> rows = rows_of(text_of(table));
    return rows.empty() ? Row() : rows.back();
  };
  const Row collapsed = last_row(R"(
[body]
J = [1.6887554198187398, 1.6887554198187398, 0.39551336257487735]
[potential]
plane = { model = "biot", mu = 1.066861928836281, lambda = 0.5376592289982426 }
thickness = { model = "harmonic", k = 2.783228126971786, rest = 0.6501720171305491 }
fibre = { k = 1.062417554432834, degrees = 34.09338152955395 }
[motion]
branch = "oblique"
axis = "1"
nu = 0.5902645172156106
[solve]
start = [-0.07102295145736529, 0.9547302116760132, 1.2832505192372745, 0.6840398258406629]
[continuation]
parameter = "body.J.1"
from = 1.0
to = 8.4437770990937
tolerance = 1e-6
)");
  EXPECT_EQ(collapsed.at("event"), "collapse");
  EXPECT_LT(number(collapsed.at("mu")), 1e-6);
  EXPECT_GT(number(collapsed.at("xi")), 0.1);
  EXPECT_GT(number(collapsed.at("zeta")), 0.1);
  const Row escaped = last_row(R"(
[body]
J = [0.3507057627197812, 2.019078390966385, 0.9846620337937597]
[potential]
coupled = { model = "neo-hookean-3d", mu = 1.6066784829389542, lambda = 1.5476772072114435 }
fibre = { k = 0.1964545671450376, degrees = 40.779368341947915 }
[motion]
branch = "iii"
nu = 0.5845913578161445
[solve]
start = [-0.013602526147513063, 0.9685723799891488, 1.2306873763127555, 0.9423958175979597]
[continuation]
from = 0.0
to = 1.7537740734484335
tolerance = 1e-6
)");
  EXPECT_EQ(escaped.at("event"), "escape");
  EXPECT_GT(number(escaped.at("lambda")), 1e6);
}

TEST(Continue, EndsAtTheLimitsAsked) {
  const auto rows = rows_of(continued(shipped("disc.toml"), along_nu("-0.625", "0.75")).out);
  EXPECT_EQ(rows.front().at("event"), "limit");
  EXPECT_EQ(rows.front().at("nu1"), "-0.625");
  EXPECT_EQ(rows.back().at("event"), "limit");
  EXPECT_EQ(rows.back().at("nu1"), "0.75");
  for (std::size_t k = 1; k < rows.size(); ++k)
    EXPECT_LT(number(rows[k - 1], "nu1"), number(rows[k], "nu1"));
}

/// cases/fold.toml
double greatest_spin_of_fold() {
  constexpr double mu = 1.1;
  constexpr double lambda = 0.8;
  return std::sqrt(2.0 * mu * (mu + lambda) / ((2.0 * mu + lambda) * std::numbers::e * 1.7));
}

/// Beside a turn of nu: a sheet that comes back to where it began, and a limit within 1e-12 of the turn.
TEST(Continue, EndsAtTheLimitBesideATurn) {
  struct Asked {
    const char* start;
    const char* from;
    const char* to;
    const char* step;
    const char* end;
  };
  for (const Asked& each : {Asked{"0.5491", "0.5491", "3", "0.1", "0.5491"},
                            Asked{"0.549105", "0.549105", "3", "0.1", "0.549105"},
                            Asked{"0.549", "0.549", "1", "0.5", "0.549"},
                            Asked{"0.3", "0", "0.5491055229307", "0.1", "0.5491055229307"},
                            Asked{"0.3", "0", "0.54910552293", "0.1", "0.54910552293"}}) {
    SCOPED_TRACE(each.start + std::string(" to ") + each.to);
    const auto text = [](const char* key, const char* value) {
      return std::string(key) + "=" + value;
    };
    const auto rows =
        rows_of(continued(shipped("fold.toml"),
                          {text("motion.nu", each.start), text("continuation.from", each.from),
                           text("continuation.to", each.to), text("continuation.step", each.step)})
                    .out);
    ASSERT_GT(rows.size(), 2U);
    EXPECT_EQ(rows.front().at("event"), "limit");
    EXPECT_EQ(rows.front().at("nu1"), each.from);
    EXPECT_EQ(rows.back().at("event"), "limit");
    EXPECT_EQ(rows.back().at("nu1"), each.end);
    // ln(zeta)/zeta^2 is as nu^2, and 1/(2 e) at the fold.
    const double zeta = number(rows.back(), "zeta");
    const double share = number(rows.back(), "nu1") / greatest_spin_of_fold();
    EXPECT_NEAR(std::log(zeta) / (zeta * zeta), share * share / (2.0 * std::numbers::e), 1e-15);
  }
}

/// The fold by its closed form (cases/fold.toml), and nu at rest on either side of it.
TEST(Continue, AFoldStandsWhereTheSpinIsGreatest) {
  const auto rows = rows_of(continued(shipped("fold.toml"), along_nu("0", "3")).out);
  EXPECT_EQ(names_of_events(rows), "limit fold-nu tilt escape");
  const std::size_t fold = index_of(rows, "fold-nu");
  EXPECT_NEAR(number(rows[fold], "nu1"), greatest_spin_of_fold(), 1e-15);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const double step = number(rows[k], "nu1") - number(rows[k - 1], "nu1");
    EXPECT_GE(k <= fold ? step : -step, 0.0) << k;
    EXPECT_LT(number(rows[k - 1], "zeta"), number(rows[k], "zeta")) << k;
  }
  EXPECT_GT(number(rows.back(), "zeta"), 9e5);
}

/// I1 = I3 at a tilt of (i): the class changes there and nowhere else.
TEST(Continue, ATiltStandsWhereTwoInertiasAreEqual) {
  const auto rows = rows_of(continued(shipped("neo_hookean.toml"), along_nu("0", "0.766")).out);
  EXPECT_EQ(names_of_events(rows), "limit tilt limit");
  const std::size_t tilt = index_of(rows, "tilt");
  const double xi = number(rows[tilt], "xi");
  const double rho = number(rows[tilt], "rho");
  EXPECT_NEAR(xi * xi, 0.6 * rho * rho, 1e-13);
  for (std::size_t k = 1; k < rows.size(); ++k)
    EXPECT_EQ(rows[k].at("class"), k < tilt ? "unstable" : k > tilt ? "stable" : "marginal") << k;
}

TEST(Continue, OverridesOfTheContinuation) {
  const auto with = [](const std::string& override) {
    auto all = along_nu("0", "1.05");
    all.push_back(override);
    return rows_of(continued(shipped("disc.toml"), all).out);
  };
  EXPECT_LT(3 * with("continuation.tolerance=1e-6").size(),
            with("continuation.tolerance=1e-10").size());
  EXPECT_EQ(with("continuation.tolerance=1e-20"), with("continuation.tolerance=1e-13"));
  const auto rows = with("continuation.step=0.001");
  // The step is an arc of ln S and of nu over its range.
  EXPECT_NEAR(number(rows[1], "nu1"), 0.001 * 1.05, 1e-6);
  EXPECT_EQ(continued(shipped("disc.toml"), {"continuation.parameter=motion.nu"}).out,
            continued(shipped("disc.toml")).out);
}

TEST(Continue, MaxPointsEndsTheTableOpen) {
  const TemporaryDirectory directory;
  for (const auto& [most, from] : {std::pair{2, "0"}, {17, "0"}, {2, "-1"}, {17, "-1"}}) {
    const Outcome outcome = continued(shipped("disc.toml"),
                                      {"continuation.max_points=" + std::to_string(most),
                                       std::string("continuation.from=") + from},
                                      directory / "x.csv");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("continuation.max_points; --resume goes on"));
    const auto rows = rows_of(text_of(directory / "x.csv"));
    EXPECT_EQ(rows.size(), static_cast<std::size_t>(most)) << from;
    EXPECT_EQ(rows.back().at("event"), "");
    const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
    EXPECT_EQ(metadata["status"], "stopped at max_points");
    EXPECT_THAT(metadata["last_end"].get<std::string>(),
                HasSubstr("continuation.max_points is reached"));
  }
  const Outcome piped = continued(shipped("disc.toml"), {"continuation.max_points=17"});
  EXPECT_THAT(piped.err, HasSubstr("continuation.max_points"));
  EXPECT_THAT(piped.err, Not(HasSubstr("--resume"))) << "no file stays";
}

// Other parameters: the spin is held.

class ContinueIn : public ::testing::TestWithParam<std::tuple<const char*, const char*>> {
 protected:
  std::string case_file() const { return shipped(std::get<0>(GetParam())); }
  std::string parameter() const { return std::get<1>(GetParam()); }
};

/// "potential.plane.c" of the case's tree.
double own_value(const Case& input, const std::string& key) {
  if (key.starts_with("body")) {
    const double J[] = {input.body.J1, input.body.J2, input.body.J3};
    return J[key.back() - '0'];
  }
  for (const ModelChoice& model : input.models)
    for (std::size_t k = 0; k < model.coefficients.size(); ++k)
      if (key == "potential." + model.slot + "." + model.description.parameters[k])
        return model.coefficients[k];
  ADD_FAILURE() << key;
  return 0.0;
}

TEST_P(ContinueIn, RowsAreWhatSolveFinds) {
  const Case input = read_case(case_file());
  const double own = own_value(input, parameter());
  const Outcome outcome = continued(
      case_file(),
      {"continuation.parameter=" + parameter(), "continuation.from=" + std::to_string(0.9 * own),
       "continuation.to=" + std::to_string(1.1 * own), "continuation.tolerance=1e-5"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(header_of(outcome.out).ends_with("krein5,segment,criticality,side," + parameter()));
  const auto rows = rows_of(outcome.out);
  ASSERT_GE(rows.size(), 3U);
  EXPECT_EQ(rows.front().at("event"), "limit");
  EXPECT_EQ(rows.back().at("event"), "limit");
  for (std::size_t k = 0; k < rows.size(); k += 1 + rows.size() / 4) {
    const Row& row = rows[k];
    const Outcome solved = run_program(
        {"solve", case_file(), "-o", "-", "--set", parameter() + "=" + row.at(parameter())});
    ASSERT_EQ(solved.code, 0) << solved.err;
    const Row cold = only_row(solved.out);
    const double bounds = number(row, "error_bound") + number(cold, "error_bound");
    for (const char* column : {"xi", "zeta", "rho"})
      EXPECT_NEAR(number(row, column), number(cold, column), 1.01 * bounds * number(cold, column));
    for (const char* column : {"branch", "nu1", "nu2", "nu3", "alpha", "compatibility", "class",
                               "negative", "krein1", "krein5"})
      EXPECT_EQ(row.at(column), cold.at(column)) << column;
    for (const char* column : {"energy", "pi1", "pi2", "pi3", "im4", "growth"}) {
      EXPECT_NEAR(number(row, column), number(cold, column),
                  1e-13 * (1.0 + std::abs(number(cold, column))))
          << column;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ContinueIn,
    ::testing::Values(std::tuple{"disc.toml", "body.J.0"}, std::tuple{"disc.toml", "body.J.1"},
                      std::tuple{"disc.toml", "body.J.2"},
                      std::tuple{"disc.toml", "potential.plane.c"},
                      std::tuple{"neo_hookean.toml", "potential.plane.lambda"},
                      std::tuple{"second_axis.toml", "potential.plane.mu"},
                      std::tuple{"second_axis.toml", "potential.thickness.b"},
                      std::tuple{"third_axis.toml", "potential.thickness.rest"},
                      std::tuple{"third_axis.toml", "potential.thickness.k"},
                      std::tuple{"third_axis.toml", "body.J.2"},
                      std::tuple{"thick.toml", "potential.thickness.rest"},
                      std::tuple{"coupled.toml", "potential.coupled.lambda"},
                      std::tuple{"coupled.toml", "body.J.0"}),
    [](const auto& info) {
      std::string text = std::string(std::get<0>(info.param)) + "_" + std::get<1>(info.param);
      for (char& c : text)
        if (c == '.') c = '_';
      return text;
    });

// What stands beside the table.

TEST(Continue, MetadataTellTheEventsOfTheTable) {
  const TemporaryDirectory directory;
  for (const char* file : {"fold.toml", "circle.toml", "apart.toml", "disc.toml"}) {
    const Outcome outcome = continued(shipped(file), along_nu("0", "3"), directory / "x.csv");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("one end"));  // the summary, beside the table too
    EXPECT_THAT(directory.names(), ElementsAre("x.csv", "x.meta.json"));
    const auto rows = rows_of(text_of(directory / "x.csv"));
    const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
    EXPECT_EQ(metadata["command"], "continue");
    EXPECT_EQ(metadata["status"], "done");
    EXPECT_EQ(metadata["rows"], rows.size());
    EXPECT_EQ(metadata["case"]["continuation"]["to"], 3.0);
    EXPECT_EQ(metadata["overrides"]["continuation.to"], "--set continuation.to=3");
    EXPECT_THAT(metadata["first_end"].get<std::string>(),
                StartsWith(rows.front().at("event") + " at nu = "));
    EXPECT_THAT(metadata["last_end"].get<std::string>(),
                StartsWith(rows.back().at("event") + " at nu = "));
    const auto& counts = metadata["counts"];
    EXPECT_EQ(counts["spectra"], counts["points_evaluated"]);
    EXPECT_GE(counts["points_evaluated"], rows.size() - 1);
    EXPECT_GE(counts["continuation_jacobians"], counts["continuation_steps"]);

    std::vector<Row> events;
    for (const Row& row : rows)
      if (!row.at("event").empty() && !is_end_name(row.at("event"))) events.push_back(row);
    ASSERT_EQ(metadata.contains("events") ? metadata["events"].size() : 0, events.size()) << file;
    const std::string nu =
        "nu" + std::to_string(1 + axis(read_case(shipped(file)).problem().branch()));
    for (std::size_t k = 0; k < events.size(); ++k) {
      const auto& event = metadata["events"][k];
      EXPECT_EQ(event["event"], events[k].at("event"));
      const double at = event["parameter"];
      EXPECT_EQ(at, number(events[k], nu));
      EXPECT_EQ(event["status"], "located");
      // A turn of nu is passed on one side of it.
      for (const double end : event["bracket"]) EXPECT_NEAR(end, at, 1e-13 * at) << event;
    }
  }
}

TEST(Continue, SummaryForAPerson) {
  const Outcome outcome = run_program(continue_command(shipped("fold.toml"), along_nu("0", "3")));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  for (const char* words :
       {"branch (i) in nu, from 0 to 3", "walk from the rest state", "limit at nu = 0",
        "escape at nu = ", "fold-nu           nu = 0.54910552293", "tilt", "unstable", "stable"})
    EXPECT_THAT(outcome.out, HasSubstr(words));
  auto quiet = continue_command(shipped("fold.toml"), along_nu("0", "3"));
  quiet.emplace_back("--quiet");
  EXPECT_THAT(run_program(quiet).out, IsEmpty());
}

/// Only the events named are in the table, where they were; the spectrum comes with those that need
/// it; residuals and energy with their columns.
TEST(Continue, EventsAndColumnsAskedFor) {
  const std::string path = shipped("apart.toml");
  const Outcome all = continued(path, {});
  const Outcome some = continued(path, {"continuation.events=[\"tilt\",\"krein-pass\"]",
                                        "output.columns=[\"event\",\"nu3\",\"xi\"]"});
  ASSERT_EQ(some.code, 0) << some.err;
  std::vector<std::pair<std::string, std::string>> expected;
  for (auto& row : rows_of(all.out))
    if (row["event"] == "tilt" || row["event"] == "krein-pass")
      expected.emplace_back(row["event"], row["nu3"]);
  ASSERT_EQ(expected.size(), 2U);
  std::vector<std::pair<std::string, std::string>> found;
  for (auto& row : rows_of(some.out))
    if (row["event"] == "tilt" || row["event"] == "krein-pass" || row["event"] == "fold-momentum")
      found.emplace_back(row["event"], row["nu3"]);
  EXPECT_EQ(found, expected);

  const TemporaryDirectory directory;
  const Outcome bare = run_program({"continue", path, "-o", directory / "x.csv", "--set",
                                    "output.columns=[\"event\",\"nu3\",\"xi\"]"});
  ASSERT_EQ(bare.code, 0) << bare.err;
  const auto counts = nlohmann::json::parse(text_of(directory / "x.meta.json"))["counts"];
  for (const char* skipped : {"spectra", "potentials", "second_derivatives", "certificates"})
    EXPECT_EQ(counts[skipped], 0) << skipped;
  EXPECT_GT(counts["continuation_extended_residuals"], counts["continuation_steps"]);

  const Outcome wrong = continued(path, {"continuation.events=[\"tilts\"]"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("\"tilt\"?"));
}

// What is refused.

struct Refused {
  const char* file;
  std::vector<std::string> overrides;
  const char* message;
};

TEST(Continue, WrongInputIsTwoAndNamesThePlace) {
  const std::vector<Refused> all{
      {"disc.toml", {"continuation.step=0.6"}, "--set continuation.step=0.6: continuation.step: "},
      {"disc.toml", {"continuation.step=0"}, "continuation.step: found 0"},
      {"disc.toml", {"continuation.from=2"}, "disc.toml:25:6: continuation.to: found the empty"},
      {"disc.toml", {"continuation.to=0"}, "continuation.to: found the empty range from 0 to 0"},
      {"disc.toml", {"continuation.tolerance=0"}, "continuation.tolerance: found 0"},
      {"disc.toml", {"continuation.tolerance=2"}, "continuation.tolerance: found 2"},
      {"disc.toml", {"continuation.tolerance=nan"}, "continuation.tolerance: found"},
      {"disc.toml", {"continuation.to=inf"}, "continuation.to: found"},
      {"disc.toml", {"continuation.max_points=1"}, "continuation.max_points: found 1"},
      {"disc.toml", {"continuation.max_points=9.5"}, "continuation.max_points: found 9.5"},
      {"disc.toml", {"continuation.parameter=potential.plane.z"}, "\"potential.plane.c\"?"},
      {"disc.toml", {"continuation.parameter=body.J.3"}, "continuation.parameter: found"},
      {"disc.toml", {"continuation.parameter=motion.omega"}, "continuation.parameter: found"},
      {"disc.toml",
       {"continuation.parameter=body.J.0"},
       "disc.toml:24:8: continuation.from: found body.J.0 = 0; expected J1 > 0"},
      {"disc.toml",
       {"continuation.parameter=potential.plane.k", "continuation.from=-1"},
       "continuation.from: found potential.plane.k = -1"},
      {"neo_hookean.toml",
       {"continuation.parameter=potential.plane.lambda", "continuation.from=-5"},
       "continuation.from: found potential.plane.lambda = -5"},
      {"disc.toml",
       {"solve.start=[0,1,1,0.7]", "continuation.from=0.6"},
       "disc.toml:20:6: motion.nu: found nu = 0.5, outside the range"},
      {"two_polar.toml", {"continuation.parameter=nu"}, "continuation.parameter: found"},
      {"two_polar.toml", {"continuation.parameter=body.J.0"}, "continuation.parameter: found"},
      {"too_fast.toml", {}, "too_fast.toml:1:1: continuation: found no such key"},
      {"two_polar.toml",
       {"continuation={from=0.0,to=1.0}"},
       "continuation.parameter: found no such key; expected one of \"motion.omega\""},
  };
  for (const Refused& each : all) {
    const Outcome outcome = continued(shipped(each.file), each.overrides);
    EXPECT_EQ(outcome.code, 2) << each.message;
    EXPECT_THAT(outcome.err, HasSubstr(each.message));
    EXPECT_THAT(outcome.out, IsEmpty());
  }
}

TEST(Continue, TheParameterIsNuUnlessAnotherIsNamed) {
  const Outcome named = continued(shipped("disc.toml"), {"continuation.to=1"});
  EXPECT_EQ(continued(shipped("disc.toml"), {"continuation={from=0.0,to=1.0,tolerance=1e-10}"}).out,
            named.out);
}

TEST(Continue, NoneAtTheStartIsThreeAndLeavesTheOldTable) {
  const TemporaryDirectory directory;
  const std::string target = directory.file("x.csv", "old\n");
  const Outcome outcome = continued(shipped("too_fast.toml"), along_nu("2.4", "3"), target);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err,
              HasSubstr("at the start nu = 2.5: no stationary ellipsoid exists: V_rho'"));
  EXPECT_EQ(text_of(target), "old\n");
  EXPECT_THAT(directory.names(), ElementsAre("x.csv"));
}

/// As nu -> 0 the disc flattens without end: |pi| = 0.5657 + 1.2 nu along it, which turns nowhere, and
/// the share of nu in the tangent is rounding.
TEST(Continue, NoFoldOfTheMomentumByAnAsymptote) {
  const TemporaryDirectory directory;
  for (
      const char* plane :
      {R"({ model = "saint-venant-kirchhoff", mu = 1.0, lambda = 0.5 })",
       R"({ model = "saint-venant-kirchhoff", mu = 1.0, lambda = 3.0 })",
       R"({ model = "orthotropic-saint-venant-kirchhoff", c11 = 0.79, c22 = 2.55, c12 = 1.16, c66 = 0.3 })"}) {
    const std::string flat =
        directory.file("flat.toml", std::string("[body]\nJ = [1.0, 1.0, 0.5]\nvolume = 0.8\n"
                                                "[potential]\nplane = ") +
                                        plane +
                                        "\n[motion]\nbranch = \"i\"\nnu = 0.3\n[continuation]\n"
                                        "from = 0.0\nto = 3.0\n");
    for (const char* tolerance : {"1e-4", "1e-5", "1e-7"}) {
      const Outcome outcome = continued(flat, {std::string("continuation.tolerance=") + tolerance});
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      int beside = 0;
      for (const Row& row : rows_of(outcome.out)) {
        if (std::abs(number(row.at("nu1"))) > 1e-5) continue;
        ++beside;
        EXPECT_NE(row.at("event"), "fold-momentum") << plane << row.at("nu1");
      }
      EXPECT_GT(beside, 10) << plane;
    }
  }
}

TEST(Continue, AnOldTableIsReplacedOnlyByAWholeOne) {
  const TemporaryDirectory directory;
  const std::string target = directory.file("x.csv", "old\n");
  EXPECT_EQ(continued(shipped("disc.toml"), {"continuation.step=9"}, target).code, 2);
  EXPECT_EQ(text_of(target), "old\n");
  EXPECT_EQ(continued(shipped("disc.toml"), {}, target).code, 0);
  EXPECT_EQ(text_of(target), continued(shipped("disc.toml")).out);
  EXPECT_EQ(continued(shipped("disc.toml"), {}, directory / "no/x.csv").code, 2);
  EXPECT_THAT(directory.names(), ElementsAre("x.csv", "x.meta.json"));
}

TEST(Continue, AFullDiskIsAFailure) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const Outcome outcome = continued(shipped("disc.toml"), {}, "/dev/full");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("No space left"));
  auto streamed = continue_command(shipped("disc.toml"), {});
  streamed.insert(streamed.end(), {"-o", "-"});
  EXPECT_EQ(run_program(streamed, {.standard_output = "/dev/full"}).code, 4);
}

/// mu turns a thousand times here, near one value: the row of a turn is between its neighbours, and not
/// another turn's.
TEST(Continue, AmongManyTurnsEachHasItsOwnRow) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("case.toml", R"case(
[body]
J = [2.3522, 0.27121, 0.15753]
[potential]
plane = { expression = "mu*(t-2)^2+k*(d-1)^2+c*cos(t)", mu = 1.3222, k = 2.8604, c = 0.33514 }
thickness = { model = "harmonic", k = 8.436, rest = 1.3676 }
[motion]
branch = "iii"
nu = 0.93309
[continuation]
parameter = "potential.plane.mu"
from = 1.0245
to = 3.9666
tolerance = 1e-05
)case");
  const Outcome outcome = continued(file, {"output.spectrum=false"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = rows_of(outcome.out);
  int turns = 0;
  for (std::size_t k = 1; k + 1 < rows.size(); ++k) {
    if (rows[k].at("event") != "fold-parameter") continue;
    const auto xi = [&](std::size_t row) { return number(rows[row].at("xi")); };
    EXPECT_GT((xi(k) - xi(k - 1)) * (xi(k + 1) - xi(k)), 0.0) << "row " << k;
    ++turns;
  }
  EXPECT_GE(turns, 1000);
}

/// The stream is written to, and no file in its place or beside its name.
TEST(Continue, ToTheNameOfAStream) {
  const TemporaryDirectory directory;
  const std::string target = directory / "x";
  const Outcome outcome = run_program({"continue", shipped("disc.toml"), "-q", "-o", "/dev/stdout"},
                                      {.standard_output = target});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(text_of(target), continued(shipped("disc.toml")).out);
  EXPECT_THAT(directory.names(), ElementsAre("x"));
  EXPECT_FALSE(std::filesystem::exists("/dev/stdout.meta.json"));
}

}  // namespace
}  // namespace stationary::testing
