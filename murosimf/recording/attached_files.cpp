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

void attach_files(McapWriter& out, const std::vector<std::filesystem::path>& files) {
  Metadata list{.name = "files", .values = {}};
  for (const std::filesystem::path& file : files) {
    const std::string path = std::filesystem::absolute(file).lexically_normal().string();
    std::string bytes = files::read_input_file(file, std::numeric_limits<std::int64_t>::max());
    list.values[path] = fmt::format("{} bytes, hash {}", bytes.size(), content_hash(bytes));
    if (bytes.size() > most_attached_bytes) continue;
    out.attach({.log_time = 0,
                .create_time = 0,
                .name = "files" + path,
                .media_type = "text/plain",
                .data = std::move(bytes)});
  }
  out.add(list);
}

}  // namespace murosimf::recording
