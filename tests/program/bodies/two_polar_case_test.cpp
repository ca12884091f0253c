// Branch "two-polar" from outside: rates, momenta, lines of solutions, the circle.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <set>

#include "solver/program/case/case_file.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

const std::string rates_case = STATIONARY_CASES "/two_polar.toml";
const std::string momenta_case = STATIONARY_CASES "/two_polar_momenta.toml";

/// The ellipses of momenta_case at prescribed rates.
constexpr const char* line_of_ellipses = R"([body]
J = [1.0, 1.0, 0.6]
[potential]
plane     = { model = "reciprocal-determinant", c = 0.96, k = 1.0 }
thickness = { model = "harmonic", k = 1.5, rest = 0.9 }
[motion]
branch = "two-polar"
omega = 0.8
theta_dot = -0.6
)";

std::map<std::string, std::string> two_polar_row(const std::vector<std::string>& arguments) {
  std::vector<std::string> all{"solve", "-o", "-"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const Outcome outcome = run_program(all);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return only_row(outcome.out);
}

TEST(TwoPolarCase, TableOfPrescribedRates) {
  const Outcome outcome = run_program({"solve", rates_case, "-o", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(header_of(outcome.out),
            "branch,sheet,point,nu1,nu2,nu3,alpha,xi,zeta,rho,lambda,mu,angle,pi1,pi2,pi3,energy,"
            "residual,compatibility,error_bound,class,growth,negative,re1,im1,krein1,re2,im2,"
            "krein2,re3,im3,krein3,re4,im4,krein4,re5,im5,krein5,omega,theta_dot,s3,p_theta");
  // Stretches and modes: a 25-digit solution of the same balance.
  auto row = only_row(outcome.out);
  EXPECT_EQ(row["branch"], "two-polar");
  EXPECT_NEAR(number(row["lambda"]), 1.372402225529043649, 1e-14);
  EXPECT_NEAR(number(row["mu"]), 0.544058187007701867, 1e-14);
  EXPECT_NEAR(number(row["rho"]), 0.901779742998413476, 1e-15);
  EXPECT_EQ(row["xi"], row["lambda"]);
  EXPECT_EQ(row["zeta"], row["mu"]);
  EXPECT_EQ(row["alpha"], "0");
  EXPECT_EQ(row["angle"], "0");
  EXPECT_EQ(row["nu1"], "0");
  EXPECT_EQ(row["nu2"], "0");
  EXPECT_EQ(number(row["nu3"]), 1.2 + -0.35);
  EXPECT_EQ(row["pi3"], row["s3"]);
  EXPECT_EQ(row["compatibility"], "0");
  EXPECT_EQ(row["omega"], "1.2");
  EXPECT_EQ(row["theta_dot"], "-0.35");
  EXPECT_EQ(row["class"], "elliptic");
  EXPECT_EQ(row["krein1"], "-1");
  const double modes[] = {0.534389416151610, 1.398757212360471, 2.353988464857323,
                          3.889963397050875};
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(number(row["im" + std::to_string(k + 1)]), modes[k], 1e-11);
  EXPECT_EQ(row["im5"], "");
}

TEST(TwoPolarCase, PrescribedMomentaOnALineOfSolutions) {
  auto row = two_polar_row({momenta_case});
  EXPECT_NEAR(number(row["lambda"]), 2.0, 1e-14);
  EXPECT_NEAR(number(row["mu"]), 0.5, 1e-14);
  EXPECT_NEAR(number(row["omega"]), 0.8, 1e-14);
  EXPECT_NEAR(number(row["theta_dot"]), -0.6, 1e-14);
  EXPECT_EQ(row["s3"], "2.2");
  EXPECT_EQ(row["p_theta"], "-0.95");
  EXPECT_NEAR(number(row["energy"]), 4.25, 1e-14);

  const TemporaryDirectory directory;
  const std::string path = directory.file("case.toml", line_of_ellipses);
  const Outcome outcome = run_program({"solve", path, "-o", directory / "x.csv"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no isolated stationary ellipsoid"));
  EXPECT_THAT(outcome.err, HasSubstr("prescribe s3 and p_theta"));
  EXPECT_EQ(nlohmann::json::parse(text_of(directory / "x.meta.json"))["rows"], 0);
}

/// W = mu t^2/2 + g(d) leaves t free there, whatever holds d rho.
TEST(TwoPolarCase, ALineOfSolutionsOfAHeldVolumeIsNoMotion) {
  const TemporaryDirectory directory;
  for (const char* const potential :
       {"plane = { model = \"neo-hookean\", mu = 1.0, lambda = 0.5 }\n",
        "plane = { model = \"reciprocal-determinant\", c = 0.9, k = 1.0 }\n",
        "coupled = { model = \"neo-hookean-3d\", mu = 1.0, lambda = 0.5 }\n"}) {
    const std::string path = directory.file(
        "case.toml", "[body]\nJ = [1.0, 1.0, 0.6]\nvolume = 1.0\n[potential]\n" +
                         std::string(potential) +
                         "[motion]\nbranch = \"two-polar\"\nomega = 0.8\ntheta_dot = -0.6\n");
    for (const char* const all : {"false", "true"}) {
      const Outcome outcome =
          run_program({"solve", path, "--set", std::string("solve.all=") + all});
      EXPECT_EQ(outcome.code, 3) << potential;
      EXPECT_THAT(outcome.err, HasSubstr("no isolated stationary ellipsoid")) << potential;
    }
  }
}

TEST(TwoPolarCase, RatesAndMomentaOfOneMotionGiveTheSameRow) {
  auto rates = two_polar_row({rates_case});
  std::string text = text_of(rates_case);
  text.resize(text.find("omega = 1.2"));
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "case.toml", text + "s3 = " + rates["s3"] + "\np_theta = " + rates["p_theta"] + '\n');
  auto momenta = two_polar_row({path});
  for (const char* column : {"lambda", "mu", "energy", "omega", "theta_dot", "im1", "im4"})
    EXPECT_NEAR(number(momenta[column]), number(rates[column]), 1e-11) << column;
  EXPECT_EQ(momenta["class"], rates["class"]);
}

TEST(TwoPolarCase, OnTheCircleItIsBranchThree) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("case.toml", line_of_ellipses);
  auto row = two_polar_row({path, "--set", "motion.omega=0.7"});
  std::string text = line_of_ellipses;
  text.resize(text.find("[motion]"));
  const std::string third =
      directory.file("third.toml", text + "[motion]\nbranch = \"iii\"\nnu = " + row["nu3"] + '\n');
  auto expected = two_polar_row({third});
  EXPECT_EQ(row["angle"], "");
  EXPECT_EQ(row["omega"], "0.7");
  for (const char* column : {"xi", "zeta", "rho", "class", "negative"})
    EXPECT_EQ(row[column], expected[column]) << column;
  for (const char* column : {"energy", "pi3", "im1", "im2", "im3", "im4", "im5"})
    EXPECT_NEAR(number(row[column]), number(expected[column]), 1e-14) << column;
  EXPECT_THAT(run_program({"solve", path, "--set", "motion.omega=0.7"}).out,
              HasSubstr("the circle lambda = mu"));
}

TEST(TwoPolarCase, AllOfThem) {
  const TemporaryDirectory directory;
  const auto all = [](const std::string& path, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"solve", path, "-o", "-", "--set", "solve.all=true"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  };
  const Outcome by_momenta = all(momenta_case, {});
  ASSERT_EQ(by_momenta.code, 0) << by_momenta.err;
  EXPECT_THAT(by_momenta.err, ::testing::IsEmpty());
  EXPECT_NEAR(number(only_row(by_momenta.out)["lambda"]), 2.0, 1e-14);
  // The ellipse of given rates, and the circle that has their sum.
  const Outcome by_rates = all(rates_case, {"--certify"});
  ASSERT_EQ(by_rates.code, 0) << by_rates.err;
  auto rows = rows_of(by_rates.out);
  ASSERT_EQ(rows.size(), 2U) << by_rates.out;
  EXPECT_NEAR(number(rows[0]["lambda"]), 1.372402225529043649, 1e-14);
  EXPECT_EQ(rows[1]["lambda"], rows[1]["mu"]);
  EXPECT_EQ(rows[1]["sheet"], "2");
  for (auto& row : rows) EXPECT_EQ(row["certified"], "yes");
  // A line of solutions is said by name, and not searched.
  const std::string line = directory.file("line.toml", line_of_ellipses);
  const Outcome on_line = all(line, {});
  EXPECT_EQ(on_line.code, 3);
  EXPECT_THAT(on_line.err, HasSubstr("no isolated stationary ellipsoid"));
  EXPECT_THAT(on_line.err, HasSubstr("J (omega^2 + theta_dot^2) = k"));
  EXPECT_TRUE(rows_of(on_line.out).empty());
  const Outcome none = all(line, {"--set", "motion.omega=1.7"});
  EXPECT_EQ(none.code, 3);
  EXPECT_THAT(none.err, HasSubstr("proven that there is none"));
}

TEST(TwoPolarCase, TheCircleOfEqualMomenta) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("case.toml", line_of_ellipses);
  auto rates = two_polar_row({path, "--set", "motion.omega=0.7"});
  std::string text = line_of_ellipses;
  text.resize(text.find("omega"));
  const std::string momenta = directory.file(
      "momenta.toml", text + "s3 = " + rates["s3"] + "\np_theta = " + rates["s3"] + '\n');
  auto row = two_polar_row({momenta});
  EXPECT_EQ(row["angle"], "");
  EXPECT_NEAR(number(row["lambda"]), number(rates["lambda"]), 1e-14);
  EXPECT_NEAR(number(row["nu3"]), number(rates["nu3"]), 1e-14);
  EXPECT_EQ(row["class"], rates["class"]);
  auto all = rows_of(run_program({"solve", momenta, "-o", "-", "--set", "solve.all=true"}).out);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0]["lambda"], row["lambda"]);
}

TEST(TwoPolarCase, AStartOfOnesOwn) {
  auto row = two_polar_row({rates_case, "--set", "solve.start=[0, 1.4, 0.5, 0.9]"});
  EXPECT_NEAR(number(row["lambda"]), 1.372402225529043649, 1e-14);
  EXPECT_THAT(run_program({"solve", rates_case, "--set", "solve.start=[0, 1.4, 0.5, 0.9]"}).out,
              HasSubstr("given start"));
}

/// A thickness with two wells: with each rho that is balanced the same lambda and mu are a motion.
TEST(TwoPolarCase, KeepsTheThicknessItStartsWith) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("case.toml", R"(
[body]
J = [0.8581276102158601, 0.8581276102158601, 2.052600637307819]
[potential.plane]
expression = "mu/2*(I1 - 2*d) + k*(d - d1)^2*(d - d2)^2"
mu = 1.3904479798461304
k = 2.18118781362386
d1 = 0.6256638669970457
d2 = 1.5317501426594524
[potential.thickness]
expression = "k*((rho - r1)*(rho - r2))^2"
k = 0.46812288517026757
r1 = 0.8
r2 = 1.133831476883512
[motion]
branch = "two-polar"
s3 = -2.538793300095023
p_theta = -3.146491359378073
[continuation]
parameter = "motion.p_theta"
from = -6.553971687053119
to = 6.553971687053119
tolerance = 1e-6
)");
  const std::string all = directory / "all.csv";
  const Outcome found = run_program({"solve", path, "--set", "solve.all=true", "-o", all});
  ASSERT_EQ(found.code, 0) << found.err;
  const std::vector<Row> motions = rows_of(text_of(all));
  ASSERT_EQ(motions.size(), 3U);
  std::set<double> thicknesses;
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const Row& at = motions[k];
    const double rho = number(at.at("rho"));
    thicknesses.insert(rho);
    const std::string start = "solve.start=[" + at.at("alpha") + "," + at.at("xi") + "," +
                              at.at("zeta") + "," + at.at("rho") + "]";
    const auto solved = two_polar_row({path, "--set", start});
    EXPECT_NEAR(number(solved.at("rho")), rho, 1e-14);
    EXPECT_EQ(solved.at("class"), at.at("class"));
    const std::string table = directory / "family.csv";
    const Outcome followed =
        run_program({"continue", path, "--from", all + ":" + std::to_string(k + 1), "-o", table});
    ASSERT_EQ(followed.code, 0) << followed.err;
    const std::vector<Row> rows = rows_of(text_of(table));
    EXPECT_GE(rows.size(), 20U);
    for (const Row& row : rows) EXPECT_NEAR(number(row.at("rho")), rho, 1e-12);
  }
  EXPECT_EQ(thicknesses.size(), 3U);
}

TEST(TwoPolarCase, CheckSaysWhatIsComputed) {
  const Outcome outcome = run_program({"check", rates_case});
  for (const char* text : {"two-polar, omega = 1.2, theta_dot = -0.35", "lambda, mu",
                           "a global search", "4 modes from 2 blocks"})
    EXPECT_THAT(outcome.out, HasSubstr(text));
  EXPECT_THAT(run_program({"check", momenta_case}).out, HasSubstr("s3 = 2.2, p_theta = -0.95"));
  EXPECT_THAT(run_program({"check", rates_case, "--set", "output.spectrum=false"}).out,
              HasSubstr("spectrum      skipped"));
}

TEST(TwoPolarCase, InterruptedItWritesNothing) {
  const TemporaryDirectory directory;
  for (const std::string& path : {rates_case, momenta_case}) {
    const Outcome outcome =
        run_program({"solve", path, "-o", directory / "x.csv"}, {.pending_signal = SIGINT});
    EXPECT_EQ(outcome.code, 130);
    EXPECT_TRUE(directory.names().empty());
  }
}

TEST(TwoPolarCase, MetadataHaveTheMotion) {
  const TemporaryDirectory directory;
  ASSERT_EQ(run_program({"solve", momenta_case, "-o", directory / "x.csv"}).code, 0);
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  const nlohmann::json motion{{"branch", "two-polar"}, {"s3", 2.2}, {"p_theta", -0.95}};
  EXPECT_EQ(metadata["case"]["motion"], motion);
  EXPECT_EQ(metadata["class"], "unstable");
}

TEST(TwoPolarCase, ContinuationIsReadLikeAnyOther) {
  const Outcome outcome =
      run_program({"check", rates_case, "--set",
                   "continuation={ parameter = \"motion.theta_dot\", from = -0.5, to = 0.5 }"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("motion.theta_dot from -0.5 to 0.5"));
}

TEST(TwoPolarCase, ParametersActOnTheMotion) {
  const Case input = read_case(momenta_case);
  const FamilyParameters family{input.body, input.models, input.motion};
  for (const std::string& key : case_parameters(input.motion, input.models))
    EXPECT_NO_THROW((void)with_parameter(family, key, 1.0)) << key;
  const FamilyParameters moved = with_parameter(family, "motion.p_theta", -0.5);
  const auto& momenta = std::get<TwoPolarMomenta<double>>(std::get<TwoPolarMotion>(moved.motion));
  EXPECT_EQ(momenta.p_theta, -0.5);
  EXPECT_EQ(momenta.s3, 2.2);
  EXPECT_THROW((void)with_parameter(family, "nu", 1.0), std::invalid_argument);
  EXPECT_THROW((void)with_parameter(family, "body.J.0", 2.0), std::invalid_argument);
  EXPECT_THROW((void)with_parameter(family, "motion.s3", std::nan("")), std::invalid_argument);
}

TEST(TwoPolarCase, IsFollowedInARate) {
  const Outcome outcome = run_program({"continue", rates_case, "--certify", "-o", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  auto rows = rows_of(outcome.out);
  ASSERT_GT(rows.size(), 50U);
  EXPECT_EQ(rows.front()["event"], "ellipse");
  EXPECT_EQ(rows.front()["lambda"], rows.front()["mu"]);
  EXPECT_EQ(rows.back()["event"], "limit");
  for (std::size_t k = 1; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k]["omega"], "1.2");
    EXPECT_EQ(rows[k]["theta_dot"], rows[k]["motion.theta_dot"]);
    EXPECT_EQ(rows[k]["certified"], "yes") << rows[k]["point"];
    EXPECT_EQ(rows[k]["class_certified"], "yes") << rows[k]["point"];
  }
}

/// At the circle of equal momenta there is no spectrum of ellipses, from whichever side it is met.
TEST(TwoPolarCase, ARowWithoutSpectrumHasNoneOfAnother) {
  const Outcome outcome =
      run_program({"continue", momenta_case, "--certify", "--set", "motion.p_theta=3.0", "--set",
                   "motion.s3=1.2", "--set", "continuation.from=0.5", "-o", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  auto rows = rows_of(outcome.out);
  ASSERT_GT(rows.size(), 50U);
  EXPECT_EQ(rows[rows.size() - 2]["class"], "stable");
  Row& last = rows.back();
  EXPECT_EQ(last["event"], "ellipse");
  for (const char* column : {"class", "class_certified", "growth", "negative", "im1", "krein4"})
    EXPECT_EQ(last[column], "") << column;
}

/// A circle at given momenta, next to the fold of (iii) in its rounded spin. True: 60 digits.
TEST(TwoPolarCase, ModesOfACircleNextToAFoldAreThoseOfItsMomenta) {
  const TemporaryDirectory directory;
  auto row = two_polar_row({directory.file("x.toml", R"toml([body]
J = [1.0, 1.0, 1.0]
[gravity]
g = 4.0
[potential]
coupled = { expression = "K/(d*rho)", K = 1.3333333333333333 }
[motion]
branch = "two-polar"
s3 = 1.8271045
p_theta = 1.8271045
)toml")});
  const double im[] = {0.027861566866948493, 0.22068694103783254, 0.91420350184049373,
                       0.97228212385837681, 1.3237668366641416};
  for (int k = 0; k < 5; ++k)
    EXPECT_NEAR(number(row["im" + std::to_string(k + 1)]), im[k], 1e-14 * im[k]) << k;
}

/// An interrupted table goes on as the whole one.
TEST(TwoPolarCase, IsGoneOnWith) {
  const TemporaryDirectory directory;
  const std::string file = directory / "x.csv";
  const Outcome part = run_program(
      {"continue", momenta_case, "-o", file, "--set", "continuation.max_points=60", "--quiet"});
  ASSERT_EQ(part.code, 0) << part.err;
  const Outcome rest = run_program({"continue", momenta_case, "-o", file, "--resume", "--quiet"});
  ASSERT_EQ(rest.code, 0) << rest.err;
  const auto rows = rows_of(text_of(file));
  EXPECT_EQ(rows.front().at("event"), "limit");
  EXPECT_EQ(rows.back().at("event"), "limit");
  EXPECT_GT(rows.size(), 100U);
}

}  // namespace
}  // namespace stationary::testing
