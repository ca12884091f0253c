// One part of a run that is shared out by hand: --part K/N, K = 1 ... N. Parts are contiguous shares of
// the rows in their order, as nearly equal as whole rows are:
//
//   part K of N has rows  [(K - 1) R / N], ..., [K R / N] - 1   of R
#pragma once

#include <cstddef>
#include <string>

namespace stationary::cli {

/// Rows first ... last - 1.
struct Share {
  std::size_t first = 0;
  std::size_t last = 0;

  std::size_t size() const { return last - first; }
};

struct Part {
  std::size_t number = 1;
  std::size_t of = 1;
  bool asked = false;  ///< --part was given, be it 1/1

  Share share(std::size_t rows) const;
  std::string text() const { return std::to_string(number) + "/" + std::to_string(of); }
};

/// Of "K/N". Throws InputError about --part.
Part read_part(const std::string& text);

/// Tiles of so many rows, from one multiple of it to the next, of a share.
class Tiles {
 public:
  Tiles(Share share, std::size_t rows_a_tile);
  std::size_t count() const { return count_; }
  Share rows(std::size_t tile) const;

 private:
  Share share_;
  std::size_t rows_a_tile_;
  std::size_t first_;  ///< its number, were the share all rows
  std::size_t count_;
};

}  // namespace stationary::cli
