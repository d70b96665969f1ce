/// proto_tokens.h - words, numbers, strings and brackets of a PROTO file, each with its line.
///
/// Commas are spaces, `#` begins a comment up to the end of the line.
/// Source: Webots reference manual, "PROTO Definition"; ISO/IEC 14772-1 (VRML97), annex A.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace murosimf::robot_formats::proto {

struct Token {
  enum class Kind { end, word, number, text, bracket };
  Kind kind = Kind::end;
  std::string text;        ///< of a word, of a string without its quotes, or one of { } [ ]
  double number = 0;       ///< of a number
  bool malformed = false;  ///< a word that begins like a number: a name like 3d_printed, or an error
  std::size_t line = 1;

  [[nodiscard]] bool is(char bracket) const { return kind == Kind::bracket && text[0] == bracket; }
};

class Tokens {
 public:
  /// Throws SetupError if the file cannot be read or its first token is none.
  explicit Tokens(std::filesystem::path file);

  /// The next token, without consuming it.
  [[nodiscard]] const Token& peek() const { return next_; }
  /// Consumes and returns the next token. Throws SetupError for strings without end and templates.
  Token take();

  /// "robot.proto:12"
  [[nodiscard]] std::string where(std::size_t line) const;
  /// Throws SetupError: where the next token is, and the message.
  [[noreturn]] void fail(const std::string& message) const;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// The year of the version in the first line, "#VRML_SIM R2022a utf8": 2022; 0 if there is none.
  [[nodiscard]] int year() const;

 private:
  [[nodiscard]] Token scan();
  void skip_blank();
  [[nodiscard]] std::string scan_string();
  void refuse_template(std::size_t position) const;

  std::filesystem::path file_;
  std::string text_;
  std::size_t at_ = 0, line_ = 1;
  Token next_;
};

}  // namespace murosimf::robot_formats::proto
