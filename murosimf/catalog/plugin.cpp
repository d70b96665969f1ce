#include "murosimf/catalog/plugin.h"

#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/catalog/plugin_interface.h"
#include "murosimf/files/shared_library.h"
#include "murosimf/model/error.h"

namespace murosimf::catalog {
namespace {

static_assert(std::string_view(plugin_version).starts_with("murosimf " MUROSIMF_VERSION ","),
              "plugin_interface.h names another version than CMakeLists.txt");

[[noreturn]] void fail(const std::filesystem::path& file, std::string_view message) {
  throw SetupError(fmt::format("{}: {}", file.string(), message));
}

/// A function of the library; its type is that of plugin_interface.h.
template <class Function>
Function* function_in(const files::SharedLibrary& library, const char* name, const std::filesystem::path& file) {
  if (auto* found = library.function<Function>(name)) return found;
  fail(file, fmt::format("this is no plug-in: it has no function {} (plugin_interface.h)", name));
}

void check_version(const files::SharedLibrary& library, const std::filesystem::path& file) {
  const char* version = function_in<decltype(murosimf_plugin_version)>(library, "murosimf_plugin_version", file)();
  if (version && std::string_view(version) == plugin_version) return;
  fail(file,
       fmt::format("made for '{}', but this program is '{}'; build it anew", version ? version : "", plugin_version));
}

void load(const std::filesystem::path& file, const std::string& path) {
  const files::SharedLibrary library(path, files::Unloading::never, file.string());
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
