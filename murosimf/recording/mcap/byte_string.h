/// byte_string.h - numbers and texts as bytes, little-endian, in the encoding of MCAP.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "murosimf/model/error.h"

namespace murosimf::recording {

/// Appends to a string of the caller.
class ByteWriter {
 public:
  explicit ByteWriter(std::string& bytes) : bytes_(&bytes) {}

  template <std::unsigned_integral T>
  void number(T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes_->push_back(static_cast<char>(value >> (8 * i) & 0xff));
  }
  void raw(std::string_view bytes) { bytes_->append(bytes); }
  /// Length in 32 bits, then the bytes.
  void text(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size()));
    raw(text);
  }

 private:
  std::string* bytes_;
};

/// Reads bytes of the caller. Throws SetupError if they end too early.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : left_(bytes) {}

  template <std::unsigned_integral T>
  [[nodiscard]] T number() {
    const std::string_view bytes = raw(sizeof(T));
    T value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      value = static_cast<T>(value | static_cast<T>(static_cast<T>(static_cast<unsigned char>(bytes[i])) << (8 * i)));
    }
    return value;
  }
  [[nodiscard]] std::string_view raw(std::uint64_t size) {
    if (size > left_.size()) throw SetupError("a record ends too early");
    const std::string_view bytes = left_.substr(0, size);
    left_.remove_prefix(size);
    return bytes;
  }
  [[nodiscard]] std::string text() { return std::string(raw(number<std::uint32_t>())); }
  [[nodiscard]] std::string_view left() const { return left_; }

 private:
  std::string_view left_;
};

}  // namespace murosimf::recording
