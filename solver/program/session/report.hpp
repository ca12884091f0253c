// Text for a person: sections of aligned label and value lines, and the parts that commands share.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/stability/spectrum.hpp"
#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/segments.hpp"

namespace stationary::cli {

class Report {
 public:
  /// For standard output: its labels are bold where that is a terminal.
  explicit Report(std::size_t label_width);

  /// "label   value"; an empty label continues the one above.
  void line(std::string_view label, std::string_view value);
  /// Likewise, but never broken.
  void whole_line(std::string_view label, std::string_view value);
  /// Several values in columns of equal width.
  void row(std::string_view label, const std::vector<std::pair<std::string_view, double>>& values);
  void gap() { text_ += '\n'; }
  const std::string& text() const { return text_; }

 private:
  /// A label in its column.
  std::string column(std::string_view label) const;

  std::size_t width_;
  bool bold_;
  std::string text_;
};

/// How each unknown is had and what is left out, one block per quantity.
void add_plan(Report& report, const std::vector<PlanItem>& plan);

/// The class, what it claims, and the modes with their error bounds.
void add_spectrum(Report& report, const Spectrum& spectrum);

/// A line a segment: its class, the events or ends that bound it, and what it covers.
void add_segments(Report& report, const std::vector<Segment>& segments, std::string_view parameter);

}  // namespace stationary::cli
