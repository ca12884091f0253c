#include "solver/program/rows/metadata.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/rows/atlas_rows.hpp"
#include "solver/program/table/table.hpp"

namespace stationary {
namespace {

using Json = nlohmann::ordered_json;

Json model_json(const ModelChoice& model) {
  Json out;
  if (model.tape) {
    out["expression"] = model.formula.expression;
    for (const Formula::Part& part : model.formula.parts) out["let"][part.name] = part.text;
    if (!model.formula.conditions.empty()) out["domain"] = model.formula.conditions;
  } else if (model.description.kind != ModelDescription::Kind::fibre) {
    out["model"] = model.description.name;
  }
  for (std::size_t k = 0; k < model.coefficients.size(); ++k)
    out[std::string(model.description.parameters[k])] = model.coefficients[k];
  return out;
}

Json motion_json(const Motion& motion) {
  Json out;
  for (const auto& [key, value] : motion_items(motion))
    std::visit([&out, name = std::string(key)](const auto& each) { out[name] = each; }, value);
  return out;
}

Json axis_json(const MapAxis& axis) {
  return {{"parameter", axis.parameter},
          {"from", axis.from},
          {"to", axis.to},
          {"count", axis.count},
          {"scale", name(axis.scale)}};
}

/// The case file's own keys, defaults included.
Json case_json(const Case& input) {
  Json out;
  out["title"] = input.title;
  out["body"]["J"] = {input.own_body.J1, input.own_body.J2, input.own_body.J3};
  out["potential"] = Json::object();
  for (const ModelChoice& model : input.models) {
    if (model.description.kind != ModelDescription::Kind::whole)
      out["potential"][model.slot] = model_json(model);
    else if (model.slot == "volume")
      out["body"]["volume"] = model.coefficients[0];
    else
      out["gravity"]["g"] = model.coefficients[0];
  }
  out["motion"] = motion_json(input.motion);
  Json& solve = out["solve"];
  if (const auto& start = input.own_solve.start)
    solve["start"] = {start->alpha, start->xi, start->zeta, start->rho};
  solve["method"] = name(input.solve.method);
  solve["all"] = input.solve.all;
  if (const auto& box = input.own_solve.box)
    for (const Interval& range : *box) solve["box"].push_back({range.lo, range.hi});
  if (const auto& continuation = input.continuation) {
    out["continuation"] = {{"parameter", continuation->parameter},
                           {"from", continuation->from},
                           {"to", continuation->to},
                           {"tolerance", continuation->tolerance},
                           {"step", continuation->step},
                           {"max_points", continuation->max_points},
                           {"events", continuation->events}};
    if (!continuation->start_row.empty())
      out["continuation"]["start_row"] = continuation->start_row;
  }
  if (input.map) {
    out["map"]["x"] = axis_json(input.map->x);
    if (input.map->y) out["map"]["y"] = axis_json(*input.map->y);
  }
  if (const auto& curve = input.curve) {
    out["curve"] = {{"event", name(curve->event)},
                    {"parameters", curve->parameters},
                    {"from", curve->from},
                    {"to", curve->to},
                    {"tolerance", curve->tolerance}};
  }
  if (input.atlas.complete) out["atlas"]["complete"] = true;
  if (input.atlas.checkpoints) out["atlas"]["checkpoints"] = *input.atlas.checkpoints;
  out["output"] = {{"spectrum", input.output.spectrum},
                   {"certificate", input.output.certificate},
                   {"columns", input.output.columns}};
  for (const auto& [number, uncertainty] : input.output.uncertainty)
    out["output"]["uncertainty"][number] = uncertainty;
  return out;
}

Json event_json(const EventRecord& event) {
  Json out{{"event", name(event.type)},
           {"parameter", event.parameter},
           {"bracket", {event.before, event.after}},
           {"status", name(event.status)}};
  if (event.enclosure) out["enclosure"] = {event.enclosure->lo, event.enclosure->hi};
  if (event.criticality_error) out["criticality_error"] = *event.criticality_error;
  return out;
}

Json events_json(const std::vector<EventRecord>& events) {
  Json out = Json::array();
  for (const EventRecord& event : events) out.push_back(event_json(event));
  return out;
}

/// All curves' events, with their rows: none of an unresolved one.
Json events_json(const std::vector<SheetRecord>& curves) {
  Json out = Json::array();
  for (const SheetRecord& curve : curves) {
    for (const EventRecord& event : curve.events) {
      Json each{{"event", name(event.type)}, {"sheet", curve.sheet}, {"point", nullptr}};
      if (event.point) each["point"] = *event.point;
      each.update(event_json(event));
      out.push_back(std::move(each));
    }
  }
  return out;
}

Json segments_json(const std::vector<SheetRecord>& curves) {
  Json out = Json::array();
  const auto bound = [](const SegmentBound& at) -> Json {
    return {{"event", name(at.event)}, {"parameter", at.parameter}};
  };
  for (const SheetRecord& curve : curves) {
    for (const Segment& segment : curve.segments) {
      out.push_back({{"sheet", curve.sheet},
                     {"segment", segment.number},
                     {"class", segment.verdict ? Json(name(*segment.verdict)) : Json()},
                     {"first_point", segment.first_point},
                     {"last_point", segment.last_point},
                     {"from", bound(segment.from)},
                     {"to", bound(segment.to)},
                     {"ranges", segment.ranges}});
    }
  }
  return out;
}

Json ends_json(const std::vector<SheetRecord>& curves) {
  Json out = Json::array();
  for (const SheetRecord& curve : curves) {
    for (const auto& [side, end] : {std::pair{"first", &curve.first}, {"last", &curve.last}}) {
      out.push_back({{"sheet", curve.sheet},
                     {"side", side},
                     {"event", name(end->event)},
                     {"parameter", end->parameter},
                     {"reason", end->reason}});
    }
  }
  return out;
}

Json event_curves_json(const std::vector<EventCurveRecord>& curves) {
  Json out = Json::array();
  for (const EventCurveRecord& each : curves) {
    Json special = Json::array();
    for (const EventCurveRecord::Special& point : each.special) {
      special.push_back({{"special", point.special}, {"point", point.point}, {"at", point.at}});
      if (!point.other.empty()) special.back()["other"] = point.other;
    }
    const auto end = [](const EventCurveEnd& of) -> Json {
      return {{"event", name(of.event)}, {"reason", of.reason}};
    };
    out.push_back({{"curve", each.curve},
                   {"points", each.points},
                   {"special", special},
                   {"first_end", end(each.first)},
                   {"last_end", end(each.last)}});
  }
  return out;
}

/// Of what is tilted in a plane.
template <class Of>
void add_plane(const Of& of, Json& out) {
  if (of.plane) out["plane"] = name(*of.plane);
}

Json sheets_json(const std::vector<AtlasSheet>& sheets) {
  Json out = Json::array();
  for (const AtlasSheet& sheet : sheets) {
    Json each{{"sheet", sheet.number}, {"branch", kind_name(sheet)}};
    add_plane(sheet, each);
    each["entry"] = name(sheet.entry);
    each["entry_nu"] = sheet.entry_nu;
    each["rows"] = sheet.rows.size();
    for (const auto& [key, junction] :
         {std::pair{"parent", sheet.parent}, {"joins", sheet.joins}}) {
      if (!junction) continue;
      each[key] = {
          {"sheet", junction->sheet}, {"event", name(junction->event)}, {"nu", junction->nu}};
    }
    const auto end = [](EventType event, const AtlasRow& row, const SheetEnd& why) -> Json {
      return {{"event", name(event)}, {"nu", row.member.nu}, {"reason", why.reason}};
    };
    if (sheet.report.vertical) each["vertical"] = true;
    each["first_end"] = end(sheet.first_event(), sheet.rows.front(), sheet.report.backward);
    each["last_end"] = end(sheet.last_event(), sheet.rows.back(), sheet.report.forward);
    each["events"] = events_json(sheet.report.events);
    out.push_back(std::move(each));
  }
  return out;
}

Json remarks_json(const std::vector<Remark>& remarks) {
  Json out = Json::array();
  for (const Remark& each : remarks) {
    Json remark{{"branch", kind_name(each)}};
    add_plane(each, remark);
    if (each.entry) {
      remark["entry"] = name(*each.entry);
      remark["nu"] = each.nu;
    }
    remark["reason"] = each.reason;
    out.push_back(std::move(remark));
  }
  return out;
}

Json checkpoints_json(const std::vector<Checkpoint>& checkpoints) {
  Json out = Json::array();
  for (const Checkpoint& at : checkpoints) {
    out.push_back({{"branch", kind_name(at)}});
    add_plane(at, out.back());
    out.back().update({{"nu", at.nu},
                       {"search", name(at.status)},
                       {"proven", at.proven},
                       {"unproven", at.unproven},
                       {"on_sheets", at.on_sheets},
                       {"on_sheets_not_proven", at.beyond},
                       {"complete", at.complete()}});
  }
  return out;
}

/// What intervals of either sort have in common.
template <class Part>
Json proven_part_json(const Completeness& kind, const Part& part) {
  Json out{{"branch", kind_name(kind)}};
  add_plane(kind, out);
  out["from"] = part.from;
  out["to"] = part.to;
  out["status"] = part.proven ? "proven" : "undecided";
  return out;
}

Json completeness_json(const std::vector<Completeness>& all) {
  Json out = Json::array();
  for (const Completeness& kind : all) {
    for (const CompleteInterval& each : kind.intervals) {
      Json interval = proven_part_json(kind, each);
      if (each.leaves_box()) interval["status"] = "beyond";
      interval["sheets"] = each.proven ? Json(each.sheets) : Json();
      interval["reason"] = each.proven ? "" : each.reason;
      interval["boxes"] = kind.boxes;
      interval["beyond"] = name(each.beyond);
      out.push_back(std::move(interval));
    }
  }
  return out;
}

/// Of how many motions each class is, for every nu of an interval.
Json classes_json(const std::vector<Completeness>& all) {
  Json out = Json::array();
  for (const Completeness& kind : all) {
    for (const ClassInterval& each : kind.classes) {
      Json interval = proven_part_json(kind, each);
      if (each.proven) {
        Json sheets = Json::object();
        for (std::size_t k = 0; k < each.sheets.size(); ++k)
          if (each.sheets[k] > 0) sheets[stability_names[k]] = each.sheets[k];
        interval["sheets"] = std::move(sheets);
      } else {
        interval["sheets"] = nullptr;
        interval["reason"] = each.reason;
        Json events = Json::array();
        for (const EventType event : each.events) events.push_back(name(event));
        interval["events"] = std::move(events);
      }
      interval["boxes"] = kind.class_arcs;
      interval["beyond"] = name(each.beyond);
      out.push_back(std::move(interval));
    }
  }
  return out;
}

Json least_energy_json(const std::vector<LeastEnergyPiece>& pieces,
                       const std::vector<AtlasSheet>& sheets) {
  Json out = Json::array();
  for (const LeastEnergyPiece& each : pieces) {
    const AtlasSheet& sheet = sheets[static_cast<std::size_t>(each.sheet) - 1];
    out.push_back({{"sheet", each.sheet},
                   {"branch", kind_name(sheet)},
                   {"momentum", {each.from.momentum, each.to.momentum}},
                   {"energy", {each.from.energy, each.to.energy}},
                   {"spin", {each.from.spin, each.to.spin}}});
  }
  return out;
}

Json items_json(const std::vector<PlanItem>& items) {
  Json out = Json::array();
  for (const PlanItem& item : items)
    out.push_back({{"quantity", item.quantity}, {"how", item.how}, {"why", item.why}});
  return out;
}

}  // namespace

std::vector<std::pair<std::string_view, long>> named_counts(const Counts& counts) {
  return {{"residuals", counts.residuals},
          {"jacobians", counts.jacobians},
          {"extended_residuals", counts.extended_residuals},
          {"newton_steps", counts.newton_steps},
          {"ceres_iterations", counts.ceres_iterations},
          {"nlopt_evaluations", counts.nlopt_evaluations},
          {"walk_steps", counts.walk_steps}};
}

std::string metadata_json(const Metadata& metadata, bool of_the_run) {
  Json out;
  out["schema"] = metadata_schema;
  out["program"] = "stationary";
  out["version"] = metadata.version;
  const CaseTree* const source =
      metadata.input != nullptr ? &metadata.input->source : metadata.source;
  if (source != nullptr) {
    out["case_file"] = source->name();
    out["case"] = metadata.input != nullptr ? case_json(*metadata.input) : Json();
    Json overrides = Json::object();
    for (const auto& [key, option] : source->overrides()) overrides[key] = option;
    out["overrides"] = overrides;
  }
  if (const auto& study = metadata.study)
    out["study"] = {{"over", study->over}, {"do", study->task}, {"rows", study->rows}};
  if (const auto& part = metadata.part) {
    out["part"] = {{"number", part->number},
                   {"of", part->of},
                   {"first_row", part->first_row + 1},
                   {"work", part->work}};
  }
  for (const auto& [name, text] : metadata.outcome) out[std::string(name)] = text;
  out["rows"] = metadata.rows;
  out["checksum"] = metadata.checksum;
  if (of_the_run) {
    out["run"] = {{"seconds", metadata.seconds},
                  {"command_line", metadata.command_line},
                  {"threads", metadata.threads}};
    if (const auto& tiles = metadata.tiles) {
      out["run"]["ranks"] = tiles->ranks;
      out["run"]["tiles"] = {{"computed", tiles->computed}, {"kept", tiles->kept}};
    }
    if (metadata.merged_parts > 0) out["run"]["parts"] = metadata.merged_parts;
    if (!metadata.instructions.empty()) out["run"]["instructions"] = metadata.instructions;
  }
  out["events"] = events_json(metadata.curves);
  out["segments"] = segments_json(metadata.curves);
  out["ends"] = ends_json(metadata.curves);
  if (!metadata.event_curves.empty()) out["curves"] = event_curves_json(metadata.event_curves);
  if (!metadata.unproven_sheets.empty()) out["unproven_sheets"] = metadata.unproven_sheets;
  if (metadata.atlas != nullptr) {
    out["sheets"] = sheets_json(metadata.atlas->sheets);
    out["checkpoints"] = checkpoints_json(metadata.atlas->checkpoints);
    out["remarks"] = remarks_json(metadata.atlas->remarks);
    if (!metadata.atlas->completeness.empty()) {
      out["complete_fraction"] = complete_fraction(*metadata.atlas);
      out["completeness"] = completeness_json(metadata.atlas->completeness);
    }
    if (Json classes = classes_json(metadata.atlas->completeness); !classes.empty())
      out["classes"] = std::move(classes);
    out["least_energy"] = least_energy_json(metadata.least_energy, metadata.atlas->sheets);
  }
  Json counts = Json::object();
  for (const auto& [name, count] : metadata.counts) counts[std::string(name)] = count;
  out["counts"] = counts;
  if (metadata.input != nullptr)
    if (const auto assumed = metadata.input->potential.assumptions(); !assumed.empty())
      out["assumed"] = assumed;
  out["plan"] = items_json(metadata.plan);
  out["skipped"] = items_json(metadata.skipped);
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

bool is_of_case(std::string_view metadata, const Case& input) {
  using Unordered = nlohmann::json;
  auto found = Unordered::parse(metadata, nullptr, /*allow_exceptions=*/false);
  if (!found.is_object() || !found.contains("case")) return false;
  auto expected = Unordered::parse(case_json(input).dump());  // numbers as they are read back
  for (Unordered* each : {&found["case"], &expected}) {
    if (!each->is_object() || !each->contains("continuation")) return false;
    if (!(*each)["continuation"].is_object()) return false;
    for (const char* key : {"step", "max_points"}) (*each)["continuation"].erase(key);
  }
  return found["case"] == expected;
}

}  // namespace stationary
