#include "murosimf/files/text_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

}  // namespace

TextLines::TextLines(const std::filesystem::path& file, bool backslash_joins)
    : name_(file.string()), backslash_joins_(backslash_joins) {
  // Streamed: meshes are too large to be kept twice in memory.
  check_input_file(file, most_mesh_bytes);
  stream_.open(file, std::ios::binary);
  if (!stream_) throw SetupError(one_line(fmt::format("{}: the file cannot be read", name_)));
  skip_mark();
}

void TextLines::skip_mark() {
  std::string mark(3, '\0');
  stream_.read(mark.data(), static_cast<std::streamsize>(mark.size()));
  if (mark.starts_with("\xff\xfe") || mark.starts_with("\xfe\xff")) {
    throw SetupError(one_line(fmt::format("{}: the file is UTF-16; save it as UTF-8", name_)));
  }
  if (mark == "\xef\xbb\xbf") return;
  stream_.clear();
  stream_.seekg(0);
}

bool TextLines::next() {
  ++line_;
  stream_.getline(buffer_.data(), buffer_.size());
  const auto count = static_cast<std::size_t>(stream_.gcount());
  if (stream_.fail() && count + 1 == buffer_.size()) fail("the line is too long; this is no text file");
  rest_ = {};
  goes_on_ = false;
  if (stream_.fail()) return false;
  MUROSIMF_ASSERT(count <= buffer_.size());
  rest_ = std::string_view(buffer_.data(), stream_.eof() ? count : count - 1);
  if (rest_.ends_with('\r')) rest_.remove_suffix(1);
  goes_on_ = backslash_joins_ && rest_.ends_with('\\');
  if (goes_on_) rest_.remove_suffix(1);
  return true;
}

std::string_view TextLines::word() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
  while (rest_.empty() && goes_on_ && next()) {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
  }
  const std::size_t size = std::min(rest_.find_first_of(blanks), rest_.size());
  MUROSIMF_ASSERT(size <= rest_.size());
  const auto found = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return found;
}

double TextLines::number(std::string_view what) {
  const std::string_view text = word();
  if (text.empty()) fail(fmt::format("the {} lacks a number", what));
  const char* begin = text.data() + (text.front() == '+' ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error == std::errc::invalid_argument || end != text.data() + text.size()) {
    fail(fmt::format("{} of the {} is not a number", quoted(text), what));
  }
  if (error != std::errc() || !std::isfinite(value)) {
    fail(fmt::format("{} of the {} is not a finite number", quoted(text), what));
  }
  return value + 0.0;  // no -0: it would count as another place in comparisons of bytes
}

void TextLines::fail(std::string_view message) const {
  throw SetupError(one_line(fmt::format("{}:{}: {}", name_, line_, message)));
}

std::string quoted(std::string_view word) {
  return word.size() <= 40 ? fmt::format("'{}'", word) : fmt::format("'{}...'", word.substr(0, 40));
}

}  // namespace murosimf::files
