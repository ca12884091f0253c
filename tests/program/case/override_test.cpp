// --set: applied in order, before validation, and named in messages instead of a place in the file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

class Override : public ::testing::Test {
 protected:
  Outcome check(const std::vector<std::string>& overrides) { return run("check", overrides); }
  Outcome run(const std::string& command, const std::vector<std::string>& overrides) {
    std::vector<std::string> arguments{command, case_file_};
    for (const std::string& each : overrides) {
      arguments.emplace_back("--set");
      arguments.push_back(each);
    }
    return run_program(arguments);
  }
  void expect_refused(const std::string& text, const std::vector<const char*>& fragments) {
    const Outcome outcome = check({text});
    EXPECT_EQ(outcome.code, 2) << text;
    EXPECT_THAT(outcome.err, HasSubstr("--set " + text));
    for (const char* fragment : fragments) EXPECT_THAT(outcome.err, HasSubstr(fragment));
  }

  TemporaryDirectory directory_;
  std::string case_file_ = directory_.file("case.toml", good_case);
};

TEST_F(Override, OfNumbersTextsArraysAndElements) {
  const Outcome outcome = check({"motion.nu=0.25", "motion.branch=iii", "body.J.1=2.5",
                                 "solve.start=[0, 1, 2, 3]", "title = Something else"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("branch (iii), nu = (0, 0, 0.25)"));
  EXPECT_THAT(outcome.out, HasSubstr("J = (1, 2.5, 0.6)"));
  EXPECT_THAT(outcome.out, HasSubstr("(0, 1, 2, 3)"));
  EXPECT_THAT(outcome.out, HasSubstr("Something else"));
}

TEST_F(Override, TheLastOneCounts) {
  const Outcome outcome = check({"motion.nu=0.25", "motion.nu=0.125"});
  EXPECT_THAT(outcome.out, HasSubstr("nu = (0.125, 0, 0)"));
  EXPECT_THAT(outcome.out, HasSubstr("motion.nu by --set motion.nu=0.125"));
}

/// What was said of a part of a table that another replaces is not in force.
TEST_F(Override, OfATableAfterOneOfItsKeys) {
  const Outcome outcome = check({"motion.nu=0.3", "motion={ branch = \"ii\", nu = 0.7 }"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("nu = (0, 0.7, 0)"));
  EXPECT_EQ(outcome.out.find("--set motion.nu=0.3"), std::string::npos) << outcome.out;
}

/// Points in a text are no parts of a key, and a path is a text.
TEST_F(Override, OfTextsWithPoints) {
  const Outcome title = check({"title=Wait...................."});
  EXPECT_EQ(title.code, 0) << title.err;
  EXPECT_THAT(title.out, HasSubstr("Wait...................."));
  std::string sum = "rho^2";
  for (int k = 0; k < 20; ++k) sum += "+0.5*rho^2";
  const Outcome formula = check(
      {"potential.thickness={ expression = \"rho\" }", "potential.thickness.expression=" + sum});
  EXPECT_EQ(formula.code, 0) << formula.err;
  const Outcome path = run("continue", {"continuation.start_row=../none.csv:5"});
  EXPECT_EQ(path.code, 2);
  EXPECT_THAT(path.err, HasSubstr("none.csv"));
}

TEST_F(Override, OfAWholeTable) {
  const Outcome outcome =
      check({"potential.plane={ model = \"biot\", mu = 2, lambda = 3 }", "potential.plane.mu=4"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("biot: mu = 4, lambda = 3"));
}

TEST_F(Override, OfAnotherWholeArrayAfterAnElement) {
  const Outcome outcome = check({"body.J.0=-1", "body.J=[3, 2, 1]"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("J = (3, 2, 1)"));
}

TEST_F(Override, MakesAWrongFileRight) {
  case_file_ = directory_.file("case.toml", std::string(good_case) + "[solve]\nmethod = \"x\"\n");
  EXPECT_EQ(check({}).code, 2);
  EXPECT_EQ(check({"solve.method=newton"}).code, 0);
}

TEST_F(Override, ReachesTheMetadata) {
  const std::string table = directory_ / "t.csv";
  const Outcome outcome =
      run_program({"solve", case_file_, "--set", "motion.nu=0.25", "-o", table});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto metadata = nlohmann::json::parse(text_of(directory_ / "t.meta.json"));
  EXPECT_EQ(metadata["case"]["motion"]["nu"], 0.25);
  EXPECT_EQ(metadata["overrides"]["motion.nu"], "--set motion.nu=0.25");
}

TEST_F(Override, ThatIsWrongNamesItself) {
  expect_refused("motion.nu=fast", {"motion.nu: found the string \"fast\"", "a finite number"});
  expect_refused("motion.nu=nan", {"found the number nan"});
  expect_refused("motoin.nu=1", {"did you mean \"motion\"?"});
  expect_refused("motion.mu=1", {"motion.mu: found an unknown key", "did you mean \"nu\"?"});
  expect_refused("motion.branch=iv", {"found the string \"iv\""});
  expect_refused("body.J=[1,2]", {"an array of 2 values"});
  expect_refused("body.J.3=1", {"found the index \"3\"", "from 0 to 2"});
  expect_refused("body.J.x=1", {"found the index \"x\""});
  expect_refused("body.J.0=0", {"found J1 = 0", "J1 > 0"});
  expect_refused("body.J.0.5=0", {"body.J.0 is the number 1"});
  expect_refused("title.x=1", {"title is the string \"A case\""});
  expect_refused("motion.nu", {"no \"=\""});
  expect_refused("motion..nu=1", {"an empty name"});
  expect_refused("=1", {"an empty name"});
  expect_refused("motion nu=1", {"the character \" \""});
  expect_refused("motion.nu=", {"no value"});
  expect_refused("motion.nu=[1", {"a TOML value"});
  const Outcome two = check({"motion.nu=1\nx=2"});
  EXPECT_EQ(two.code, 2);
  EXPECT_THAT(two.err, HasSubstr("found more than one value"));
  expect_refused("potential.plane.mu=-1", {"expected mu > 0"});
  expect_refused("motion.branch=oblique", {"isotropic potential", "directions of its own"});
}

TEST_F(Override, OptionWithoutAValue) {
  const Outcome outcome = run_program({"check", case_file_, "--set"});
  EXPECT_EQ(outcome.code, 2);
}

/// Trees of tables are recursive: what nests deeply is refused before there is one.
TEST_F(Override, DepthIsLimited) {
  std::string key = "a";
  std::string value = "1";
  for (int k = 0; k < 20000; ++k) key += ".a";
  for (int k = 0; k < 20000; ++k) value = "[" + value + "]";
  const Outcome parts = run_program({"solve", case_file_, "--set", key + "=1"});
  EXPECT_EQ(parts.code, 2);
  EXPECT_THAT(parts.err, HasSubstr("found a key of 20001 parts; expected at most 16"));
  for (const std::string& each : {value, "{ " + key + " = 1 }"}) {
    const Outcome deep = run_program({"solve", case_file_, "--set", "solve.start=" + each});
    EXPECT_EQ(deep.code, 2);
    EXPECT_THAT(deep.err, HasSubstr("nests more deeply than a case does"));
  }
}

/// The file's coefficients that the new model does not have are out of the way.
TEST_F(Override, OfAModel) {
  const Outcome other = check({"potential.plane.model=reciprocal-determinant",
                               "potential.plane.c=1.5", "potential.plane.k=2.5"});
  EXPECT_EQ(other.code, 0) << other.err;
  EXPECT_THAT(other.out, HasSubstr("reciprocal-determinant: c = 1.5, k = 2.5"));
  const Outcome same = check({"potential.plane.model=neo-hookean", "potential.plane.mu=1.5"});
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_THAT(same.out, HasSubstr("neo-hookean: mu = 1.5, lambda = 2"));
  const Outcome named_alike = check({"potential.plane.model=hencky"});
  EXPECT_EQ(named_alike.code, 0) << named_alike.err;
  EXPECT_THAT(named_alike.out, HasSubstr("hencky: mu = 1, lambda = 2"));
  const Outcome reversed = check({"potential.plane.c=1.5", "potential.plane.k=2.5",
                                  "potential.plane.model=reciprocal-determinant"});
  EXPECT_EQ(reversed.code, 0) << reversed.err;
}

TEST_F(Override, OfAModelNamesWhatIsMissing) {
  const Outcome all = check({"potential.plane.model=reciprocal-determinant"});
  EXPECT_EQ(all.code, 2);
  EXPECT_THAT(all.err,
              HasSubstr("--set potential.plane.model=reciprocal-determinant: potential.plane.c: "
                        "found no coefficients \"c\", \"k\""));
  EXPECT_THAT(all.err, HasSubstr("--set potential.plane.c=1.0"));
  const Outcome one =
      check({"potential.plane.model=reciprocal-determinant", "potential.plane.c=1.0"});
  EXPECT_EQ(one.code, 2);
  EXPECT_THAT(one.err, HasSubstr("found no coefficient \"k\""));
  // What is given with it and is none of its coefficients is still wrong.
  const Outcome wrong =
      check({"potential.plane.model=reciprocal-determinant", "potential.plane.c=1.0",
             "potential.plane.k=2.0", "potential.plane.mu=3.0"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("--set potential.plane.mu=3.0: potential.plane.mu"));
}

TEST_F(Override, OfAFormulaByAModel) {
  const std::string written = directory_.file(
      "written.toml",
      "[body]\nJ = [1.0, 1.7, 0.6]\n[potential]\n"
      "plane = { expression = \"p/2*(I1 - 2*log(d))\", p = 1.0, domain = \"d > 0\" }\n"
      "thickness = { model = \"reciprocal-quadratic\", a = 1.0, b = 3.0 }\n"
      "[motion]\nbranch = \"i\"\nnu = 0.5\n");
  ASSERT_EQ(run_program({"check", written}).code, 0) << run_program({"check", written}).err;
  const Outcome outcome =
      run_program({"check", written, "--set", "potential.plane.model=hencky", "--set",
                   "potential.plane.mu=1.0", "--set", "potential.plane.lambda=2.0"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("hencky: mu = 1, lambda = 2"));
}

/// What is written later is text of a file of metadata.
TEST_F(Override, BytesThatAreNoCharactersAreRefused) {
  const Outcome outcome = run_program({"check", shipped("fold.toml"), "--set", "title=a\xff"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("a TOML value"));
}

}  // namespace
}  // namespace stationary::testing
