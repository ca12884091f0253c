// The keys of a case file: one declarative table of names, types and what is allowed, and the check
// of a parsed file against it. Everything that needs to know the keys asks here.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/material/potential.hpp"
#include "solver/program/case/case_toml.hpp"
#include "solver/program/text/faults.hpp"

namespace stationary {

enum class KeyType {
  table,
  model,         ///< a table of `model` and that model's coefficients
  coefficients,  ///< a table of the coefficients of the one model it can be
  text,
  number,   ///< finite; integers count as numbers
  numbers,  ///< a fixed count of them
  ranges,   ///< one pair of numbers, or a fixed count of pairs
  boolean,
  texts,
  uncertainties  ///< a table of numbers > 0 by dotted keys of numbers of the case
};

struct CaseKey {
  std::string_view path;  ///< dotted
  KeyType type;
  bool required;                                   ///< whenever the table it stands in is there
  std::string_view allowed;                        ///< for messages
  int count = 0;                                   ///< of numbers
  std::span<const std::string_view> choices = {};  ///< names a text may hold; none: any text
};

std::span<const CaseKey> case_keys();

/// The key with this dotted path, or nullptr.
const CaseKey* find_case_key(std::string_view path);

/// Which of the models a `potential.*` table takes.
ModelDescription::Kind model_kind(std::string_view path);

/// The model of that kind and name, or nullptr.
const ModelDescription* find_model(ModelDescription::Kind kind, std::string_view name);

/// Checks names, types, counts, choices and required keys of the whole file; models' names and the
/// names of their coefficients included. What it finds nothing against may be read without further
/// checks of type.
void require_known_keys(const CaseTree& tree, Faults& faults);

/// Whether a case may have a value at this dotted key: a key of the table, an element of an array of
/// numbers, or a number of a model.
bool may_be_set(std::string_view path);

/// Whether that key is of a number of the body, its gravity, its potential or the motion.
bool is_number_of_case(std::string_view path);

/// `found` and `allowed` at a key's value, ready to throw.
InputError fault_at(const CaseTree& tree, std::string_view key, std::string found,
                    std::string allowed, std::string remedy = {});

}  // namespace stationary
