// Where the motions of an even V leave alpha = 0: at an event `shear` of branch (iii) or `oblique`
// of (i), (ii) the balance is singular in alpha, or in alpha and the axis' angle where that is an
// unknown,
//
//   dG/d(a[, phi]) n = 0,
//
// and a family with alpha != 0 begins there along n, with its mirror image along -n.
#pragma once

#include <optional>

#include "solver/motion/family_parameter.hpp"

namespace stationary {

/// A motion of the family with alpha != 0, a little way from the event; nothing where none was found.
/// N < 5: mirrored() says which of its unknowns alpha is, if one is; N = 5: oblique, the axis an unknown. branch:
/// whose event it is.
template <int N>
std::optional<Member> leave_straight(const Family<N>& family, const Member& event, Branch branch);

extern template std::optional<Member> leave_straight<3>(const Family<3>&, const Member&, Branch);
extern template std::optional<Member> leave_straight<4>(const Family<4>&, const Member&, Branch);
extern template std::optional<Member> leave_straight<5>(const Family<5>&, const Member&, Branch);

/// Likewise of any family; nothing of two unknowns, none of which is alpha.
std::optional<Member> leave_straight(const AnyFamily& family, const Member& event, Branch branch);

}  // namespace stationary
