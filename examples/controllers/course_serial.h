/// course_serial.h - the behavior of course.h at a serial line: servos by Dynamixel 2.0, time by the IMU board. Needs POSIX and nothing else.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "course.h"

/// A serial port with devices that speak Dynamixel 2.0 (ROBOTIS e-Manual).
class DynamixelPort {
 public:
  using Bytes = std::vector<std::uint8_t>;

  explicit DynamixelPort(const std::string& name) : file_(open(name.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    if (file_ < 0) throw std::runtime_error("the port '" + name + "' cannot be opened");
    termios settings{};
    tcgetattr(file_, &settings);
    cfmakeraw(&settings);
    tcsetattr(file_, TCSANOW, &settings);
  }
  ~DynamixelPort() { close(file_); }
  DynamixelPort(const DynamixelPort&) = delete;
  DynamixelPort& operator=(const DynamixelPort&) = delete;

  void send(std::uint8_t id, std::uint8_t instruction, const Bytes& parameters) const {
    const std::size_t length = parameters.size() + 3;
    Bytes bytes{0xFF, 0xFF, 0xFD, 0, id, low(length), high(length), instruction};
    bytes.insert(bytes.end(), parameters.begin(), parameters.end());  // none of ours has FF FF FD in it
    const unsigned check = checksum(bytes, bytes.size());
    bytes.push_back(low(check));
    bytes.push_back(high(check));
    if (write(file_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
      throw std::runtime_error("the port is gone");
  }

  /// The data of the next answer without errors; empty: none within 200 ms.
  Bytes receive(std::uint8_t& id) {
    for (;;) {
      while (come_.size() >= 4 && !(come_[0] == 0xFF && come_[1] == 0xFF && come_[2] == 0xFD && come_[3] == 0))
        come_.erase(come_.begin());
      const std::size_t size = come_.size() < 7 ? 7 : 7U + come_[5] + 256U * come_[6];
      if (come_.size() >= size && size >= 11) {
        const Bytes packet(come_.begin(), come_.begin() + static_cast<std::ptrdiff_t>(size));
        come_.erase(come_.begin(), come_.begin() + static_cast<std::ptrdiff_t>(size));
        const unsigned check = checksum(packet, size - 2);
        if (packet[7] != 0x55 || packet[size - 2] != low(check) || packet[size - 1] != high(check)) continue;
        id = packet[4];
        return {packet.begin() + 9, packet.end() - 2};
      }
      if (!more()) return {};
    }
  }

  static std::uint8_t low(std::size_t number) { return static_cast<std::uint8_t>(number & 0xFF); }
  static std::uint8_t high(std::size_t number) { return static_cast<std::uint8_t>(number >> 8 & 0xFF); }

 private:
  bool more() {
    pollfd asked{file_, POLLIN, 0};
    if (poll(&asked, 1, 200) <= 0) return false;
    std::array<std::uint8_t, 1024> bytes{};
    const ssize_t count = read(file_, bytes.data(), bytes.size());
    if (count <= 0) throw std::runtime_error("the port is gone");
    come_.insert(come_.end(), bytes.begin(), bytes.begin() + count);
    return true;
  }

  static unsigned checksum(const Bytes& bytes, std::size_t size) {  // CRC-16/UMTS
    unsigned crc = 0;
    for (std::size_t i = 0; i < size; ++i) {
      crc ^= static_cast<unsigned>(bytes[i]) << 8;
      for (int bit = 0; bit < 8; ++bit)
        crc = (crc & 0x8000U) != 0 ? (crc << 1 ^ 0x8005U) & 0xFFFFU : crc << 1 & 0xFFFFU;
    }
    return crc;
  }

  int file_;
  Bytes come_;
};

/// Until it has arrived, or as long as others want. Throws std::runtime_error.
template <class GoesOn>
void cross_course_over_serial(const std::string& name, const GoesOn& goes_on) {
  constexpr std::uint8_t broadcast = 0xFE, write = 0x03, sync_write = 0x83, bulk_read = 0x92, imu = 200;
  constexpr std::uint8_t torque_enable = 64, goal_position = 116, present_position = 132, sample_time = 38;
  constexpr std::array<std::uint8_t, CourseRunner::joint_count> ids{10, 12, 13, 14,
                                                                    16, 18, 19, 20};  // of kid21's joints
  constexpr double pulses_per_radian = 4096 / 6.283185307179586;
  DynamixelPort port(name);
  port.send(broadcast, write, {torque_enable, 0, 1});
  DynamixelPort::Bytes question{imu, sample_time, 0, 2, 0};
  for (const std::uint8_t id : ids) question.insert(question.end(), {id, present_position, 0, 4, 0});
  CourseRunner runner;
  int last = -1000;  // [ms] of simulated time, modulo 65536
  while (!runner.arrived && goes_on()) {
    port.send(broadcast, bulk_read, question);
    int now = -1;
    std::size_t known = 0;
    CourseRunner::Angles measured, target;
    for (std::size_t i = 0; i <= ids.size(); ++i) {
      std::uint8_t id = 0;
      const DynamixelPort::Bytes data = port.receive(id);
      if (data.empty()) break;
      if (id == imu) now = data[0] + 256 * data[1];
      if (i == 0 || id != ids[i - 1]) continue;
      measured[i - 1] = ((data[0] + 256 * data[1]) - 2048) / pulses_per_radian;
      ++known;
    }
    if (now < 0 || known < ids.size() || now == last) continue;  // the IMU has a new sample every 10 ms
    last = now;
    runner.step(measured, target);
    DynamixelPort::Bytes goals{goal_position, 0, 4, 0};
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const auto goal = static_cast<std::size_t>(std::lround(2048 + target[i] * pulses_per_radian));
      goals.insert(goals.end(), {ids[i], DynamixelPort::low(goal), DynamixelPort::high(goal), 0, 0});
    }
    port.send(broadcast, sync_write, goals);
  }
}
