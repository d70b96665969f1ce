#include "murosimf/recording/unpacked_files.h"

#include <limits>
#include <set>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/attached_files.h"
#include "murosimf/recording/recorded_paths.h"
#include "murosimf/recording/recorded_run.h"

namespace murosimf::recording {
namespace fs = std::filesystem;

UnpackedFiles::UnpackedFiles(const McapReader& file) {
  with_context(file.file().string(), [&] { unpack(file); });
}

/// Names are checked against the folder: a recording must not write outside of it.
void UnpackedFiles::unpack(const McapReader& file) {
  const TextMap list = described(file, "files");
  std::set<std::string> written;
  for (const AttachmentIndex& attachment : file.contents().attachments) {
    if (!attachment.name.starts_with(files_prefix)) continue;
    const std::string path = attachment.name.substr(files_prefix.size() - 1);
    const std::string bytes = file.attachment(attachment).data;
    const auto known = list.find(path);
    if (known != list.end() && known->second != size_and_hash(bytes)) {
      throw SetupError(fmt::format("what it holds of '{}' is damaged", path));
    }
    write(path, bytes);
    written.insert(path);
  }
  for (const auto& [path, what] : list) {
    if (!written.contains(path)) link(path, what, file);
  }
}

/// Checks the path: a recording must not be able to write outside of the folder.
fs::path UnpackedFiles::place_of(const fs::path& path) const {
  if (!path.is_absolute() || path != path.lexically_normal() || !path.has_filename()) {
    throw SetupError(fmt::format("it has a file of the impossible name '{}'", path.string()));
  }
  const fs::path place = folder_.path() / path.relative_path();
  std::error_code error;
  fs::create_directories(place.parent_path(), error);
  if (error)
    throw SetupError(fmt::format("cannot make the folder '{}': {}", place.parent_path().string(), error.message()));
  return place;
}

void UnpackedFiles::write(const fs::path& path, const std::string& bytes) const {
  files::write_file(place_of(path), bytes);
}

/// Links the first place with a file of this hash.
void UnpackedFiles::link(const fs::path& path, const std::string& size_and_hash_then, const McapReader& file) const {
  constexpr auto most = static_cast<std::uintmax_t>(std::numeric_limits<std::int64_t>::max());
  const fs::path place = place_of(path);
  const std::string needed = "it needs a file that was too large to be attached: ";
  std::string other;
  std::error_code error;
  for (const fs::path& candidate : places_of(path, file.file(), described(file, "folders"))) {
    if (!fs::is_regular_file(candidate, error)) continue;
    const std::string now = size_and_hash(files::read_input_file(candidate, most));
    if (now == size_and_hash_then) {
      fs::create_symlink(fs::absolute(candidate), place, error);
      if (error) throw SetupError(fmt::format("cannot link '{}': {}", place.string(), error.message()));
      return;
    }
    if (other.empty()) {
      other = fmt::format("'{}' is another one now ({} then, {} now)", candidate.string(), size_and_hash_then, now);
    }
  }
  if (!other.empty()) throw SetupError(needed + other);
  throw SetupError(fmt::format("{}'{}' ({}); there is no such file here: run this where it is", needed,
                               path.relative_path().string(), size_and_hash_then));
}

}  // namespace murosimf::recording
