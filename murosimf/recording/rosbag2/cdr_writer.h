/// cdr_writer.h - messages in the Common Data Representation (OMG DDSI-RTPS 2.5, section 10; CORBA 3.3, section 15.3), little endian,
/// as ROS 2 sends and stores them: each number at a multiple of its size from the beginning of the message.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "murosimf/math/quaternion.h"
#include "murosimf/math/vec3.h"
#include "murosimf/world/time.h"

namespace murosimf::recording {

class CdrWriter {
 public:
  CdrWriter() : bytes_({0, 1, 0, 0}) {}  // CDR_LE, no options

  void u8(std::uint8_t value) { bytes_.push_back(static_cast<char>(value)); }
  void boolean(bool value) { u8(value ? 1 : 0); }
  void u32(std::uint32_t value) { fixed(value, 4); }
  void i32(std::int32_t value) { fixed(static_cast<std::uint32_t>(value), 4); }
  void f32(double value) { fixed(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4); }
  void f64(double value) { fixed(std::bit_cast<std::uint64_t>(value), 8); }
  void text(std::string_view value) {
    u32(static_cast<std::uint32_t>(value.size() + 1));
    bytes_.append(value);
    u8(0);
  }
  /// A sequence of bytes.
  void bytes(std::string_view value) {
    u32(static_cast<std::uint32_t>(value.size()));
    bytes_.append(value);
  }
  void vector(const Vec3d& v) {
    f64(v.x);
    f64(v.y);
    f64(v.z);
  }
  void quaternion(const Quaterniond& q) {
    f64(q.x);
    f64(q.y);
    f64(q.z);
    f64(q.w);
  }
  /// builtin_interfaces/Time.
  void time(Duration value) {
    constexpr Duration::rep second = 1'000'000'000;
    i32(static_cast<std::int32_t>(value.count() / second));
    u32(static_cast<std::uint32_t>(value.count() % second));
  }
  /// std_msgs/Header.
  void header(Duration stamp, std::string_view frame) {
    time(stamp);
    text(frame);
  }

  [[nodiscard]] const std::string& message() const { return bytes_; }
  /// The message with another first number, a count that is known at the end only.
  [[nodiscard]] std::string with_count(std::uint32_t count) const {
    CdrWriter head;
    head.u32(count);
    std::string bytes = bytes_;
    return bytes.replace(0, head.bytes_.size(), head.bytes_);
  }

 private:
  void fixed(std::uint64_t value, std::size_t size) {
    constexpr std::size_t head = 4;  // not counted for alignment
    while ((bytes_.size() - head) % size != 0) bytes_.push_back('\0');
    for (std::size_t i = 0; i < size; ++i) bytes_.push_back(static_cast<char>(value >> (8 * i) & 0xff));
  }

  std::string bytes_;
};

}  // namespace murosimf::recording
