#include "murosimf/catalog/plugin.h"

#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/catalog/plugin_interface.h"
#include "murosimf/control_software/crash_note.h"
#include "murosimf/control_software/guard/guarded_call.h"
#include "murosimf/files/shared_library.h"
#include "murosimf/model/error.h"
#include "murosimf/world/foreign_code.h"

namespace murosimf::catalog {
namespace {

static_assert(std::string_view(plugin_version).find(" of murosimf " MUROSIMF_VERSION ",") != std::string_view::npos,
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

/// Other exceptions than SetupError would end the program without the name of the plug-in.
void enter_what_is_in(const files::SharedLibrary& library, const std::filesystem::path& file) {
  auto* enter = function_in<decltype(murosimf_register)>(library, "murosimf_register", file);
  try {
    enter(registries());
  } catch (const SetupError&) {
    throw;
  } catch (const std::exception& error) {
    fail(file, error.what());
  } catch (...) {
    fail(file, "its function murosimf_register throws something that is no std::exception");
  }
}

/// Guards calls like those of control software (control_software/guard/guarded_call.h).
void guarded(const std::filesystem::path& file, const char* what, const std::function<void()>& call) {
  constexpr Duration longest_loading = std::chrono::seconds(60);
  std::exception_ptr refused;
  const control_software::GuardedCall guard{.name = fmt::format("plug-in '{}'", file.string()),
                                            .what = what,
                                            .limit = longest_loading,
                                            .keeps_process = true};
  const control_software::CallOutcome outcome = guard([&] {
    try {
      call();
    } catch (const SetupError&) {
      refused = std::current_exception();
    }
  });
  if (outcome.kind == control_software::CallOutcome::crashed) throw control_software::SoftwareCrash(outcome.text);
  if (!outcome) throw SetupError(outcome.text);
  if (refused) std::rethrow_exception(refused);
}

/// Calls a step of a plug-in's algorithm. After a crash the run ends before the next step of the simulation.
void call_algorithm(const ForeignCode& code, const std::string& what, const std::function<void()>& call) {
  constexpr Duration longest_step = std::chrono::seconds(10);
  const control_software::GuardedCall guard{.name = code.name, .what = what, .limit = longest_step};
  if (const control_software::CallOutcome outcome = guard(call); !outcome)
    control_software::crashes_of_plugins().write(outcome.text);
}

void load(const std::filesystem::path& file, const std::string& path) {
  // a copy: the file may be overwritten by a new build while it is mapped
  const files::PrivateCopy copy(path, file.string());
  std::optional<files::SharedLibrary> library;
  guarded(file, "its loading", [&] { library.emplace(copy, files::Unloading::never, file.string()); });
  ForeignCode::add({fmt::format("plug-in '{}'", file.string()), library->memory(), call_algorithm});
  guarded(file, "its murosimf_plugin_version", [&] { check_version(*library, file); });
  guarded(file, "its murosimf_register", [&] { enter_what_is_in(*library, file); });
}

}  // namespace

void load_plugin(const std::filesystem::path& file) {
  static std::mutex loading;
  static std::set<std::string> loaded;
  // one at a time: registries are not synchronized
  const std::lock_guard lock(loading);
  std::error_code error;
  const std::string path = std::filesystem::canonical(file, error).string();
  if (error) fail(file, error.message());
  if (!std::filesystem::is_regular_file(path, error)) fail(file, "is no file");
  if (!loaded.contains(path)) load(file, path);
  loaded.insert(path);
}

}  // namespace murosimf::catalog
