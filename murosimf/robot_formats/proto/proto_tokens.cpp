#include "murosimf/robot_formats/proto/proto_tokens.h"

#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/files/text_encoding.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::robot_formats::proto {
namespace {

constexpr std::uintmax_t most_bytes = 64'000'000;
constexpr std::string_view blank = " \t\r,";

bool ends_word(char c) {
  return blank.find(c) != std::string_view::npos || std::string_view("\n#\"{}[]").find(c) != std::string_view::npos;
}

bool begins_number(std::string_view word) {
  MUROSIMF_ASSERT(!word.empty());
  const std::string_view rest = word.substr(word[0] == '+' || word[0] == '-' ? 1 : 0);
  const bool dot = rest.size() > 1 && rest[0] == '.';
  const char first = rest.empty() ? 'x' : rest[dot ? 1 : 0];
  return first >= '0' && first <= '9';
}

/// False if the word is no finite number.
bool to_number(std::string_view word, double& number) {
  MUROSIMF_ASSERT(!word.empty());
  if (word[0] == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size() && std::isfinite(number);
}

}  // namespace

Tokens::Tokens(std::filesystem::path file) : file_(std::move(file)), text_(files::read_text_file(file_, most_bytes)) {
  next_ = scan();
}

std::string Tokens::where(std::size_t line) const { return fmt::format("{}:{}", file_.string(), line); }

void Tokens::fail(const std::string& message) const {
  throw SetupError(files::one_line(fmt::format("{}: {}", where(next_.line), message)));
}

int Tokens::year() const {
  constexpr std::string_view begin = "#VRML_SIM R";
  int year = 0;
  if (text_.starts_with(begin)) std::from_chars(text_.data() + begin.size(), text_.data() + text_.size(), year);
  return year;
}

Token Tokens::take() {
  Token token = std::move(next_);
  next_ = scan();
  return token;
}

void Tokens::skip_blank() {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == '#') {
      while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    } else if (c == '\n' || blank.find(c) != std::string_view::npos) {
      line_ += c == '\n' ? 1 : 0;
      ++at_;
    } else {
      return;
    }
  }
}

void Tokens::refuse_template(std::size_t position) const {
  // Templates are recognized anywhere in the text: their scripts may stand in words, strings and between them.
  const char next = position + 1 < text_.size() ? text_[position + 1] : ' ';
  if (text_[position] != '%' || (next != '<' && next != '{')) return;
  throw SetupError(
      fmt::format("{}: this PROTO is a template with scripts, which are not run here; 'Convert to Base Node(s)' "
                  "of Webots writes the robot out into its world, which is read",
                  where(line_)));
}

std::string Tokens::scan_string() {
  const std::size_t begin = line_;
  MUROSIMF_ASSERT(text_[at_] == '"');
  std::string text;
  for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
    refuse_template(at_);
    if (text_[at_] == '\n') ++line_;
    if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;  // an escaped quote or backslash stands for itself
    text += text_[at_];
  }
  if (at_ >= text_.size()) throw SetupError(fmt::format("{}: a string without end; close it with \"", where(begin)));
  ++at_;
  return text;
}

Token Tokens::scan() {
  skip_blank();
  Token token;
  token.line = line_;
  if (at_ >= text_.size()) return token;
  if (text_[at_] == '"') {
    token.kind = Token::Kind::text;
    token.text = scan_string();
    return token;
  }
  if (std::string_view("{}[]").find(text_[at_]) != std::string_view::npos) {
    token.kind = Token::Kind::bracket;
    token.text = text_[at_++];
    return token;
  }
  for (; at_ < text_.size() && !ends_word(text_[at_]); ++at_) {
    refuse_template(at_);
    token.text += text_[at_];
  }
  MUROSIMF_ASSERT(!token.text.empty());
  const bool numeric = begins_number(token.text);
  token.malformed = numeric && !to_number(token.text, token.number);
  token.kind = numeric && !token.malformed ? Token::Kind::number : Token::Kind::word;
  return token;
}

}  // namespace murosimf::robot_formats::proto
