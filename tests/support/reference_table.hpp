// Reference tables (tests/data/*.csv): a header line, then rows of text. Cells stay text, so that
// 25 printed digits reach a 50-digit number and coefficients never pass through a double.
//
// What a row was computed from differs: the tables of equilibria from the doubles nearest to the
// printed inputs, the others from the decimals themselves (checked on the thickness balance, which
// is closed: the other reading leaves 1e-16 instead of 1e-24). Moments of inertia are doubles in
// Body; to keep a decimal J exact, such a row is posed in units in which it is an integer: J and V
// times 10^4 have the same stationary motions.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "lib/body/motion.hpp"
#include "lib/material/potential.hpp"
#include "tests/support/bodies/models.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary::support {

/// Text to a number, each type by its own reader; ".7" and "7" included.
template <class T>
T parse(const std::string& text) {
  if constexpr (std::is_same_v<T, double>) {
    return std::stod(text);
  } else {
    return T(text.front() == '.' ? "0" + text : text);
  }
}

/// How to read the inputs (coefficients, J, nu) of a table.
enum class Inputs { doubles, decimals };

class ReferenceRow {
 public:
  ReferenceRow(std::string where, Inputs inputs, std::map<std::string, std::string> cells)
      : where_(std::move(where)), inputs_(inputs), cells_(std::move(cells)) {}

  const std::string& where() const { return where_; }
  const std::string& text(const std::string& column) const {
    const auto found = cells_.find(column);
    if (found == cells_.end()) throw std::out_of_range(where_ + ": no column " + column);
    return found->second;
  }
  /// A result of the table: all its digits.
  template <class T>
  T number(const std::string& column) const {
    return parse<T>(text(column));
  }
  /// An input of the table, as it was read when the table was made.
  template <class T>
  T input(const std::string& column) const {
    if (inputs_ == Inputs::doubles) return T(parse<double>(text(column)));
    return parse<T>(text(column));
  }

  /// Factor on J and V that makes every J of this row a double.
  double unit() const { return inputs_ == Inputs::doubles ? 1.0 : 1e4; }
  /// J in the scaled units; exact.
  double scaled_inertia(const std::string& column) const {
    const Real50 scaled = input<Real50>(column) * unit();
    const double value = nearest(scaled);
    if (abs(Real50(scaled - value)) > Real50("1e-40"))
      throw std::domain_error(where_ + ": more than four decimals in " + column);
    return value;
  }
  Body scaled_body() const {
    return {scaled_inertia("J1"), scaled_inertia("J2"), scaled_inertia("J3")};
  }
  /// To double precision.
  Body body() const { return {number<double>("J1"), number<double>("J2"), number<double>("J3")}; }

  Branch branch() const { return branch_from_name(text("branch")).value(); }

  template <class T>
  BasicStretch<T> stretch() const {
    const T alpha = cells_.contains("alpha") ? number<T>("alpha") : T(0.0);
    return {alpha, number<T>("xi"), number<T>("zeta"), number<T>("rho")};
  }
  /// From branch and nu, or from the three components.
  template <class T>
  Vector3<T> nu() const {
    if (cells_.contains("nu")) return angular_velocity(branch(), input<T>("nu"));
    return {input<T>("nu1"), input<T>("nu2"), input<T>("nu3")};
  }

  Potential potential() const {
    const double plane[] = {coefficient<double>(1), coefficient<double>(2)};
    const double axial[] = {number<double>("a"), number<double>("b")};
    return {Potential::planar(text("model"), plane),
            Potential::thickness("reciprocal-quadratic", axial)};
  }

  /// Calls f with the model in the scaled units, coefficients of type T.
  template <class T, class F>
  void with_scaled_model(F&& f) const {
    const T scale = unit();
    const ReciprocalQuadratic<T> thickness{input<T>("a") * scale, input<T>("b") * scale};
    std::visit(
        [&]<template <class> class Plane>(const Plane<double>&) {
          const Plane<T> plane{coefficient<T>(1) * scale, coefficient<T>(2) * scale};
          f(Separable<Plane<T>, ReciprocalQuadratic<T>>{plane, thickness});
        },
        potential().plane());
  }

 private:
  /// Columns v1, v2, or p1, p2 in the table of events.
  template <class T>
  T coefficient(int k) const {
    const std::string column = std::to_string(k);
    return input<T>(cells_.contains("v" + column) ? "v" + column : "p" + column);
  }

  std::string where_;
  Inputs inputs_;
  std::map<std::string, std::string> cells_;
};

inline std::vector<ReferenceRow> reference_table(const std::string& name) {
  const Inputs inputs = name.starts_with("equilibria") ? Inputs::doubles : Inputs::decimals;
  std::ifstream file(std::string(STATIONARY_TEST_DATA) + "/" + name);
  if (!file) throw std::runtime_error("cannot read " + name);
  const auto split = [](std::string line) {
    if (line.ends_with('\r')) line.pop_back();
    std::vector<std::string> out;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) out.push_back(cell);
    return out;
  };
  std::string line;
  std::getline(file, line);
  const auto header = split(line);
  std::vector<ReferenceRow> rows;
  for (int number = 2; std::getline(file, line); ++number) {
    const auto cells = split(line);
    if (cells.size() != header.size())
      throw std::runtime_error(name + ": row " + std::to_string(number) + " has the wrong length");
    std::map<std::string, std::string> row;
    for (std::size_t k = 0; k < header.size(); ++k) row[header[k]] = cells[k];
    rows.emplace_back(name + ":" + std::to_string(number), inputs, std::move(row));
  }
  return rows;
}

}  // namespace stationary::support
