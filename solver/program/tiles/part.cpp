#include "solver/program/tiles/part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "solver/program/text/input_error.hpp"

namespace stationary::cli {
namespace {

constexpr std::size_t most_parts = 1'000'000;

}  // namespace

Share Part::share(std::size_t rows) const {
  // Without a product that could be too large.
  const auto bound = [&](std::size_t k) { return rows / of * k + rows % of * k / of; };
  return {bound(number - 1), bound(number)};
}

Part read_part(const std::string& text) {
  Part out{.asked = true};
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, out.number);
  const bool slash = number.ec == std::errc() && number.ptr != end && *number.ptr == '/';
  const auto of = slash ? std::from_chars(number.ptr + 1, end, out.of) : number;
  if (!slash || of.ec != std::errc() || of.ptr != end || out.number < 1 || out.of > most_parts ||
      out.number > out.of)
    throw InputError(Origin::of_option("--part " + text), "", "found " + in_quotes(text),
                     fmt::format("K/N, part K = 1 ... N of N, N up to {}, as 2/7", most_parts));
  return out;
}

Tiles::Tiles(Share share, std::size_t rows_a_tile)
    : share_(share),
      rows_a_tile_(rows_a_tile),
      first_(share.first / rows_a_tile),
      count_(share.size() == 0 ? 0 : (share.last - 1) / rows_a_tile - first_ + 1) {}

Share Tiles::rows(std::size_t tile) const {
  const std::size_t begin = (first_ + tile) * rows_a_tile_;
  return {std::max(begin, share_.first), std::min(begin + rows_a_tile_, share_.last)};
}

}  // namespace stationary::cli
