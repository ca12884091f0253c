#include "solver/program/rows/atlas_rows.hpp"

#include <fmt/format.h>

#include "solver/kind/kind.hpp"

namespace stationary {

SheetRecord write_rows(AtlasSheet& sheet, CurveTable& table) {
  for (const AtlasRow& row : sheet.rows) {
    if (row.before) table.between(*row.before);
    table.row(row.member, row.event);
  }
  table.complete(sheet.report.events);
  return table.record(sheet.report);
}

CurveProofs write_sheets(const AtlasBody& of, Atlas& found, RowSink* writer,
                         std::vector<SheetRecord>& records) {
  CurveProofs out;
  // What an atlas interrupted before has found is written whole.
  const bool to_stop = of.stop != nullptr && !found.interrupted;
  for (AtlasSheet& sheet : found.sheets) {
    const bool stopped = to_stop && *of.stop;
    found.interrupted = found.interrupted || stopped;
    CurveTable table(name(sheet.motion(0.0)), stopped ? nullptr : writer, sheet.number);
    const auto kind_at = [&](double nu) {
      return kind_of(of.body, of.potential, sheet.motion(nu));
    };
    table.in_coordinates(of.coordinates);
    table.tell_normal_forms(kind_at, {});
    if (of.prove && !stopped) table.prove(kind_at, {});
    records.push_back(write_rows(sheet, table));
    out.add(table.proofs());
  }
  return out;
}

std::vector<CellColumn> least_energy_columns() {
  std::vector<CellColumn> out{{"sheet", CellKind::count}, {"branch", CellKind::text}};
  for (const char* each :
       {"momentum_from", "momentum_to", "energy_from", "energy_to", "spin_from", "spin_to"})
    out.push_back({each, CellKind::number});
  return out;
}

std::string least_energy_rows(const std::vector<LeastEnergyPiece>& pieces,
                              const std::vector<AtlasSheet>& sheets) {
  std::string out;
  for (const LeastEnergyPiece& each : pieces)
    out += fmt::format("{},{},{},{},{},{},{},{}\n", each.sheet,
                       kind_name(sheets[static_cast<std::size_t>(each.sheet) - 1]),
                       each.from.momentum, each.to.momentum, each.from.energy, each.to.energy,
                       each.from.spin, each.to.spin);
  return out;
}

}  // namespace stationary
