/// file_spelling.h - finds files by names as robot files of other systems spell them: percent escapes, backslashes, capital letters.
///
/// Source of percent escapes and of file: addresses: RFC 3986, 2.1; RFC 8089.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace murosimf::files {

/// `text` with every "%20" and the like replaced by its byte; other characters remain.
[[nodiscard]] std::string percent_decoded(std::string_view text);

/// The part behind "SCHEME:" and up to two slashes, if the address has that scheme, in small or capital letters: "pkg/a.stl" of
/// "package://pkg/a.stl". Nothing if it has another one, or none.
[[nodiscard]] std::optional<std::string> after_scheme(std::string_view address, std::string_view scheme);

/// The path in an address file:///path, file:/path, file://localhost/path or file://relative/path; nothing if it is no such address.
[[nodiscard]] std::optional<std::string> path_of_address(std::string_view address);

/// The ordinary file `name` in `folder`: as it is spelled; else with escapes decoded, with backslashes as slashes, or both; else with
/// other small and capital letters, if exactly one such file exists. Absolute names are searched for at their own place.
[[nodiscard]] std::optional<std::filesystem::path> find_spelled(const std::filesystem::path& folder,
                                                                std::string_view name);

}  // namespace murosimf::files
