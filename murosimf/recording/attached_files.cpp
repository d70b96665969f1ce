#include "murosimf/recording/attached_files.h"

#include <limits>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/math/hash.h"

namespace murosimf::recording {

std::string content_hash(const std::string& bytes) {
  Hasher hasher;
  hasher.add(std::string_view(bytes));
  return fmt::format("{:016x}", hasher.value());
}

std::string size_and_hash(const std::string& bytes) {
  return fmt::format("{} bytes, hash {}", bytes.size(), content_hash(bytes));
}

AttachedFiles files_now(const std::vector<std::filesystem::path>& files, const RecordedPaths& paths) {
  AttachedFiles now{.list = {.name = "files", .values = {}},
                    .folders = {.name = "folders", .values = paths.folders()},
                    .contents = {}};
  for (const std::filesystem::path& file : files) {
    const std::string path = paths.reduced(file);
    std::string bytes = files::read_input_file(
        file, std::numeric_limits<std::int64_t>::max());  // read once: hash and attachment are of the same bytes
    now.list.values[path] = size_and_hash(bytes);
    if (bytes.size() > most_attached_bytes) continue;
    now.contents.push_back({.log_time = 0,
                            .create_time = 0,
                            .name = "files" + path,
                            .media_type = "text/plain",
                            .data = std::move(bytes)});
  }
  return now;
}

void attach_files(McapWriter& out, const AttachedFiles& files) {
  for (const Attachment& file : files.contents) out.attach(file);
  out.add(files.list);
  if (!files.folders.values.empty()) out.add(files.folders);
}

/// Attachments are copied as they are: their hashes are in the metadata.
void copy_files(McapWriter& out, const McapReader& from) {
  for (const AttachmentIndex& one : from.contents().attachments) {
    if (one.name.starts_with(files_prefix)) out.attach(from.attachment(one));
  }
  for (const MetadataIndex& one : from.contents().metadata) {
    if (one.name == "files" || one.name == "folders") out.add(from.metadata(one));
  }
}

}  // namespace murosimf::recording
