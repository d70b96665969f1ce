/// bus_line.h - a bus at the end of a line: bytes of a client come in, bytes of the devices go out.
///
/// Without a baud rate bytes take no time: what has come is done, and answered, at once. With one, every byte takes ten bits of simulated time
/// on the one wire that client and devices share: an instruction is done when its last byte has come, its answers begin after the
/// devices' return delay times, one after the other, and their bytes leave one by one.
#pragma once

#include <deque>

#include "murosimf/serial/dynamixel/bus.h"
#include "murosimf/serial/dynamixel/packet_parser.h"

namespace murosimf::serial::dynamixel {

class BusLine {
 public:
  /// `baud_rate` [bit/s]; 0: bytes take no time.
  explicit BusLine(Bus& bus, double baud_rate = 0) : bus_(&bus), byte_time_(baud_rate > 0 ? 10 / baud_rate : 0) {}

  /// The client's port is at this rate [bit/s]: devices that listen at another hear nothing, and if bytes take time here, it is
  /// that of this rate. 0: everybody hears.
  void set_rate(double rate);
  /// What the client has sent, seen at the time `now` [s].
  void push(ByteView bytes, double now);
  /// Does what is due, and appends the bytes that have left by now.
  void run(double now, Bytes& out);
  /// Drops a packet that has begun and is not whole.
  void forget_partial() { parser_.forget(); }
  /// Drops everything on its way: the client has gone.
  void hang_up();
  /// All that is on its way.
  void state(StateArchive& archive);

  /// [bit/s]
  [[nodiscard]] double rate() const { return rate_; }
  /// [s] When nobody is on the wire any more; past, if nobody is.
  [[nodiscard]] double free_at() const { return free_; }
  [[nodiscard]] bool has_partial() const { return parser_.pending() > 0; }
  [[nodiscard]] std::uint64_t instructions() const { return instructions_; }
  [[nodiscard]] std::uint64_t damaged() const { return parser_.damaged(); }

 private:
  struct Arrival {
    double due = 0;  // [s] when its last byte has come
    Packet packet;
    void state(StateArchive& archive);
  };
  struct Departure {
    double begin = 0;  // [s] of its first byte
    Bytes bytes;
    std::size_t sent = 0;
    void state(StateArchive& archive);
  };
  void execute(const Arrival& arrival);

  Bus* bus_;
  double byte_time_;  // [s]
  double rate_ = 0;   // [bit/s] of the client
  PacketParser parser_;
  std::deque<Arrival> arrivals_;
  std::deque<Departure> departures_;
  double free_ = 0;      // [s] when nobody is on the wire any more
  double answered_ = 0;  // [s] when the last answer has left
  std::uint64_t instructions_ = 0;
};

}  // namespace murosimf::serial::dynamixel
