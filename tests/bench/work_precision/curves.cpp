#include "tests/bench/work_precision/curves.hpp"

#include <array>

#include "tests/bench/bodies.hpp"
#include "tests/bench/work_precision/references.hpp"
#include "tests/support/curve_error.hpp"

namespace stationary::bench {
namespace {

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

std::vector<double> errors_between(const Curve& of, const std::vector<CurveRow>& rows) {
  std::vector<testing::FollowedRow> all;
  for (const CurveRow& row : rows) {
    const auto& [xi, zeta, rho] = row.stretches;
    Member member;
    member.parameter = row.nu;
    member.q = {0.0, double(xi), double(zeta), double(rho)};
    all.push_back({member, EventType::none});
  }
  return std::visit([&](const auto& f) { return testing::interpolation_errors(*f, all, last_nu); },
                    of.equilibria);
}

std::vector<double> errors_at(const Curve& of, const std::vector<CurveRow>& rows) {
  const Problem problem = problem_of(of.model, of.branch);
  std::vector<double> out;
  for (const CurveRow& row : rows) {
    const auto& [xi, zeta, rho] = row.stretches;
    if (testing::is_moderate(Stretch{0.0, double(xi), double(zeta), double(rho)}))
      out.push_back(distance_from_sheet(problem, row.stretches, row.nu, last_nu));
  }
  return out;
}

void add_curves(const Curve& of, std::vector<Entry>& out) {
  constexpr double tolerance_of_rows = 1e-9;
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13}) {
    const FollowOptions options = testing::range(0.0, last_nu, tolerance);
    for (const bool spectra : {false, true}) {
      const AnyFamily& family = spectra ? of.with_spectra : of.equilibria;
      const std::string method = spectra ? "follow-spectra" : "follow";
      Counted counted;
      follow(family, of.rest, 0.0, options, counted);
      const auto pass = [&of, &family, options] {
        Counted sink;
        follow(family, of.rest, 0.0, options, sink);
      };
      const auto rows = [&of, &family, options] {
        std::vector<CurveRow> all;
        for (const testing::FollowedRow& row :
             testing::followed(family, of.rest, 0.0, options).rows) {
          const Stretch& q = row.member.q;
          if (row.event == EventType::none || is_end(row.event))
            all.push_back({{DoubleDouble(q.xi), DoubleDouble(q.zeta), DoubleDouble(q.rho)},
                           row.member.parameter});
        }
        return all;
      };
      const auto add = [&](const char* what, const auto& errors) {
        out.push_back({what, method, of.model, of.branch, tolerance, counted.rows, timed(pass),
                       [rows, errors, &of] { return errors(of, rows()); }});
      };
      add("curve", errors_between);
      if (tolerance == tolerance_of_rows) add("curve-rows", errors_at);
    }
  }
}

}  // namespace stationary::bench
