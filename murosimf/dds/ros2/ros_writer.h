/// ros_writer.h - fields of ROS 2 messages, in the representation of dds/cdr.h, as topics carry and bags store them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "murosimf/dds/cdr.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/math/vec3.h"
#include "murosimf/world/time.h"

namespace murosimf::dds::ros2 {

class RosWriter {
 public:
  /// Keeps the memory.
  void clear() { out_.clear(); }
  void u8(std::uint8_t value) { out_.number(value); }
  void boolean(bool value) { u8(value ? 1 : 0); }
  void u32(std::uint32_t value) { out_.number(value); }
  void i32(std::int32_t value) { out_.number(value); }
  void u16(std::uint16_t value) { out_.number(value); }
  void u64(std::uint64_t value) { out_.number(value); }
  void f32(double value) { out_.number(static_cast<float>(value)); }
  void f64(double value) { out_.number(value); }
  void text(std::string_view value) { out_.text(value); }
  /// A sequence of bytes.
  void bytes(std::string_view value) { out_.blob(value); }
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

  /// Sequences.
  void texts(std::span<const std::string> all) {
    u32(static_cast<std::uint32_t>(all.size()));
    for (const std::string& one : all) text(one);
  }

  [[nodiscard]] const Bytes& encoded() const { return out_.bytes(); }
  [[nodiscard]] std::string message() const { return {out_.bytes().begin(), out_.bytes().end()}; }
  /// The message with another first number, a count that is known at the end only.
  [[nodiscard]] std::string with_count(std::uint32_t count) {
    out_.set_first(count);
    return message();
  }

 private:
  CdrWriter out_;
};

}  // namespace murosimf::dds::ros2
