// What kind of motion the sheets, checkpoints and remarks of an atlas (atlas.hpp) are of.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lib/body/motion.hpp"

namespace stationary {

/// Which motions a sheet, a checkpoint ... is of: about the axis of a branch, about oblique axes (then `branch` has no
/// meaning), or about axes tilted in one plane (of a sheet `branch` is then that it was entered at).
struct SheetKind {
  Branch branch = Branch::i;
  bool oblique = false;
  std::optional<TiltPlane> plane = {};

  /// One of them.
  Motion motion(double nu) const;
  bool operator==(const SheetKind&) const = default;
};
/// As the column `branch` has it.
std::string_view kind_name(const SheetKind& kind);
/// For a person: with the plane.
std::string kind_text(const SheetKind& kind);

}  // namespace stationary
