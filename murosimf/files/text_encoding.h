/// text_encoding.h - converts text files of every Unicode encoding to UTF-8: spreadsheets and editors of some systems write UTF-16.
///
/// UTF-8, UTF-16 and UTF-32 are distinguished by their byte order mark, or, without one, by the zero bytes that characters of ASCII
/// have at the beginning of a file. The mark itself is left out. Source: The Unicode Standard, ch. 2.6 and 23.8; Extensible Markup
/// Language (XML) 1.0, appendix F.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace murosimf::files {

/// `bytes` of the text file `file` as UTF-8; unchanged if they show no other encoding. Throws SetupError, one line that begins
/// with the file's name: it is UTF-16 or UTF-32 with a character that does not exist, or that is cut off.
[[nodiscard]] std::string to_utf8(std::string bytes, const std::filesystem::path& file);

/// The same for an XML file that declares in its first line ISO-8859-1, Latin-1, ASCII or Windows-1252. Throws SetupError also if it
/// declares another encoding than these and Unicode's, and has characters that are not ASCII.
[[nodiscard]] std::string xml_to_utf8(std::string bytes, const std::filesystem::path& file);

/// The text of a file of at most `most` bytes. Throws SetupError as read_input_file and to_utf8 do.
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file, std::uintmax_t most);

}  // namespace murosimf::files
