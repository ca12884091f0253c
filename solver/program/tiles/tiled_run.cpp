#include "solver/program/tiles/tiled_run.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "solver/program/tiles/tile_loop.hpp"

namespace stationary::cli {

TileRunner::TileRunner(TiledWork work, const TiledRun& how, const Run& run)
    : work_(std::move(work)), how_(how), run_(run), tiles_(work_.share, work_.rows_a_tile) {
  if (how.serves() || !how.journal) return;
  journal_.emplace(*how.journal, hash_of({work_.hash, work_.kept, how.part.text()}), how.resume);
}

bool TileRunner::run(const std::function<void(const Share& rows, const std::string& tile)>& take) {
  TileLoop loop;
  loop.tiles = tiles_.count();
  loop.threads = run_.threads;
  loop.stop = run_.stop;
  loop.compute = [this](std::size_t tile) { return work_.compute(tiles_.rows(tile)); };
  if (how_.serves()) {
    how_.crew->serve(loop, work_.hash);
    return whole_ = true;
  }
  if (journal_) {
    journal_->begin();
    for (const std::string& line : journal_->remarks()) run_.complain(line);
    loop.has = [this](std::size_t tile) { return journal_->has(tile); };
    loop.known = [this](std::size_t tile) { return journal_->read(tile).value(); };
    for (std::size_t k = 0; k < tiles_.count(); ++k) kept_ += journal_->has(k) ? 1 : 0;
  }
  begin_ = std::chrono::steady_clock::now();
  loop.done = [this](std::size_t tile, const std::string& text, double seconds) {
    const double elapsed =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    if (journal_ && elapsed >= work_.too_short) {
      journal_->add(tile, text, seconds);
      ++journaled_;
    }
    ++computed_;
    if (run_.progress) show(elapsed);
  };
  loop.take = [&](std::size_t tile, const std::string& text) { take(tiles_.rows(tile), text); };
  whole_ = how_.crew != nullptr ? how_.crew->run(loop, work_.hash) : cli::run(loop);
  return whole_;
}

void TileRunner::show(double seconds) {
  const double tiles = static_cast<double>(tiles_.count());
  const double rows_a_tile = static_cast<double>(work_.share.size()) / tiles;
  const double rate = static_cast<double>(computed_) * rows_a_tile / seconds;
  run_.progress(static_cast<double>(kept_ + computed_) / tiles,
                fmt::format("{} {}, {:.3g} per second", work_.share.size(), work_.unit, rate));
}

void TileRunner::describe(Metadata& metadata) const {
  metadata.tiles = TileRecord{computed_, kept_, how_.crew != nullptr ? how_.crew->ranks() : 1};
  if (how_.part.asked)
    metadata.part = PartRecord{how_.part.number, how_.part.of, work_.share.first, work_.hash};
}

std::string TileRunner::interruption(std::size_t rows, bool written) const {
  return fmt::format("interrupted after {} of {} {}{}{}", rows, work_.share.size(), work_.unit,
                     written && rows > 0 ? ", which are written" : "", resumption());
}

std::string TileRunner::resumption() const {
  if (!journal_) return {};
  const std::size_t in_journal = kept_ + journaled_;
  if (in_journal == 0) return "; --resume begins anew, after so short a time";
  if (journaled_ == computed_) return "; --resume goes on with them";
  return fmt::format("; --resume goes on with {} of {} tiles", in_journal, kept_ + computed_);
}

void TileRunner::finish() {
  if (journal_ && whole_) journal_->finish();
}

std::string work_hash(std::string_view command, const CaseTree& tree,
                      std::initializer_list<std::string_view> asked) {
  std::ostringstream text;
  text << tree.root();
  std::string all;
  for (const std::string_view each : asked) all += hash_of({each});
  return hash_of({command, STATIONARY_VERSION, text.str(), all});
}

}  // namespace stationary::cli
