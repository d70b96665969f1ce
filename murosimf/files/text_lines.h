/// text_lines.h - reads a text file line by line, in bounded memory, and reports places of errors.
#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace murosimf::files {

class TextLines {
 public:
  /// `backslash_joins`: a line that ends with a backslash continues in the next one. Throws SetupError if the file cannot be
  /// read, or is UTF-16; a byte order mark of UTF-8 is skipped.
  explicit TextLines(const std::filesystem::path& file, bool backslash_joins = false);

  /// Goes to the next line; false at the end of the file. Throws SetupError for a line of more than 65,535 characters,
  /// which does not occur in text files.
  bool next();
  /// The next word of this line, valid until the next call; empty at its end.
  std::string_view word();
  /// The next word as a number. Throws SetupError if it is missing, no number or not finite; `what`: "vertex", ...
  [[nodiscard]] double number(std::string_view what);

  /// Throws SetupError: file:line: message.
  [[noreturn]] void fail(std::string_view message) const;

 private:
  void skip_mark();

  std::array<char, 1 << 16> buffer_{};
  std::string name_;
  std::ifstream stream_;
  std::string_view rest_;
  std::size_t line_ = 0;
  bool backslash_joins_, goes_on_ = false;
};

/// A word for a message: in quotes, at most 40 characters.
[[nodiscard]] std::string quoted(std::string_view word);

}  // namespace murosimf::files
