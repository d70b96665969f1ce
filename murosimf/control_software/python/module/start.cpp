// The module murosimf-python.so: begins Python, or joins the interpreter of a Python program, and loads classes.
#include "murosimf/control_software/python/module/python_class.h"

#include <dlfcn.h>

#include <atomic>
#include <clocale>
#include <csignal>
#include <string>

#include <classes_text.h>

namespace murosimf::control_software::python {
namespace {

Watch* watch = nullptr;

/// Whether a call of a class runs in this thread, to which the line belongs then.
PyObject* say(PyObject*, PyObject* line) {
  const Class* const running = watch ? watch->place().running : nullptr;
  if (!running) Py_RETURN_FALSE;
  Py_ssize_t size = 0;
  const char* const bytes = PyUnicode_AsUTF8AndSize(line, &size);
  if (!bytes) return nullptr;
  running->say({bytes, static_cast<std::size_t>(size)});
  Py_RETURN_TRUE;
}

PyMethodDef say_function{"say", say, METH_O, nullptr};

/// Functions that newer versions of the stable interface no longer have, and those that never were in it.
template <class Function>
Function* python_function(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

/// Handlers of signals and the locale of the process remain those of the program.
void initialize(const std::string& program) {
  const std::string locale = std::setlocale(LC_CTYPE, nullptr);
  if (auto* const name = python_function<void(const wchar_t*)>("Py_SetProgramName"); name && !program.empty()) {
    name(Py_DecodeLocale(program.c_str(), nullptr));  // Python keeps the text
  }
  Py_InitializeEx(0);
  std::setlocale(LC_CTYPE, locale.c_str());
}

class Backend final : public PythonBackend {
 public:
  /// With the interpreter's lock. Throws Raised.
  Backend(const Object& module, bool own_interpreter, bool (*interrupted)())
      : classes_{module.attribute("load"), module.attribute("explain"), own_interpreter},
        watch_(module.attribute("Late"), module.attribute("Interrupted"), interrupted, !own_interpreter) {}

  [[nodiscard]] PythonObject* load(const PythonRequest& request, Duration limit,
                                   PythonOutcome& outcome) noexcept override {
    const Lock locked;
    try {
      return new Class(classes_, watch_, request, limit);
    } catch (const Raised&) {
      outcome = outcome_of_exception(classes_.explain, {});
      return nullptr;
    }
  }

  void abandon() noexcept override {
    Watch::Place& place = watch_.place();
    place.due = 0;
    place.running = nullptr;
    auto* const holds = python_function<int()>("PyGILState_Check");
    if (holds && holds() != 0) (void)PyEval_SaveThread();
  }

  [[nodiscard]] Watch& the_watch() { return watch_; }

 private:
  Classes classes_;
  Watch watch_;
};

Object run_classes_text() {
  const Object code(Py_CompileString(classes_text, "<murosimf>/classes.py", Py_file_input));
  return Object(PyImport_ExecCodeModule("_murosimf_classes", code.get()));
}

/// One line about the exception that is set.
std::string line_of_exception() {
  PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
  PyErr_Fetch(&type, &value, &trace);
  PyErr_NormalizeException(&type, &value, &trace);
  std::string line = "Python cannot be started";
  try {
    line = text_of(Object(PyObject_Str(value)));
  } catch (const Raised&) {
    PyErr_Clear();
  }
  Py_XDECREF(type);
  Py_XDECREF(value);
  Py_XDECREF(trace);
  return line;
}

/// With the interpreter's lock. Null: `why`.
Backend* make_backend(const PythonStart& start, bool own_interpreter, std::string& why) {
  try {
    const Object module = run_classes_text();
    auto* const backend = new Backend(module, own_interpreter, start.interrupted);
    watch = &backend->the_watch();
    // what a Python program prints stays its own affair
    if (own_interpreter) (void)module.attribute("own_interpreter")(Object(PyCFunction_New(&say_function, nullptr)));
    return backend;
  } catch (const Raised&) {
    why = line_of_exception();
    return nullptr;
  }
}

// ---- Ctrl-C in a Python program: its handler acts in the main thread alone ----

std::atomic<bool> ctrl_c{false};
void (*handler_of_python)(int) = nullptr;

void on_ctrl_c(int signal) {
  ctrl_c = true;
  handler_of_python(signal);
}

bool ctrl_c_came() { return ctrl_c.exchange(false); }

/// Calls in other threads are ended by the watch, for which the signal is noted before Python's own handler gets it.
void note_ctrl_c() {
  struct sigaction action {};
  const bool handled = sigaction(SIGINT, nullptr, &action) == 0 && (action.sa_flags & SA_SIGINFO) == 0 &&
                       action.sa_handler != SIG_DFL && action.sa_handler != SIG_IGN;
  if (!handled) return;
  handler_of_python = action.sa_handler;
  action.sa_handler = on_ctrl_c;
  sigaction(SIGINT, &action, nullptr);
}

PythonBackend* begin(const PythonStart& start, std::string& why) {
  if (Py_IsInitialized() != 0) {
    const Lock locked;
    note_ctrl_c();
    return make_backend({.program = {}, .interrupted = ctrl_c_came}, false, why);
  }
  initialize(start.program);
  PythonBackend* const backend = make_backend(start, true, why);
  (void)PyEval_SaveThread();
  return backend;
}

}  // namespace
}  // namespace murosimf::control_software::python

extern "C" __attribute__((visibility("default"))) murosimf::control_software::PythonBackend* murosimf_start_python(
    const murosimf::control_software::PythonStart& start, std::string& why) {
  static std::string reason;
  static auto* const backend = murosimf::control_software::python::begin(start, reason);
  why = reason;
  return backend;
}
