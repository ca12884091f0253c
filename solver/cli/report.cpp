#include "solver/cli/report.hpp"

#include <fmt/format.h>

namespace stationary::cli {

void Report::line(std::string_view label, std::string_view value) {
  text_ += fmt::format("{:<{}}{}\n", label, width_, value);
}

void Report::row(std::string_view label,
                 const std::vector<std::pair<std::string_view, double>>& values) {
  std::string text;
  for (const auto& [name, value] : values) {
    if (!text.empty()) text += "  ";
    text += fmt::format("{} = {:<22.16g}", name, value == 0.0 ? 0.0 : value);
  }
  text.erase(text.find_last_not_of(' ') + 1);
  line(label, text);
}

void add_plan(Report& report, const std::vector<PlanItem>& plan) {
  for (const PlanItem& item : plan) {
    report.line(item.quantity, item.how);
    report.line("", item.why);
  }
}

std::string motion_text(Branch branch, double nu) {
  const Vector3<double> v = angular_velocity(branch, nu);
  return fmt::format("branch ({}), nu = ({}, {}, {})", name(branch), v[0], v[1], v[2]);
}

std::vector<PlanItem> not_computed(const Case& input) {
  std::vector<PlanItem> out;
  const std::string why = input.output.spectrum
                              ? "this version of the program has no linearization yet"
                              : "output.spectrum = false";
  out.push_back({"class, growth, negative, modes", "not computed", why});
  return out;
}

}  // namespace stationary::cli
