// The rooms of lib/ and solver/ and the direction of what they include: a file may include files of
// its own room and of rooms that stand before it in the list below, never of one after it. So there
// is no circle between rooms either.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stationary {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// From the ground up.
constexpr std::string_view rooms[] = {
    "lib/number",
    "lib/matrix",
    "lib/body",
    "lib/gravity",
    "lib/expression",
    "lib/tape",
    "lib/formula",
    "lib/material/models",
    "lib/material/gravitating",
    "lib/material",
    "lib/balance",
    "lib/leaf",
    "lib/stability",
    "lib/balanced",
    "solver/newton",
    "solver/motion",
    "solver/continuation",
    "solver/proof",
    "solver/family",
    "solver/normal_form",
    "solver/search",
    "solver/tube",
    "solver/solve",
    "solver/event_curve",
    "solver/kind",
    "solver/atlas",
    "solver/batch",
    "solver/batch_spectrum",
    "solver/program/text",
    "solver/program/table",
    "solver/program/case",
    "solver/program/rows",
    "solver/program/diagram",
    "solver/program/plot",
    "solver/program/explore",
    "solver/program/session",
    "solver/program/tiles",
    "solver/program/computation",
    "solver/program/commands",
};

/// The place of a file's room in the list; nothing for a file of none.
std::optional<std::size_t> room_of(std::string_view path) {
  const std::string_view folder = path.substr(0, path.rfind('/'));
  const auto at = std::ranges::find(rooms, folder);
  if (at == std::end(rooms)) return std::nullopt;
  return static_cast<std::size_t>(at - std::begin(rooms));
}

struct Source {
  std::string path;
  std::string text;
};

/// Of lib/ and solver/, their paths from the top.
std::vector<Source> sources() {
  namespace fs = std::filesystem;
  const fs::path top = STATIONARY_SOURCES;
  std::vector<Source> out;
  for (const char* part : {"lib", "solver"}) {
    for (const auto& entry : fs::recursive_directory_iterator(top / part)) {
      const fs::path& path = entry.path();
      if (path.extension() != ".hpp" && path.extension() != ".cpp") continue;
      std::ifstream file(path);
      out.push_back({fs::relative(path, top).generic_string(),
                     {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()}});
    }
  }
  return out;
}

/// The files of this project that a source includes.
std::vector<std::string> includes_of(const Source& source) {
  constexpr std::string_view start = "#include \"";
  std::vector<std::string> out;
  for (std::size_t at = source.text.find(start); at != std::string::npos;
       at = source.text.find(start, at + 1)) {
    const std::size_t begin = at + start.size();
    out.push_back(source.text.substr(begin, source.text.find('"', begin) - begin));
  }
  return out;
}

/// What breaks the rule, a line each.
std::vector<std::string> faults(const std::vector<Source>& all) {
  std::vector<std::string> out;
  for (const Source& source : all) {
    const auto from = room_of(source.path);
    if (!from) {
      out.push_back(source.path + " is in no room");
      continue;
    }
    for (const std::string& included : includes_of(source)) {
      const auto to = room_of(included);
      if (!to) {
        out.push_back(source.path + " includes " + included + ", which is in no room");
      } else if (*to > *from) {
        out.push_back(source.path + " includes " + included + ", upwards");
      }
    }
  }
  return out;
}

/// Where a motion's own type may be asked for: the kinds themselves, and what reads and names the
/// motion of a case. map_grid is the batch of one kind.
constexpr std::string_view rooms_of_kinds[] = {"solver/kind/", "solver/program/case/",
                                               "lib/body/motion.hpp",
                                               "solver/program/rows/map_grid.cpp"};

/// The sources that ask which kind a motion is, by its type or by its name.
std::vector<std::string> asking(const std::vector<Source>& all) {
  std::vector<std::string> out;
  for (const Source& source : all) {
    const auto allowed = [&](std::string_view start) { return source.path.starts_with(start); };
    if (std::ranges::any_of(rooms_of_kinds, allowed)) continue;
    for (const char* kind : {"AxisRotation", "TiltedMotion", "ObliqueRotation", "TwoPolarMotion"})
      for (const char* question : {"get<", "get_if<", "holds_alternative<"})
        if (source.text.find(std::string(question) + kind + ">") != std::string::npos)
          out.push_back(source.path + " asks for " + kind);
    for (const char* kind : {"tilted_name", "oblique_name", "two_polar_name", "\"tilted\"",
                             "\"oblique\"", "\"two-polar\""})
      for (const char* question : {"== ", "!= "})
        if (source.text.find(std::string(question) + kind) != std::string::npos)
          out.push_back(source.path + " asks for " + kind);
  }
  return out;
}

TEST(Rooms, NothingOutsideAKindAsksWhichItIs) {
  EXPECT_THAT(asking(sources()), IsEmpty());
  EXPECT_THAT(asking({{"solver/atlas/a.cpp", "std::get_if<TiltedMotion>(&motion)"}}),
              ElementsAre(HasSubstr("asks for TiltedMotion")));
  EXPECT_THAT(asking({{"solver/atlas/a.cpp", "if (name(motion) == tilted_name) return;"}}),
              ElementsAre(HasSubstr("asks for tilted_name")));
}

/// The sources that name a processor's instructions outside the one header that may.
std::vector<std::string> naming_instructions(const std::vector<Source>& all) {
  std::vector<std::string> out;
  for (const Source& source : all) {
    if (source.path == "lib/number/simd_pack.hpp") continue;
    for (const char* each : {"intrin.h", "arm_neon.h", "_mm_", "_mm256_", "_mm512_", "__m128",
                             "__m256", "__m512", "__builtin_ia32_", "__asm"})
      if (source.text.find(each) != std::string::npos)
        out.push_back(source.path + " names " + each);
  }
  return out;
}

TEST(Rooms, OneHeaderNamesAProcessorsInstructions) {
  EXPECT_THAT(naming_instructions(sources()), IsEmpty());
  EXPECT_THAT(naming_instructions({{"solver/batch/a.cpp", "#include <immintrin.h>\n"}}),
              ElementsAre(HasSubstr("intrin.h")));
}

TEST(Rooms, EveryFileIsInOneAndIncludesNothingAbove) {
  const auto all = sources();
  ASSERT_GT(all.size(), 300U);
  EXPECT_THAT(faults(all), IsEmpty());
}

TEST(Rooms, HaveFiveToTwentyFiveFiles) {
  std::map<std::size_t, int> count;
  for (const Source& source : sources())
    if (const auto room = room_of(source.path)) ++count[*room];
  for (std::size_t room = 0; room < std::size(rooms); ++room) {
    EXPECT_GE(count[room], 5) << rooms[room];
    EXPECT_LE(count[room], 25) << rooms[room];
  }
}

TEST(Rooms, AnArrowUpIsSeen) {
  EXPECT_THAT(faults({{"lib/number/a.hpp", "#pragma once\n#include \"lib/body/body.hpp\"\n"}}),
              ElementsAre(HasSubstr("upwards")));
  EXPECT_THAT(faults({{"lib/body/a.hpp", "#include \"lib/number/number.hpp\"\n"}}), IsEmpty());
  EXPECT_THAT(faults({{"solver/loose.hpp", ""}}), ElementsAre(HasSubstr("no room")));
  EXPECT_THAT(faults({{"lib/body/a.hpp", "#include \"solver/loose.hpp\"\n"}}),
              ElementsAre(HasSubstr("no room")));
}

}  // namespace
}  // namespace stationary
