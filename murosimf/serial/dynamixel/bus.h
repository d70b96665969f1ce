/// bus.h - devices on one line: which device executes an instruction, and the order of their answers.
#pragma once

#include <memory>

#include "murosimf/serial/dynamixel/bus_device.h"

namespace murosimf::serial::dynamixel {

/// An answer of a device.
struct BusAnswer {
  double delay = 0;  ///< [s] its return delay time
  Bytes bytes;
};

class Bus {
 public:
  void add(std::unique_ptr<BusDevice> device) { devices_.push_back(std::move(device)); }
  [[nodiscard]] const std::vector<std::unique_ptr<BusDevice>>& devices() const { return devices_; }

  /// Returns the answers, in the order in which they go over the line. In sync and bulk reads every device waits for the previous one in
  /// the list: after one that is missing, or that refuses to answer, no device answers. Devices set to another rate
  /// [bit/s] receive nothing; 0: all do.
  [[nodiscard]] std::vector<BusAnswer> execute(const Packet& packet, double rate = 0);

 private:
  using Answers = std::vector<BusAnswer>;

  /// The part of a request that addresses one device.
  struct Request {
    std::uint8_t id = 0;
    std::size_t address = 0, size = 0;
  };

  [[nodiscard]] static std::vector<Request> requests(const Packet& packet);
  [[nodiscard]] bool understands(const BusDevice& device, Protocol protocol) const;
  void fast_read(const Packet& packet, Answers& answers) const;
  [[nodiscard]] BusDevice* find(Protocol protocol, std::uint8_t id) const;
  /// Appends the device's answer; false if there is none.
  [[nodiscard]] bool read(Protocol protocol, const Request& request, Answers& answers) const;
  void ping_all(Protocol protocol, Answers& answers) const;
  void read_all(const Packet& packet, Answers& answers) const;
  void sync_write(const Packet& packet);
  void bulk_write(const Packet& packet);
  void write(Protocol protocol, std::uint8_t id, std::size_t address, ByteView data);

  std::vector<std::unique_ptr<BusDevice>> devices_;
  double rate_ = 0;  // [bit/s] of the present packet
};

}  // namespace murosimf::serial::dynamixel
