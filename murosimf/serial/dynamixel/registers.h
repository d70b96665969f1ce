/// registers.h - the memory of a device that has a control table.
#pragma once

#include <array>
#include <functional>

#include "murosimf/model/state_archive.h"
#include "murosimf/serial/dynamixel/control_table.h"

namespace murosimf::serial::dynamixel {

/// Why something is not done.
enum class Refusal : std::uint8_t { none, failed, instruction, range, length, limit, access };

/// As the error byte of an answer says it; 1.0 knows fewer.
[[nodiscard]] std::uint8_t error_byte(Protocol protocol, Refusal refusal);

class Registers {
 public:
  /// As from the factory. The table must outlive it.
  explicit Registers(const ControlTable& table);

  [[nodiscard]] const ControlTable& table() const { return *table_; }
  [[nodiscard]] bool has(Item item) const { return field(item) != nullptr; }
  /// 0 if there is none.
  [[nodiscard]] std::int32_t get(Item item) const;
  /// Whatever the table says about writing; what does not fit is cut to the nearest that does. Nothing if there is none.
  void set(Item item, std::int32_t value);
  /// As from the factory: all, or what is not in the EEPROM.
  void restore();
  void restore_ram();

  /// One byte; 0 if it is of no field or beyond the end.
  [[nodiscard]] std::uint8_t byte(std::size_t address) const { return address < bytes_.size() ? bytes_[address] : 0; }
  /// Bytes of no field are 0.
  [[nodiscard]] Refusal read(std::size_t address, std::size_t size, Bytes& data) const;

  struct Change {
    const Field* field = nullptr;
    std::int32_t value = 0;
  };
  /// What bytes at an address would change, in the order of the table: whole fields that may be written, within their ranges; bytes
  /// of no field between them change nothing. Writes nothing itself.
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
