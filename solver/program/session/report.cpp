#include "solver/program/session/report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "solver/program/text/terminal.hpp"

namespace stationary::cli {
namespace {

/// What a class says, and what it does not.
std::string_view claim(const Spectrum& spectrum) {
  switch (spectrum.verdict) {
    case StabilityClass::stable:
      if (spectrum.negative > 0) {
        return "the second variation is definite on the motions that keep the material symmetry's "
               "momentum, or with a multiple of it, so small disturbances stay small, up to the "
               "symmetries";
      }
      return "the second variation is definite, so small disturbances stay small, up to the "
             "symmetries";
    case StabilityClass::elliptic:
      return "all eigenvalues are imaginary but the second variation is indefinite, so no "
             "disturbance grows to first order; dissipation may destroy it";
    case StabilityClass::unstable:
      return "a real pair of eigenvalues, so some disturbances grow exponentially";
    case StabilityClass::oscillatory:
      return "a complex quadruple of eigenvalues, so some disturbances grow while they oscillate";
    case StabilityClass::marginal:
      break;
  }
  return "nothing is claimed: within the error bounds an eigenvalue may be zero, or two of "
         "opposite Krein sign may meet";
}

}  // namespace

Report::Report(std::size_t label_width) : width_(label_width), bold_(has_colours(STDOUT_FILENO)) {}

std::string Report::column(std::string_view label) const {
  const std::string out = fmt::format("{:<{}}", label, width_);
  return bold_ && !label.empty() ? heading(out) : out;
}

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
    text_ += fmt::format("{}{}\n", column(label), value.substr(0, end));
    value.remove_prefix(std::min(value.size(), end + 1));
    label = {};
  } while (!value.empty());
}

void Report::whole_line(std::string_view label, std::string_view value) {
  text_ += fmt::format("{}{}\n", column(label), value);
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

void add_spectrum(Report& report, const Spectrum& spectrum) {
  report.line("spectrum", fmt::format("{}: {}", name(spectrum.verdict), claim(spectrum)));
  report.line("", fmt::format("growth {:.16g}; negative directions of the second variation: {}",
                              spectrum.growth, spectrum.negative));
  report.line("", fmt::format("{:<6}{:<24}{:<24}{:<7}{}", "mode", "re s", "im s", "Krein",
                              "error bound of s^2"));
  for (int k = 0; k < spectrum.modes; ++k) {
    const Mode& mode = spectrum.mode[static_cast<std::size_t>(k)];
    const std::string krein = mode.krein_open   ? "?"
                              : mode.krein == 0 ? "0"
                                                : fmt::format("{:+d}", mode.krein);
    const std::string error =
        mode.forced_zero ? "0 (a symmetry's)" : fmt::format("{:.1e}", mode.lambda_error);
    report.line(
        "", fmt::format("{:<6}{:<24.16g}{:<24.16g}{:<7}{}", k + 1, mode.re, mode.im, krein, error));
  }
}

void add_segments(Report& report, const std::vector<Segment>& segments,
                  std::string_view parameter) {
  const auto bound = [&](const SegmentBound& at) {
    return fmt::format("{}{:.15g}",
                       at.event == EventType::none ? "" : fmt::format("{} ", name(at.event)),
                       at.parameter);
  };
  std::string_view label = "stability";
  for (const Segment& each : segments) {
    std::string covered;
    for (const auto& [low, high] : each.ranges)
      covered += fmt::format("{}[{:.12g}, {:.12g}]", covered.empty() ? "" : ", ", low, high);
    report.whole_line(std::exchange(label, {}),
                      fmt::format("{:<12} from {} to {}: {} in {}",
                                  each.verdict ? name(*each.verdict) : "unknown", bound(each.from),
                                  bound(each.to), parameter, covered));
  }
}

}  // namespace stationary::cli
