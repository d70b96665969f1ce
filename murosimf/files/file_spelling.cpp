#include "murosimf/files/file_spelling.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <vector>

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

bool same_letters(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// The only entry of a folder with this name but for capital letters; nothing if there are none or several.
std::optional<fs::path> entry_like(const fs::path& folder, const std::string& name) {
  std::optional<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error)) {
    const std::string other = entry.path().filename().string();
    if (!same_letters(other, name)) continue;
    if (found) return std::nullopt;
    found = folder / other;
  }
  return found;
}

/// The path with the capital letters of its existing parts, if each part is unique.
std::optional<fs::path> with_true_letters(const fs::path& path) {
  fs::path so_far;
  for (const fs::path& part : path.lexically_normal()) {
    fs::path next = so_far / part;
    if (!is_there(next)) {
      const auto entry = entry_like(so_far, part.string());
      if (!entry) return std::nullopt;
      next = *entry;
    }
    so_far = next;
  }
  return is_file(so_far) ? std::optional(so_far) : std::nullopt;
}

/// The name as it is, and as other systems spell it; each once.
std::vector<std::string> spellings(std::string_view name) {
  std::vector<std::string> all{std::string(name)};
  const auto add = [&](std::string other) {
    if (std::ranges::find(all, other) == all.end()) all.push_back(std::move(other));
  };
  const auto with_slashes = [](std::string text) {
    std::ranges::replace(text, '\\', '/');
    return text;
  };
  add(percent_decoded(name));
  add(with_slashes(std::string(name)));
  add(with_slashes(percent_decoded(name)));
  return all;
}

}  // namespace

std::string percent_decoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned byte = 0;
    const bool escape = text[i] == '%' && i + 2 < text.size();
    const auto [end, error] = escape ? std::from_chars(text.data() + i + 1, text.data() + i + 3, byte, 16)
                                     : std::from_chars_result{text.data(), std::errc::invalid_argument};
    if (error == std::errc{} && end == text.data() + i + 3 && byte != 0) {
      result += static_cast<char>(byte);
      i += 2;
    } else {
      result += text[i];
    }
  }
  return result;
}

std::optional<std::string> after_scheme(std::string_view address, std::string_view scheme) {
  if (address.size() <= scheme.size() || address[scheme.size()] != ':') return std::nullopt;
  if (!same_letters(address.substr(0, scheme.size()), scheme)) return std::nullopt;
  address.remove_prefix(scheme.size() + 1);
  const auto is_slash = [](char c) { return c == '/' || c == '\\'; };
  for (int i = 0; i < 2 && !address.empty() && is_slash(address.front()); ++i) address.remove_prefix(1);
  return std::string(address);
}

std::optional<std::string> path_of_address(std::string_view address) {
  auto path = after_scheme(address, "file");
  if (!path) return std::nullopt;
  constexpr std::string_view here = "localhost/";
  if (address.substr(4, 3) == "://") {
    if (path->starts_with(here)) path->erase(0, here.size() - 1);
  } else if (address.substr(4, 2) == ":/") {
    path->insert(path->begin(), '/');  // file:/path
  }
  return path;
}

std::optional<fs::path> find_spelled(const fs::path& folder, std::string_view name) {
  if (name.empty()) return std::nullopt;
  const std::vector<std::string> names = spellings(name);
  for (const std::string& spelling : names) {
    if (is_file(folder / spelling)) return folder / spelling;
  }
  for (const std::string& spelling : names) {
    if (const auto found = with_true_letters(folder / spelling)) return found;
  }
  return std::nullopt;
}

}  // namespace murosimf::files
