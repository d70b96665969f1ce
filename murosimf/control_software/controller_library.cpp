#include "murosimf/control_software/controller_library.h"

#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "murosimf/control_software/crash_note.h"
#include "murosimf/control_software/guard/foreign_call.h"
#include "murosimf/control_software/guard/watched_functions.h"
#include "murosimf/model/error.h"
#include "murosimf/world/time.h"

namespace murosimf::control_software {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t oldest_abi = 1;  // later ones have only added functions at the end of murosimf_robot

[[noreturn]] void fail(const fs::path& file, std::string_view message) {
  throw SetupError(fmt::format("{}: {}", file.string(), message));
}

constexpr Duration longest_loading = std::chrono::seconds(60);  // constructors may read files of their own

/// Calls code of the library that belongs to no robot yet. Throws SetupError or SoftwareCrash.
void guarded(const fs::path& file, const char* what, const std::shared_ptr<ForeignThreads>& threads,
             const std::function<void()>& call) {
  std::exception_ptr refused;
  const GuardedCall guard{fmt::format("library '{}'", file.string()), what, longest_loading, nullptr, threads, true};
  const CallOutcome outcome = guard([&] {
    try {
      call();
    } catch (const SetupError&) {
      refused = std::current_exception();
    }
  });
  if (outcome.kind == CallOutcome::crashed) throw SoftwareCrash(outcome.text);
  if (!outcome) throw SetupError(outcome.text);
  if (refused) std::rethrow_exception(refused);
}

const murosimf_controller* checked_functions(const files::SharedLibrary& library, const fs::path& file,
                                             const std::shared_ptr<ForeignThreads>& threads) {
  auto* entry = library.function<decltype(murosimf_controller_entry)>("murosimf_controller_entry");
  if (!entry)
    fail(file, "this is no control software: it has no function murosimf_controller_entry (murosimf_controller.h)");
  const murosimf_controller* functions = nullptr;
  guarded(file, "its murosimf_controller_entry", threads, [&] { functions = entry(); });
  if (!functions) fail(file, "its murosimf_controller_entry returns nothing");
  if (functions->abi < oldest_abi || functions->abi > MUROSIMF_CONTROLLER_ABI) {
    fail(file,
         fmt::format(
             "made for version {} of murosimf_controller.h, but this program has versions {} to {}; build it anew",
             functions->abi, oldest_abi, MUROSIMF_CONTROLLER_ABI));
  }
  if (!functions->create || !functions->destroy || !functions->step) fail(file, "it lacks create, destroy or step");
  if (!functions->save != !functions->load) fail(file, "it has one of save and load, but not the other");
  const double rate = functions->rate;
  if (rate != 0 && !(rate >= slowest_rate && rate <= fastest_rate)) fail(file, fmt::format("its rate is {} Hz", rate));
  return functions;
}

fs::file_time_type time_of(const fs::path& file) {
  std::error_code error;
  const auto written = fs::last_write_time(file, error);
  if (error) fail(file, error.message());
  return written;
}

}  // namespace

ControllerLibrary::ControllerLibrary(const fs::path& file, fs::file_time_type written)
    : file_(file), written_(written), threads_(std::make_shared<ForeignThreads>()) {
  threads_->name = fmt::format("library '{}'", file.string());
  note_suspect(threads_->name);
  const files::PrivateCopy copy(file, file.string());
  if (time_of(file) != written) fail(file, "was written to while it was read; try again");
  guarded(file, "its loading", threads_, [&] { library_.emplace(copy, files::Unloading::when_unused, file.string()); });
  watch_functions();  // before what the library does at the end of the program
  functions_ = checked_functions(*library_, file, threads_);
}

ControllerLibrary::~ControllerLibrary() {
  try {
    guarded(file_, "its unloading", threads_, [&] { library_.reset(); });
  } catch (const std::exception&) {  // said already
  }
}

/// A library is loaded once while any robot uses it; a file that was built anew is another library.
std::shared_ptr<const ControllerLibrary> ControllerLibrary::load(const fs::path& file) {
  static std::mutex loading;
  static std::map<std::pair<fs::path, fs::file_time_type>, std::weak_ptr<const ControllerLibrary>> loaded;
  const std::lock_guard lock(loading);
  std::erase_if(loaded, [](const auto& one) { return one.second.expired(); });
  const fs::file_time_type written = time_of(file);
  if (!fs::is_regular_file(file)) fail(file, "is no file");
  auto& known = loaded[{fs::canonical(file), written}];
  if (auto library = known.lock()) return library;
  auto library = std::make_shared<const ControllerLibrary>(file, written);
  known = library;
  return library;
}

std::optional<fs::file_time_type> ControllerLibrary::newer() const {
  std::error_code error;
  const auto written = fs::last_write_time(file_, error);
  if (error || written == written_) return std::nullopt;
  return written;
}

}  // namespace murosimf::control_software
