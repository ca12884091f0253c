// Every way a case file can be wrong that we could think of: the program ends with 2, computes
// nothing, and its message names the place, the key, what was found and what is allowed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* body = "[body]\nJ = [1.0, 1.7, 0.6]\n";
constexpr const char* potential =
    "[potential]\nplane = { model = \"biot\", mu = 1.0, lambda = 0.6 }\n"
    "thickness = { model = \"harmonic\", k = 1.0, rest = 0.8 }\n";
constexpr const char* motion = "[motion]\nbranch = \"i\"\nnu = 0.5\n";

struct Malformed {
  const char* name;
  std::string text;
  std::vector<const char*> fragments;
};

std::string repeated(const std::string& text, int times) {
  std::string out;
  for (int k = 0; k < times; ++k) out += text;
  return out;
}
std::string with_body(const std::string& text) { return text + potential + motion; }
std::string with_potential(const std::string& text) { return std::string(body) + text + motion; }
std::string with_motion(const std::string& text) { return std::string(body) + potential + text; }
std::string with_more(const std::string& text) {
  return std::string(body) + potential + motion + text;
}
std::string planar(const std::string& coefficients) {
  return with_potential("[potential]\nplane = { " + coefficients +
                        " }\nthickness = { model = \"harmonic\", k = 1.0, rest = 0.8 }\n");
}
/// A two-polar motion of a round body.
std::string round_body(const std::string& text) {
  return std::string("[body]\nJ = [1, 1, 0.6]\n") + potential +
         "[motion]\nbranch = \"two-polar\"\n" + text;
}
std::string continuation(const std::string& text) { return with_more("[continuation]\n" + text); }

const std::vector<Malformed>& malformed_cases() {
  static const std::vector<Malformed> all{
      // TOML itself
      {"empty", "", {"case.toml:1:1", "no keys", "[body]"}},
      {"comment_only", "# nothing\n", {"case.toml:1:1", "no keys"}},
      {"binary",
       std::string("\x7f\x45\x4c\x46\x02\x01\x00\xff\xfe\x80", 10),
       {"case.toml:", "TOML"}},
      {"unfinished_string", with_motion("[motion]\nbranch = \"i\n"), {"case.toml:7:", "TOML"}},
      {"unfinished_array", "[body]\nJ = [1.0, 1.7\n", {"case.toml:", "TOML"}},
      {"no_value", "[body]\nJ = \n", {"case.toml:2:", "TOML"}},
      {"duplicate_key", with_motion("[motion]\nnu = 1\nnu = 2\n"), {"case.toml:8:", "TOML"}},
      {"duplicate_table", with_more("[body]\nJ = [1, 1, 1]\n"), {"case.toml:9:", "TOML"}},
      {"not_utf8", "title = \"\xc3\x28\"\n", {"case.toml:1:", "TOML"}},
      {"deep_nesting", "title = " + std::string(5000, '['), {"case.toml:1:", "TOML"}},
      {"deep_tables",
       "x = " + repeated("{ a = ", 5000),
       {"case.toml:1:", "nests more deeply", "at most 32 brackets in one another"}},
      {"long_dotted_key",
       "# \"\ntitle = \"\"\"\n#\"\"\"\na" + repeated(".a", 40000) + " = 1\n",
       {"case.toml:4:", "nests more deeply", "keys of at most 16 parts"}},
      {"long_table_name",
       "[a" + repeated(". \"b\"", 40000) + "]\n",
       {"case.toml:1:", "nests more deeply"}},
      {"huge_integer",
       with_motion("[motion]\nbranch = \"i\"\nnu = 99999999999999999999\n"),
       {"case.toml:8:", "TOML"}},
      // unknown keys
      {"unknown_top",
       with_more("[solver]\nmethod = \"auto\"\n"),
       {"case.toml:9:", "solver: found an unknown key", "did you mean \"solve\"?"}},
      {"unknown_body",
       with_body("[body]\nJ = [1, 2, 3]\nK = 1\n"),
       {"case.toml:3:1", "body.K: found an unknown key", "one of \"J\", \"volume\" in [body]"}},
      {"unknown_motion",
       with_motion("[motion]\nbrunch = \"i\"\nnu = 1\n"),
       {"case.toml:7:1", "motion.brunch", "did you mean \"branch\"?"}},
      {"wrong_table",
       with_more("[output]\nmethod = \"auto\"\n"),
       {"case.toml:10:1", "output.method", "did you mean \"solve.method\"?"}},
      {"dotted_in_quotes", with_more("\"motion.nu\" = 3\n"), {"case.toml:9:1", "unknown key"}},
      {"control_characters", "\"\\u001b[31m\" = 1\n", {"\\x1B[31m", "unknown key"}},
      // missing keys
      {"no_body", std::string(potential) + motion, {"case.toml:1:1", "body:", "add body"}},
      {"no_J", with_body("[body]\n"), {"case.toml:1:1", "body.J: found no such key", "three"}},
      {"no_potential", std::string(body) + motion, {"potential: found no such key"}},
      {"no_motion", std::string(body) + potential, {"motion: found no such key"}},
      {"no_branch",
       with_motion("[motion]\nnu = 1\n"),
       {"case.toml:6:1", "motion.branch", "\"i\", \"ii\", \"iii\""}},
      {"no_nu", with_motion("[motion]\nbranch = \"i\"\n"), {"case.toml:6:1", "motion.nu"}},
      // types
      {"body_no_table", "body = 3\n", {"case.toml:1:8", "body: found the integer 3", "a table"}},
      {"title_number", "title = 3\n", {"case.toml:1:9", "found the integer 3", "a text"}},
      {"nu_string",
       with_motion("[motion]\nbranch = \"i\"\nnu = \"fast\"\n"),
       {"case.toml:8:6", "motion.nu: found the string \"fast\"", "a finite number"}},
      {"nu_boolean",
       with_motion("[motion]\nbranch = \"i\"\nnu = true\n"),
       {"case.toml:8:6", "motion.nu: found true", "a finite number"}},
      {"nu_date",
       with_motion("[motion]\nbranch = \"i\"\nnu = 2020-01-01\n"),
       {"case.toml:8:6", "found a date or time"}},
      {"nu_nan",
       with_motion("[motion]\nbranch = \"i\"\nnu = nan\n"),
       {"case.toml:8:6", "motion.nu: found the number nan", "a finite number"}},
      {"nu_infinite",
       with_motion("[motion]\nbranch = \"i\"\nnu = -inf\n"),
       {"case.toml:8:6", "found the number -inf", "a finite number"}},
      {"nu_array",
       with_motion("[motion]\nbranch = \"i\"\nnu = [1]\n"),
       {"case.toml:8:6", "found an array of 1 value;"}},
      {"all_text", with_more("[solve]\nall = \"yes\"\n"), {"case.toml:10:7", "true or false"}},
      // body
      {"J_short",
       with_body("[body]\nJ = [1, 2]\n"),
       {"case.toml:2:5", "an array of 2 values", "three"}},
      {"J_long",
       with_body("[body]\nJ = [1, 2, 3, 4]\n"),
       {"case.toml:2:5", "an array of 4 values"}},
      {"J_scalar", with_body("[body]\nJ = 1\n"), {"case.toml:2:5", "found the integer 1", "three"}},
      {"J_text",
       with_body("[body]\nJ = [1, \"2\", 3]\n"),
       {"case.toml:2:9", "body.J.1: found the string \"2\""}},
      {"J_zero", with_body("[body]\nJ = [1, 0, 3]\n"), {"case.toml:2:9", "found J2 = 0", "J2 > 0"}},
      {"J_negative",
       with_body("[body]\nJ = [1, 2, -3.5]\n"),
       {"case.toml:2:12", "found J3 = -3.5", "J3 > 0"}},
      {"J_nan",
       with_body("[body]\nJ = [nan, 2, 3]\n"),
       {"case.toml:2:6", "body.J.0: found the number nan"}},
      {"J_infinite",
       with_body("[body]\nJ = [inf, 2, 3]\n"),
       {"case.toml:2:6", "found the number inf"}},
      // potential
      {"model_misspelt",
       planar("model = \"neo-hokean\", mu = 1, lambda = 1"),
       {"case.toml:4:19", "potential.plane.model", "\"neo-hokean\"",
        "did you mean \"neo-hookean\"?"}},
      {"model_unlike_any",
       planar("model = \"steel\", mu = 1"),
       {"found the string \"steel\"", "\"hencky\""}},
      {"model_number", planar("model = 3"), {"potential.plane.model: found the integer 3"}},
      {"model_elsewhere",
       planar("model = \"harmonic\", k = 1, rest = 1"),
       {"\"harmonic\" belongs under potential.thickness"}},
      {"model_missing", planar("mu = 1, lambda = 1"), {"found no model", "\"biot\""}},
      {"model_key_misspelt",
       planar("modle = \"biot\", mu = 1, lambda = 1"),
       {"found no model", "did you mean \"model\"?"}},
      {"model_not_a_table",
       with_potential("[potential]\nplane = \"biot\"\nthickness = 1\n"),
       {"case.toml:4:9", "potential.plane: found the string \"biot\"", "coefficients"}},
      {"coefficient_misspelt",
       planar("model = \"biot\", mu = 1, lamda = 1"),
       {"case.toml:4:35", "potential.plane.lamda", "did you mean \"lambda\"?"}},
      {"coefficient_missing",
       planar("model = \"biot\", mu = 1"),
       {"case.toml:4:9", "potential.plane.lambda: found no coefficient \"lambda\""}},
      {"coefficient_text",
       planar("model = \"biot\", mu = 1, lambda = \"1\""),
       {"case.toml:4:44", "potential.plane.lambda: found the string \"1\""}},
      {"coefficient_nan",
       planar("model = \"biot\", mu = nan, lambda = 1"),
       {"case.toml:4:32", "potential.plane.mu: found the number nan"}},
      {"outside_domain",
       planar("model = \"biot\", mu = -1, lambda = 2"),
       {"case.toml:4:32", "potential.plane.mu: found mu = -1", "expected mu > 0"}},
      {"outside_joint_domain",
       planar("model = \"biot\", mu = 1, lambda = -2"),
       {"case.toml:4:44", "found mu = 1, lambda = -2", "expected mu + lambda > 0"}},
      {"both_kinds",
       with_potential("[potential]\nplane = { model = \"biot\", mu = 1, lambda = 1 }\n"
                      "coupled = { model = \"neo-hookean-3d\", mu = 1, lambda = 1 }\n"),
       {"case.toml:5:11", "potential.coupled: found both coupled and plane", "remove"}},
      {"plane_alone",
       with_potential("[potential]\nplane = { model = \"biot\", mu = 1, lambda = 1 }\n"),
       {"potential.thickness: found plane alone", "add thickness"}},
      {"thickness_alone",
       with_potential("[potential]\nthickness = { model = \"harmonic\", k = 1, rest = 1 }\n"),
       {"potential.plane: found thickness alone", "add plane"}},
      {"no_model_at_all", with_potential("[potential]\n"), {"case.toml:3:1", "found neither"}},
      // motion
      {"branch_unknown",
       with_motion("[motion]\nbranch = \"iv\"\nnu = 1\n"),
       {"case.toml:7:10", "motion.branch: found the string \"iv\"", "\"i\", \"ii\", \"iii\""}},
      {"branch_case",
       with_motion("[motion]\nbranch = \"III\"\nnu = 1\n"),
       {"did you mean \"iii\"?"}},
      {"branch_oblique",
       with_motion("[motion]\nbranch = \"oblique\"\nnu = 1\n"),
       {"\"oblique\" with an isotropic potential", "\"i\", \"ii\", \"iii\""}},
      {"plane_of_another_branch",
       with_motion("[motion]\nbranch = \"i\"\nnu = 1\nplane = \"13\"\n"),
       {"case.toml:9:1", "motion.plane: found plane, which branch \"i\" does not take",
        "remove plane"}},
      // tilted motions
      {"tilted_plane",
       with_motion("[motion]\nbranch = \"tilted\"\nplane = \"12\"\nnu = 1\n"),
       {"case.toml:8:9", "motion.plane: found the string \"12\"", "one of \"13\", \"23\""}},
      {"tilted_without_nu",
       with_motion("[motion]\nbranch = \"tilted\"\n"),
       {"motion.nu", "add nu"}},
      {"tilted_at_rest",
       with_motion("[motion]\nbranch = \"tilted\"\nnu = 0\n"),
       {"case.toml:8:6", "motion.nu: found nu = 0", "nu > 0"}},
      {"tilted_with_rates",
       with_motion("[motion]\nbranch = \"tilted\"\nnu = 1\nomega = 1\n"),
       {"case.toml:9:1", "motion.omega: found omega, which branch \"tilted\" does not take"}},
      {"tilted_method",
       with_motion("[motion]\nbranch = \"tilted\"\nnu = 1\n[solve]\nmethod = \"nlopt\"\n"),
       {"case.toml:10:10", "solve.method", "\"auto\" or \"newton\""}},
      {"tilted_parameter",
       with_motion("[motion]\nbranch = \"tilted\"\nnu = 1\n[continuation]\nparameter = "
                   "\"body.J.0\"\nfrom = 0.5\nto = 2\n"),
       {"continuation.parameter", "one of \"nu\""}},
      {"tilted_range",
       with_motion("[motion]\nbranch = \"tilted\"\nnu = 1\n[continuation]\nparameter = "
                   "\"nu\"\nfrom = -1\nto = 2\n"),
       {"continuation.from", "from >= 0"}},
      {"rate_of_another_branch",
       with_motion("[motion]\nbranch = \"i\"\nnu = 1\nomega = 1\n"),
       {"case.toml:9:1", "motion.omega: found omega, which branch \"i\" does not take",
        "expected nu", "remove omega"}},
      {"momentum_of_another_branch",
       with_motion("[motion]\nbranch = \"iii\"\np_theta = 1\n"),
       {"case.toml:8:1", "motion.p_theta", "branch \"iii\"", "expected nu"}},
      // two-polar motions
      {"two_polar_with_nu",
       round_body("nu = 1\nomega = 1\ntheta_dot = 1\n"),
       {"case.toml:8:1", "motion.nu: found nu, which branch \"two-polar\" does not take",
        "omega and theta_dot, or s3 and p_theta, instead", "remove nu"}},
      {"two_polar_of_nothing",
       round_body(""),
       {"case.toml:6:1", "motion: found none of omega, theta_dot, s3, p_theta", "add one of"}},
      {"two_polar_half_rates",
       round_body("omega = 1\n"),
       {"case.toml:6:1", "motion.theta_dot: found omega alone",
        "expected omega and theta_dot, or s3 and p_theta", "add theta_dot"}},
      {"two_polar_half_momenta",
       round_body("p_theta = 1\n"),
       {"motion.s3: found p_theta alone", "add s3"}},
      {"two_polar_both_pairs",
       round_body("omega = 1\ntheta_dot = 1\ns3 = 1\np_theta = 1\n"),
       {"case.toml:10:1", "motion.s3: found both omega and s3", "keep one of the two pairs"}},
      {"two_polar_half_of_each",
       round_body("theta_dot = 1\np_theta = 1\n"),
       {"case.toml:9:1", "motion.p_theta: found both theta_dot and p_theta"}},
      {"two_polar_rate_nan",
       round_body("omega = nan\ntheta_dot = 1\n"),
       {"case.toml:8:9", "motion.omega: found the number nan", "a finite number"}},
      {"two_polar_momentum_text",
       round_body("s3 = \"much\"\np_theta = 1\n"),
       {"case.toml:8:6", "motion.s3: found the string \"much\"", "a finite number"}},
      {"two_polar_misspelt",
       round_body("omega = 1\ntheta_dt = 1\n"),
       {"motion.theta_dt", "did you mean \"theta_dot\"?"}},
      {"two_polar_unsymmetric",
       with_motion("[motion]\nbranch = \"two-polar\"\nomega = 1\ntheta_dot = 2\n"),
       {"case.toml:2:5", "body.J: found J1 = 1, J2 = 1.7", "expected J1 = J2"}},
      {"two_polar_ceres",
       round_body("omega = 1\ntheta_dot = 2\n[solve]\nmethod = \"ceres\"\n"),
       {"case.toml:11:10", "solve.method: found the string \"ceres\" with branch \"two-polar\"",
        "\"auto\" or \"nlopt\""}},
      {"two_polar_newton",
       round_body("omega = 1\ntheta_dot = 2\n[solve]\nmethod = \"newton\"\n"),
       {"\"auto\" or \"nlopt\""}},
      {"two_polar_start_negative",
       round_body("omega = 1\ntheta_dot = 2\n[solve]\nstart = [0, 1, -1, 1]\n"),
       {"case.toml:11:16", "found mu = -1", "mu > 0"}},
      {"two_polar_start_on_the_circle",
       round_body("omega = 1\ntheta_dot = 2\n[solve]\nstart = [0, 1, 1, 1]\n"),
       {"case.toml:11:16", "found mu = 1", "lambda != mu"}},
      {"two_polar_parameter_nu",
       round_body("omega = 1\ntheta_dot = 2\n[continuation]\nparameter = \"nu\"\nfrom = 0\n"
                  "to = 1\n"),
       {"case.toml:11:13", "found the string \"nu\"", "\"motion.omega\", \"motion.theta_dot\""}},
      {"two_polar_parameter_of_the_other_pair",
       round_body("omega = 1\ntheta_dot = 2\n[continuation]\nparameter = \"motion.s3\"\n"
                  "from = 0\nto = 1\n"),
       {"found the string \"motion.s3\"", "\"motion.omega\""}},
      {"two_polar_parameter_J1",
       round_body("omega = 1\ntheta_dot = 2\n[continuation]\nparameter = \"body.J.0\"\n"
                  "from = 0.5\nto = 1\n"),
       {"found the string \"body.J.0\"", "did you mean \"body.J.2\"?"}},
      // solve
      {"method_unknown",
       with_more("[solve]\nmethod = \"neuton\"\n"),
       {"case.toml:10:10", "solve.method", "did you mean \"newton\"?"}},
      {"start_short", with_more("[solve]\nstart = [0, 1, 1]\n"), {"case.toml:10:9", "four"}},
      {"start_alpha",
       with_more("[solve]\nstart = [0.1, 1, 1, 1]\n"),
       {"case.toml:10:10", "found alpha = 0.1", "alpha = 0", "isotropic"}},
      {"start_negative",
       with_more("[solve]\nstart = [0, 1, -1, 1]\n"),
       {"case.toml:10:16", "found zeta = -1", "zeta > 0"}},
      {"start_zero", with_more("[solve]\nstart = [0, 1, 1, 0]\n"), {"found rho = 0", "rho > 0"}},
      {"start_nan", with_more("[solve]\nstart = [0, nan, 1, 1]\n"), {"case.toml:10:13", "nan"}},
      // continuation
      {"range_empty",
       continuation("parameter = \"nu\"\nfrom = 1.0\nto = 1.0\n"),
       {"case.toml:12:6", "continuation.to: found the empty range from 1 to 1", "from < to"}},
      {"range_backward", continuation("parameter = \"nu\"\nfrom = 2\nto = 1\n"), {"from < to"}},
      {"range_infinite",
       continuation("parameter = \"nu\"\nfrom = 0\nto = inf\n"),
       {"case.toml:12:6", "the number inf", "a finite number"}},
      {"range_missing",
       continuation("parameter = \"nu\"\nfrom = 0\n"),
       {"case.toml:9:1", "continuation.to: found no such key"}},
      {"tolerance_zero",
       continuation("parameter = \"nu\"\nfrom = 0\nto = 1\ntolerance = 0\n"),
       {"case.toml:13:13", "continuation.tolerance: found 0", "> 0 and <= 1"}},
      {"tolerance_large",
       continuation("parameter = \"nu\"\nfrom = 0\nto = 1\ntolerance = 2\n"),
       {"found 2", "> 0 and <= 1"}},
      {"parameter_unknown",
       continuation("parameter = \"potential.plane.mo\"\nfrom = 1\nto = 2\n"),
       {"case.toml:10:13", "\"potential.plane.mo\"", "did you mean \"potential.plane.mu\"?"}},
      {"parameter_of_other_model",
       continuation("parameter = \"potential.plane.k\"\nfrom = 1\nto = 2\n"),
       {"continuation.parameter", "\"body.J.0\""}},
      {"parameter_index",
       continuation("parameter = \"body.J.3\"\nfrom = 1\nto = 2\n"),
       {"did you mean \"body.J."}},
      {"range_leaves_body",
       continuation("parameter = \"body.J.1\"\nfrom = 0.0\nto = 2.0\n"),
       {"case.toml:11:8", "continuation.from: found body.J.1 = 0", "J2 > 0"}},
      {"range_leaves_domain",
       continuation("parameter = \"potential.plane.lambda\"\nfrom = -3.0\nto = 2.0\n"),
       {"case.toml:11:8", "found potential.plane.lambda = -3", "mu + lambda > 0"}},
      // output
      {"column_unknown",
       with_more("[output]\ncolumns = [\"nu1\", \"enrgy\"]\n"),
       {"case.toml:10:19", "output.columns.1", "did you mean \"energy\"?"}},
      {"column_number",
       with_more("[output]\ncolumns = [1]\n"),
       {"case.toml:10:12", "column names"}},
      {"columns_text", with_more("[output]\ncolumns = \"nu1\"\n"), {"case.toml:10:11", "an array"}},
      {"columns_none_computed",
       with_more("[output]\ncolumns = [\"event\"]\n"),
       {"output.columns", "no column that solve computes"}},
      {"columns_of_a_spectrum_not_asked_for",
       with_more("[output]\nspectrum = false\ncolumns = [\"class\", \"growth\"]\n"),
       {"case.toml:11:11", "no column that solve computes"}},
      {"columns_of_another_branch",
       with_more("[output]\ncolumns = [\"omega\"]\n"),
       {"output.columns", "no column that solve computes"}},
  };
  return all;
}

/// For the test's listing; the default prints bytes, addresses among them.
void PrintTo(const Malformed& malformed, std::ostream* out) { *out << malformed.name; }

class MalformedCase : public ::testing::TestWithParam<Malformed> {};

TEST_P(MalformedCase, IsRefusedWithItsPlaceAndTheRemedy) {
  const TemporaryDirectory directory;
  directory.file("case.toml", GetParam().text);
  const Outcome outcome =
      run_program({"solve", "case.toml", "-o", "table.csv"}, {.directory = directory.path()});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.out, IsEmpty());
  for (const char* fragment : GetParam().fragments) EXPECT_THAT(outcome.err, HasSubstr(fragment));
  EXPECT_THAT(outcome.err, Not(HasSubstr("\x1b")));
  EXPECT_THAT(directory.names(), ::testing::ElementsAre("case.toml"));
}

INSTANTIATE_TEST_SUITE_P(All, MalformedCase, ::testing::ValuesIn(malformed_cases()),
                         [](const auto& param) { return std::string(param.param.name); });

TEST(CaseFile, ThatIsNotThere) {
  const Outcome outcome = run_program({"check", "nowhere/case.toml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("nowhere/case.toml: no readable file (No such file"));
}

TEST(CaseFile, ThatIsADirectory) {
  const TemporaryDirectory directory;
  const Outcome outcome = run_program({"solve", directory.path()});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("a directory; expected a case file"));
}

TEST(CaseFile, ThatNeverEnds) {
  const Outcome outcome = run_program({"check", "/dev/zero"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("more than 1 MiB"));
}

TEST(CaseFile, IntegersAreNumbers) {
  const TemporaryDirectory directory;
  const std::string path = directory.file(
      "case.toml",
      "[body]\nJ = [1, 2, 1]\n[potential]\nplane = { model = \"biot\", mu = 1, lambda = 1 }\n"
      "thickness = { model = \"harmonic\", k = 2, rest = 1 }\n"
      "[motion]\nbranch = \"iii\"\nnu = 0\n[continuation]\nparameter = \"motion.nu\"\n"
      "from = 0\nto = 1\ntolerance = 1\n");
  const Outcome outcome = run_program({"check", path});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("nu from 0 to 1, tolerance 1"));
}

TEST(CaseFile, AllFaultsOfAMotionAreToldAtOnce) {
  const Outcome pair = run_program({"check", shipped("fold.toml"), "--set",
                                    "motion.branch=\"two-polar\"", "--set", "motion.plane=\"13\""});
  EXPECT_EQ(pair.code, 2);
  for (const char* fault : {"motion.nu: found nu", "motion.plane: found plane",
                            "found none of omega, theta_dot", "body.J: found J1 = "})
    EXPECT_THAT(pair.err, HasSubstr(fault));
  const Outcome spin = run_program({"check", shipped("fold.toml"), "--set", "motion.plane=\"13\"",
                                    "--set", "motion.axis=\"1\"", "--set", "motion.s3=1.0"});
  for (const char* key : {"motion.plane: ", "motion.axis: ", "motion.s3: "})
    EXPECT_THAT(spin.err, HasSubstr(key));
  const Outcome body = run_program({"check", shipped("fold.toml"), "--set", "body.J=[nan,1,inf]"});
  EXPECT_THAT(body.err, HasSubstr("body.J.0: "));
  EXPECT_THAT(body.err, HasSubstr("body.J.2: "));
}

TEST(CaseFile, AllFaultsAreToldAtOnce) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("case.toml", R"([body]
J = [1.0, -1.7, 0.0]
[potential]
plane = { model = "biot", mu = 1.0, lambad = 0.6 }
thickness = { model = "harmonic", k = -1.0, rest = 0.8 }
[motion]
branch = "iv"
nu = "fast"
[solve]
start = [0, 1, -1, 1]
box = [3, 2]
[continuation]
form = 0.0
to = 1.0
tolerance = -1.0
step = 2
events = ["tlit"]
[map]
x = { parameter = "nu", from = 1.0, to = 0.0, count = 1 }
[output]
columns = ["xii"]
spectrum = 1
)");
  const Outcome outcome =
      run_program({"solve", path, "--set", "solve.method=fast", "--set", "motion=1.x=3"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.out, IsEmpty());
  const std::vector<std::string> found = lines_of(outcome.err);
  const std::vector<std::pair<const char*, const char*>> expected{
      {":2:11", "body.J.1: found J2 = -1.7"},
      {":2:17", "body.J.2: found J3 = 0"},
      {":4", "potential.plane.lambad"},
      {":5", "potential.thickness.k: found k = -1"},
      {":7", "motion.branch: found the string \"iv\""},
      {":8", "motion.nu: found the string \"fast\""},
      {":10", "solve.start.2: found zeta = -1"},
      {":11", "solve.box: found [3, 2]"},
      {":13", "continuation.form: found an unknown key"},
      {":15", "continuation.tolerance"},
      {":16", "continuation.step"},
      {":17", "did you mean \"tilt\"?"},
      {":19", "map.x.to: found the empty range"},
      {":19", "map.x.count: found 1"},
      {":21", "did you mean \"xi\"?"},
      {":22", "output.spectrum: found the integer 1"},
      {"--set motion=1.x=3", "motion"},
      {"--set solve.method=fast", "solve.method: found the string \"fast\""}};
  ASSERT_EQ(found.size(), expected.size()) << outcome.err;
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_THAT(found[k], ::testing::StartsWith("stationary: "));
    EXPECT_THAT(found[k], HasSubstr(expected[k].first));
    EXPECT_THAT(found[k], HasSubstr(expected[k].second));
  }
}

/// One mistake, one line.
TEST(CaseFile, ARefusalSaysWhatWasMeant) {
  struct {
    const char* set;
    const char* said;
  } const all[] = {
      {"motion.parameter=\"nu\"", "did you mean \"continuation.parameter\"?"},
      {"motion.from=0.1", "did you mean \"continuation.from\"?"},
      {"motion.plane=13",
       "found the integer 13; expected one of \"13\", \"23\", \"123\"; in quotes: "
       "--set 'motion.plane=\"13\"'"},
      {"continuation.step=1e-300",
       "continuation.step: found 1e-300; expected a number from 1e-12 to 0.5"},
      {"continuation.parameter=\"gravity.g\"", "the case has no gravity.g to begin with"},
      {"potential.fibre={k=1.0,degrees=1e7}",
       "numbers from -1e+06 to 1e+06; beyond, a number hardly tells one direction from another"},
      {"output.uncertainty={\"body.J.1\"=-1}",
       "found \"body.J.1\" = the integer -1; expected a standard uncertainty > 0"},
      {"solve.box=[1,2,3,4]", "lambda, mu and rho"}};
  for (const auto& each : all) {
    const Outcome outcome = run_program({"check", shipped("fold.toml"), "--set", each.set});
    EXPECT_EQ(outcome.code, 2) << each.set;
    EXPECT_THAT(outcome.err, HasSubstr(each.said)) << each.set;
  }
}

TEST(CaseFile, AFaultIsToldOnce) {
  // Without the tables that a case has, or with two models that are none.
  const std::map<std::string, std::size_t> several{{"control_characters", 4U},
                                                   {"body_no_table", 3U},
                                                   {"title_number", 4U},
                                                   {"model_not_a_table", 2U}};
  const TemporaryDirectory directory;
  for (const Malformed& each : malformed_cases()) {
    directory.file("case.toml", each.text);
    const Outcome outcome =
        run_program({"solve", "case.toml", "-o", "table.csv"}, {.directory = directory.path()});
    const auto at = several.find(each.name);
    EXPECT_EQ(lines_of(outcome.err).size(), at == several.end() ? 1U : at->second)
        << each.name << "\n"
        << outcome.err;
  }
}

}  // namespace
}  // namespace stationary::testing
