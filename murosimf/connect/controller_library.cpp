#include "murosimf/connect/controller_library.h"

#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <map>
#include <mutex>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/model/error.h"
#include "murosimf/model/time.h"

namespace murosimf::connect {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_library_bytes = 1'000'000'000;
constexpr std::uint32_t oldest_abi = 1;  // later ones have only added functions at the end of murosimf_robot

[[noreturn]] void fail(const fs::path& file, std::string_view message) {
  throw SetupError(fmt::format("{}: {}", file.string(), message));
}

/// A copy in memory, under a name of its own: the loader takes a file of the same name for the library that it has already.
class CopyInMemory {
 public:
  explicit CopyInMemory(const fs::path& file) : descriptor_(memfd_create("controller", MFD_CLOEXEC)) {
    const std::string bytes = files::read_input_file(file, most_library_bytes);
    std::size_t done = 0;
    while (descriptor_ >= 0 && done < bytes.size()) {
      const ssize_t written = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) break;
      done += static_cast<std::size_t>(written);
    }
    if (done < bytes.size()) fail(file, fmt::format("cannot be copied to memory: {}", std::strerror(errno)));
  }
  ~CopyInMemory() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  CopyInMemory(const CopyInMemory&) = delete;
  CopyInMemory& operator=(const CopyInMemory&) = delete;

  /// Descriptors are used again, and the loader knows libraries by their names: so each name is another one, with the digits of a
  /// number as "//" and "/.".
  [[nodiscard]] fs::path path() const {
    static std::atomic<std::uint32_t> count{0};
    std::string name = "/proc/self/fd";
    const std::uint32_t number = count++;
    for (int bit = 0; bit < 32; ++bit) name += (number >> bit & 1) != 0 ? "/." : "//";
    return fmt::format("{}/{}", name, descriptor_);
  }

 private:
  int descriptor_;
};

/// Under its own name if it is the `first` file of that name: then it finds what lies beside it.
files::SharedLibrary open(const fs::path& file, bool first) {
  if (first) return {fs::canonical(file), files::Unloading::when_unused, file.string()};
  return {CopyInMemory(file).path(), files::Unloading::when_unused, file.string()};
}

const murosimf_controller* checked_functions(const files::SharedLibrary& library, const fs::path& file) {
  auto* entry = library.function<decltype(murosimf_controller_entry)>("murosimf_controller_entry");
  if (!entry)
    fail(file, "this is no control software: it has no function murosimf_controller_entry (murosimf_controller.h)");
  const murosimf_controller* functions = entry();
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

ControllerLibrary::ControllerLibrary(const fs::path& file, fs::file_time_type written, bool first)
    : file_(file), written_(written), library_(open(file, first)), functions_(checked_functions(library_, file)) {}

std::shared_ptr<const ControllerLibrary> ControllerLibrary::load(const fs::path& file) {
  static std::mutex loading;
  static std::map<fs::path, fs::file_time_type> first;  // of each name
  static std::map<std::pair<fs::path, fs::file_time_type>, std::weak_ptr<const ControllerLibrary>> loaded;
  const std::lock_guard lock(loading);
  std::erase_if(loaded, [](const auto& one) { return one.second.expired(); });
  const fs::file_time_type written = time_of(file);
  if (!fs::is_regular_file(file)) fail(file, "is no file");
  const fs::path path = fs::canonical(file);
  auto& known = loaded[{path, written}];
  if (auto library = known.lock()) return library;
  auto library =
      std::make_shared<const ControllerLibrary>(file, written, first.emplace(path, written).first->second == written);
  known = library;
  return library;
}

std::optional<fs::file_time_type> ControllerLibrary::newer() const {
  std::error_code error;
  const auto written = fs::last_write_time(file_, error);
  if (error || written == written_) return std::nullopt;
  return written;
}

}  // namespace murosimf::connect
