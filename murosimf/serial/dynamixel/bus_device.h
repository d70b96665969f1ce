/// bus_device.h - a device with an id and a control table on the bus: answers reads, executes writes, stores registered ones. The effect
/// of the registers is defined by derived classes (servo_device.h, imu_board.h).
#pragma once

#include <optional>

#include "murosimf/serial/dynamixel/packet.h"
#include "murosimf/serial/dynamixel/registers.h"

namespace murosimf::serial::dynamixel {

class BusDevice {
 public:
  BusDevice(const ControlTable& table, std::uint8_t id);
  virtual ~BusDevice() = default;
  BusDevice(const BusDevice&) = delete;
  BusDevice& operator=(const BusDevice&) = delete;

  [[nodiscard]] Protocol protocol() const { return registers_.table().protocol; }
  [[nodiscard]] std::uint8_t id() const { return static_cast<std::uint8_t>(registers_.get(Item::id)); }
  /// Whether it executes packets to this id: its own, its secondary one, or the broadcast id. Only its own is answered.
  [[nodiscard]] bool obeys(std::uint8_t id) const;
  /// Whether it receives at a rate [bit/s]; 0: any. Not while it starts.
  [[nodiscard]] bool hears(double rate) const;
  /// Called for every received instruction, also those for others.
  virtual void heard() {}
  /// Whether it answers a broadcast ping.
  [[nodiscard]] virtual bool answers_broadcast() const { return true; }
  /// Advances time by dt [s].
  void pass(double dt) { asleep_ -= dt < asleep_ ? dt : asleep_; }
  /// Sets its rate [bit/s]. False: it has no rate near enough.
  bool listen_at(double rate);
  /// [s] Delay from an instruction to its answer.
  [[nodiscard]] double return_delay() const { return 2e-6 * registers_.get(Item::return_delay); }
  [[nodiscard]] const Registers& registers() const { return registers_; }

  /// Executes one instruction. Returns the answer to its own id; nothing where its status return level forbids one.
  [[nodiscard]] std::optional<Packet> execute(const Packet& packet);
  [[nodiscard]] std::optional<Packet> ping() const;
  [[nodiscard]] std::optional<Packet> read(std::size_t address, std::size_t size) const;
  Refusal write(std::size_t address, ByteView data);

  virtual void state(StateArchive& archive);

  static constexpr double start_time = 0.2;  ///< [s] without an answer after a reboot or a factory reset [assumption]

 protected:
  /// Whether the EEPROM is write-protected at present.
  [[nodiscard]] virtual bool eeprom_locked() const { return false; }
  /// Whether a number within the range of its field may be written at present.
  [[nodiscard]] virtual Refusal check(const Field&, std::int32_t) const { return Refusal::none; }
  /// Called after a write.
  virtual void written(const Field&) {}
  /// Called after a restart.
  virtual void restarted() {}
  /// "Clear" of protocol 2.0.
  [[nodiscard]] virtual Refusal clear(ByteView) { return Refusal::instruction; }
  /// Bits that every error byte contains in addition.
  [[nodiscard]] virtual std::uint8_t alarm() const { return 0; }

  Registers& memory() { return registers_; }

 private:
  [[nodiscard]] Packet status(Refusal refusal, ByteView data = {}) const;
  [[nodiscard]] std::int32_t answer_level() const;
  [[nodiscard]] std::size_t resolved(std::size_t address) const;
  [[nodiscard]] Refusal read_bytes(std::size_t address, std::size_t size, Bytes& data) const;
  [[nodiscard]] Refusal do_as(const Packet& packet);
  [[nodiscard]] Refusal write(const Packet& packet);
  [[nodiscard]] Refusal act();
  [[nodiscard]] Refusal reset(const Packet& packet);
  [[nodiscard]] std::optional<Packet> read(const Packet& packet) const;
  void restart();

  Registers registers_;
  std::vector<Packet> standing_by_;  // the registered write; at most one
  double asleep_ = 0;                // [s] until the start is complete
};

}  // namespace murosimf::serial::dynamixel
