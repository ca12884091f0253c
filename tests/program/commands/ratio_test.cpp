// Ratios of two numbers as the parameter of `continue` and of `map`: the same motions as with the first
// number alone, the second held, under another name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "solver/program/table/column_file.hpp"
#include "tests/program/json_schema.hpp"
#include "tests/program/needs_hdf5.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using nlohmann::json;
using ::testing::EndsWith;
using ::testing::HasSubstr;

constexpr const char* ratio = "body.J.1/body.J.0";

std::vector<std::string> with(std::vector<std::string> arguments,
                              const std::vector<std::string>& set) {
  for (const std::string& each : set) {
    arguments.emplace_back("--set");
    arguments.push_back(each);
  }
  return arguments;
}

/// J1 = 2, so that every quotient is exact.
const std::vector<std::string> by_number{"body.J=[2.0, 1.2, 0.6]", "continuation.from=0.6",
                                         "continuation.to=3.0"};
const std::vector<std::string> by_ratio{"body.J=[2.0, 1.2, 0.6]",
                                        "continuation.parameter=\"body.J.1/body.J.0\"",
                                        "continuation.from=0.3", "continuation.to=1.5"};

class Ratio : public ::testing::Test {
 protected:
  json metadata() const { return json::parse(text_of(directory_ / "x.meta.json")); }
  Outcome follow(const std::vector<std::string>& set,
                 const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"continue", shipped("inertia.toml"), "-o", table_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(with(arguments, set));
  }
  TemporaryDirectory directory_;
  std::string table_ = directory_ / "x.csv";
};

TEST_F(Ratio, FollowsTheSameMotions) {
  ASSERT_EQ(follow(by_number).code, 0);
  auto expected = rows_of(text_of(table_));
  const json numbers = metadata();
  ASSERT_EQ(follow(by_ratio).code, 0);
  const auto found = rows_of(text_of(table_));
  const json ratios = metadata();
  EXPECT_THAT(std::string(header_of(text_of(table_))), EndsWith(",body.J.1/body.J.0"));
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(number(found[k].at(ratio)), 0.5 * number(expected[k].at("body.J.1")));
    for (const auto& [column, cell] : expected[k]) {
      if (column != "body.J.1") {
        EXPECT_EQ(found[k].at(column), cell) << column;
      }
    }
  }
  ASSERT_EQ(ratios["events"].size(), numbers["events"].size());
  ASSERT_FALSE(numbers["events"].empty());
  for (std::size_t k = 0; k < numbers["events"].size(); ++k) {
    const json& of_number = numbers["events"][k];
    const json& of_ratio = ratios["events"][k];
    EXPECT_EQ(of_ratio["event"], of_number["event"]);
    EXPECT_EQ(of_ratio["point"], of_number["point"]);
    EXPECT_EQ(of_ratio["parameter"].get<double>(), 0.5 * of_number["parameter"].get<double>());
    const auto least = [](const json& each) {
      return std::min(each["bracket"][0].get<double>(), each["bracket"][1].get<double>());
    };
    const auto most = [](const json& each) {
      return std::max(each["bracket"][0].get<double>(), each["bracket"][1].get<double>());
    };
    EXPECT_LE(least(of_ratio), 0.5 * least(of_number));
    EXPECT_GE(most(of_ratio), 0.5 * most(of_number));
    EXPECT_NEAR(least(of_ratio), 0.5 * least(of_number), 1e-15);
  }
  ASSERT_EQ(ratios["segments"].size(), numbers["segments"].size());
  for (std::size_t k = 0; k < numbers["segments"].size(); ++k)
    EXPECT_EQ(ratios["segments"][k]["to"]["parameter"].get<double>(),
              0.5 * numbers["segments"][k]["to"]["parameter"].get<double>());
  EXPECT_EQ(ratios["ends"][1]["parameter"], 1.5);
  EXPECT_EQ(schema_fault(ratios, json::parse(text_of(STATIONARY_SCHEMA))), "");
  EXPECT_THAT(ratios["plan"].dump(), HasSubstr("body.J.1 varies, body.J.0 = 2 is held"));
}

TEST_F(Ratio, IsGoneOnWith) {
  ASSERT_EQ(follow(by_ratio).code, 0);
  const auto whole = rows_of(text_of(table_));
  ASSERT_EQ(follow(by_ratio, {"--set", "continuation.max_points=12"}).code, 0);
  const auto part = rows_of(text_of(table_));
  ASSERT_LT(part.size(), whole.size());
  ASSERT_EQ(follow(by_ratio, {"--resume"}).code, 0);
  const auto found = rows_of(text_of(table_));
  EXPECT_NEAR(static_cast<double>(found.size()), static_cast<double>(whole.size()), 8.0);
  EXPECT_EQ(found.front().at(ratio), "0.3");
  EXPECT_EQ(found.back().at(ratio), "1.5");
  for (std::size_t k = 1; k < found.size(); ++k)
    EXPECT_GT(number(found[k].at(ratio)), number(found[k - 1].at(ratio)));
  const auto event = [](const std::vector<Row>& rows) {
    for (const Row& row : rows)
      if (row.at("event") == "oblique") return number(row.at(ratio));
    return 0.0;
  };
  EXPECT_GT(event(whole), 0.0);
  EXPECT_NEAR(event(found), event(whole), 1e-12);
}

TEST_F(Ratio, ARowGivesItsNumber) {
  ASSERT_EQ(follow(by_ratio).code, 0);
  const auto rows = rows_of(text_of(table_));
  const Row& row = rows[rows.size() / 2];
  const Outcome outcome = run_program(
      with({"continue", shipped("inertia.toml"), "--from",
            table_ + ":" + std::to_string(rows.size() / 2 + 1), "-o", directory_ / "y.csv"},
           {"body.J=[2.0, 1.2, 0.6]", "continuation.parameter=nu", "continuation.from=0.4",
            "continuation.to=0.6"}));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json told = json::parse(text_of(directory_ / "y.meta.json"));
  EXPECT_EQ(told["case"]["body"]["J"][1].get<double>(), 2.0 * number(row.at(ratio)));
}

/// Of a cell whose x is divided by what y varies: that comes first, in whichever order the columns stand.
TEST_F(Ratio, ACellOfChainedRatiosGivesItsNumbers) {
  const auto axis = [](const char* parameter, const char* from, const char* to) {
    return "={parameter=\"" + std::string(parameter) + "\",from=" + from + ",to=" + to +
           ",count=2}";
  };
  for (const bool swapped : {false, true}) {
    const std::string first = axis("body.J.0/body.J.1", "0.5", "0.75");
    const std::string second = axis("body.J.1/body.J.2", "2", "3");
    ASSERT_EQ(run_program(with({"map", shipped("disc.toml"), "-o", table_},
                               {"body.J=[1.25, 1.7, 0.5]", "map.x" + (swapped ? second : first),
                                "map.y" + (swapped ? first : second)}))
                  .code,
              0);
    const auto rows = rows_of(text_of(table_));
    for (std::size_t k = 0; k < rows.size(); ++k) {
      ASSERT_EQ(run_program(with({"continue", shipped("disc.toml"), "--from",
                                  table_ + ":" + std::to_string(k + 1), "-o", directory_ / "y.csv"},
                                 {"body.J=[1.25, 1.7, 0.5]"}))
                    .code,
                0);
      const json J = json::parse(text_of(directory_ / "y.meta.json"))["case"]["body"]["J"];
      const double second_J = 0.5 * number(rows[k].at("body.J.1/body.J.2"));
      EXPECT_EQ(J, json({number(rows[k].at("body.J.0/body.J.1")) * second_J, second_J, 0.5}));
    }
  }
}

TEST_F(Ratio, IsProven) {
  ASSERT_EQ(follow(by_ratio, {"--certify"}).code, 0);
  for (const Row& row : rows_of(text_of(table_))) EXPECT_EQ(row.at("certified"), "yes");
  const json found = metadata();
  std::size_t enclosed = 0;
  for (const json& event : found["events"]) {
    if (!event.contains("enclosure")) continue;
    ++enclosed;
    EXPECT_LE(event["enclosure"][0].get<double>(), event["parameter"].get<double>());
    EXPECT_GE(event["enclosure"][1].get<double>(), event["parameter"].get<double>());
  }
  EXPECT_GE(enclosed, 1U);
}

#ifdef STATIONARY_HAS_HDF5
TEST_F(Ratio, ColumnFileHasItInAGroup) {
  const std::string file = directory_ / "x.h5";
  ASSERT_EQ(run_program(with({"continue", shipped("inertia.toml"), "-o", file}, by_ratio)).code, 0);
  ASSERT_EQ(follow(by_ratio).code, 0);
  const auto stream = column_file_table(file, {});
  const auto found = rows_of({std::istreambuf_iterator<char>(*stream), {}});
  EXPECT_EQ(found, rows_of(text_of(table_)));
  // As little as the file does the group remember when it was made: the same bytes at any time.
  const Handle read(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const Handle group(H5Gopen2(read.id(), "body.J.1", H5P_DEFAULT), H5Gclose);
  ASSERT_TRUE(group.valid());
  const Handle how(H5Gget_create_plist(group.id()), H5Pclose);
  hbool_t times = true;
  ASSERT_GE(H5Pget_obj_track_times(how.id(), &times), 0);
  EXPECT_FALSE(times);
}
#endif

TEST_F(Ratio, WhatIsNone) {
  const auto refused = [&](const std::string& parameter, const std::string& words) {
    const Outcome outcome = follow({"continuation.parameter=\"" + parameter + "\""});
    EXPECT_EQ(outcome.code, 2) << parameter;
    EXPECT_THAT(outcome.err, HasSubstr(words)) << parameter;
  };
  refused("body.J.1/body.J.1", "two different numbers");
  refused("body.J.1/body.J.7", "or a ratio");
  refused("body.J.1/", "or a ratio");
  refused("/body.J.0", "or a ratio");
  refused("body.J.1/body.J.0/body.J.2", "or a ratio");
  EXPECT_THAT(follow({"continuation.parameter=\"body.J.0/nu\"", "motion.nu=0.0"}).err,
              HasSubstr("nu > 0"));
}

/// Each cell is the solve with the two numbers that it stands for.
TEST(MapRatio, CellsAreSolvesOfTheirOwn) {
  struct Asked {
    const char* x;
    const char* y;
    std::vector<std::string> (*set)(double x, double y);
  };
  const auto text = [](double value) { return json(value).dump(); };
  static const auto number_text = text;
  const Asked all[] = {{"body.J.1/body.J.0", "nu",
                        [](double x, double y) {
                          return std::vector<std::string>{"body.J.1=" + number_text(x * 1.25),
                                                          "motion.nu=" + number_text(y)};
                        }},
                       {"body.J.1/body.J.0", "body.J.0",
                        [](double x, double y) {
                          return std::vector<std::string>{"body.J.0=" + number_text(y),
                                                          "body.J.1=" + number_text(x * y)};
                        }},
                       {"body.J.0", "body.J.1/body.J.0",
                        [](double x, double y) {
                          return std::vector<std::string>{"body.J.0=" + number_text(x),
                                                          "body.J.1=" + number_text(y * x)};
                        }},
                       {"body.J.0/body.J.1", "body.J.1/body.J.2",
                        [](double x, double y) {
                          return std::vector<std::string>{"body.J.1=" + number_text(y * 0.6),
                                                          "body.J.0=" + number_text(x * (y * 0.6))};
                        }},
                       {"nu/body.J.0", "body.J.0",
                        [](double x, double y) {
                          return std::vector<std::string>{"body.J.0=" + number_text(y),
                                                          "motion.nu=" + number_text(x * y)};
                        }},
                       {"nu/body.J.0", "body.J.1", [](double x, double y) {
                          return std::vector<std::string>{"motion.nu=" + number_text(x * 1.25),
                                                          "body.J.1=" + number_text(y)};
                        }}};
  for (const Asked& each : all) {
    const auto axis = [](const std::string& parameter, const char* from, const char* to) {
      return "={parameter=\"" + parameter + "\",from=" + from + ",to=" + to + ",count=3}";
    };
    const std::vector<std::string> body{"body.J=[1.25, 1.7, 0.6]"};
    const Outcome outcome = run_program(with(
        {"map", shipped("disc.toml"), "-o", "-"},
        {body[0], "map.x" + axis(each.x, "0.25", "0.5"), "map.y" + axis(each.y, "0.5", "0.75")}));
    ASSERT_EQ(outcome.code, 0) << each.x << " " << outcome.err;
    const auto rows = rows_of(outcome.out);
    ASSERT_EQ(rows.size(), 9U);
    for (const Row& row : rows) {
      std::vector<std::string> set = body;
      for (const std::string& one : each.set(number(row.at(each.x)), number(row.at(each.y))))
        set.push_back(one);
      const Row alone =
          only_row(run_program(with({"solve", shipped("disc.toml"), "-o", "-"}, set)).out);
      for (const char* column : {"xi", "zeta", "rho", "nu1", "energy"})
        EXPECT_NEAR(number(row.at(column)), number(alone.at(column)),
                    1e-13 * std::abs(number(alone.at(column))))
            << each.x << " " << each.y << " " << column;
      EXPECT_EQ(row.at("class"), alone.at("class"));
    }
  }
}

TEST(MapRatio, NumbersThatTwoAxesVary) {
  const auto refused = [](const std::string& x, const std::string& y, const std::string& words) {
    const auto axis = [](const std::string& parameter) {
      return "={parameter=\"" + parameter + "\",from=0.5,to=0.75,count=2}";
    };
    const Outcome outcome =
        run_program(with({"map", shipped("disc.toml")}, {"map.x" + axis(x), "map.y" + axis(y)}));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr(words));
  };
  refused("body.J.1/body.J.0", "body.J.1", "which is x's too");
  refused("body.J.1/body.J.0", "body.J.1/body.J.2", "which is x's too");
  refused("body.J.1/body.J.0", "body.J.0/body.J.1", "each divided by the other");
}

}  // namespace
}  // namespace stationary::testing
