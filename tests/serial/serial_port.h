/// serial_port.h - the client's end of a serial line, for tests, without help of any library.
#pragma once

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

#include <gtest/gtest.h>

#include "murosimf/serial/dynamixel/packet_parser.h"
#include "murosimf/serial/line_rate.h"

namespace murosimf::serial {

class SerialPort {
 public:
  explicit SerialPort(const std::filesystem::path& path)
      : file_(open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
    EXPECT_GE(file_, 0) << path;
  }
  ~SerialPort() { hang_up(); }
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  void hang_up() {
    if (file_ >= 0) close(file_);
    file_ = -1;
  }
  void send(dynamixel::ByteView bytes) const {
    EXPECT_EQ(write(file_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  void send(const dynamixel::Packet& packet) const { send(dynamixel::to_bytes(packet)); }
  /// What was written and is not sent yet is dropped.
  void flush_output() const { EXPECT_EQ(tcflush(file_, TCOFLUSH), 0); }
  /// [bit/s]
  [[nodiscard]] bool set_rate(double rate) const { return set_line_rate(file_, rate); }
  [[nodiscard]] dynamixel::Bytes received() const {
    std::array<std::uint8_t, 8192> bytes{};
    const ssize_t count = read(file_, bytes.data(), bytes.size());
    return {bytes.begin(), bytes.begin() + std::max<ssize_t>(count, 0)};
  }
  /// The next answer among what has come.
  [[nodiscard]] std::optional<dynamixel::Packet> answer() {
    parser_.push(received());
    return parser_.next();
  }

 private:
  int file_;
  dynamixel::PacketParser parser_;
};

/// File descriptors of this process.
inline std::size_t open_files() {
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) ++count;
  return count;
}

}  // namespace murosimf::serial
