#include "murosimf/files/text_encoding.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/files/lower_case.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

/// Encoding of a file's characters.
struct Encoding {
  const char* name;
  std::size_t unit;  // [byte] of one code unit
  bool low_first;    // the order of its bytes
  std::size_t mark;  // [byte] length of the byte order mark
};

constexpr char32_t first_surrogate = 0xd800, low_surrogate = 0xdc00, past_surrogates = 0xe000;
constexpr char32_t past_unicode = 0x110000;

[[noreturn]] void refuse_text(const std::filesystem::path& file, const std::string& why) {
  throw SetupError(one_line(fmt::format("{}: {}; save the file as UTF-8", file.string(), why)));
}

/// The encoding; nothing: the bytes are used as they are.
std::optional<Encoding> encoding_of(std::string_view bytes) {
  using namespace std::string_view_literals;
  // Longer marks first: that of UTF-32 begins with that of UTF-16.
  constexpr std::array marks{std::pair{"\xff\xfe\0\0"sv, Encoding{"UTF-32", 4, true, 4}},
                             std::pair{"\0\0\xfe\xff"sv, Encoding{"UTF-32", 4, false, 4}},
                             std::pair{"\xff\xfe"sv, Encoding{"UTF-16", 2, true, 2}},
                             std::pair{"\xfe\xff"sv, Encoding{"UTF-16", 2, false, 2}},
                             std::pair{"\xef\xbb\xbf"sv, Encoding{"UTF-8", 1, true, 3}}};
  for (const auto& [mark, encoding] : marks) {
    if (bytes.starts_with(mark)) return encoding;
  }
  if (bytes.size() < 4) return std::nullopt;
  const auto pattern = [&](std::string_view zeros) {  // 'x': a byte that is not zero
    for (std::size_t i = 0; i < 4; ++i) {
      if ((bytes[i] != 0) != (zeros[i] == 'x')) return false;
    }
    return true;
  };
  if (pattern("x000")) return Encoding{"UTF-32", 4, true, 0};
  if (pattern("000x")) return Encoding{"UTF-32", 4, false, 0};
  if (pattern("x0x0")) return Encoding{"UTF-16", 2, true, 0};
  if (pattern("0x0x")) return Encoding{"UTF-16", 2, false, 0};
  return std::nullopt;
}

void append(std::string& text, char32_t c) {
  MUROSIMF_ASSERT(c < past_unicode);
  const auto tail = [&](int shift) { text += static_cast<char>(0x80 | ((c >> shift) & 0x3f)); };
  if (c < 0x80) {
    text += static_cast<char>(c);
  } else if (c < 0x800) {
    text += static_cast<char>(0xc0 | (c >> 6));
    tail(0);
  } else if (c < 0x10000) {
    text += static_cast<char>(0xe0 | (c >> 12));
    tail(6);
    tail(0);
  } else {
    text += static_cast<char>(0xf0 | (c >> 18));
    tail(12);
    tail(6);
    tail(0);
  }
}

/// The code units of UTF-16 or UTF-32 in their order.
class Units {
 public:
  Units(std::string_view bytes, const Encoding& encoding, const std::filesystem::path& file)
      : bytes_(bytes.substr(encoding.mark)), encoding_(&encoding), file_(&file) {
    if (bytes_.size() % encoding.unit != 0) fail("ends within a character");
  }

  [[nodiscard]] bool more() const { return !bytes_.empty(); }

  /// The next character.
  char32_t next() {
    MUROSIMF_ASSERT(more());
    const char32_t first = unit();
    const bool surrogate = first >= first_surrogate && first < past_surrogates;
    if (!surrogate && first < past_unicode) return first;
    if (encoding_->unit == 2 && first < low_surrogate && more()) {
      const char32_t second = unit();
      if (second >= low_surrogate && second < past_surrogates) {
        return 0x10000 + ((first - first_surrogate) << 10) + (second - low_surrogate);
      }
    }
    fail("has a character that does not exist");
  }

 private:
  char32_t unit() {
    char32_t value = 0;
    MUROSIMF_ASSERT(bytes_.size() >= encoding_->unit);
    for (std::size_t i = 0; i < encoding_->unit; ++i) {
      const std::size_t place = encoding_->low_first ? encoding_->unit - 1 - i : i;
      value = value << 8 | static_cast<unsigned char>(bytes_[place]);
    }
    bytes_.remove_prefix(encoding_->unit);
    return value;
  }

  [[noreturn]] void fail(std::string_view why) const {
    refuse_text(*file_, fmt::format("the file is {} and {}", encoding_->name, why));
  }

  std::string_view bytes_;
  const Encoding* encoding_;
  const std::filesystem::path* file_;
};

bool is_ascii(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// The declared encoding in small letters; empty: the file declares none.
std::string declared_encoding(std::string_view xml) {
  xml = xml.substr(0, std::min(xml.find("?>"), xml.size()));
  const std::size_t word = xml.starts_with("<?xml") ? xml.find("encoding") : std::string_view::npos;
  if (word == std::string_view::npos) return {};
  const std::size_t begin = xml.find_first_of("\"'", word);
  if (begin == std::string_view::npos) return {};
  return lower_case(std::string(xml.substr(begin + 1, xml.find(xml[begin], begin + 1) - begin - 1)));
}

bool is_latin(std::string_view encoding) {
  constexpr std::array<std::string_view, 6> names{"iso-8859-1", "iso8859-1", "latin1",
                                                  "latin-1",    "us-ascii",  "windows-1252"};
  return std::ranges::find(names, encoding) != names.end();
}

}  // namespace

std::string to_utf8(std::string bytes, const std::filesystem::path& file) {
  const auto encoding = encoding_of(bytes);
  if (!encoding) return bytes;
  if (encoding->unit == 1) return bytes.substr(encoding->mark);
  std::string text;
  text.reserve(bytes.size() / encoding->unit);
  for (Units units(bytes, *encoding, file); units.more();) append(text, units.next());
  return text;
}

std::string xml_to_utf8(std::string bytes, const std::filesystem::path& file) {
  const bool unicode = encoding_of(bytes).has_value();
  std::string text = to_utf8(std::move(bytes), file);
  const std::string declared = declared_encoding(text);
  // Editors of Windows write a declaration of Latin-1 over UTF-8 and ASCII: these need no conversion.
  if (unicode || declared.empty() || declared == "utf-8" || is_ascii(text)) return text;
  if (!is_latin(declared)) refuse_text(file, fmt::format("the file is declared to be {}", declared));
  std::string wide;
  wide.reserve(text.size());
  for (const char c : text) append(wide, static_cast<unsigned char>(c));
  return wide;
}

std::string read_text_file(const std::filesystem::path& file, std::uintmax_t most) {
  return to_utf8(read_input_file(file, most), file);
}

}  // namespace murosimf::files
