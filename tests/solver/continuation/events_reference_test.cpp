// Located events against 25-digit ones, and a pair of sheets that almost touch.
#include <gtest/gtest.h>

#include <map>

#include "tests/support/followed.hpp"
#include "tests/support/reference_table.hpp"

namespace stationary::testing {
namespace {

using support::Real50;
using support::ReferenceRow;

constexpr std::initializer_list<EventType> tabulated = {
    EventType::fold_nu, EventType::fold_momentum, EventType::tilt, EventType::hamiltonian_hopf};

struct Start {
  double nu = 0.0;
  SolveOptions options;
};

/// A point on the row's sheet.
Start start_of_sheet(const ReferenceRow& row) {
  if (row.text("sheet") == "rest") return {};
  Start out;
  out.options.method = Method::newton;
  if (row.text("model") == "neo-hookean") {
    out.nu = 0.35;
    out.options.start = Stretch{0.0, 0.9949, 1.0604, 0.6755};
  } else {
    out.nu = 1.4;
    out.options.start = Stretch{0.0, 48.91, 0.722, 0.6934};
  }
  return out;
}

/// The rows of events.csv by sheet.
std::map<std::string, std::vector<ReferenceRow>> sheets() {
  std::map<std::string, std::vector<ReferenceRow>> out;
  for (const ReferenceRow& row : support::reference_table("events.csv")) {
    std::string key;
    for (const char* column : {"model", "p1", "p2", "a", "b", "J1", "J2", "J3", "branch", "sheet"})
      key += row.text(column) + " ";
    out[key].push_back(row);
  }
  return out;
}

bool in_the_tables_range(const Stretch& q) {
  return std::min({q.xi, q.zeta, q.rho}) > 0.005 && std::max({q.xi, q.zeta, q.rho}) < 60.0;
}

double relative_difference(double actual, const Real50& exact) {
  return std::abs(support::nearest(Real50((Real50(actual) - exact) / exact)));
}

class EventsReferenceTest : public ::testing::TestWithParam<double> {};

TEST_P(EventsReferenceTest, EveryRowFoundAndNoOther) {
  const double tolerance = GetParam();
  int found = 0;
  for (const auto& [key, rows] : sheets()) {
    const Problem problem(rows[0].body(), rows[0].potential(), rows[0].branch());
    const Start start = start_of_sheet(rows[0]);
    const Followed sheet =
        followed(problem, start.nu, range(0.0, 2.0, tolerance), true, start.options);
    std::vector<FollowedRow> events = sheet.events(tabulated);
    std::erase_if(events, [](const auto& e) { return !in_the_tables_range(e.member.q); });
    ASSERT_EQ(events.size(), rows.size()) << key << ": " << sheet.text();
    for (const ReferenceRow& row : rows) {
      const Real50 nu = row.number<Real50>("nu");
      const auto near = std::ranges::min_element(events, {}, [&](const FollowedRow& event) {
        const double wrong = name(event.event) == row.text("event") ? 0.0 : 1.0;
        return wrong + relative_difference(event.member.nu, nu);
      });
      ASSERT_EQ(name(near->event), row.text("event")) << key << sheet.text();
      const Member& at = near->member;
      EXPECT_LE(relative_difference(at.nu, nu), 1e-14) << key << name(near->event);
      EXPECT_LE(at.error_bound, 1e-9) << key << name(near->event);
      EXPECT_LE(relative_difference(at.q.xi, row.number<Real50>("xi")), at.error_bound) << key;
      EXPECT_LE(relative_difference(at.q.zeta, row.number<Real50>("zeta")), at.error_bound) << key;
      EXPECT_LE(relative_difference(at.q.rho, row.number<Real50>("rho")), at.error_bound) << key;
      EXPECT_LE(at.residual, 1e-14) << key;
      ++found;
    }
  }
  EXPECT_EQ(found, 12);
}

INSTANTIATE_TEST_SUITE_P(Tolerances, EventsReferenceTest,
                         ::testing::Values(1e-3, 1e-5, 1e-8, 1e-10), [](const auto& info) {
                           return "OneInTenToThe" +
                                  std::to_string(std::lround(-std::log10(info.param)));
                         });

/// A circle-to-ellipse pitchfork broken by nearly equal J1, J2: the rest sheet escapes where
/// J1 nu^2 = mu, and another sheet passes close by.
TEST(NearlyDegeneratePair, TheRestSheetIsKeptWhateverTheSteps) {
  const double J1 = 1.046;
  const double mu = 0.0525;
  const Problem problem(Body(J1, 0.972, 0.234),
                        {Potential::planar("neo-hookean", std::array{mu, 2.3792}),
                         Potential::thickness("reciprocal-quadratic", std::array{0.591, 1.917})},
                        Branch::iii);
  for (const double first : {0.5, 0.3, 0.1, 0.01, 1e-3}) {
    for (int digits = 3; digits <= 12; ++digits) {
      FollowOptions options = range(0.0, 1.0, std::pow(10.0, -digits));
      options.continuation.step.first = first;
      const Followed sheet = followed(problem, 0.0, options);
      const std::string x = std::to_string(first) + " 1e-" + std::to_string(digits);
      EXPECT_EQ(sheet.rows.back().event, EventType::escape) << x << sheet.text();
      EXPECT_EQ(sheet.report.forward.event, EventType::escape) << x;
      EXPECT_NEAR(sheet.rows.back().member.nu, std::sqrt(mu / J1), 1e-9) << x;
      EXPECT_EQ(sheet.rows.front().event, EventType::limit) << x;
      const auto tilts = sheet.events({EventType::tilt});
      ASSERT_EQ(tilts.size(), 1U) << x << ": " << sheet.text();
      EXPECT_NEAR(tilts[0].member.nu, 0.2239413673440838, 1e-14) << x;
      EXPECT_TRUE(sheet.events({EventType::fold_nu}).empty()) << x << ": " << sheet.text();
      for (const FollowedRow& row : sheet.rows) {
        if (row.member.nu > 0.0) {
          EXPECT_GT(row.member.q.xi, row.member.q.zeta) << x;
        }
      }
    }
  }
}

}  // namespace
}  // namespace stationary::testing
