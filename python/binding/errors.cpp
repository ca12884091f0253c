// Wrong input as stationary.InputError, with its text and its parts.
#include <exception>
#include <stdexcept>

#include "python/binding/module.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary::python {
namespace {

py::object none_if_empty(const std::string& text) {
  return text.empty() ? py::object(py::none()) : py::str(text);
}

void raise_input_error(const InputError& error) {
  const py::object type = py::module_::import("stationary.errors").attr("InputError");
  const py::object raised = type(error.what());
  const Origin& origin = error.origin();
  const auto place = [](int number) {
    return number > 0 ? py::object(py::int_(number)) : py::none();
  };
  raised.attr("key") = none_if_empty(error.key());
  raised.attr("file") = none_if_empty(origin.file);
  raised.attr("line") = place(origin.line);
  raised.attr("column") = place(origin.column);
  raised.attr("option") = none_if_empty(origin.option);
  raised.attr("found") = none_if_empty(error.found());
  raised.attr("allowed") = none_if_empty(error.allowed());
  raised.attr("remedy") = none_if_empty(error.remedy());
  PyErr_SetObject(type.ptr(), raised.ptr());
}

}  // namespace

void declare_errors(py::module_&) {
  py::register_local_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const InputError& wrong) {
      raise_input_error(wrong);
    } catch (const std::invalid_argument& wrong) {
      // Misuse of the library: the text is what is required.
      raise_input_error(InputError({}, "", "", wrong.what()));
    }
  });
}

}  // namespace stationary::python
