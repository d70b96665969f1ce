#include "murosimf/control_software/python/python_interpreter.h"

#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::control_software {

namespace fs = std::filesystem;

namespace {

bool (*end_asked)() = nullptr;

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

/// Folder of the file in which this code is: the program, the library or the extension of Python.
fs::path own_folder() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&python_backend), &info) == 0 || !info.dli_fname) return {};
  std::error_code error;
  return fs::canonical(info.dli_fname, error).parent_path();
}

/// Beside the program or the extension, where it was built, or where it was installed.
std::string module_file() {
  constexpr const char* name = "murosimf-python.so";
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& place : {own_folder() / name, program / name, program.parent_path() / name,
                                fs::path(MUROSIMF_PYTHON_BUILT), fs::path(MUROSIMF_PYTHON_INSTALLED)}) {
    if (fs::is_regular_file(place, error)) return place.string();
  }
  throw SetupError(fmt::format("controller 'python' needs the module {}, which is neither beside this program nor {}",
                               name, MUROSIMF_PYTHON_INSTALLED));
}

/// Its symbols are for all: extensions of Python, like NumPy, need them.
bool load_library_of_python(const std::string& file) {
  return !file.empty() && dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL) != nullptr;
}

/// The program of the Python whose library was loaded: of a virtual environment that is active, or that of the build.
std::string load_python() {
  const std::string chosen = environment("MUROSIMF_PYTHON"), active = environment("VIRTUAL_ENV");
  const std::string program = !chosen.empty() ? chosen : active.empty() ? "" : active + "/bin/python3";
  if (load_library_of_python(environment("MUROSIMF_LIBPYTHON"))) return program;
  std::error_code error;
  if (load_library_of_python(MUROSIMF_LIBPYTHON)) {
    const bool there = program.empty() && fs::exists(MUROSIMF_PYTHON_PROGRAM, error);
    return there ? MUROSIMF_PYTHON_PROGRAM : program;
  }
  for (int minor = 20; minor >= 10; --minor) {
    if (load_library_of_python(fmt::format("libpython3.{}.so.1.0", minor))) return program;
  }
  throw SetupError(
      "controller 'python' needs Python as a shared library (Debian: libpython3.11), which is not found; "
      "MUROSIMF_LIBPYTHON can name its file");
}

PythonBackend* start() {
  const std::string file = module_file();
  const std::string program = in_python_program() ? "" : load_python();
  void* const module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  auto* const begin = module ? reinterpret_cast<StartPython*>(dlsym(module, start_python_name)) : nullptr;
  if (!begin) throw SetupError(fmt::format("controller 'python': {} cannot be loaded: {}", file, dlerror()));
  std::string why;
  PythonBackend* const backend = begin({.program = program, .interrupted = end_asked}, why);
  if (!backend) throw SetupError(why);
  return backend;
}

}  // namespace

/// Never unloaded: Python has threads.
PythonBackend& python_backend() {
  static std::mutex starting;
  static PythonBackend* backend = nullptr;
  const std::lock_guard lock(starting);
  if (!backend) backend = start();
  return *backend;
}

/// Asked before the program's own interpreter begins.
bool in_python_program() {
  static const bool is_one = [] {
    auto* const initialized = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "Py_IsInitialized"));
    return initialized && initialized() != 0;
  }();
  return is_one;
}

void end_python_calls_if(bool (*asked)()) { end_asked = asked; }

}  // namespace murosimf::control_software
