#include "tests/stress/categories.hpp"

#include "tests/stress/cases/near_event.hpp"
#include "tests/stress/cases/oriented_case.hpp"
#include "tests/stress/cases/tilted_case.hpp"
#include "tests/stress/cases/two_polar_case.hpp"
#include "tests/stress/cases/whole_body_case.hpp"

namespace stationary::stress {
namespace {

std::function<Outcome(Random&)> judging(HardCase (*draw)(Random&)) {
  return [draw](Random& random) { return judged(draw(random)); };
}

}  // namespace

const std::vector<Category>& categories() {
  static const std::vector<Category> out{{"well posed", 120'000, 1, judging(well_posed)},
                                         {"ratios", 20'000, 2, judging(ratios)},
                                         {"collapse", 20'000, 3, judging(collapse)},
                                         {"large stretches", 20'000, 4, judging(large_stretches)},
                                         {"slow", 20'000, 5, judging(slow)},
                                         {"near escape", 20'000, 6, judging(near_escape)},
                                         {"equal inertias", 20'000, 7, judging(equal_inertias)},
                                         {"thin and thick", 20'000, 8, judging(thin_and_thick)},
                                         {"units", 20'000, 9, judging(units)},
                                         {"near a fold", 20'000, 10, judging(near_fold)},
                                         {"near a collision", 10'000, 11, judging(near_collision)},
                                         {"near a pass", 10'000, 12, judging(near_pass)},
                                         {"near a double zero", 10'000, 13, judging(near_zero)},
                                         {"tilted", 4'000, 14, try_tilted},
                                         {"two-polar", 4'000, 15, try_two_polar},
                                         {"held volume", 4'000, 16, try_held_volume},
                                         {"gravity", 4'000, 17, try_gravity},
                                         {"fibres", 4'000, 18, try_oriented}};
  return out;
}

Tally tried(const Category& category, long count) {
  Random random(category.seed);
  Tally out;
  for (long k = 0; k < count; ++k) out.add(category.try_one(random));
  return out;
}

}  // namespace stationary::stress
