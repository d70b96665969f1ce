/// attached_files.h - the files that a scene was read from, in its recording: their names and contents.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/mcap/mcap_writer.h"
#include "murosimf/recording/recorded_paths.h"

namespace murosimf::recording {

/// [byte] Files up to this size are attached completely: scenes, models, tables. Of larger ones, like meshes, only the hash is stored.
inline constexpr std::uintmax_t most_attached_bytes = 256'000;

/// Name of attachments: the file at /PATH, as named by RecordedPaths, is "files/PATH".
inline constexpr std::string_view files_prefix = "files/";

/// Files in their present state.
struct AttachedFiles {
  Metadata list;     ///< "files", from path to "SIZE bytes, hash HASH" (content_hash())
  Metadata folders;  ///< "folders", RecordedPaths::folders()
  std::vector<Attachment> contents;
};
/// Throws SetupError if one cannot be read.
[[nodiscard]] AttachedFiles files_now(const std::vector<std::filesystem::path>& files, const RecordedPaths& paths);
void attach_files(McapWriter& out, const AttachedFiles& files);

/// Adds the files of another recording.
void copy_files(McapWriter& out, const McapReader& from);

/// The entry of the metadata "files" for a file with these bytes.
[[nodiscard]] std::string size_and_hash(const std::string& bytes);

/// 16 hexadecimal digits (math/hash.h); not for security.
[[nodiscard]] std::string content_hash(const std::string& bytes);

}  // namespace murosimf::recording
