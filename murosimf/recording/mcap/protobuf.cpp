#include "murosimf/recording/mcap/protobuf.h"

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::recording {

bool ProtobufReader::next() {
  if (left_.empty()) return false;
  const std::uint64_t tag = take_varint();
  field_ = static_cast<int>(tag >> 3 & 0x1fffffff);
  wire_ = static_cast<Wire>(tag & 7);
  switch (wire_) {
    case Wire::varint: bits_ = take_varint(); return true;
    case Wire::fixed64: bits_ = take_fixed(8); return true;
    case Wire::fixed32: bits_ = take_fixed(4); return true;
    case Wire::length: {
      const std::uint64_t size = take_varint();
      if (size > left_.size()) throw SetupError("a message ends too early");
      bytes_ = left_.substr(0, size);
      left_.remove_prefix(size);
      return true;
    }
  }
  throw SetupError("a message has a field of a kind that there is not");
}

double ProtobufReader::number() const { return std::bit_cast<double>(fixed64()); }

std::uint64_t ProtobufReader::varint() const {
  want(Wire::varint);
  return bits_;
}

std::uint64_t ProtobufReader::fixed64() const {
  want(Wire::fixed64);
  return bits_;
}

std::uint32_t ProtobufReader::fixed32() const {
  want(Wire::fixed32);
  return static_cast<std::uint32_t>(bits_);
}

std::string_view ProtobufReader::bytes() const {
  want(Wire::length);
  return bytes_;
}

/// Seven bits in each byte; at most ten bytes.
std::uint64_t ProtobufReader::take_varint() {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    if (left_.empty()) throw SetupError("a message ends too early");
    const auto byte = static_cast<unsigned char>(left_.front());
    left_.remove_prefix(1);
    value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
    if (byte < 0x80) return value;
  }
  throw SetupError("a message has a number of more than 64 bits");
}

/// Little endian, whatever the processor is.
std::uint64_t ProtobufReader::take_fixed(std::size_t size) {
  MUROSIMF_ASSERT(size <= sizeof(std::uint64_t));
  if (size > left_.size()) throw SetupError("a message ends too early");
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    value |= static_cast<std::uint64_t>(static_cast<unsigned char>(left_[i])) << (8 * i);
  }
  left_.remove_prefix(size);
  return value;
}

void ProtobufReader::want(Wire wire) const {
  if (wire_ != wire) throw SetupError("a field of a message has another type than its schema says");
}

}  // namespace murosimf::recording
