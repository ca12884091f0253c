// Labels along an edge: none lies on another, each as near its event as that allows.
#include "solver/program/plot/event_labels.hpp"

#include <gtest/gtest.h>

#include <random>

namespace stationary {
namespace {

constexpr AxisRange edge{70.0, 670.0};
constexpr double pitch = 14.0;

TEST(EventLabels, ApartTheyAreAtTheirEvents) {
  const auto labels =
      event_labels({{"tilt", 300.0}, {"escape", 670.0}, {"fold-nu", 70.0}}, edge, pitch);
  ASSERT_EQ(labels.size(), 3U);
  EXPECT_EQ(labels[0].name, "fold-nu");
  for (const EventLabel& label : labels) EXPECT_DOUBLE_EQ(label.place, label.anchor);
}

TEST(EventLabels, NeighboursStepAsideEvenly) {
  const auto labels = event_labels({{"tilt", 300.0}, {"fold-nu", 302.0}}, edge, pitch);
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_DOUBLE_EQ(labels[0].place, 301.0 - pitch / 2);
  EXPECT_DOUBLE_EQ(labels[1].place, 301.0 + pitch / 2);
}

TEST(EventLabels, EqualNeighboursShareOne) {
  const auto labels = event_labels(
      {{"hamiltonian-hopf", 300.0}, {"tilt", 300.5}, {"hamiltonian-hopf", 301.0}}, edge, pitch);
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_EQ(labels[0].count, 2);
  EXPECT_EQ(labels[1].count, 1);
}

TEST(EventLabels, NeverOneOnAnotherNorLost) {
  std::mt19937 random(7);
  const std::string names[] = {"tilt", "fold-nu", "fold-momentum", "krein-pass", "escape"};
  for (int round = 0; round < 200; ++round) {
    // Clusters, and more events than there is room for.
    std::vector<NamedPlace> events(1 + random() % 300);
    std::uniform_real_distribution<double> place(edge.low, round % 2 == 0 ? edge.high : 90.0);
    for (NamedPlace& event : events) event = {names[random() % 5], place(random)};
    const auto labels = event_labels(events, edge, pitch);
    int count = 0;
    for (std::size_t k = 0; k < labels.size(); ++k) {
      count += labels[k].count;
      EXPECT_GE(labels[k].place, edge.low - 1e-9);
      EXPECT_LE(labels[k].place, edge.high + 1e-9);
      if (k > 0) {
        EXPECT_GE(labels[k].place - labels[k - 1].place, pitch - 1e-9);
      }
    }
    EXPECT_EQ(count, static_cast<int>(events.size()));
  }
}

}  // namespace
}  // namespace stationary
