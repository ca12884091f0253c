// The table: CSV after RFC 4180 with LF, one header row, doubles in shortest round-trip form, an
// empty cell where nothing was computed. Columns in the contract's order; those a command does not
// compute are left out of its table.
//
// Rows stream into a buffer of the writer's own and from there, in large blocks, into a sink; a row
// costs no allocation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/program/table/number_texts.hpp"

namespace stationary {

enum class Column : std::uint8_t {
  // clang-format off
  branch, sheet, point, event, nu1, nu2, nu3, alpha, xi, zeta, rho, lambda, mu, angle,
  pi1, pi2, pi3, energy, residual, compatibility, error_bound, stability, growth, negative,
  re1, im1, krein1, re2, im2, krein2, re3, im3, krein3, re4, im4, krein4, re5, im5, krein5,
  omega, theta_dot, s3, p_theta,  // the two-polar family's
  status,                         // of a map's cell
  certified, class_certified,     // with output.certificate
  segment,                        // of a curve with classes
  criticality, side,              // of its events (solver/normal_form/normal_form.hpp)
  pressure                        // of a body whose volume is held
  // clang-format on
};

/// Column "status".
enum class CellStatus { solved, none_exists, not_found, failed };
constexpr std::string_view cell_status_names[] = {"solved", "none-exists", "not-found", "failed"};
constexpr std::string_view name(CellStatus s) { return cell_status_names[static_cast<int>(s)]; }

/// Header names, by Column.
constexpr std::string_view column_names[] = {
    // clang-format off
    "branch", "sheet", "point", "event", "nu1", "nu2", "nu3", "alpha", "xi", "zeta", "rho",
    "lambda", "mu", "angle", "pi1", "pi2", "pi3", "energy", "residual", "compatibility",
    "error_bound", "class", "growth", "negative", "re1", "im1", "krein1", "re2", "im2", "krein2",
    "re3", "im3", "krein3", "re4", "im4", "krein4", "re5", "im5", "krein5", "omega", "theta_dot",
    "s3", "p_theta", "status", "certified", "class_certified", "segment", "criticality", "side",
    "pressure"
    // clang-format on
};
constexpr std::size_t column_count = std::size(column_names);
static_assert(column_count == static_cast<std::size_t>(Column::pressure) + 1);

constexpr std::string_view name(Column c) { return column_names[static_cast<std::size_t>(c)]; }
std::optional<Column> find_column(std::string_view name);

/// What the linearization gives: class ... krein5.
constexpr bool is_spectral(Column c) { return c >= Column::stability && c <= Column::krein5; }
/// What takes the linearization: those, the proof of a class, and which segment of one class a curve's row is in.
constexpr bool needs_spectrum(Column c) {
  return is_spectral(c) || c == Column::class_certified || c == Column::segment;
}
/// What only two-polar motions have.
constexpr bool is_two_polar(Column c) { return c >= Column::omega && c <= Column::p_theta; }
/// "yes" where a proof stands behind the row's stretches and error_bound, and behind its class.
constexpr bool is_certificate(Column c) {
  return c == Column::certified || c == Column::class_certified;
}

/// What is told of a curve's events beside their names.
constexpr bool is_of_events(Column c) {
  return c == Column::event || c == Column::criticality || c == Column::side;
}

constexpr std::string_view proof_words[] = {"no", "yes", "assuming"};
/// assuming: with identities of the potential's formula taken for granted (the metadata name them).
constexpr std::string_view proof_word(bool proven, bool assuming = false) {
  return proof_words[!proven ? 0 : assuming ? 2 : 1];
}

enum class ModePart : std::uint8_t { re, im, krein };
constexpr int mode_count = 5;
/// Column of one part of mode 0 .. 4 (headed 1 .. 5).
constexpr Column mode_column(int mode, ModePart part) {
  return static_cast<Column>(static_cast<int>(Column::re1) + 3 * mode + static_cast<int>(part));
}

/// Columns somebody asks for; what none of them needs is not computed.
class ColumnSet {
 public:
  constexpr ColumnSet() = default;
  constexpr ColumnSet(std::span<const Column> columns) {  // NOLINT(google-explicit-constructor)
    for (const Column c : columns) bits_ |= bit(c);
  }
  static constexpr ColumnSet all() {
    ColumnSet out;
    out.bits_ = ~std::uint64_t{0};
    return out;
  }
  constexpr bool has(Column c) const { return (bits_ & bit(c)) != 0; }
  /// One of first ... last.
  constexpr bool has_any(Column first, Column last) const {
    return (bits_ & (2 * bit(last) - bit(first))) != 0;
  }

 private:
  static_assert(column_count < 64);
  static constexpr std::uint64_t bit(Column c) {
    return std::uint64_t{1} << static_cast<unsigned>(c);
  }
  std::uint64_t bits_ = 0;
};

/// One row; NaN and empty texts mean not computed. Texts must outlive the call that writes them.
struct TableRow {
  std::string_view branch;
  std::string_view event;
  std::string_view stability;  ///< column "class"
  std::string_view certified;
  std::string_view class_certified;
  std::string_view status;
  std::string_view side;
  std::array<double, column_count> numbers;
  double parameter;         ///< the trailing column
  double second_parameter;  ///< and one more after it, of a map

  TableRow() { clear(); }
  void clear() {
    branch = event = stability = certified = class_certified = status = side = {};
    numbers.fill(std::numeric_limits<double>::quiet_NaN());
    parameter = second_parameter = std::numeric_limits<double>::quiet_NaN();
  }
  double& operator[](Column c) { return numbers[static_cast<std::size_t>(c)]; }
  double operator[](Column c) const { return numbers[static_cast<std::size_t>(c)]; }
};

/// A number that tells whether a table read back is the one written: of the values of all cells in
/// their order, not of how a file spells them.
class TableChecksum {
 public:
  /// parameters: how many trailing columns it has.
  void add(const TableRow& row, std::span<const Column> columns, std::size_t parameters);
  void add(std::string_view text);
  void add(double value);
  /// In hexadecimal.
  std::string text() const;

 private:
  void add(std::uint64_t word);

  std::uint64_t state_ = 0x9e3779b97f4a7c15U;
};

/// Where bytes go. write() throws std::runtime_error where they cannot.
class ByteSink {
 public:
  ByteSink() = default;
  ByteSink(const ByteSink&) = delete;
  ByteSink& operator=(const ByteSink&) = delete;
  virtual ~ByteSink() = default;
  virtual void write(std::string_view bytes) = 0;
};

/// What the cells of a column are.
enum class CellKind : std::uint8_t { text, count, number };
CellKind cell_kind(Column c);
/// The row's text in a column of texts.
std::string_view text_of(const TableRow& row, Column c);
/// Is this from now on; it must outlive what is made of the row.
void set_text(TableRow& row, Column c, std::string_view text);

/// The computed columns the user asked for, in the contract's order; all of them if none is named.
std::vector<Column> select_columns(std::span<const Column> computed,
                                   std::span<const std::string> asked);

/// What a command hands its rows to, whatever the file's format.
class RowSink {
 public:
  /// parameters: how many trailing columns there are.
  RowSink(std::vector<Column> columns, std::size_t parameters)
      : columns_(std::move(columns)), parameters_(parameters) {}
  RowSink(const RowSink&) = delete;
  RowSink& operator=(const RowSink&) = delete;
  virtual ~RowSink() = default;

  void write(const TableRow& row) {
    ++rows_;
    put(row, checksum_);
  }
  /// What its rows need.
  ColumnSet columns() const { return ColumnSet(columns_); }
  std::size_t rows() const { return rows_; }
  const TableChecksum& checksum() const { return checksum_; }

 protected:
  /// Takes a row, and adds its cells to the sum.
  virtual void put(const TableRow& row, TableChecksum& sum) = 0;
  void add_cells(const TableRow& row, TableChecksum& sum) const {
    sum.add(row, columns_, parameters_);
  }
  const std::vector<Column>& column_list() const { return columns_; }

 private:
  std::vector<Column> columns_;
  std::size_t parameters_;
  TableChecksum checksum_;
  std::size_t rows_ = 0;
};

/// Of the numbers of the rows before, which lines are made with: one after the other by one thread.
using RowTexts = NumberTexts<column_count + 2>;

/// A row as a line of CSV, and the line of the names.
class RowFormat {
 public:
  /// parameter, second: headers of the trailing columns, if there are such.
  RowFormat(const std::vector<Column>& columns, const std::optional<std::string>& parameter,
            const std::optional<std::string>& second);

  std::string header() const;
  static const std::size_t longest_line;
  /// From `at` on, where there must be room for the longest. The line's end.
  char* line(const TableRow& row, RowTexts& texts, char* at) const;
  /// Its cells are added to the sum as they are written: a step of the sum waits for the one before,
  /// and the processor writes meanwhile.
  char* line(const TableRow& row, RowTexts& texts, char* at, TableChecksum& sum) const;

 private:
  template <class Sum>
  char* summed_line(const TableRow& row, RowTexts& texts, char* at, Sum& sum) const;

  std::vector<Column> columns_;
  std::vector<std::string> parameters_;
};

class TableWriter final : public RowSink {
 public:
  /// As of RowFormat. Writes the header.
  TableWriter(ByteSink& sink, std::vector<Column> columns,
              const std::optional<std::string>& parameter = std::nullopt,
              const std::optional<std::string>& second = std::nullopt);

  /// Hands the rest to the sink. Without it the last block is lost.
  void flush();

 private:
  void put(const TableRow& row, TableChecksum& sum) override;

  ByteSink* sink_;
  RowFormat format_;
  RowTexts texts_;
  std::vector<char> buffer_;
  char* cursor_ = nullptr;
};

}  // namespace stationary
