/// attached_files.h - the files that a scene was read from, in its recording: which they were, and what stood in them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "murosimf/recording/mcap_writer.h"

namespace murosimf::recording {

/// [byte] Files up to this size are attached whole: scenes, models, tables. Of larger ones, like meshes, there is the hash alone.
inline constexpr std::uintmax_t most_attached_bytes = 256'000;

/// Adds the metadata "files", from path to "SIZE bytes, hash HASH" (content_hash()), and the attachments "files/PATH".
void attach_files(McapWriter& out, const std::vector<std::filesystem::path>& files);

/// 16 hexadecimal digits (math/hash.h); not for security.
[[nodiscard]] std::string content_hash(const std::string& bytes);

}  // namespace murosimf::recording
