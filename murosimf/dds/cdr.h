/// cdr.h - numbers and texts as DDS sends them: CDR of version 1 (XCDR1), little endian, behind its four bytes of encapsulation.
///
/// Numbers stand at multiples of their size, counted from behind the encapsulation; a text is its length with the final zero, its bytes, and that
/// zero; a sequence its count and its elements.
/// Source: OMG, "DDS Extensible Types" 1.3, 7.4.1 (encoding) and 7.6.3 (encapsulation).
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace murosimf::dds {

using Bytes = std::vector<std::uint8_t>;
inline constexpr std::size_t encapsulation_size = 4;  ///< [byte]

class CdrWriter {
 public:
  CdrWriter() { clear(); }
  /// Keeps the memory.
  void clear() { bytes_.assign({0, 1, 0, 0}); }
  template <class T>
  CdrWriter& number(T value) {
    static_assert(std::is_arithmetic_v<T>);
    while ((bytes_.size() - encapsulation_size) % sizeof(T) != 0) bytes_.push_back(0);
    bytes_.resize(bytes_.size() + sizeof(T));
    std::memcpy(&bytes_[bytes_.size() - sizeof(T)], &value, sizeof(T));
    return *this;
  }
  CdrWriter& text(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size() + 1));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
    return *this;
  }
  /// A sequence of bytes.
  CdrWriter& blob(std::string_view blob) {
    number(static_cast<std::uint32_t>(blob.size()));
    bytes_.insert(bytes_.end(), blob.begin(), blob.end());
    return *this;
  }
  /// Replaces the first number, a count that is known at the end only.
  CdrWriter& set_first(std::uint32_t count) {
    std::memcpy(&bytes_[encapsulation_size], &count, sizeof count);
    return *this;
  }
  [[nodiscard]] const Bytes& bytes() const { return bytes_; }

 private:
  Bytes bytes_;
};

/// What is not there is 0 or empty, and makes the reader not good().
class CdrReader {
 public:
  /// Not good if the encapsulation is missing, or says something else.
  explicit CdrReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {
    good_ = bytes.size() >= encapsulation_size && bytes[0] == 0 && bytes[1] == 1;
  }
  [[nodiscard]] bool good() const { return good_; }

  template <class T>
  [[nodiscard]] T number() {
    static_assert(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>);
    while ((at_ - encapsulation_size) % sizeof(T) != 0) ++at_;
    T value{};
    if (!has(sizeof(T))) return value;
    std::memcpy(&value, &bytes_[at_], sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  [[nodiscard]] std::string text() {
    const auto size = number<std::uint32_t>();
    if (size == 0 || !has(size)) return good_ = false, std::string();
    const std::string text(bytes_.begin() + static_cast<std::ptrdiff_t>(at_),
                           bytes_.begin() + static_cast<std::ptrdiff_t>(at_ + size - 1));
    at_ += size;
    return text;
  }
  /// [byte] not read yet.
  [[nodiscard]] std::size_t left() const { return good_ ? bytes_.size() - at_ : 0; }
  /// Count of a sequence, at most `most`; 0 if there are more.
  [[nodiscard]] std::uint32_t count(std::uint32_t most) {
    const auto count = number<std::uint32_t>();
    if (count <= most) return count;
    good_ = false;
    return 0;
  }

 private:
  [[nodiscard]] bool has(std::size_t size) {
    good_ = good_ && at_ <= bytes_.size() && size <= bytes_.size() - at_;
    return good_;
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = encapsulation_size;
  bool good_ = false;
};

}  // namespace murosimf::dds
