/// protobuf.h - messages in the wire format of Protocol Buffers (protobuf.dev/programming-guides/encoding).
///
///     ProtobufWriter out(bytes);
///     out.message(1, [&](auto& vector) { vector.number(1, x); vector.number(2, y); });
///
/// Zero and empty values are omitted, as in proto3, except by `present_...`, for optional fields.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace murosimf::recording {

enum class Wire : std::uint8_t { varint = 0, fixed64 = 1, length = 2, fixed32 = 5 };

/// Appends fields to a string of the caller.
class ProtobufWriter {
 public:
  explicit ProtobufWriter(std::string& bytes) : bytes_(&bytes) {}

  void number(int field, double value) {
    if (std::bit_cast<std::uint64_t>(value) != 0) present_number(field, value);
  }
  void present_number(int field, double value) {
    tag(field, Wire::fixed64);
    fixed(std::bit_cast<std::uint64_t>(value), 8);
  }
  void varint(int field, std::uint64_t value) {
    if (value != 0) present_varint(field, value);
  }
  void present_varint(int field, std::uint64_t value) {
    tag(field, Wire::varint);
    raw_varint(value);
  }
  void fixed64(int field, std::uint64_t value) {
    if (value == 0) return;
    tag(field, Wire::fixed64);
    fixed(value, 8);
  }
  void fixed32(int field, std::uint32_t value) {
    if (value == 0) return;
    tag(field, Wire::fixed32);
    fixed(value, 4);
  }
  void text(int field, std::string_view value) {
    if (!value.empty()) bytes(field, value);
  }
  /// For repeated fields, where an empty one counts.
  void bytes(int field, std::string_view value) {
    tag(field, Wire::length);
    raw_varint(value.size());
    bytes_->append(value);
  }
  /// Numbers of 32 bits, packed; `Range` of std::uint32_t.
  template <class Range>
  void packed_fixed32(int field, const Range& values) {
    message(field, [&](ProtobufWriter& out) {
      for (const std::uint32_t value : values) out.fixed(value, 4);
    });
  }
  template <class Range>
  void packed_numbers(int field, const Range& values) {
    message(field, [&](ProtobufWriter& out) {
      for (const double value : values) out.fixed(std::bit_cast<std::uint64_t>(value), 8);
    });
  }
  /// fill(writer) writes the fields of an embedded message.
  template <class Fill>
  void message(int field, const Fill& fill) {
    tag(field, Wire::length);
    const std::size_t begin = bytes_->size();
    bytes_->push_back('\0');  // sufficient for 127 bytes, as for most messages
    fill(*this);
    const std::size_t size = bytes_->size() - begin - 1;
    if (size < 0x80) {
      (*bytes_)[begin] = static_cast<char>(size);
    } else {
      std::string length;
      ProtobufWriter(length).raw_varint(size);
      bytes_->replace(begin, 1, length);
    }
  }

 private:
  void tag(int field, Wire wire) {
    raw_varint(static_cast<std::uint64_t>(field) << 3 | static_cast<std::uint64_t>(wire));
  }
  void raw_varint(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) bytes_->push_back(static_cast<char>((value & 0x7f) | 0x80));
    bytes_->push_back(static_cast<char>(value));
  }
  void fixed(std::uint64_t value, std::size_t size) {
    std::array<char, 8> bytes{};
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(value >> (8 * i) & 0xff);
    bytes_->append(bytes.data(), size);
  }

  std::string* bytes_;
};

/// Iterates over the fields of a message in the caller's bytes.
///
///     for (ProtobufReader in(bytes); in.next();) {
///       if (in.field() == 1) x = in.number();
///     }
class ProtobufReader {
 public:
  explicit ProtobufReader(std::string_view bytes) : left_(bytes) {}

  /// Whether there is another field. Throws SetupError if it ends too early.
  [[nodiscard]] bool next();
  [[nodiscard]] int field() const { return field_; }

  // The value of the field. Throw SetupError if it has another type.
  [[nodiscard]] double number() const;
  [[nodiscard]] std::uint64_t varint() const;
  [[nodiscard]] std::uint64_t fixed64() const;
  [[nodiscard]] std::uint32_t fixed32() const;
  [[nodiscard]] std::string_view bytes() const;
  [[nodiscard]] ProtobufReader message() const { return ProtobufReader(bytes()); }

 private:
  [[nodiscard]] std::uint64_t take_varint();
  [[nodiscard]] std::uint64_t take_fixed(std::size_t size);
  void want(Wire wire) const;

  std::string_view left_;
  int field_ = 0;
  Wire wire_ = Wire::varint;
  std::uint64_t bits_ = 0;
  std::string_view bytes_;
};

}  // namespace murosimf::recording
