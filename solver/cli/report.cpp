#include "solver/cli/report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stationary::cli {

void Report::line(std::string_view label, std::string_view value) {
  // Broken between words, continued under the value.
  constexpr std::size_t line_width = 100;
  do {
    std::size_t end = value.size();
    if (width_ + end > line_width) {
      end = value.rfind(' ', line_width - width_);
      if (end == std::string_view::npos || end == 0) end = value.find(' ', line_width - width_);
      if (end == std::string_view::npos) end = value.size();
    }
    text_ += fmt::format("{:<{}}{}\n", label, width_, value.substr(0, end));
    value.remove_prefix(std::min(value.size(), end + 1));
    label = {};
  } while (!value.empty());
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
  out.push_back({"spectrum", "not computed", why});
  return out;
}

}  // namespace stationary::cli
