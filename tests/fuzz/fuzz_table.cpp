// Any text as a table that somebody else made: of a diagram, of a map, of curves of events, of a page,
// of a study's rows; and as metadata of a part of a run. Its columns are whatever its header names.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>

#include "solver/program/diagram/diagram.hpp"
#include "solver/program/diagram/diagram_lines.hpp"
#include "solver/program/diagram/map_diagram.hpp"
#include "solver/program/rows/metadata_reading.hpp"
#include "solver/program/table/table_reader.hpp"
#include "solver/program/text/input_error.hpp"
#include "solver/program/tiles/study_source.hpp"

namespace {

using namespace stationary;

TableReader table_of(std::string_view text) {
  return {std::make_unique<std::istringstream>(std::string(text)), "table"};
}

/// use(); wrong input is an answer.
template <class Use>
void attempt(const Use& use) {
  try {
    use();
  } catch (const InputError&) {
  }
}

void draw(std::string_view text, bool energy_momentum) {
  TableReader table = table_of(text);
  const Diagram diagram = read_diagram({&table}, {.energy_momentum = energy_momentum});
  for (const DiagramPiece& piece : diagram.pieces) {
    (void)class_lines(diagram, piece, {{0.0, 1.0}});
    (void)spectrum_rows(diagram, piece, {{0.0, 1.0}});
  }
}

void study(std::string_view text) {
  const cli::StudySource source(table_of(text), "table");
  for (std::size_t k = 0; k < source.rows(); ++k) {
    (void)source.overrides(k);
    (void)source.cells(k);
  }
  (void)source.text();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  attempt([&] { draw(text, false); });
  attempt([&] { draw(text, true); });
  attempt([&] {
    TableReader table = table_of(text);
    (void)read_map_diagram(table, {});
  });
  attempt([&] {
    TableReader table = table_of(text);
    (void)read_curve_diagram({&table});
  });
  attempt([&] { study(text); });
  (void)part_metadata(text);
  return 0;
}
