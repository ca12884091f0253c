// `curve` from outside: a table of closed forms, special points, rows to start from, what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "solver/program/table/column_file.hpp"
#include "tests/program/json_schema.hpp"
#include "tests/program/needs_gnuplot.hpp"
#include "tests/program/needs_hdf5.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const char* const fold_of_hencky = R"(
[body]
J = [1.0, 1.7, 0.6]
[potential]
plane     = { model = "hencky", mu = 1.1, lambda = 0.8 }
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }
[motion]
branch = "i"
nu = 0.3
[curve]
event = "fold-nu"
parameters = ["nu", "body.J.1"]
from = [0.0, 0.5]
to = [1.2, 3.0]
tolerance = 1e-6
)";

class Curve : public ::testing::Test {
 protected:
  Outcome run(const std::string& text, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"curve", directory_.file("case.toml", text), "-o", out_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  std::vector<Row> rows() const { return rows_of(text_of(out_)); }
  json metadata() const { return json::parse(text_of(directory_ / "x.meta.json")); }

  TemporaryDirectory directory_;
  std::string out_ = directory_ / "x.csv";
};

/// nu^2 J2 = 2 mu (mu + lambda)/[(2 mu + lambda) e], zeta = sqrt e.
TEST_F(Curve, FoldOfHencky) {
  const Outcome outcome = run(fold_of_hencky, {"--certify"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("fold-nu in branch (i), in nu and body.J.1"));
  EXPECT_THAT(
      std::string(header_of(text_of(out_))),
      StartsWith("event,curve,point,special,branch,nu,body.J.1,nu1,nu2,nu3,alpha,xi,zeta,"));
  const double product = 2.0 * 1.1 * 1.9 / (3.0 * std::exp(1.0));
  const std::vector<Row> found = rows();
  ASSERT_GE(found.size(), 10U);
  for (const Row& row : found) {
    const double nu = number(row.at("nu"));
    EXPECT_EQ(row.at("event"), "fold-nu");
    EXPECT_EQ(row.at("nu"), row.at("nu1"));
    EXPECT_NEAR(nu * nu * number(row.at("body.J.1")), product, 1e-13);
    EXPECT_NEAR(number(row.at("zeta")), std::exp(0.5), 1e-13);
    if (row.at("special").empty()) {
      EXPECT_NE(row.at("class_before"), "");
    }
    EXPECT_EQ(row.at("certified"), "yes");
  }
  EXPECT_EQ(found.front().at("body.J.1"), "0.5");
  EXPECT_EQ(found.back().at("body.J.1"), "3");
  const json said = metadata();
  EXPECT_EQ(schema_fault(said, json::parse(text_of(STATIONARY_SCHEMA))), "");
  EXPECT_EQ(said.at("command"), "curve");
  EXPECT_EQ(said.at("case").at("curve").at("event"), "fold-nu");
  ASSERT_EQ(said.at("curves").size(), 1U);
  EXPECT_EQ(said.at("curves")[0].at("points"), found.size());
  EXPECT_EQ(said.at("curves")[0].at("first_end").at("event"), "limit");
}

/// The circle's event stands in one nu; what is added to V is of fourth order across the circle,
/// a = -16 mu - 48 mu^2/lambda + 384 r^4 e.
TEST_F(Curve, DegeneratePitchfork) {
  const Outcome outcome = run(R"(
[body]
J = [1.0, 1.0, 0.5]
[potential.plane]
expression = "m*(log(lambda)^2 + log(mu_)^2) + l/2*log(d)^2 + e*(t^2 - 4*d)^2"
m = 1.0
l = 3.0
e = 0.01
[potential.thickness]
model = "reciprocal-quadratic"
a = 1.0
b = 3.0
[motion]
branch = "iii"
nu = 0.5
[curve]
event = "ellipse"
parameters = ["nu", "potential.plane.e"]
from = [0.1, 0.0]
to = [1.5, 0.2]
tolerance = 1e-6
)");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const double expected = 32.0 / (384.0 * std::exp(0.5));
  int special = 0;
  for (const Row& row : rows()) {
    EXPECT_NEAR(number(row.at("nu")), std::exp(-0.125), 1e-13);
    if (row.at("special").empty()) continue;
    EXPECT_EQ(row.at("special"), "degenerate-pitchfork");
    EXPECT_NEAR(number(row.at("potential.plane.e")), expected, 1e-10);
    ++special;
  }
  EXPECT_EQ(special, 1);
}

/// The circle's two folds meet and vanish: below the cusp continue finds both, above none.
TEST_F(Curve, CuspOfTheCircle) {
  const std::string circle = STATIONARY_CASES "/circle.toml";
  const Outcome outcome = run_program(
      {"curve", circle, "-o", out_, "--set", "curve.event=fold-nu", "--set",
       "curve.parameters=[\"nu\", \"potential.plane.mu\"]", "--set", "curve.from=[0.0, 0.5]",
       "--set", "curve.to=[2.5, 3.0]", "--set", "curve.tolerance=1e-6", "--certify"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::vector<double> cusps;
  int unproven = 0;
  for (const Row& row : rows()) {
    const bool cusp = row.at("special") == "cusp";
    if (cusp) cusps.push_back(number(row.at("potential.plane.mu")));
    // Two folds are one there.
    EXPECT_EQ(row.at("certified"), cusp ? "no" : "yes");
    unproven += cusp;
  }
  ASSERT_EQ(cusps.size(), 1U);
  const std::string said = "1 of " + std::to_string(rows().size()) + " events are not proven";
  ASSERT_EQ(unproven, 1);
  EXPECT_THAT(outcome.err, HasSubstr(said));
  EXPECT_THAT(metadata().at("warning").get<std::string>(), HasSubstr(said));
  for (const double side : {-1e-3, 1e-3}) {
    const std::string table = directory_ / "side.csv";
    ASSERT_EQ(run_program({"continue", circle, "-o", table, "-q", "--set",
                           "potential.plane.mu=" + std::to_string(cusps[0] + side)})
                  .code,
              0);
    const auto found = rows_of(text_of(table));
    EXPECT_EQ(std::ranges::count(found, "fold-nu", [](const Row& row) { return row.at("event"); }),
              side < 0.0 ? 2 : 0)
        << side;
  }
}

/// What is known at points only is taken for granted by proofs of events as by those of motions.
TEST_F(Curve, ProofsSayWhatTheyTakeForGranted) {
  const std::string text = R"(
[body]
J = [1.0, 0.8, 0.5]
[potential.coupled]
expression = "mu/2*(xi^2 + 2*alpha^2 + zeta^2 - 2*ln(d)) + k/2*ln(d)^2 + b/2*(rho - 1)^2 + ADDED"
mu = 1.0
k = 0.5
b = 1.0
[motion]
branch = "i"
nu = 0.1
[curve]
event = "tilt"
parameters = ["nu", "body.J.1"]
from = [0.0, 0.7]
to = [0.9, 0.9]
)";
  for (const auto& [added, word] :
       {std::pair{"sin(2*alpha) - 2*sin(alpha)*cos(alpha)", "assuming"}, {"0*alpha", "yes"}}) {
    SCOPED_TRACE(added);
    std::string own = text;
    own.replace(own.find("ADDED"), 5, added);
    const Outcome outcome = run(own, {"--certify"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    ASSERT_GE(rows().size(), 3U);
    for (const Row& row : rows()) EXPECT_EQ(row.at("certified"), word);
    const json said = metadata();
    EXPECT_EQ(schema_fault(said, json::parse(text_of(STATIONARY_SCHEMA))), "");
    const bool assuming = std::string(word) == "assuming";
    EXPECT_EQ(said.contains("assumed"), assuming);
    EXPECT_EQ(outcome.out.find("take for granted") != std::string::npos, assuming);
    EXPECT_EQ(std::ranges::count(said.at("plan"), "proofs",
                                 [](const json& item) { return item.at("quantity"); }),
              assuming);
  }
}

TEST_F(Curve, CheckSaysWhichCurve) {
  const Outcome outcome = run_program({"check", shipped("elastic_sphere.toml")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("curve         hamiltonian-hopf in nu from 0.1 to 0.9 and "));
}

TEST_F(Curve, FromARowIsThatCurve) {
  const std::string file = directory_.file(
      "family.toml", std::string(fold_of_hencky) + "[continuation]\nfrom = 0.0\nto = 1.0\n");
  const std::string table = directory_ / "family.csv";
  ASSERT_EQ(run_program({"continue", file, "-o", table, "-q"}).code, 0);
  ASSERT_EQ(run(fold_of_hencky).code, 0);
  const std::vector<Row> all = rows();
  const Outcome outcome = run(fold_of_hencky, {"--from", table + ":fold-nu"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<Row> one = rows();
  ASSERT_GE(one.size(), 10U);
  EXPECT_EQ(one.front().at("body.J.1"), all.front().at("body.J.1"));
  EXPECT_NEAR(number(one.front().at("nu")), number(all.front().at("nu")), 1e-14);
  const Outcome wrong = run(fold_of_hencky, {"--from", table + ":1"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("fold-nu"));
}

/// Of either parameter, of the row's own and of the case's.
TEST_F(Curve, ARowOutsideTheRangeIsRefused) {
  const std::string file = directory_.file(
      "family.toml", std::string(fold_of_hencky) + "[continuation]\nfrom = 0.0\nto = 1.0\n");
  const std::string table = directory_ / "family.csv";
  ASSERT_EQ(run_program({"continue", file, "-o", table, "-q"}).code, 0);
  for (const auto& [sets, said] :
       {std::pair{"curve.to=[0.4, 3.0]", "found a row at nu = 0.549"},
        {"curve.from=[0.9, 0.5]", "a row in the range followed, [0.9, 1.2]"},
        {"curve.from=[0.0, 2.0]", "found a row at body.J.1 = 1.7"}}) {
    const Outcome outcome = run(fold_of_hencky, {"--from", table + ":fold-nu", "--set", sets});
    EXPECT_EQ(outcome.code, 2) << sets;
    EXPECT_THAT(outcome.err, HasSubstr(said)) << sets;
    EXPECT_EQ(outcome.out, "") << sets;
  }
  // The row's own numbers stand for the case's: those alone must be in the range.
  const std::string in_inertia = directory_ / "inertia.csv";
  ASSERT_EQ(
      run_program({"curve", directory_.file("case.toml", fold_of_hencky), "-o", in_inertia, "-q"})
          .code,
      0);
  const std::size_t rows = rows_of(text_of(in_inertia)).size();
  const Outcome last = run(fold_of_hencky, {"--from", in_inertia + ":" + std::to_string(rows),
                                            "--set", "curve.from=[0.0, 2.0]"});
  EXPECT_EQ(last.code, 0) << last.err;
}

TEST_F(Curve, ColumnFileHasTheSameColumns) {
  NEEDS_HDF5();
  const std::string file = directory_.file("case.toml", fold_of_hencky);
  const std::string columnar = directory_ / "x.h5";
  ASSERT_EQ(run_program({"curve", file, "-o", columnar, "-q"}).code, 0);
  ASSERT_EQ(run_program({"curve", file, "-o", out_, "-q"}).code, 0);
  auto stream = column_file_table(columnar, {});
  const std::string read{std::istreambuf_iterator<char>(*stream), {}};
  EXPECT_EQ(read, text_of(out_));
}

/// Over a map in the same parameters, whichever of them is x; alone; in others not at all.
TEST_F(Curve, DrawnOverAMap) {
  NEEDS_GNUPLOT();
  ASSERT_EQ(run(fold_of_hencky).code, 0);
  const auto map_of = [&](const std::string& x, const std::string& y) {
    const std::string file = directory_.file(
        "map.toml", std::string(fold_of_hencky) + "[map]\nx = { parameter = \"" + x +
                        "\", from = 0.1, to = 1.0, count = 6 }\ny = { parameter = \"" + y +
                        "\", from = 0.5, to = 3.0, count = 5 }\n");
    const std::string table = directory_ / "map.csv";
    EXPECT_EQ(run_program({"map", file, "-o", table, "-q"}).code, 0);
    return table;
  };
  const std::string nu_and_J = map_of("nu", "body.J.1");
  const Outcome over = run_program({"plot", nu_and_J, out_, "--script", "-"});
  ASSERT_EQ(over.code, 0) << over.err;
  EXPECT_THAT(over.out, HasSubstr("$codes matrix"));
  EXPECT_THAT(over.out, HasSubstr("$lines index 0 using 1:2 with lines"));
  EXPECT_THAT(over.out, HasSubstr("title 'fold-nu'"));
  EXPECT_THAT(over.out, HasSubstr("title 'double'"));
  const Outcome image = run_program({"plot", nu_and_J, out_, "-o", directory_ / "map.svg"});
  EXPECT_EQ(image.code, 0) << image.err;
  EXPECT_THAT(image.out, HasSubstr("6 by 5 cells, class, 1 curve"));
  const Outcome alone = run_program({"plot", out_, "-o", directory_ / "curve.svg"});
  EXPECT_EQ(alone.code, 0) << alone.err;
  EXPECT_THAT(alone.out, HasSubstr("1 curve"));
  const Outcome other = run_program({"plot", map_of("nu", "body.J.2"), out_, "--script", "-"});
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("body.J.1"));
}

/// A curve in nu and a fibre's stiffness: its ends, as continue finds them there.
void expect_ends_as_continued(const std::vector<Row>& curve, const std::string& with_fibre,
                              const std::string& event, const TemporaryDirectory& directory) {
  ASSERT_GE(curve.size(), 3U);
  for (const Row& row : {curve.front(), curve.back()}) {
    const std::string own = directory / "own.csv";
    const Outcome continued =
        run_program({"continue", directory.file("own.toml", with_fibre), "-o", own, "--set",
                     "potential.fibre.k=" + row.at("potential.fibre.k")});
    ASSERT_EQ(continued.code, 0) << continued.err;
    int found = 0;
    for (const Row& each : rows_of(text_of(own))) {
      if (each.at("event") != event) continue;
      EXPECT_NEAR(number(each.at("nu1")), number(row.at("nu")), 1e-12) << event;
      EXPECT_NEAR(number(each.at("xi")), number(row.at("xi")), 1e-11) << event;
      EXPECT_NEAR(number(each.at("zeta")), number(row.at("zeta")), 1e-11) << event;
      EXPECT_EQ(each.at("criticality").empty(), event != "oblique");
      ++found;
    }
    EXPECT_EQ(found, 1) << event;
  }
}

/// Where the axis of a body with a fibre leaves its own.
TEST_F(Curve, ObliqueOfABodyWithAFibre) {
  const std::string with_fibre = R"(
[body]
J = [1.0, 1.7, 0.6]
[potential]
plane     = { model = "neo-hookean", mu = 1.0, lambda = 2.0 }
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }
fibre     = { k = 0.4, degrees = 0.0 }
[motion]
branch = "i"
nu = 0.7
[continuation]
from = 0.6
to = 0.8
[curve]
event = "oblique"
parameters = ["nu", "potential.fibre.k"]
from = [0.5, 0.3]
to = [0.9, 0.5]
)";
  const Outcome outcome = run(with_fibre);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const std::vector<Row> curve = rows();
  expect_ends_as_continued(curve, with_fibre, "oblique", directory_);
  EXPECT_THAT(
      (std::vector{curve.front().at("potential.fibre.k"), curve.back().at("potential.fibre.k")}),
      ::testing::UnorderedElementsAre("0.3", "0.5"));
  const Outcome skew = run(with_fibre, {"--set", "potential.fibre.degrees=30"});
  EXPECT_EQ(skew.code, 2);
  EXPECT_THAT(skew.err, HasSubstr("even in alpha"));
  const Outcome refused = run(with_fibre, {"--set", "curve.event=ellipse"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("an anisotropic potential"));
  EXPECT_THAT(refused.err, HasSubstr("curve.event"));
  // Turned, the fibre leaves no motion with alpha = 0.
  const Outcome turned =
      run(with_fibre, {"--set", "curve.parameters=[\"nu\", \"potential.fibre.degrees\"]", "--set",
                       "curve.from=[0.5, -1.0]", "--set", "curve.to=[0.9, 1.0]"});
  EXPECT_EQ(turned.code, 2);
  EXPECT_THAT(turned.err, HasSubstr("curve.parameters.1"));
  EXPECT_THAT(turned.err, HasSubstr("even in alpha"));
}

/// Where its frequencies meet.
TEST_F(Curve, FrequenciesOfABodyWithAFibre) {
  const std::string with_fibre = R"(
[body]
J = [1.0, 1.7, 0.6]
[potential]
plane     = { model = "hencky", mu = 1.0, lambda = 0.6 }
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }
fibre     = { k = 0.5, degrees = 0.0 }
[motion]
branch = "i"
nu = 0.3
[continuation]
from = 0.01
to = 0.9
[curve]
event = "hamiltonian-hopf"
parameters = ["nu", "potential.fibre.k"]
from = [0.01, 0.2]
to = [0.9, 0.8]
)";
  for (const std::string event : {"hamiltonian-hopf", "real-collision"}) {
    const Outcome outcome = run(with_fibre, {"--set", "curve.event=" + event});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    expect_ends_as_continued(rows(), with_fibre, event, directory_);
  }
}

/// Of motions of other kinds, whose families have equations of their own for it: the ends of the curve,
/// as continue finds the event there.
TEST_F(Curve, OfOtherMotions) {
  struct Asked {
    const char* of;
    const char* event;
    const char* first;
    const char* second;
    std::array<double, 2> from;
    std::array<double, 2> to;
    const char* column;  ///< of continue's table: the first; empty: |nu|
  };
  for (const Asked& each :
       {Asked{"tilted", "tilt", "nu", "body.J.1", {1.0, 1.68}, {1.12, 1.72}, ""},
        {"oblique", "tilt", "nu", "potential.fibre.degrees", {0.3, 28.0}, {0.785, 32.0}, ""},
        {"fibre", "tilt", "nu", "potential.fibre.degrees", {0.3, 28.0}, {0.79, 32.0}, ""},
        {"two_polar",
         "ellipse",
         "motion.theta_dot",
         "potential.plane.mu",
         {-0.7, 0.88},
         {-0.3, 0.92},
         "theta_dot"},
        {"two_polar_momenta", "tilt", "motion.s3", "body.J.2", {0.3, 0.58}, {4.0, 0.62}, "s3"}}) {
    SCOPED_TRACE(each.of);
    const std::string file = std::string(STATIONARY_CASES "/") + each.of + ".toml";
    const auto pair = [](const std::array<double, 2>& at) {
      return "[" + std::to_string(at[0]) + ", " + std::to_string(at[1]) + "]";
    };
    const Outcome outcome = run_program(
        {"curve", file, "-o", out_, "--certify", "--set", std::string("curve.event=") + each.event,
         "--set", std::string("curve.parameters=[\"") + each.first + "\", \"" + each.second + "\"]",
         "--set", "curve.from=" + pair(each.from), "--set", "curve.to=" + pair(each.to)});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::vector<Row> curve = rows();
    ASSERT_GE(curve.size(), 2U);
    for (const Row* row : {&curve.front(), &curve.back()}) {
      EXPECT_EQ(row->at("certified"), "yes");
      const std::string own = directory_ / "own.csv";
      const Outcome continued =
          run_program({"continue", file, "-o", own, "-q", "--set",
                       std::string(each.second) + "=" + row->at(each.second), "--set",
                       "continuation.to=" + std::to_string(each.to[0])});
      ASSERT_EQ(continued.code, 0) << continued.err;
      double nearest = 1.0;
      for (const Row& found : rows_of(text_of(own))) {
        if (found.at("event") != each.event) continue;
        const double p = *each.column == '\0'
                             ? std::hypot(number(found.at("nu1")), number(found.at("nu2")),
                                          number(found.at("nu3")))
                             : number(found.at(each.column));
        nearest = std::min(nearest, std::abs(p - number(row->at(each.first))));
      }
      EXPECT_LE(nearest, 1e-12) << row->at(each.second);
    }
  }
  const Outcome refused =
      run_program({"curve", STATIONARY_CASES "/tilted.toml", "-o", out_, "--set",
                   "curve.event=krein-pass", "--set", "curve.parameters=[\"nu\", \"body.J.1\"]",
                   "--set", "curve.from=[1.0, 1.6]", "--set", "curve.to=[1.1, 1.8]"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("branch \"tilted\""));
  // At 0 degrees alpha is 0, and beside it is not.
  const Outcome leaves =
      run_program({"curve", STATIONARY_CASES "/fibre.toml", "-o", out_, "--set",
                   "potential.fibre.degrees=0.0", "--set", "curve.event=tilt", "--set",
                   "curve.parameters=[\"nu\", \"potential.fibre.degrees\"]", "--set",
                   "curve.from=[0.3, -5.0]", "--set", "curve.to=[0.79, 5.0]"});
  EXPECT_EQ(leaves.code, 4);
  EXPECT_THAT(leaves.err, HasSubstr("alpha = 0 there"));
  const Outcome in_inertia =
      run_program({"curve", STATIONARY_CASES "/tilted.toml", "-o", out_, "--set",
                   "curve.event=tilt", "--set", "curve.parameters=[\"body.J.1\", \"nu\"]", "--set",
                   "curve.from=[1.6, 1.0]", "--set", "curve.to=[1.8, 1.1]"});
  EXPECT_EQ(in_inertia.code, 2);
  EXPECT_THAT(in_inertia.err, HasSubstr("curve.parameters.0"));
}

/// A ratio's curve is that of the number it varies, in units of the other.
TEST_F(Curve, InARatioOfTwoNumbers) {
  ASSERT_EQ(run(fold_of_hencky, {"--set", "body.J=[2.0, 1.7, 0.6]"}).code, 0);
  const std::vector<Row> expected = rows();
  const std::vector<std::string> by_ratio{
      "--set",    "body.J=[2.0, 1.7, 0.6]",
      "--set",    "curve.parameters=[\"nu\", \"body.J.1/body.J.0\"]",
      "--set",    "curve.from=[0.0, 0.25]",
      "--set",    "curve.to=[1.2, 1.5]",
      "--certify"};
  const Outcome outcome = run(fold_of_hencky, by_ratio);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("in nu and body.J.1/body.J.0"));
  EXPECT_THAT(outcome.out, HasSubstr("body.J.1/body.J.0 = 0.25: "));
  const std::vector<Row> found = rows();
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(2.0 * number(found[k].at("body.J.1/body.J.0")), number(expected[k].at("body.J.1")));
    EXPECT_EQ(found[k].at("nu"), expected[k].at("nu"));
    EXPECT_EQ(found[k].at("zeta"), expected[k].at("zeta"));
    EXPECT_EQ(found[k].at("certified"), "yes");
  }
  EXPECT_EQ(schema_fault(metadata(), json::parse(text_of(STATIONARY_SCHEMA))), "");
  // The family may be one in a ratio too.
  const Outcome first =
      run(fold_of_hencky, {"--set", "body.J=[2.0, 1.7, 0.6]", "--set", "motion.nu=0.5", "--set",
                           "curve.parameters=[\"body.J.1/body.J.0\", \"nu\"]", "--set",
                           "curve.from=[0.25, 0.3]", "--set", "curve.to=[2.0, 0.9]"});
  ASSERT_EQ(first.code, 0) << first.err;
  const double product = 2.0 * 1.1 * 1.9 / (3.0 * std::exp(1.0));
  for (const Row& row : rows()) {
    const double nu = number(row.at("nu"));
    EXPECT_EQ(row.at("event"), "fold-parameter");
    EXPECT_NEAR(nu * nu * 2.0 * number(row.at("body.J.1/body.J.0")), product, 1e-13);
  }
  for (const char* pair :
       {"[\"body.J.1/body.J.0\", \"body.J.1\"]", "[\"body.J.0\", \"body.J.1/body.J.0\"]"}) {
    const Outcome refused = run(fold_of_hencky, {"--set", std::string("curve.parameters=") + pair});
    EXPECT_EQ(refused.code, 2) << pair;
    EXPECT_THAT(refused.err, HasSubstr("leaves the other as it is")) << pair;
  }
}

TEST_F(Curve, WhatIsRefused) {
  const auto with = [&](const std::vector<std::string>& sets) {
    std::vector<std::string> more;
    for (const std::string& each : sets) more.insert(more.end(), {"--set", each});
    return run(fold_of_hencky, more);
  };
  const struct {
    std::vector<std::string> sets;
    std::string said;
  } cases[] = {
      {{"curve.event=folds"}, "fold-nu"},
      {{"curve.parameters=[\"nu\"]"}, "two numbers of the case"},
      {{"curve.parameters=[\"nu\", \"nu\"]"}, "twice"},
      {{"curve.parameters=[\"nu\", \"body.J.7\"]"}, "body.J.1"},
      {{"curve.from=[0.0, 4.0]"}, "empty range"},
      {{"curve.from=[0.0, -1.0]"}, "J2 > 0"},
      {{"curve.tolerance=0"}, "> 0"},
      {{"curve.from=[0.0, 2.0]"}, "outside the range"},
  };
  for (const auto& each : cases) {
    const Outcome outcome = with(each.sets);
    EXPECT_EQ(outcome.code, 2) << each.sets.front();
    EXPECT_THAT(outcome.err, HasSubstr(each.said)) << each.sets.front();
  }
  const Outcome missing = run(R"(
[body]
J = [1.0, 1.7, 0.6]
[potential]
plane     = { model = "hencky", mu = 1.1, lambda = 0.8 }
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }
[motion]
branch = "i"
nu = 0.3
)");
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.err, HasSubstr("add [curve]"));
  const Outcome tilted = with({"motion.branch=tilted", "curve.event=krein-pass"});
  EXPECT_EQ(tilted.code, 2);
  EXPECT_THAT(tilted.err, HasSubstr("found \"krein-pass\" and branch \"tilted\""));
  EXPECT_THAT(tilted.err, HasSubstr("of spins about a material axis with alpha = 0 alone"));
  const Outcome spin = with({"curve.event=zero-momentum"});
  EXPECT_EQ(spin.code, 2);
  EXPECT_THAT(spin.err, HasSubstr("a spin about a material axis has no momentum at rest alone"));
  EXPECT_THAT(spin.err, HasSubstr("\"ellipse-13\""));
  EXPECT_EQ(spin.err.find("\"zero-momentum\""), spin.err.rfind("\"zero-momentum\""))
      << "found, and not among the allowed: " << spin.err;
}

/// A table that does not say what its rows are says of none that it is an event.
TEST_F(Curve, ARowOfATableWithoutEventsIsRefused) {
  const std::string table = directory_ / "solved.csv";
  ASSERT_EQ(
      run_program(
          {"solve", STATIONARY_CASES "/disc.toml", "-q", "-o", table, "--set",
           "output.columns=[\"branch\", \"nu1\", \"nu2\", \"nu3\", \"xi\", \"zeta\", \"rho\"]"})
          .code,
      0);
  const Outcome outcome = run(fold_of_hencky, {"--from", table + ":1"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("found no column event"));
}

TEST_F(Curve, NoSuchEventIsSaid) {
  const Outcome outcome = run(fold_of_hencky, {"--set", "curve.to=[0.2, 3.0]"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no fold-nu"));
}

/// One that turns and comes back to the case's own value, the lower end of the range, is one curve.
TEST_F(Curve, ThatEndsAtTheCasesOwnValueIsListedOnce) {
  for (const auto& [from, to] : {std::pair{"1.0", "3.0"}, {"0.9", "3.0"}}) {
    const Outcome outcome =
        run_program({"curve", STATIONARY_CASES "/circle.toml", "--set", "curve.event=fold-nu",
                     "--set", "curve.parameters=[\"nu\",\"potential.plane.mu\"]", "--set",
                     std::string("curve.from=[0.0,") + from + "]", "--set",
                     std::string("curve.to=[2.5,") + to + "]", "-o", out_});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_FALSE(rows().empty()) << from;
    for (const Row& row : rows()) EXPECT_EQ(row.at("curve"), "1") << from;
  }
}

/// A failure is no table: what stood there stays.
TEST_F(Curve, ThatFailsReplacesNothing) {
  std::ofstream(out_) << "kept\n";
  const Outcome outcome = run_program(
      {"curve", STATIONARY_CASES "/fibre_map.toml", "--set", "potential.fibre.degrees=0", "-o",
       out_, "--set",
       "curve={event=\"tilt\",parameters=[\"nu\",\"potential.fibre.degrees\"],from=[0.0,-30.0],to="
       "[1.5,30.0]}"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("no curve from"));
  EXPECT_EQ(text_of(out_), "kept\n");
}

}  // namespace
}  // namespace stationary::testing
