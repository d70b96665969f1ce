#include "murosimf/serial/dynamixel/registers.h"

#include <algorithm>
#include <cstdint>

#include "murosimf/math/assert.h"

namespace murosimf::serial::dynamixel {
namespace {

bool is_signed(const Field& field) { return field.lowest < 0; }

}  // namespace

std::uint8_t error_byte(Protocol protocol, Refusal refusal) {
  const bool old = protocol == Protocol::v1;
  switch (refusal) {
    case Refusal::none: return 0;
    case Refusal::failed: return old ? 0 : error_v2::result_fail;
    case Refusal::instruction: return old ? error_v1::instruction : error_v2::instruction;
    case Refusal::range: return old ? error_v1::range : error_v2::data_range;
    case Refusal::length: return old ? error_v1::range : error_v2::data_length;
    case Refusal::limit: return old ? error_v1::angle_limit : error_v2::data_limit;
    case Refusal::access: return old ? error_v1::range : error_v2::access;
  }
  return 0;
}

Registers::Registers(const ControlTable& table) : table_(&table), bytes_(table.size()) {
  // a pointer for each item: get and set are called dozens of times per servo and step
  for (const Field& field : table.fields) {
    if (field.item != Item::stored) fields_[static_cast<std::size_t>(field.item)] = &field;
  }
  restore();
}

std::int32_t Registers::value(const Field& field, ByteView bytes) {
  MUROSIMF_ASSERT(bytes.size() >= field.size && field.size <= 4);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < field.size; ++i) bits |= std::uint32_t{bytes[i]} << 8 * i;
  if (field.sign_bit > 0) {
    const std::uint32_t sign = 1U << field.sign_bit;
    const auto size = static_cast<std::int32_t>(bits & (sign - 1));
    // INT32_MAX, which no field allows: bits above the sign make the number invalid
    return (bits & ~(2 * sign - 1)) != 0 ? INT32_MAX : (bits & sign) != 0 ? -size : size;
  }
  if (!is_signed(field) || field.size == 4) return static_cast<std::int32_t>(bits);
  return field.size == 2 ? static_cast<std::int16_t>(bits) : static_cast<std::int8_t>(bits);
}

void Registers::store(const Field& field, std::int32_t value) {
  MUROSIMF_ASSERT(field.address + std::size_t{field.size} <= bytes_.size());
  auto bits = static_cast<std::uint32_t>(value);
  if (field.sign_bit > 0 && value < 0) bits = (0U - bits) | 1U << field.sign_bit;
  for (std::size_t i = 0; i < field.size; ++i) {
    bytes_[field.address + i] = static_cast<std::uint8_t>(bits >> 8 * i & 0xFF);
  }
}

std::int32_t Registers::get(Item item) const {
  const Field* found = field(item);
  return found ? value(*found, ByteView(bytes_).subspan(found->address)) : 0;
}

void Registers::set(Item item, std::int32_t value) {
  const Field* found = field(item);
  if (found) store(*found, std::clamp(value, found->lowest, std::max(found->lowest, found->highest)));
}

void Registers::restore() {
  for (const Field& field : table_->fields) store(field, field.initial);
}

void Registers::restore_ram() {
  for (const Field& field : table_->fields) {
    if (field.access == Access::ram) store(field, field.initial);
  }
}

Refusal Registers::read(std::size_t address, std::size_t size, Bytes& data) const {
  if (size == 0) return Refusal::length;
  if (address + size > bytes_.size()) return Refusal::access;
  append(data, ByteView(bytes_).subspan(address, size));
  return Refusal::none;
}

/// All changes are planned before the first is made: a refused write changes nothing.
Refusal Registers::plan(std::size_t address, ByteView data, bool eeprom_locked, std::vector<Change>& changes) const {
  if (data.empty()) return Refusal::length;
  const std::size_t end = address + data.size();
  if (!table_->at(address) || end > bytes_.size()) return Refusal::access;
  for (const Field& field : table_->fields) {
    if (field.end() <= address || field.address >= end) continue;
    if (field.access == Access::read_only) return Refusal::access;
    if (field.access == Access::eeprom && eeprom_locked) return Refusal::access;
    if (field.address < address || field.end() > end) return Refusal::length;
    const std::int32_t wanted = value(field, data.subspan(field.address - address));
    if (wanted < field.lowest || wanted > field.highest) return Refusal::range;
    changes.push_back({&field, wanted});
  }
  return Refusal::none;
}

}  // namespace murosimf::serial::dynamixel
