// Files of maps: CSV and HDF5 hold the same table, which is read back as a grid and drawn.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "solver/program/diagram/map_diagram.hpp"
#include "solver/program/plot/map_plot.hpp"
#include "solver/program/table/column_file.hpp"
#include "tests/program/mapped.hpp"
#include "tests/program/needs_gnuplot.hpp"
#include "tests/program/needs_hdf5.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class MapFile : public ::testing::Test {
 protected:
  void SetUp() override {
    NEEDS_HDF5();
    mapped({}, {"-o", csv_, "-q"});
    mapped({}, {"-o", h5_, "-q"});
  }
  Outcome plot(const std::string& table, const std::string& image,
               const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"plot", table, "-o", directory_ / image};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(arguments);
  }

  TemporaryDirectory directory_;
  std::string csv_ = directory_ / "m.csv";
  std::string h5_ = directory_ / "n.h5";
};

TEST_F(MapFile, Hdf5HoldsTheSameTable) {
  ASSERT_TRUE(is_column_file(h5_));
  EXPECT_FALSE(is_column_file(csv_));
  std::ostringstream text;
  text << column_file_table(h5_, {})->rdbuf();
  EXPECT_EQ(text.str(), text_of(csv_));
  std::ostringstream part;
  const std::vector<std::string> wanted{"status", "xi"};
  part << column_file_table(h5_, wanted)->rdbuf();
  EXPECT_TRUE(part.str().starts_with("xi,status\n1,solved\n"));
  EXPECT_EQ(nlohmann::json::parse(column_file_metadata(h5_)).at("rows"), 117);
  EXPECT_EQ(column_file_metadata(csv_), "");
}

#ifdef STATIONARY_HAS_HDF5
/// With the HDF5 library alone: a dataset a column, 64-bit numbers, words as enumerations.
TEST_F(MapFile, Hdf5IsPlain) {
  const hid_t file = H5Fopen(h5_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  const hid_t xi = H5Dopen2(file, "xi", H5P_DEFAULT);
  std::vector<double> values(117);
  ASSERT_GE(H5Dread(xi, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  EXPECT_EQ(values[0], 1.0);
  EXPECT_TRUE(std::isnan(values[116]));
  const hid_t verdict = H5Dopen2(file, "class", H5P_DEFAULT);
  const hid_t type = H5Dget_type(verdict);
  EXPECT_EQ(H5Tget_class(type), H5T_ENUM);
  EXPECT_EQ(H5Tget_size(type), 1U);
  // Whole numbers have another one in the place of NaN, and say which.
  const hid_t krein = H5Dopen2(file, "krein1", H5P_DEFAULT);
  std::vector<std::int32_t> signs(117);
  ASSERT_GE(H5Dread(krein, H5T_NATIVE_INT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, signs.data()), 0);
  const hid_t attribute = H5Aopen(krein, "_FillValue", H5P_DEFAULT);
  ASSERT_GE(attribute, 0);
  std::int32_t missing = 0;
  ASSERT_GE(H5Aread(attribute, H5T_NATIVE_INT32, &missing), 0);
  EXPECT_EQ(missing, -2147483647 - 1);
  EXPECT_EQ(signs[116], missing);
  EXPECT_NE(signs[0], missing);
  H5Aclose(attribute);
  H5Dclose(krein);
  EXPECT_LE(H5Aexists_by_name(file, "xi", "_FillValue", H5P_DEFAULT), 0);
  EXPECT_GT(H5Aexists(file, "metadata"), 0);
  EXPECT_GT(H5Lexists(file, "body.J.1", H5P_DEFAULT), 0);
  H5Tclose(type);
  H5Dclose(verdict);
  H5Dclose(xi);
  H5Fclose(file);
}
#endif

TEST_F(MapFile, IsDrawnTheSameFromEither) {
  NEEDS_GNUPLOT();
  EXPECT_EQ(plot(csv_, "a.svg", {"--title", "t"}).out,
            directory_ / "a.svg" + ": 13 by 9 cells, class\n");
  EXPECT_EQ(plot(h5_, "b.svg", {"--title", "t"}).code, 0);
  EXPECT_EQ(text_of(directory_ / "a.svg"), text_of(directory_ / "b.svg"));
  EXPECT_THAT(text_of(directory_ / "a.svg"),
              AllOf(HasSubstr("elliptic"), HasSubstr("unstable"), HasSubstr("J₂"), HasSubstr("ν"),
                    HasSubstr("image-rendering:pixelated")));
  EXPECT_EQ(plot(h5_, "c.png", {"--show", "growth", "-q"}).out, "");
  EXPECT_GT(std::filesystem::file_size(directory_ / "c.png"), 1000U);
  const Outcome titled = plot(h5_, "d.svg");
  EXPECT_THAT(text_of(directory_ / "d.svg"), HasSubstr("Biot-log bodies"));
}

TEST_F(MapFile, WhatCannotBeShownIsRefused) {
  const Outcome unknown = plot(csv_, "a.svg", {"--show", "growht"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("--show growht: found no such column"));
  EXPECT_THAT(unknown.err, HasSubstr("did you mean \"growth\"?"));
  const std::string curve = directory_.file("c.csv", "branch,nu1,rho\ni,0.5,1\ni,0.6,1.1\n");
  if (has_gnuplot()) {
    EXPECT_EQ(plot(curve, "a.svg", {"--show", "rho"}).code, 0);
  }
  const std::string broken = directory_.file("x.h5", text_of(h5_).substr(0, 700));
  EXPECT_EQ(plot(broken, "a.svg").code, 2);
}

TEST_F(MapFile, OneParameterIsACurve) {
  NEEDS_GNUPLOT();
  const std::string table = directory_ / "curve.h5";
  const Outcome made =
      run_program({"map", STATIONARY_CASES "/disc.toml", "--set",
                   "map.x={parameter=\"nu\",from=0.0,to=1.0,count=50}", "-o", table});
  ASSERT_EQ(made.code, 0) << made.err;
  const Outcome drawn = plot(table, "curve.svg");
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_THAT(text_of(directory_ / "curve.svg"),
              AllOf(HasSubstr("principal stretch"), HasSubstr("ν")));
}

MapDiagram diagram_of(const std::string& csv, const std::optional<std::string>& quantity = {}) {
  TableReader table(std::make_unique<std::istringstream>(csv), "x.csv");
  return read_map_diagram(table, quantity);
}

TEST(MapDiagram, GridFromTheRows) {
  const MapDiagram diagram = diagram_of(
      "xi,class,status,nu,body.J.0\n1,stable,solved,0,1\n,,not-found,0.5,1\n"
      "2,unstable,solved,0,10\n,,none-exists,0.5,10\n3,stable,solved,0,100\n");
  EXPECT_EQ(diagram.x.parameter, "nu");
  EXPECT_EQ(diagram.x.scale, AxisScale::linear);
  EXPECT_EQ(diagram.y.scale, AxisScale::log);
  EXPECT_EQ(diagram.quantity, "class");
  EXPECT_EQ(diagram.values[2], 2.0);
  EXPECT_EQ(diagram.statuses[1], CellStatus::not_found);
  EXPECT_EQ(diagram.statuses[3], CellStatus::none_exists);
  EXPECT_FALSE(diagram.statuses[5].has_value()) << "interrupted before it";
  const std::string script = gnuplot_script(diagram, ImageFormat::svg, "Title");
  EXPECT_THAT(script, AllOf(HasSubstr("$codes << END_OF_DATA\n0 7 \n2 6 \n0 5 \n"),
                            HasSubstr("title 'not found'"), Not(HasSubstr("title 'failed'"))));
  const std::string numbers =
      gnuplot_script(diagram_of("xi,status,nu,body.J.0\n1,solved,0,1\n,not-found,0.5,1\n100,solved,"
                                "0,2\n60,solved,0.5,2\n"),
                     ImageFormat::svg, "");
  EXPECT_THAT(numbers, AllOf(HasSubstr("$numbers << END_OF_DATA\n1 NaN \n100 60 \n"),
                             HasSubstr("set logscale cb")));
}

TEST(MapDiagram, RefusesARangeThatLogarithmsDoNotHave) {
  const TemporaryDirectory directory;
  const std::string table = directory.file(
      "m.csv",
      "xi,status,nu,body.J.0\n1,solved,0,1\n2,solved,1,1\n1,solved,0,10\n2,solved,1,10\n"
      "3,solved,0,100\n2,solved,1,100\n");
  for (const char* const range : {"y=0:1", "y=-1:10"}) {
    const Outcome outcome =
        run_program({"plot", table, "-o", directory / "m.svg", "--range", range});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("LOW > 0 on a logarithmic axis"));
  }
}

TEST(MapDiagram, WhatIsNoGridIsRefused) {
  const auto refused = [](const std::string& csv, const std::string& why) {
    try {
      diagram_of(csv);
      ADD_FAILURE() << "accepted: " << csv;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(why));
    }
  };
  refused("xi,status,nu,body.J.0\n", "found no rows");
  refused("xi,status,nu,body.J.0\n1,solved,0,1\n1,solved,0.1,1\n1,solved,0.5,1\n", "no grid's");
  refused("xi,status,nu,body.J.0\n1,well,0,1\n", "expected solved, none-exists");
  refused("class,status,nu,body.J.0\nbad,solved,0,1\n", "expected stable, elliptic");
  refused("xi,status,nu,body.J.0\n1,solved,,1\n", "expected a number between");
  refused("xi,status,nu,body.J.0\n1,solved,-1e308,1\n1,solved,1e308,1\n", "between -4e307 and");
}

}  // namespace
}  // namespace stationary::testing
