/// attached_files.h - the files that a scene was read from, in its recording: which they were, and what stood in them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/mcap/mcap_writer.h"
#include "murosimf/recording/recorded_paths.h"

namespace murosimf::recording {

/// [byte] Files up to this size are attached whole: scenes, models, tables. Of larger ones, like meshes, there is the hash alone.
inline constexpr std::uintmax_t most_attached_bytes = 256'000;

/// Of attachments: what was at /PATH, as RecordedPaths says it, is "files/PATH".
inline constexpr std::string_view files_prefix = "files/";

/// Files as they are now.
struct AttachedFiles {
  Metadata list;     ///< "files", from path to "SIZE bytes, hash HASH" (content_hash())
  Metadata folders;  ///< "folders", RecordedPaths::folders()
  std::vector<Attachment> contents;
};
/// Throws SetupError if one cannot be read.
[[nodiscard]] AttachedFiles files_now(const std::vector<std::filesystem::path>& files, const RecordedPaths& paths);
void attach_files(McapWriter& out, const AttachedFiles& files);

/// Adds those of another recording.
void copy_files(McapWriter& out, const McapReader& from);

/// What the metadata "files" says of a file with these bytes.
[[nodiscard]] std::string size_and_hash(const std::string& bytes);

/// 16 hexadecimal digits (math/hash.h); not for security.
[[nodiscard]] std::string content_hash(const std::string& bytes);

}  // namespace murosimf::recording
