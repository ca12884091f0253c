// Of a sheet that is followed to come to a motion only its ends are kept, and the events asked for.
#include <gtest/gtest.h>

#include "solver/solve/family_solve.hpp"

namespace stationary {
namespace {

Member at(double p) {
  Member out;
  out.parameter = out.nu = p;
  return out;
}

void give_rows(CurveSink& sink) {
  sink.row(at(0.0), EventType::limit);
  sink.row(at(0.1), EventType::none);
  sink.row(at(0.2), EventType::oblique);
  sink.row(at(0.3), EventType::tilt);
  sink.row(at(0.4), EventType::oblique);
  sink.row(at(0.5), EventType::escape);
}

TEST(EndSink, KeepsTheEventsAskedFor) {
  EndSink oblique(EventType::oblique);
  give_rows(oblique);
  ASSERT_EQ(oblique.events.size(), 2U);
  EXPECT_EQ(oblique.events[0].parameter, 0.2);
  EXPECT_EQ(oblique.events[1].parameter, 0.4);
  EndSink none;
  give_rows(none);
  EXPECT_TRUE(none.events.empty());
}

TEST(EndSink, AnEndIsThatOfTheRange) {
  EndSink ends;
  give_rows(ends);
  ASSERT_NE(ends.at(0.0), nullptr);
  EXPECT_EQ(ends.at(0.0)->parameter, 0.0);
  EXPECT_EQ(ends.at(0.5), nullptr);
  EXPECT_EQ(ends.at(0.1), nullptr);
  EXPECT_EQ(ends.text(), "from |nu| = 0 (limit) to 0.5 (escape)");
}

}  // namespace
}  // namespace stationary
