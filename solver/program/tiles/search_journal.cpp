#include "solver/program/tiles/search_journal.hpp"

#include <fmt/format.h>

#include <sstream>

namespace stationary::cli {
namespace {

std::string tree_text(const CaseTree& tree) {
  std::ostringstream out;
  out << tree.root();
  return out.str();
}

}  // namespace

std::string search_text(const SearchResult& found) {
  std::string out = fmt::format("{} {} {}", static_cast<int>(found.status), found.solutions.size(),
                                found.unproven.size());
  for (const auto* list : {&found.solutions, &found.unproven})
    for (const Equilibrium& each : *list)
      out += fmt::format(" {:a} {:a} {:a} {:a} {:a} {:a} {:a}", each.q.alpha, each.q.xi,
                         each.q.zeta, each.q.rho, each.nu[0], each.nu[1], each.nu[2]);
  return out;
}

std::optional<SearchResult> search_of(const std::string& text) {
  std::istringstream words(text);
  int status = 0;
  std::size_t proven = 0;
  std::size_t unproven = 0;
  if (!(words >> status >> proven >> unproven)) return std::nullopt;
  SearchResult out;
  out.status = static_cast<SearchStatus>(status);
  const auto number = [&words] {
    std::string word;
    words >> word;
    return word.empty() ? 0.0 : std::stod(word);
  };
  for (auto* list : {&out.solutions, &out.unproven}) {
    for (std::size_t left = list == &out.solutions ? proven : unproven; left > 0; --left) {
      Equilibrium& each = list->emplace_back();
      each.status = SolveStatus::solved;
      for (double* part : {&each.q.alpha, &each.q.xi, &each.q.zeta, &each.q.rho}) *part = number();
      for (int k = 0; k < 3; ++k) each.nu[k] = number();
    }
  }
  if (!words) return std::nullopt;
  return out;
}

SearchJournal::SearchJournal(const std::string& table, const Case& input, const AtlasOptions& asked,
                             bool resume)
    : journal_(table,
               hash_of({"atlas", STATIONARY_VERSION, tree_text(input.source),
                        fmt::format("{} {} {}", asked.from, asked.to, asked.checkpoints)}),
               resume) {}

void SearchJournal::keep(AtlasOptions& options) {
  journal_.begin();
  options.known_search = [this](std::size_t number) -> std::optional<SearchResult> {
    const auto text = journal_.read(number);
    return text ? search_of(*text) : std::nullopt;
  };
  options.searched = [this](std::size_t number, const SearchResult& found) {
    if (found.status == SearchStatus::interrupted) return;
    const std::scoped_lock lock(writing_);
    journal_.add(number, search_text(found));
  };
}

}  // namespace stationary::cli
