#include "murosimf/connect/dynamixel/control_table.h"

#include <algorithm>

namespace murosimf::connect::dynamixel {

const Field* ControlTable::find(Item item) const {
  const auto found = std::ranges::find(fields, item, &Field::item);
  return found == fields.end() ? nullptr : &*found;
}

const Field* ControlTable::at(std::size_t address) const {
  const auto after = std::ranges::upper_bound(fields, address, {}, &Field::address);
  if (after == fields.begin()) return nullptr;
  const Field& field = *std::prev(after);
  return address < field.end() ? &field : nullptr;
}

const std::vector<ControlTable>& servo_tables() {
  static const std::vector<ControlTable> tables = [] {
    std::vector<ControlTable> all = servo_tables_v1();
    for (ControlTable& table : servo_tables_v2()) all.push_back(std::move(table));
    return all;
  }();
  return tables;
}

const ControlTable* find_servo_table(std::string_view name) {
  const auto found = std::ranges::find(servo_tables(), name, &ControlTable::name);
  return found == servo_tables().end() ? nullptr : &*found;
}

}  // namespace murosimf::connect::dynamixel
