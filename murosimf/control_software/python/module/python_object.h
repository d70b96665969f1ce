/// python_object.h - objects of Python's C interface that are released by themselves. All of it with the interpreter's lock.
#pragma once

#define Py_LIMITED_API 0x030A0000
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace murosimf::control_software::python {

/// Thrown where an exception of Python is set.
struct Raised {};

class Object {
 public:
  Object() = default;
  /// Takes over a new reference. Throws Raised if it is null.
  explicit Object(PyObject* taken) : object_(taken) {
    if (!taken) throw Raised();
  }
  Object(Object&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  ~Object() { Py_XDECREF(object_); }

  [[nodiscard]] PyObject* get() const { return object_; }
  [[nodiscard]] PyObject* release() { return std::exchange(object_, nullptr); }
  [[nodiscard]] Object attribute(const char* name) const { return Object(PyObject_GetAttrString(object_, name)); }
  template <class... Arguments>
  Object operator()(const Arguments&... arguments) const {
    return Object(PyObject_CallFunctionObjArgs(object_, arguments.get()..., nullptr));
  }

 private:
  PyObject* object_ = nullptr;
};

[[nodiscard]] inline Object text(std::string_view given) {
  return Object(PyUnicode_DecodeUTF8(given.data(), static_cast<Py_ssize_t>(given.size()), "replace"));
}
[[nodiscard]] inline Object number(double given) { return Object(PyFloat_FromDouble(given)); }
[[nodiscard]] inline Object truth(bool given) { return Object(PyBool_FromLong(given ? 1 : 0)); }

[[nodiscard]] inline Object list_of(const std::vector<std::string>& texts) {
  Object list(PyList_New(0));
  for (const std::string& each : texts) {
    if (PyList_Append(list.get(), text(each).get()) != 0) throw Raised();
  }
  return list;
}

[[nodiscard]] inline std::string text_of(const Object& object) {
  Py_ssize_t size = 0;
  const char* const bytes = PyUnicode_AsUTF8AndSize(object.get(), &size);
  if (!bytes) throw Raised();
  return {bytes, static_cast<std::size_t>(size)};
}

[[nodiscard]] inline double number_of(const Object& object) {
  const double value = PyFloat_AsDouble(object.get());
  if (PyErr_Occurred()) throw Raised();
  return value;
}

/// Of a list or tuple of texts.
[[nodiscard]] inline std::vector<std::string> texts_of(const Object& sequence) {
  std::vector<std::string> texts;
  const Py_ssize_t size = PySequence_Size(sequence.get());
  for (Py_ssize_t i = 0; i < size; ++i) texts.push_back(text_of(Object(PySequence_GetItem(sequence.get(), i))));
  return texts;
}

/// Writes an entry of a dictionary.
inline void put(const Object& dictionary, const char* key, const Object& value) {
  if (PyDict_SetItemString(dictionary.get(), key, value.get()) != 0) throw Raised();
}

/// The interpreter's lock, held by this thread.
class Lock {
 public:
  Lock() : state_(PyGILState_Ensure()) {}
  ~Lock() { PyGILState_Release(state_); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  PyGILState_STATE state_;
};

}  // namespace murosimf::control_software::python
