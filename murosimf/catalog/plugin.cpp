#include "murosimf/catalog/plugin.h"

#include <dlfcn.h>

#include <algorithm>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/catalog/plugin_interface.h"
#include "murosimf/model/error.h"

namespace murosimf::catalog {
namespace {

static_assert(std::string_view(plugin_version).starts_with("murosimf " MUROSIMF_VERSION ","),
              "plugin_interface.h names another version than CMakeLists.txt");

[[noreturn]] void fail(const std::filesystem::path& file, std::string_view message) {
  throw SetupError(fmt::format("{}: {}", file.string(), message));
}

/// What the loader says of its last failure, without the file at its beginning and in one line.
std::string loader_message(const std::string& file) {
  const char* said = dlerror();
  std::string text = said ? said : "cannot be loaded";
  if (text.starts_with(file + ": ")) text.erase(0, file.size() + 2);
  std::ranges::replace(text, '\n', ' ');
  return text;
}

/// A function of the library; its type is that of plugin_interface.h.
template <class Function>
Function* function_in(void* library, const char* name, const std::filesystem::path& file) {
  void* found = dlsym(library, name);
  if (!found) fail(file, fmt::format("this is no plug-in: it has no function {} (plugin_interface.h)", name));
  return reinterpret_cast<Function*>(found);
}

void check_version(void* library, const std::filesystem::path& file) {
  const char* version = function_in<decltype(murosimf_plugin_version)>(library, "murosimf_plugin_version", file)();
  if (version && std::string_view(version) == plugin_version) return;
  fail(file,
       fmt::format("made for '{}', but this program is '{}'; build it anew", version ? version : "", plugin_version));
}

void load(const std::filesystem::path& file, const std::string& path) {
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!library) fail(file, fmt::format("cannot be loaded: {}", loader_message(path)));
  check_version(library, file);
  auto* enter = function_in<decltype(murosimf_register)>(library, "murosimf_register", file);
  try {
    enter(registries());
  } catch (const std::exception& error) {
    fail(file, error.what());
  } catch (...) {
    fail(file, "its function murosimf_register throws something that is no std::exception");
  }
}

}  // namespace

void load_plugin(const std::filesystem::path& file) {
  static std::mutex loading;
  static std::set<std::string> loaded;
  const std::lock_guard lock(loading);
  std::error_code error;
  const std::string path = std::filesystem::canonical(file, error).string();
  if (error) fail(file, error.message());
  if (!std::filesystem::is_regular_file(path, error)) fail(file, "is no file");
  if (!loaded.contains(path)) load(file, path);
  loaded.insert(path);
}

}  // namespace murosimf::catalog
