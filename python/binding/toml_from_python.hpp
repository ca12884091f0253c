// Python's values as TOML's and back: a case is the same tree whatever it was written in.
//
//   dict -> table   list, tuple, NumPy array -> array   str, bool, int, float and NumPy's numbers
//   a SymPy expression -> its text in the language of formulas, or its number where it is one
#pragma once

#include <pybind11/pybind11.h>
#include <toml++/toml.h>

#include <string>

namespace stationary::python {

/// Throws InputError for a value that TOML has none for, at its dotted key; name: what messages call
/// the whole.
toml::table table_from_python(const pybind11::dict& keys, const std::string& name);

/// The value as it stands after `--set key=`.
std::string assigned_text(pybind11::handle value, const std::string& key);

pybind11::object to_python(const toml::node& node);

}  // namespace stationary::python
