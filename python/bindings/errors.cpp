// What the library throws becomes the exceptions of murosimf/errors.py, with the same text.
#include "murosimf/error.h"

#include "module.h"

namespace nb = nanobind;

namespace murosimf::python {
namespace {

/// The module stays until the process ends, and so do these.
nb::handle type(const char* name) { return nb::object(nb::module_::import_("murosimf.errors").attr(name)).release(); }

struct Types {
  nb::handle error = type("StateError"), input = type("InputError"), unknown = type("UnknownName"),
             simulation = type("SimulationError");
};

void translate(const std::exception_ptr& thrown, void* types) {
  const Types& known = *static_cast<const Types*>(types);
  try {
    std::rethrow_exception(thrown);
  } catch (const UnknownName& error) {
    PyErr_SetString(known.unknown.ptr(), error.what());
  } catch (const InputError& error) {
    PyErr_SetString(known.input.ptr(), error.what());
  } catch (const SimulationError& error) {
    PyErr_SetString(known.simulation.ptr(), error.what());
  } catch (const Error& error) {
    PyErr_SetString(known.error.ptr(), error.what());
  }
}

}  // namespace

void bind_errors() {
  static Types types;
  nb::register_exception_translator(translate, &types);
}

}  // namespace murosimf::python
