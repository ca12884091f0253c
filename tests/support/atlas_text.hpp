// An atlas in short, and whether its checkpoints are all settled.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "solver/atlas/atlas.hpp"

namespace stationary::testing {

/// "iii: limit tilt escape; ...": of each sheet its kind, or the plane it tilts in, and its events.
inline std::string text_of(const Atlas& found) {
  std::string out;
  for (const AtlasSheet& sheet : found.sheets) {
    out += std::string(sheet.plane ? name(*sheet.plane) : kind_name(sheet)) + ":";
    for (const AtlasRow& row : sheet.rows)
      if (row.event != EventType::none) out += " " + std::string(name(row.event));
    out += "; ";
  }
  return out;
}

inline void expect_complete(const Atlas& found) {
  EXPECT_FALSE(found.interrupted);
  for (const Checkpoint& at : found.checkpoints) {
    EXPECT_TRUE(at.complete()) << kind_text(at) << " " << at.nu << ": " << name(at.status) << " "
                               << at.proven << " " << at.on_sheets << " " << at.beyond;
  }
}

}  // namespace stationary::testing
