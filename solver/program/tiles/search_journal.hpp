// The searches of an atlas in a journal, so that an interrupted one goes on without those it has. The
// sheets are followed anew, from the same places: the table is that of a run never interrupted.
#pragma once

#include <mutex>
#include <string>

#include "solver/atlas/atlas.hpp"
#include "solver/program/case/case_file.hpp"
#include "solver/program/tiles/journal.hpp"

namespace stationary::cli {

class SearchJournal {
 public:
  /// As Journal's; of the atlas that is asked for.
  SearchJournal(const std::string& table, const Case& input, const AtlasOptions& asked,
                bool resume);

  /// Begins it (Journal::begin). Makes an atlas ask it, and tell it what is found. It must live as long as the options.
  void keep(AtlasOptions& options);
  const std::vector<std::string>& remarks() const { return journal_.remarks(); }
  void finish() { journal_.finish(); }

 private:
  Journal journal_;
  std::mutex writing_;
};

/// What a search found of motions and of its own completeness, as text, and back.
std::string search_text(const SearchResult& found);
std::optional<SearchResult> search_of(const std::string& text);

}  // namespace stationary::cli
