#include "python/binding/toml_from_python.hpp"

#include <sstream>
#include <string>
#include <utility>
#include <variant>

#include "solver/program/case/case_toml.hpp"
#include "solver/program/text/input_error.hpp"
#include "solver/program/text/toml_depth.hpp"

namespace stationary::python {
namespace py = pybind11;

namespace {

/// Where a value stands.
struct Place {
  const Origin& origin;
  std::string key;
  int depth = 0;

  Place below(const std::string& name) const { return {origin, dotted(key, name), depth + 1}; }
  [[noreturn]] void refuse(const std::string& found, const std::string& allowed) const {
    throw InputError(origin, printable(key), found, allowed);
  }
};

std::string type_name(py::handle value) {
  return py::str(py::type::handle_of(value).attr("__name__"));
}

using Value = std::variant<bool, std::int64_t, double, std::string, toml::array, toml::table>;

std::int64_t integer(py::handle value, const Place& at) {
  const auto whole = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if (!whole) throw py::error_already_set();
  int overflow = 0;
  const long long number = PyLong_AsLongLongAndOverflow(whole.ptr(), &overflow);
  if (overflow != 0)
    at.refuse("found the integer " + py::cast<std::string>(py::str(whole)),
              "an integer of 64 bits");
  return number;
}

/// Whether it is of NumPy: an array, or a number, of which some pass for Python's own.
bool is_numpy(py::handle value) {
  return py::hasattr(value, "dtype") && py::hasattr(value, "tolist");
}

/// A text of Python may hold what none of Unicode's has.
std::string text(py::handle value, const Place& at) {
  Py_ssize_t size = 0;
  const char* const begin = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
  if (begin != nullptr) return {begin, static_cast<std::size_t>(size)};
  PyErr_Clear();
  at.refuse("found half a character (a lone surrogate)", "text in Unicode");
}

Value converted(py::handle value, const Place& at);

Value of_numpy(py::handle value, const Place& at) {
  const py::object held = value.attr("tolist")();
  if (!py::type::handle_of(held).is(py::type::handle_of(value))) return converted(held, at);
  // Python has none of NumPy's widest numbers, which stay what they are; a real one has a double.
  if (py::isinstance(held, py::module_::import("numpy").attr("floating")))
    return py::cast<double>(py::float_(held));
  at.refuse("found a value of type " + type_name(value), "a number of at most 64 bits");
}

/// sympy_text raises ValueError for what no formula has, and says what it is.
Value of_sympy(py::handle value, const Place& at) {
  py::object plain;
  try {
    plain = py::module_::import("stationary.sympy_text").attr("plain")(value);
  } catch (const py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError)) throw;
    at.refuse("found " + std::string(py::str(error.value())), "real, finite numbers");
  }
  return converted(plain, at);
}

toml::table table(const py::dict& keys, const Place& at) {
  toml::table out;
  for (const auto& [key, value] : keys) {
    if (!py::isinstance<py::str>(key)) at.refuse("found a key of type " + type_name(key), "names");
    const std::string name = text(key, at);
    std::visit([&](auto&& each) { out.insert(name, std::forward<decltype(each)>(each)); },
               converted(value, at.below(name)));
  }
  return out;
}

toml::array array(const py::sequence& values, const Place& at) {
  toml::array out;
  for (const py::handle value : values)
    std::visit([&](auto&& each) { out.push_back(std::forward<decltype(each)>(each)); },
               converted(value, at.below(std::to_string(out.size()))));
  return out;
}

Value converted(py::handle value, const Place& at) {
  if (at.depth > largest_toml_depth)
    at.refuse("found a value that nests more deeply than a case does",
              "at most " + std::to_string(largest_toml_depth) + " in one another");
  const Place inside{at.origin, at.key, at.depth + 1};
  if (is_numpy(value)) return of_numpy(value, inside);
  if (py::isinstance<py::bool_>(value)) return py::cast<bool>(value);
  if (py::isinstance<py::str>(value)) return text(value, at);
  if (PyIndex_Check(value.ptr()) != 0) return integer(value, at);
  if (py::isinstance<py::float_>(value)) return py::cast<double>(value);
  if (py::isinstance<py::dict>(value)) return table(py::cast<py::dict>(value), at);
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value))
    return array(py::cast<py::sequence>(value), at);
  if (py::hasattr(value, "free_symbols")) return of_sympy(value, inside);
  at.refuse("found a value of type " + type_name(value),
            "a number, a text, true or false, a list of them, or a dict");
}

/// Text in TOML, on one line.
void write(const toml::node& node, std::ostream& out) {
  if (const toml::table* table = node.as_table()) {
    const char* between = "{ ";
    for (const auto& [key, each] : *table) {
      out << std::exchange(between, ", ");
      write(toml::value<std::string>(std::string(key.str())), out);
      out << " = ";
      write(each, out);
    }
    out << (table->empty() ? "{}" : " }");
  } else if (const toml::array* array = node.as_array()) {
    out << '[';
    const char* between = "";
    for (const toml::node& each : *array) {
      out << std::exchange(between, ",");
      write(each, out);
    }
    out << ']';
  } else if (const auto* text = node.as_string()) {
    // A basic string of TOML is JSON's, but for U+007F.
    const py::object json = py::module_::import("json").attr("dumps");
    const py::object written = json(text->get(), py::arg("ensure_ascii") = false);
    out << py::cast<std::string>(written.attr("replace")("\x7f", "\\u007f"));
  } else if (const auto* number = node.as_floating_point()) {
    out << std::string(py::repr(py::float_(number->get())));  // the shortest that reads the same
  } else {
    node.visit([&](const auto& each) { out << each; });
  }
}

}  // namespace

toml::table table_from_python(const py::dict& keys, const std::string& name) {
  const Origin origin = Origin::in_file(name);
  return table(keys, {origin, ""});
}

std::string assigned_text(py::handle value, const std::string& key) {
  const Origin origin = Origin::of_option("--set " + key);
  toml::table held;
  std::visit([&](auto&& each) { held.insert("value", std::forward<decltype(each)>(each)); },
             converted(value, {origin, key}));
  std::ostringstream out;
  write(*held.get("value"), out);
  return out.str();
}

py::object to_python(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table: {
      py::dict out;
      for (const auto& [key, each] : *node.as_table())
        out[py::str(std::string(key.str()))] = to_python(each);
      return out;
    }
    case toml::node_type::array: {
      py::list out;
      for (const toml::node& each : *node.as_array()) out.append(to_python(each));
      return out;
    }
    case toml::node_type::integer:
      return py::int_(node.as_integer()->get());
    case toml::node_type::floating_point:
      return py::float_(node.as_floating_point()->get());
    case toml::node_type::boolean:
      return py::bool_(node.as_boolean()->get());
    default:
      return py::str(node.value_or(std::string()));
  }
}

}  // namespace stationary::python
