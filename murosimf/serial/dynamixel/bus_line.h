/// bus_line.h - a bus at the end of a line: bytes of a client enter, bytes of the devices leave.
///
/// Without a baud rate bytes take no time: received packets are executed and answered at once. With one, every byte takes ten bits of simulated time
/// on the single wire that client and devices share: an instruction is executed when its last byte has arrived, its answers begin after the
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

  /// Sets the rate [bit/s] of the client's port: devices set to another one receive nothing, and if bytes take time, their duration
  /// follows it. 0: all devices receive.
  void set_rate(double rate);
  /// Bytes of the client, received at the time `now` [s].
  void push(ByteView bytes, double now);
  /// Executes due instructions, and appends the bytes that have left by now.
  void run(double now, Bytes& out);
  /// Drops an incomplete packet.
  void forget_partial() { parser_.forget(); }
  /// Drops everything in transit: the client has disconnected.
  void hang_up();
  /// Everything in transit.
  void state(StateArchive& archive);

  /// [bit/s]
  [[nodiscard]] double rate() const { return rate_; }
  /// [s] When the wire becomes free; in the past if it is free.
  [[nodiscard]] double free_at() const { return free_; }
  [[nodiscard]] bool has_partial() const { return parser_.pending() > 0; }
  [[nodiscard]] std::uint64_t instructions() const { return instructions_; }
  [[nodiscard]] std::uint64_t damaged() const { return parser_.damaged(); }

 private:
  struct Arrival {
    double due = 0;  // [s] when its last byte has arrived
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
  double free_ = 0;      // [s] when the wire becomes free
  double answered_ = 0;  // [s] when the last answer has left
  std::uint64_t instructions_ = 0;
};

}  // namespace murosimf::serial::dynamixel
