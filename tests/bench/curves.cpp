#include "tests/bench/curves.hpp"

#include <array>

#include "tests/bench/bodies.hpp"
#include "tests/support/curve_error.hpp"

namespace stationary::bench {
namespace {

constexpr double last_nu = 3.0;

/// Counts the rows and keeps none.
class Counted final : public CurveSink {
 public:
  void row(const Member&, EventType) override { ++rows; }
  std::size_t rows = 0;
};

}  // namespace

Curve curve(std::string_view model, Branch branch) {
  const Problem problem = problem_of(model, branch);
  return {std::string(model), branch, solve(problem, 0.0).q,
          axis_family(problem, {.nu = 0.0, .parameter = {}, .spectrum = false}),
          axis_family(problem, {.nu = 0.0, .parameter = {}, .spectrum = true})};
}

void add_curves(const Curve& of, const std::string& what, std::vector<Entry>& out) {
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13}) {
    const FollowOptions options = testing::range(0.0, last_nu, tolerance);
    for (const bool spectra : {false, true}) {
      const AnyFamily& family = spectra ? of.with_spectra : of.equilibria;
      Counted counted;
      follow(family, of.rest, 0.0, options, counted);
      const auto pass = [&of, &family, options] {
        Counted sink;
        follow(family, of.rest, 0.0, options, sink);
      };
      const auto errors = [&of, &family, options] {
        const testing::Followed sheet = testing::followed(family, of.rest, 0.0, options);
        return std::visit(
            [&](const auto& f) { return testing::interpolation_errors(*f, sheet.rows, last_nu); },
            family);
      };
      out.push_back({what, spectra ? "follow-spectra" : "follow", of.model, of.branch, tolerance,
                     counted.rows, timed(pass), errors});
    }
  }
}

}  // namespace stationary::bench
