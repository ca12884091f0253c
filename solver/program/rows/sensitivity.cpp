#include "solver/program/rows/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <variant>

#include "lib/body/circle.hpp"
#include "lib/number/elementary.hpp"
#include "solver/kind/kind.hpp"
#include "solver/program/case/case_motion.hpp"
#include "solver/program/rows/equilibrium_row.hpp"

namespace stationary {
namespace {

/// `at` with the number at a value; nothing where that is not allowed.
std::optional<FamilyParameters> moved_number(const FamilyParameters& at, const std::string& number,
                                             double value) {
  try {
    return with_parameter(at, number, value);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// near: values beside which these are: what has none there, as the angle of a circle, has none here. The
/// angle of an axis, half a turn of which is none, is brought there.
std::vector<double> picked(const TableRow& row, std::span<const Column> columns,
                           const TableRow& near) {
  std::vector<double> out;
  for (const Column c : columns) {
    double value = std::isnan(near[c]) ? near[c] : row[c];
    if (c == Column::angle && std::isfinite(near[c]))
      value -= std::numbers::pi * std::round((value - near[c]) / std::numbers::pi);
    out.push_back(value);
  }
  return out;
}

/// A row's modes in another order: each beside that mode of another row's which it is next to, all together.
void order_modes(const TableRow& near, TableRow& row) {
  const auto has = [](const TableRow& of, int k) {
    return std::isfinite(of[mode_column(k, ModePart::re)]) &&
           std::isfinite(of[mode_column(k, ModePart::im)]);
  };
  std::vector<int> places;
  for (int k = 0; k < mode_count; ++k) {
    if (has(near, k) != has(row, k)) return;
    if (has(row, k)) places.push_back(k);
  }
  const auto apart = [&](int a, int b) {
    return hypotenuse(near[mode_column(a, ModePart::re)] - row[mode_column(b, ModePart::re)],
                      near[mode_column(a, ModePart::im)] - row[mode_column(b, ModePart::im)]);
  };
  std::vector<int> order = places;
  std::vector<int> best = order;
  double least = std::numeric_limits<double>::infinity();
  do {
    double sum = 0.0;
    for (std::size_t k = 0; k < places.size(); ++k) sum += apart(places[k], order[k]);
    if (sum < least) least = sum, best = order;
  } while (std::next_permutation(order.begin(), order.end()));
  const TableRow own = row;
  for (std::size_t k = 0; k < places.size(); ++k)
    for (const ModePart part : {ModePart::re, ModePart::im, ModePart::krein})
      row[mode_column(places[k], part)] = own[mode_column(best[k], part)];
}

/// Whether a motion may be the same one at another value of a number. From a start that is nearly round, or where
/// another solution is near, a solve may come to one about another axis.
bool is_near(const TableRow& found, const TableRow& row) {
  constexpr double most = 0.25;
  double change = 0.0;
  double size = 0.0;
  for (const Column c : {Column::alpha, Column::xi, Column::zeta, Column::rho}) {
    change = std::max(change, std::abs(found[c] - row[c]));
    size = std::max(size, std::abs(row[c]));
  }
  const auto length = [](const TableRow& of) {
    return hypotenuse(of[Column::nu1], of[Column::nu2], of[Column::nu3]);
  };
  const double own = length(row);
  const double other = length(found);
  double cosine = 0.0;
  for (const Column c : {Column::nu1, Column::nu2, Column::nu3})
    cosine += (found[c] / other) * (row[c] / own);
  const double along = std::abs(cosine);
  return change <= most * size && !(along < 1.0 - 0.5 * most * most);
}

/// Over which a number may change what is computed by much.
double size_of(double value) { return value == 0.0 ? 1.0 : std::abs(value); }

/// The circle of the family that the figure is.
template <int N>
Circle circle_of_figure(const Family<N>& family, const Stretch& q) {
  const Circle circle = family.circle();
  return is_on(circle, q, 1e-9) ? circle : Circle::none;
}

template <int N>
std::optional<Member> event_beside(const Family<N>& family, Circle circle, EventType type,
                                   const Member& near) {
  if (circle_of_figure(family, near.q) != circle) return std::nullopt;
  const auto found = family.event_at(type, circle, near);
  if (!found) return std::nullopt;
  ReducedVector<N> x;
  ReducedVector<N> tail;
  for (int k = 0; k < N; ++k) {
    x[k] = found->x[static_cast<std::size_t>(k)].hi;
    tail[k] = found->x[static_cast<std::size_t>(k)].lo;
  }
  return family.member(x, tail, double(found->parameter), found->error_bound);
}

template <class At>
std::vector<NumberSlopes> slopes_by(const FamilyParameters& at,
                                    std::span<const std::string> numbers, std::size_t count,
                                    const At& values) {
  std::vector<NumberSlopes> out;
  for (const std::string& number : numbers) {
    const double value = parameter_value(at, number);
    out.push_back({number, value,
                   difference_quotients(
                       [&](double x) -> std::optional<std::vector<double>> {
                         const auto beside = moved_number(at, number, x);
                         if (!beside) return std::nullopt;
                         return values(*beside);
                       },
                       value, size_of(value), count)});
  }
  return out;
}

bool stopped(const std::atomic<bool>* stop) { return stop != nullptr && *stop; }

}  // namespace

std::vector<Column> sloped_columns(std::span<const Column> columns) {
  std::vector<Column> out;
  for (const Column c : columns) {
    const bool of_error =
        c == Column::residual || c == Column::compatibility || c == Column::error_bound;
    const bool of_event = c == Column::criticality;
    if (cell_kind(c) == CellKind::number && !of_error && !of_event) out.push_back(c);
  }
  return out;
}

std::vector<NumberSlopes> motion_slopes(const FamilyParameters& at, const TableRow& row,
                                        std::span<const std::string> numbers,
                                        std::span<const Column> columns,
                                        const std::atomic<bool>* stop) {
  const ColumnSet wanted(columns);
  const bool spectrum = std::ranges::any_of(columns, is_spectral);
  const SolveOptions options{
      .method = Method::newton,
      .start = Stretch{row[Column::alpha], row[Column::xi], row[Column::zeta], row[Column::rho]},
      .stop = stop};
  return slopes_by(at, numbers, columns.size(),
                   [&](const FamilyParameters& beside) -> std::optional<std::vector<double>> {
                     if (stopped(stop)) return std::nullopt;
                     const auto kind = kind_of(beside);
                     const Equilibrium found = kind->solve(options);
                     if (found.status != SolveStatus::solved) return std::nullopt;
                     TableRow out;
                     fill_row(name(kind->motion()), kind->body(), kind->potential(), found, wanted,
                              out);
                     if (!is_near(out, row)) return std::nullopt;
                     if (spectrum) {
                       const auto modes = kind->spectrum(found);
                       if (!modes) return std::nullopt;
                       fill_spectrum(*modes, out);
                       order_modes(row, out);
                     }
                     return picked(out, columns, row);
                   });
}

std::vector<NumberSlopes> event_slopes(const FamilyParameters& at, const std::string& parameter,
                                       const Member& event, EventType type,
                                       std::span<const std::string> numbers,
                                       std::span<const Column> columns,
                                       const std::atomic<bool>* stop) {
  const ColumnSet wanted(columns);
  const std::string followed(parts_of(parameter).first);
  const FamilyParameter in_family = family_parameter(parameter, at.models);
  const auto family_at = [&](const FamilyParameters& beside) {
    return kind_of(with_parameter(beside, followed, event.parameter));
  };
  const auto family_of = [&](const Kind& kind) {
    return kind.family(in_family, {.spectrum = false}, event.q);
  };
  const Circle circle =
      std::visit([&](const auto& family) { return circle_of_figure(*family, event.q); },
                 family_of(*family_at(at)));
  TableRow near;
  fill_row(name(family_at(at)->motion()), event, wanted, near);
  return slopes_by(
      at, numbers, 1 + columns.size(),
      [&](const FamilyParameters& beside) -> std::optional<std::vector<double>> {
        if (stopped(stop)) return std::nullopt;
        std::unique_ptr<Kind> kind;
        AnyFamily beside_it;
        try {
          kind = family_at(beside);
          beside_it = family_of(*kind);
        } catch (const std::invalid_argument&) {
          return std::nullopt;
        }
        const std::optional<Member> found = std::visit(
            [&](const auto& family) { return event_beside(*family, circle, type, event); },
            beside_it);
        if (!found) return std::nullopt;
        TableRow row;
        fill_row(name(kind->motion()), *found, wanted, row);
        std::vector<double> out{found->parameter / parameter_unit(beside, parameter)};
        const std::vector<double> rest = picked(row, columns, near);
        out.insert(out.end(), rest.begin(), rest.end());
        return out;
      });
}

std::vector<double> combined_uncertainty(std::span<const NumberSlopes> slopes,
                                         std::span<const double> uncertainty) {
  if (slopes.empty()) return {};
  std::vector<double> out(slopes.front().of.slope.size(), 0.0);
  for (std::size_t i = 0; i < out.size(); ++i)
    for (std::size_t k = 0; k < slopes.size(); ++k)
      if (uncertainty[k] > 0.0) out[i] = hypotenuse(out[i], slopes[k].of.slope[i] * uncertainty[k]);
  return out;
}

}  // namespace stationary
