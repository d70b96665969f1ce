/// registers.h - the memory of a device that has a control table.
#pragma once

#include <array>
#include <functional>

#include "murosimf/serial/dynamixel/control_table.h"
#include "murosimf/world/state_archive.h"

namespace murosimf::serial::dynamixel {

/// Reason why an instruction is refused.
enum class Refusal : std::uint8_t { none, failed, instruction, range, length, limit, access };

/// The refusal as error byte of an answer; 1.0 has fewer values.
[[nodiscard]] std::uint8_t error_byte(Protocol protocol, Refusal refusal);

class Registers {
 public:
  /// Factory state. The table must outlive it.
  explicit Registers(const ControlTable& table);

  [[nodiscard]] const ControlTable& table() const { return *table_; }
  [[nodiscard]] bool has(Item item) const { return field(item) != nullptr; }
  /// Value of an item; 0 if the table has none.
  [[nodiscard]] std::int32_t get(Item item) const;
  /// Sets an item regardless of its access; values out of range are clamped. Nothing if there is none.
  void set(Item item, std::int32_t value);
  /// Restores the factory state: everything, or all but the EEPROM.
  void restore();
  void restore_ram();

  /// One byte; 0 outside of the memory and of all fields.
  [[nodiscard]] std::uint8_t byte(std::size_t address) const { return address < bytes_.size() ? bytes_[address] : 0; }
  /// Bytes outside of fields are 0.
  [[nodiscard]] Refusal read(std::size_t address, std::size_t size, Bytes& data) const;

  struct Change {
    const Field* field = nullptr;
    std::int32_t value = 0;
  };
  /// Changes that a write at an address would make, in the order of the table: whole writable fields, within their ranges; bytes
  /// outside of fields are ignored. Does not write.
  [[nodiscard]] Refusal plan(std::size_t address, ByteView data, bool eeprom_locked,
                             std::vector<Change>& changes) const;
  void apply(const Change& change) { store(*change.field, change.value); }

  void state(StateArchive& archive) { archive.elements(std::span(bytes_)); }

 private:
  [[nodiscard]] const Field* field(Item item) const { return fields_[static_cast<std::size_t>(item)]; }
  [[nodiscard]] static std::int32_t value(const Field& field, ByteView bytes);
  void store(const Field& field, std::int32_t value);

  const ControlTable* table_;
  std::array<const Field*, static_cast<std::size_t>(Item::last)> fields_{};
  Bytes bytes_;
};

}  // namespace murosimf::serial::dynamixel
