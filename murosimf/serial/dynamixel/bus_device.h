/// bus_device.h - what has an id on the bus and a control table: answers reads, takes writes, keeps registered ones. What the numbers
/// do is that of its kind (servo_device.h, imu_board.h).
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
  /// Whether it does what is sent to this id: its own, its secondary one, or everybody's. Only its own is answered.
  [[nodiscard]] bool obeys(std::uint8_t id) const;
  /// Whether it understands what comes at a rate [bit/s]; 0: any. Not while it starts.
  [[nodiscard]] bool hears(double rate) const;
  /// An instruction has come, for it or for others.
  virtual void heard() {}
  /// Whether it answers a ping to everybody.
  [[nodiscard]] virtual bool answers_everybody() const { return true; }
  /// dt [s] go by.
  void pass(double dt) { asleep_ -= dt < asleep_ ? dt : asleep_; }
  /// Listens at this rate [bit/s]. False: it knows none that is near enough.
  bool listen_at(double rate);
  /// [s] from an instruction to its answer.
  [[nodiscard]] double return_delay() const { return 2e-6 * registers_.get(Item::return_delay); }
  [[nodiscard]] const Registers& registers() const { return registers_; }

  /// Does what one instruction for one device says. The answer to its own id; nothing where its status return level forbids one.
  [[nodiscard]] std::optional<Packet> execute(const Packet& packet);
  [[nodiscard]] std::optional<Packet> ping() const;
  [[nodiscard]] std::optional<Packet> read(std::size_t address, std::size_t size) const;
  Refusal write(std::size_t address, ByteView data);

  virtual void state(StateArchive& archive);

  static constexpr double start_time = 0.2;  ///< [s] without an answer after a reboot or a factory reset [assumption]

 protected:
  /// The EEPROM takes nothing now.
  [[nodiscard]] virtual bool eeprom_locked() const { return false; }
  /// Whether a number that its field allows may be written now.
  [[nodiscard]] virtual Refusal check(const Field&, std::int32_t) const { return Refusal::none; }
  /// It was.
  virtual void written(const Field&) {}
  /// It has started.
  virtual void restarted() {}
  /// "Clear" of protocol 2.0.
  [[nodiscard]] virtual Refusal clear(ByteView) { return Refusal::instruction; }
  /// What every error byte has besides.
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
  double asleep_ = 0;                // [s] until it has started
};

}  // namespace murosimf::serial::dynamixel
