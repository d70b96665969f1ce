#include "murosimf/files/moved_files.h"

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/hash.h"

namespace murosimf::files {
std::string look_up_key(std::string_view name, std::string_view kind, std::string_view extension,
                        const std::filesystem::path& beside) {
  const std::string folder = beside.empty() ? "" : std::filesystem::absolute(beside).lexically_normal().string();
  return fmt::format("{}\n{}\n{}\n{}", name, kind, extension, folder);
}

std::string hidden_key(const std::string& key) {
  const std::size_t end = key.find('\n');
  if (!key.starts_with('/') || end == std::string::npos) return key;
  Hasher hasher;
  // Only the name: kind and extension are no secrets, and tell the keys apart.
  hasher.add(std::string_view(key).substr(0, end));
  return fmt::format("#{:016x}{}", hasher.value(), key.substr(end));
}

std::filesystem::path MovedFiles::to_here(const std::filesystem::path& path) const {
  return folder_ / path.relative_path();
}

std::filesystem::path MovedFiles::to_there(const std::filesystem::path& path) const {
  const std::filesystem::path inner = path.lexically_relative(folder_);
  return inner.empty() || *inner.begin() == ".." ? path : "/" / inner;
}

const std::string* MovedFiles::found(const std::string& key) const {
  auto name = names_.find(key);
  // A key of an absolute name may be recorded as a hash alone.
  if (name == names_.end()) name = names_.find(hidden_key(key));
  return name == names_.end() ? nullptr : &name->second;
}

}  // namespace murosimf::files
