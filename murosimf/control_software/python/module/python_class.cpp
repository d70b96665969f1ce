#include "murosimf/control_software/python/module/python_class.h"

#include <array>
#include <chrono>
#include <sstream>
#include <thread>
#include <variant>

namespace murosimf::control_software::python {
namespace {

Object value_of(const OptionValue& value) {
  if (const auto* as_number = std::get_if<double>(&value)) return number(*as_number);
  if (const auto* as_truth = std::get_if<bool>(&value)) return truth(*as_truth);
  if (const auto* as_text = std::get_if<std::string>(&value)) return text(*as_text);
  const auto& vector = std::get<Vec3d>(value);
  return Object(Py_BuildValue("(ddd)", vector.x, vector.y, vector.z));
}

Object request_of(const PythonRequest& given) {
  Object request(PyDict_New()), options(PyDict_New());
  for (const auto& [name, value] : given.options) put(options, name.c_str(), value_of(value));
  put(request, "module", text(given.module));
  put(request, "class", text(given.name));
  put(request, "file", text(given.file));
  put(request, "folder", text(given.folder));
  put(request, "robot", text(given.robot));
  put(request, "team", text(given.team));
  put(request, "model", text(given.model));
  put(request, "seed", Object(PyLong_FromUnsignedLongLong(given.seed)));
  put(request, "joints", list_of(given.joints));
  put(request, "objects", list_of(given.objects));
  put(request, "options", options);
  put(request, "of_scene_file", truth(given.of_scene_file));
  return request;
}

/// Name, unit and labels of each, one after the other.
std::vector<PythonOutput> outputs_of(const Object& flat) {
  const std::vector<std::string> texts = texts_of(flat);
  std::vector<PythonOutput> outputs;
  for (std::size_t i = 0; i + 2 < texts.size(); i += 3) {
    PythonOutput output{texts[i], texts[i + 1], {}};
    std::istringstream labels(texts[i + 2]);
    for (std::string label; labels >> label;) output.labels.push_back(label);
    outputs.push_back(std::move(output));
  }
  return outputs;
}

PythonTraits traits_of(const Object& loaded) {
  return {.file = text_of(loaded.attribute("file")),
          .where = text_of(loaded.attribute("where")),
          .phase = text_of(loaded.attribute("phase")),
          .rate = number_of(loaded.attribute("rate")),
          .reads = texts_of(loaded.attribute("reads")),
          .writes = texts_of(loaded.attribute("writes")),
          .gives = outputs_of(loaded.attribute("gives")),
          .starts = PyObject_IsTrue(loaded.attribute("starts").get()) == 1,
          .saves = PyObject_IsTrue(loaded.attribute("saves").get()) == 1};
}

PythonOutcome::Kind kind_of(const std::string& name) {
  if (name == "refused") return PythonOutcome::refused;
  if (name == "late") return PythonOutcome::late;
  if (name == "ends") return PythonOutcome::ends;
  return name == "interrupted" ? PythonOutcome::interrupted : PythonOutcome::raised;
}

/// Ctrl-C in a Python program: the call of the package that steps the scene raises it again. It asks for signals every 10 ms: so after
/// this step, before any further one.
void interrupt_program() {
  PyErr_SetInterrupt();
  std::this_thread::sleep_for(std::chrono::milliseconds(12));
}

}  // namespace

PythonOutcome outcome_of_exception(const Object& explain, const std::string& file) noexcept {
  PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
  PyErr_Fetch(&type, &value, &trace);
  PyErr_NormalizeException(&type, &value, &trace);
  if (value && trace) PyException_SetTraceback(value, trace);
  Py_XDECREF(type);
  Py_XDECREF(trace);
  try {
    const Object raised(value), told = explain(raised, text(file));
    return {kind_of(text_of(Object(PySequence_GetItem(told.get(), 0)))),
            text_of(Object(PySequence_GetItem(told.get(), 1))), texts_of(Object(PySequence_GetItem(told.get(), 2)))};
  } catch (const Raised&) {
    PyErr_Clear();
    return {PythonOutcome::raised, "an exception that cannot be explained", {}};
  }
}

Class::Class(const Classes& classes, Watch& watch, const PythonRequest& request, Duration limit)
    : classes_(classes), watch_(watch) {
  const Watch::Call watched(watch_, this, limit);
  loaded_ = classes_.load(request_of(request));
  traits_ = traits_of(loaded_);
  robot_ = loaded_.attribute("robot");
  find_object();
}

/// After the end of the interpreter, as at the exit of a Python program, its objects are gone.
Class::~Class() {
  if (Py_IsInitialized() == 0) {
    (void)loaded_.release();
    (void)object_.release();
    (void)robot_.release();
    return;
  }
  const Lock locked;
  loaded_ = {};
  object_ = {};
  robot_ = {};
}

void Class::find_object() { object_ = loaded_.attribute("object"); }

/// function(): with the interpreter's lock; throws Raised.
template <class Function>
PythonOutcome Class::call(Duration limit, const Function& function) noexcept {
  PythonOutcome outcome;
  {
    const Lock locked;
    try {
      const Watch::Call watched(watch_, this, limit);
      function();
    } catch (const Raised&) {
      outcome = outcome_of_exception(classes_.explain, traits_.file);
    }
  }
  if (outcome.kind == PythonOutcome::interrupted && !classes_.own_interpreter) interrupt_program();
  return outcome;
}

double* Class::add(const PythonRow& row, PythonOutcome& outcome) noexcept {
  static constexpr std::array kinds{"property", "signal", "command", "output"};
  double* memory = nullptr;
  outcome = call(std::chrono::seconds(10), [&] {
    Object shape(PyList_New(0));
    for (const std::size_t size : row.shape) {
      if (PyList_Append(shape.get(), Object(PyLong_FromSize_t(size)).get()) != 0) throw Raised();
    }
    const Object address = loaded_.attribute("add")(text(row.name), text(kinds[row.kind]), shape, list_of(row.labels),
                                                    truth(row.writable));
    memory = static_cast<double*>(PyLong_AsVoidPtr(address.get()));
    if (!memory) throw Raised();
  });
  return memory;
}

void Class::print_to(std::function<void(const std::string&)> say) noexcept {
  say_ = std::move(say);
  for (const std::string& line : early_) say_(line);
  early_.clear();
}

void Class::say(const std::string& line) const {
  if (say_) {
    say_(line);
  } else {
    early_.push_back(line);
  }
}

void Class::reseed(std::uint64_t seed) noexcept {
  (void)call(std::chrono::seconds(10),
             [&] { (void)loaded_.attribute("reseed")(Object(PyLong_FromUnsignedLongLong(seed))); });
}

PythonOutcome Class::renew(Duration limit) noexcept {
  return call(limit, [&] {
    (void)loaded_.attribute("renew")();
    find_object();
  });
}

PythonOutcome Class::start(double time, Duration limit) noexcept {
  return call(limit, [&] { (void)object_.attribute("start")(robot_, number(time)); });
}

PythonOutcome Class::step(double time, Duration limit) noexcept {
  return call(limit, [&] { (void)object_(robot_, number(time)); });
}

PythonOutcome Class::save(std::string& bytes, Duration limit) noexcept {
  return call(limit, [&] {
    const Object saved = loaded_.attribute("save")();
    char* data = nullptr;
    Py_ssize_t size = 0;
    if (PyBytes_AsStringAndSize(saved.get(), &data, &size) != 0) throw Raised();
    bytes.assign(data, static_cast<std::size_t>(size));
  });
}

PythonOutcome Class::load(const std::string& bytes, Duration limit) noexcept {
  return call(limit, [&] {
    const Object given(PyBytes_FromStringAndSize(bytes.data(), static_cast<Py_ssize_t>(bytes.size())));
    (void)object_.attribute("load")(given);
  });
}

}  // namespace murosimf::control_software::python
