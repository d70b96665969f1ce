#include "murosimf/files/toml_bounds.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

/// Scans the text, skips comments and quoted texts, and counts open brackets.
class BoundsScan {
 public:
  BoundsScan(std::string_view text, std::string_view where) : text_(text), where_(where) {}

  void run() {
    while (place_ < text_.size()) take(text_[place_]);
    MUROSIMF_ASSERT(place_ == text_.size());
  }

 private:
  void take(char c) {
    if (c == '#') return skip_comment();
    if (c == '"' || c == '\'') return skip_quoted(c);
    if (c == '[' || c == '{') open();
    if (c == ']' || c == '}') open_ = std::max(0, open_ - 1);
    // A point in a number is counted like one in a key; neither has many.
    if (c == '.' && ++points_ >= most_key_parts) refuse(fmt::format("more than {} parts in one key", most_key_parts));
    if (c == '\n' || c == '=' || c == ',' || c == '[' || c == '{') points_ = 0;
    ++place_;
  }

  void open() {
    if (++open_ > most_open_brackets)
      refuse(fmt::format("more than {} brackets inside each other", most_open_brackets));
  }

  void skip_comment() { place_ = std::min(text_.find('\n', place_), text_.size()); }

  /// Skips to the end of a quoted text. One without an end stops at its line: the library refuses it there.
  void skip_quoted(char quote) {
    const std::string triple(3, quote);
    const bool long_text = text_.substr(place_).starts_with(triple);
    place_ += long_text ? 3 : 1;
    while (place_ < text_.size()) {
      if (long_text ? text_.substr(place_).starts_with(triple) : text_[place_] == quote) break;
      if (!long_text && text_[place_] == '\n') return;
      place_ += text_[place_] == '\\' && quote == '"' ? 2 : 1;
    }
    place_ = std::min(place_ + (long_text ? 3 : 1), text_.size());
  }

  [[noreturn]] void refuse(const std::string& message) const {
    const std::string_view before = text_.substr(0, place_);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t begin = before.rfind('\n') + 1;  // npos + 1 is 0
    throw SetupError(fmt::format("{}:{}:{}: {}; write it simpler", where_, line, 1 + place_ - begin, message));
  }

  std::string_view text_, where_;
  std::size_t place_ = 0;
  int open_ = 0, points_ = 0;
};

}  // namespace

void check_toml_bounds(std::string_view text, std::string_view where) { BoundsScan(text, where).run(); }

}  // namespace murosimf::files
