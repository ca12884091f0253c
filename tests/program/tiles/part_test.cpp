// Shares of rows, and their tiles: together they are all of it, once.
#include "solver/program/tiles/part.hpp"

#include <gtest/gtest.h>

#include "solver/program/text/input_error.hpp"

namespace stationary::cli {
namespace {

TEST(Part, SharesAreContiguousAndNearlyEqual) {
  for (const std::size_t rows : {0U, 1U, 2U, 7U, 100U, 101U, 20'000'000U}) {
    for (const std::size_t parts : {1U, 2U, 3U, 7U, 64U, 1000U}) {
      std::size_t next = 0;
      for (std::size_t k = 1; k <= parts; ++k) {
        const Share share = Part{k, parts}.share(rows);
        EXPECT_EQ(share.first, next);
        EXPECT_GE(share.size(), rows / parts);
        EXPECT_LE(share.size(), rows / parts + 1);
        next = share.last;
      }
      EXPECT_EQ(next, rows);
    }
  }
}

TEST(Part, TilesOfASharePartitionIt) {
  for (const std::size_t size : {1U, 3U, 16U}) {
    for (std::size_t first = 0; first < 40; ++first) {
      for (std::size_t last = first; last < 60; ++last) {
        const Tiles tiles({first, last}, size);
        std::size_t next = first;
        for (std::size_t k = 0; k < tiles.count(); ++k) {
          const Share rows = tiles.rows(k);
          EXPECT_EQ(rows.first, next);
          EXPECT_GT(rows.last, rows.first);
          EXPECT_TRUE(rows.last % size == 0 || rows.last == last);
          next = rows.last;
        }
        EXPECT_EQ(next, last);
      }
    }
  }
}

TEST(Part, IsReadOrRefused) {
  const Part part = read_part("2/7");
  EXPECT_EQ(part.number, 2U);
  EXPECT_EQ(part.of, 7U);
  EXPECT_TRUE(part.asked);
  for (const char* text : {"", "1", "1/", "/1", "0/3", "4/3", "1/0", "-1/3", "1/3 ", "1/3/5", "a/3",
                           "1/1000001", "1.5/3", "99999999999999999999/3"})
    EXPECT_THROW(read_part(text), InputError) << text;
}

}  // namespace
}  // namespace stationary::cli
