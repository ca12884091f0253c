// The motions of a sheet between two of its rows: the cubic of both places and both tangents
// (hermite_arc.hpp), each of its points brought onto the curve, past folds too.
#pragma once

#include <memory>
#include <optional>

#include "solver/atlas/atlas.hpp"
#include "solver/family/axis_family.hpp"

namespace stationary {

/// Of the family that the sheet belongs to.
SheetArc sheet_arc(const std::shared_ptr<const AnyFamily>& family);

/// With principal stretches in the box of an atlas, or the same turned by a right angle of ellipses that stand for
/// both (AtlasSheet::mirror).
bool in_box(const Stretch& q, const SearchOptions& box, Circle mirror);

/// Both on the same one of the two ways along an axis, of a row at rest that of the other row.
void align_axes(Member& a, Member& b);

}  // namespace stationary
