/// bus.h - devices on one line: who does what an instruction says, and who answers in which order.
#pragma once

#include <memory>

#include "murosimf/connect/dynamixel/bus_device.h"

namespace murosimf::connect::dynamixel {

/// What a device sends.
struct BusAnswer {
  double delay = 0;  ///< [s] its return delay time
  Bytes bytes;
};

class Bus {
 public:
  void add(std::unique_ptr<BusDevice> device) { devices_.push_back(std::move(device)); }
  [[nodiscard]] const std::vector<std::unique_ptr<BusDevice>>& devices() const { return devices_; }

  /// The answers, in the order in which they go over the line. In sync and bulk reads every device waits for the one before
  /// it in the list: after one that is not there, or that refuses to answer, nobody answers.
  [[nodiscard]] std::vector<BusAnswer> execute(const Packet& packet);

 private:
  using Answers = std::vector<BusAnswer>;

  [[nodiscard]] BusDevice* find(Protocol protocol, std::uint8_t id) const;
  /// Appends its answer; false if there is none.
  [[nodiscard]] bool read(const Packet& packet, std::uint8_t id, std::size_t address, std::size_t size,
                          Answers& answers) const;
  void ping_all(Protocol protocol, Answers& answers) const;
  void sync_read(const Packet& packet, Answers& answers) const;
  void bulk_read(const Packet& packet, Answers& answers) const;
  void sync_write(const Packet& packet);
  void bulk_write(const Packet& packet);
  void write(Protocol protocol, std::uint8_t id, std::size_t address, ByteView data);

  std::vector<std::unique_ptr<BusDevice>> devices_;
};

}  // namespace murosimf::connect::dynamixel
