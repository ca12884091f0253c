// The solver of a page, as WebAssembly: what `solve` and `continue` do with a case, in memory. The page's worker writes a
// request, JSON, where live_room() says, calls live_run(), and reads the answer, JSON, from there on.
//
//   {"do": "read", "name": "x.toml", "case": TOML, "set": ["motion.nu=0.3", ...]}
//     -> {"code": 0, "title", "motion", "parameters": [{"key", "value"}], "followed": [keys], "range": {...} | null}
//   {"do": "solve" | "continue", ...}
//     -> {"code", "messages": [...], "summary", "parameters", "csv", "metadata", "page": what a page holds of the table}
//
//   {"do": "modes", ..., "row": {"q": S of the row, "nu": [...], "rates": [omega, theta'] | null, "s": [[re, im], ...]}}
//     -> {"code", "modes": for each s {"s", "displacement", "residual"} (mode_shape.hpp), null where s is 0}
//
// code is the program's exit code; csv is to the byte what it would have written.
#include <complex>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/program/computation/continue_case.hpp"
#include "solver/program/computation/solve_case.hpp"
#include "solver/program/explore/page_data.hpp"
#include "solver/program/explore/page_table.hpp"
#include "solver/program/session/exit_code.hpp"
#include "solver/solve/mode_shape.hpp"

namespace {

using namespace stationary;
using Json = nlohmann::ordered_json;

extern "C" [[clang::import_module("page"), clang::import_name("progress")]] void page_progress(
    double fraction, const char* what, std::size_t size);

class Memory final : public ByteSink {
 public:
  void write(std::string_view bytes) override { text += bytes; }
  std::string text;
};

class MemoryTable final : public TableTarget {
 public:
  void prepare() override {}
  RowSink& open(const std::vector<Column>& columns, const std::vector<std::string>& parameters,
                std::optional<std::size_t>) override {
    return table_.emplace(csv_, columns,
                          parameters.empty() ? std::nullopt : std::optional(parameters.front()));
  }
  CellTable& open(std::vector<CellColumn>) override {
    throw std::logic_error("solve and continue have columns of their own");
  }
  void commit(Metadata metadata) override {
    table_->flush();
    metadata.rows = table_->rows();
    metadata.checksum = table_->checksum().text();
    metadata_ = metadata_json(metadata, /*of_the_run=*/false);
  }

  const std::string& csv() const { return csv_.text; }
  const std::string& metadata() const { return metadata_; }

 private:
  Memory csv_;
  std::optional<TableWriter> table_;
  std::string metadata_;  ///< empty: there is no table
};

/// Some follow from others: the strength of gravity, told by a density, from the inertias.
Json parameters(const Case& input) {
  const FamilyParameters family{input.own_body, input.models, input.motion};
  Json out = Json::array();
  for (const std::string& key : case_parameters(input.motion, input.models))
    out.push_back({{"key", key}, {"value", parameter_value(family, key)}});
  return out;
}

Json described(const Case& input) {
  Json out{{"code", 0}, {"title", input.title}, {"motion", name(input.motion)}};
  out["parameters"] = parameters(input);
  out["followed"] = followed_parameters(input.motion, input.models);
  out["range"] = nullptr;
  if (const auto& range = input.continuation)
    out["range"] = {{"parameter", range->parameter}, {"from", range->from}, {"to", range->to}};
  return out;
}

constexpr std::string_view no_certificates =
    "output.certificate is not used: a page certifies no rows, the program does";

Json computed(Case input, const std::string& what, const std::string& table_name) {
  Json messages = Json::array();
  cli::Run run;
  run.complain = [&messages](const std::string& line) { messages.push_back(line); };
  run.progress = [](double fraction, const std::string& doing) {
    page_progress(fraction, doing.data(), doing.size());
  };
  Json numbers = parameters(input);
  if (std::exchange(input.output.certificate, false)) messages.push_back(no_certificates);
  MemoryTable target;
  const cli::Outcome outcome = what == "continue" ? cli::continue_case(input, {}, &target, run)
                                                  : cli::solve_case(input, &target, run);
  Json out{{"code", static_cast<int>(outcome.code)}, {"summary", outcome.summary}};
  out["messages"] = std::move(messages);
  out["parameters"] = std::move(numbers);
  out["csv"] = target.csv();
  out["metadata"] = target.metadata();
  out["page"] = nullptr;
  if (target.metadata().empty()) return out;
  TableReader reader(std::make_unique<std::istringstream>(target.csv()), table_name);
  if (!reader.next()) return out;  // none exists, which is no table to draw
  TableReader again(std::make_unique<std::istringstream>(target.csv()), table_name);
  PageTable table = read_page_table(again);
  table.metadata = target.metadata();
  if (!input.title.empty()) table.title = input.title;
  out["page"] = page_data({&table, 1}, table.title, STATIONARY_VERSION);
  return out;
}

/// How modes of a row of the case's table move the body, S being told in the case's coordinates.
Json mode_answer(const Case& input, const Json& row) {
  using Complex = std::complex<double>;
  const auto q = row.at("q").get<std::vector<double>>();
  const auto nu = row.at("nu").get<std::vector<double>>();
  const Stretch at = input.coordinates.computed({q.at(0), q.at(1), q.at(2), q.at(3)});
  std::vector<Complex> moving;
  for (const Json& s : row.at("s"))
    if (const Complex each(s.at(0).get<double>(), s.at(1).get<double>()); each != 0.0)
      moving.push_back(each);
  // On the circle a two-polar motion is one of branch (iii).
  const bool two_polar = !row.at("rates").is_null() && at.xi != at.zeta;
  const auto rates = two_polar ? row.at("rates").get<std::vector<double>>() : std::vector(2, 0.0);
  const std::vector<ModeShape> shapes =
      two_polar ? mode_shapes(input.body, input.potential, at,
                              TwoPolarRates<double>{rates.at(0), rates.at(1)}, moving)
                : mode_shapes(input.body, input.potential, at,
                              Vector3<double>(nu.at(0), nu.at(1), nu.at(2)), moving);
  const auto pair = [](const Complex& z) { return Json::array({z.real(), z.imag()}); };
  Json out{{"code", 0}, {"modes", Json::array()}};
  std::size_t next = 0;
  for (const Json& s : row.at("s")) {
    if (next == shapes.size() || pair(shapes[next].s) != s) {
      out["modes"].push_back(nullptr);
      continue;
    }
    const ModeShape& shape = shapes[next++];
    Json displacement = Json::array();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        displacement.push_back(
            pair(shape.displacement(i, j) * input.coordinates.unit[static_cast<std::size_t>(j)]));
    out["modes"].push_back(
        {{"s", s}, {"displacement", displacement}, {"residual", shape.residual}});
  }
  return out;
}

Json answered(const Json& request) {
  std::vector<Override> overrides;
  for (const Json& each : request.at("set")) overrides.push_back({each.get<std::string>()});
  const std::string file = request.at("name").get<std::string>();
  const Case input =
      make_case(CaseTree::parse(request.at("case").get<std::string>(), file), overrides);
  const std::string what = request.at("do").get<std::string>();
  if (what == "modes") return mode_answer(input, request.at("row"));
  return what == "read" ? described(input) : computed(input, what, "live.csv");
}

std::string request;
std::string answer;

}  // namespace

extern "C" {

[[clang::export_name("live_room")]] char* live_room(std::size_t size) {
  request.resize(size);
  return request.data();
}

[[clang::export_name("live_run")]] const char* live_run() {
  Json out;
  try {
    out = answered(Json::parse(request));
  } catch (const InputError& fault) {
    out = {{"code", static_cast<int>(cli::ExitCode::wrong_input)}, {"messages", {fault.what()}}};
  } catch (const std::exception& error) {
    out = {{"code", static_cast<int>(cli::ExitCode::failure)}, {"messages", {error.what()}}};
  }
  answer = out.dump(-1, ' ', false, Json::error_handler_t::replace);
  return answer.data();
}

[[clang::export_name("live_size")]] std::size_t live_size() { return answer.size(); }

}  // extern "C"
