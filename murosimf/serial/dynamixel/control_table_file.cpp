#include "murosimf/serial/dynamixel/control_table_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "murosimf/files/data_path.h"
#include "murosimf/files/toml_reader.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::serial::dynamixel {
namespace {

using files::fail_at;
using files::TomlTable;

constexpr std::size_t largest_address = 2048;
constexpr int most_bases = 4;  // limits recursion of tables that name each other

constexpr std::pair<std::string_view, Item> names[] = {
    {"model_number", Item::model_number},
    {"firmware_version", Item::firmware},
    {"id", Item::id},
    {"secondary_id", Item::secondary_id},
    {"baud_rate", Item::baud_rate},
    {"return_delay_time", Item::return_delay},
    {"status_return_level", Item::status_return_level},
    {"registered_instruction", Item::registered},
    {"drive_mode", Item::drive_mode},
    {"operating_mode", Item::operating_mode},
    {"homing_offset", Item::position_offset},
    {"moving_threshold", Item::moving_threshold},
    {"temperature_limit", Item::temperature_limit},
    {"min_voltage_limit", Item::lowest_voltage},
    {"max_voltage_limit", Item::highest_voltage},
    {"pwm_limit", Item::pwm_limit},
    {"current_limit", Item::current_limit},
    {"velocity_limit", Item::velocity_limit},
    {"min_position_limit", Item::lowest_position},
    {"max_position_limit", Item::highest_position},
    {"overload_torque", Item::overload_torque},
    {"overload_time", Item::overload_time},
    {"shutdown", Item::shutdown},
    {"lock", Item::lock},
    {"torque_enable", Item::torque_enable},
    {"led", Item::led},
    {"hardware_error_status", Item::hardware_error},
    {"position_p_gain", Item::position_p_gain},
    {"position_i_gain", Item::position_i_gain},
    {"position_d_gain", Item::position_d_gain},
    {"bus_watchdog", Item::bus_watchdog},
    {"torque_limit", Item::torque_limit},
    {"goal_pwm", Item::goal_pwm},
    {"goal_current", Item::goal_current},
    {"goal_velocity", Item::goal_velocity},
    {"profile_acceleration", Item::profile_acceleration},
    {"profile_velocity", Item::profile_velocity},
    {"goal_position", Item::goal_position},
    {"realtime_tick", Item::realtime_tick},
    {"moving", Item::moving},
    {"moving_status", Item::moving_status},
    {"present_pwm", Item::present_pwm},
    {"present_load", Item::present_load},
    {"present_current", Item::present_current},
    {"present_velocity", Item::present_velocity},
    {"present_position", Item::present_position},
    {"velocity_trajectory", Item::velocity_trajectory},
    {"position_trajectory", Item::position_trajectory},
    {"present_input_voltage", Item::present_voltage},
    {"present_temperature", Item::present_temperature},
};

/// A row of the table of fields.
class Row {
 public:
  explicit Row(const toml::node& node) : node_(&node), cells_(node.as_array()) {
    if (!cells_ || cells_->size() < 7 || cells_->size() > 8) {
      fail("a field is [address, bytes, access, value, lowest, highest, name], and the sign's bit if there is one");
    }
  }
  [[noreturn]] void fail(std::string_view message) const { fail_at(node_->source(), message); }

  [[nodiscard]] Field field() const {
    Field field;
    field.address = static_cast<std::uint16_t>(number(0, 0, largest_address));
    field.size = static_cast<std::uint8_t>(number(1, 1, 4));
    if (field.size == 3) fail("a field has 1, 2 or 4 bytes");
    field.access = access();
    field.initial = static_cast<std::int32_t>(number(3, -INT32_MAX, INT32_MAX));
    field.lowest = static_cast<std::int32_t>(number(4, -INT32_MAX, INT32_MAX));
    field.highest = static_cast<std::int32_t>(number(5, -INT32_MAX, INT32_MAX));
    field.item = item();
    if (cells_->size() > 7) field.sign_bit = static_cast<std::uint8_t>(number(7, 1, 8 * field.size - 1));
    check(field);
    return field;
  }

 private:
  [[nodiscard]] std::int64_t number(std::size_t cell, std::int64_t lowest, std::int64_t highest) const {
    const auto value = (*cells_)[cell].value_exact<std::int64_t>();
    if (!value || *value < lowest || *value > highest) {
      fail(fmt::format("number {} of a field is a whole number from {} to {}", cell + 1, lowest, highest));
    }
    return *value;
  }
  [[nodiscard]] std::string text(std::size_t cell) const {
    const auto value = (*cells_)[cell].value_exact<std::string>();
    if (!value) fail(fmt::format("number {} of a field is a text", cell + 1));
    return *value;
  }
  [[nodiscard]] Access access() const {
    const std::string word = text(2);
    if (word == "read") return Access::read_only;
    if (word == "ram") return Access::ram;
    if (word == "eeprom") return Access::eeprom;
    fail(unknown_name("access", word, {"read", "ram", "eeprom"}));
  }
  [[nodiscard]] Item item() const {
    const std::string name = text(6);
    if (name.starts_with('(') && name.ends_with(')')) return Item::stored;
    const auto found = std::ranges::find(names, name, &std::pair<std::string_view, Item>::first);
    if (found != std::end(names)) return found->second;
    std::vector<std::string_view> known;
    for (const auto& [one, item] : names) known.push_back(one);
    fail(unknown_name("field", name, known) + "; in brackets it is kept without effect");
  }
  void check(const Field& field) const {
    if (field.lowest > field.highest) fail("the lowest number is above the highest");
    if (field.access == Access::read_only) return;
    if (field.initial < field.lowest || field.initial > field.highest) fail("the value is out of its range");
    const int bits = field.sign_bit > 0 ? field.sign_bit : field.lowest < 0 ? 8 * field.size - 1 : 8 * field.size;
    // below 31 bits only: 1 << 31 overflows, and every int32 fits into 32 bits
    if (bits < 31 && (field.highest >= 1 << bits || field.lowest < -(1 << bits))) fail("the range needs more bytes");
  }

  const toml::node* node_;
  const toml::array* cells_;
};

void read_units(const TomlTable& file, ServoUnits& units) {
  const toml::table* table = file.table("units");
  if (!table) return;
  const TomlTable given(*table, {"velocity", "acceleration", "current", "stall_torque", "stall_current",
                                 "no_load_speed", "p_gain", "i_gain", "d_gain", "full_torque"});
  const std::pair<std::string_view, double*> numbers[] = {{"velocity", &units.velocity},
                                                          {"acceleration", &units.acceleration},
                                                          {"current", &units.current},
                                                          {"stall_torque", &units.stall_torque},
                                                          {"stall_current", &units.stall_current},
                                                          {"no_load_speed", &units.no_load_speed},
                                                          {"p_gain", &units.p_gain},
                                                          {"i_gain", &units.i_gain},
                                                          {"d_gain", &units.d_gain},
                                                          {"full_torque", &units.full_torque}};
  for (const auto& [key, value] : numbers) {
    given.read(key, *value);
    if (!(*value >= 0 && *value < 1e9))
      throw SetupError(fmt::format("{}: {} is negative or too large", given.where(key), key));
  }
}

/// Reads the numbers of a key, if present.
void read_numbers(const TomlTable& file, std::string_view key, double highest, std::vector<double>& numbers) {
  const toml::node* node = file.find(key);
  if (!node) return;
  const auto given = node->is_array() ? files::numbers_of(*node) : std::nullopt;
  const bool right = given && std::ranges::all_of(*given, [&](double one) { return one >= 0 && one <= highest; });
  if (!right) throw SetupError(fmt::format("{}: {} is a list of numbers from 0 to {}", file.where(key), key, highest));
  numbers = *given;
}

void put(std::vector<Field>& fields, const Field& field) {
  // kept in the order of addresses, which ControlTable::at searches
  const auto place = std::ranges::lower_bound(fields, field.address, {}, &Field::address);
  if (place != fields.end() && place->address == field.address) {
    *place = field;
  } else {
    fields.insert(place, field);
  }
}

/// Adds the fields of a block, one for each address and each byte.
void put_block(const toml::table& table, ControlTable& made) {
  const TomlTable given(table, {"addresses", "data", "count", "lowest", "highest"});
  std::uint64_t addresses = 0, data = 0, count = 0, lowest = 0, highest = largest_address;
  given.read("addresses", addresses);
  given.read("data", data);
  given.read("count", count);
  given.read("lowest", lowest);
  given.read("highest", highest);
  const bool right = count > 0 && count <= 256 && addresses + 2 * count <= largest_address &&
                     data + count <= largest_address && lowest <= highest && highest <= largest_address &&
                     (addresses + 2 * count <= data || data + count <= addresses);
  if (!right) throw SetupError(given.where() + ": indirect addresses and data must have room side by side");
  made.indirect.push_back(
      {static_cast<std::uint16_t>(addresses), static_cast<std::uint16_t>(data), static_cast<std::uint16_t>(count)});
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto target = static_cast<std::int32_t>(data + i);
    if (target < static_cast<std::int32_t>(lowest) || target > static_cast<std::int32_t>(highest))
      throw SetupError(given.where() + ": the data must be within 'lowest' and 'highest'");
    put(made.fields, {static_cast<std::uint16_t>(addresses + 2 * i), 2, Access::ram, target,
                      static_cast<std::int32_t>(lowest), static_cast<std::int32_t>(highest)});
    put(made.fields, {static_cast<std::uint16_t>(data + i), 1, Access::ram, 0, 0, 255});
    MUROSIMF_ASSERT(std::ranges::is_sorted(made.fields, {}, &Field::address));
  }
}

void drop_block(const IndirectBlock& block, std::vector<Field>& fields) {
  std::erase_if(fields, [&](const Field& field) {
    return block.has_data(field.address) ||
           (field.address >= block.addresses && field.address < block.addresses + 2 * block.count);
  });
}

void read_fields(const TomlTable& file, ControlTable& made) {
  const toml::table* table = file.table("table");
  if (!table) return;
  const TomlTable given(*table, {"fields"});
  const toml::node* node = given.find("fields");
  const toml::array* rows = node ? node->as_array() : nullptr;
  if (!rows) throw SetupError(given.where() + ": 'fields' is a list of fields");
  std::set<std::uint16_t> own;
  for (const toml::node& node_of_row : *rows) {
    const Row row(node_of_row);
    const Field field = row.field();
    if (!own.insert(field.address).second) row.fail(fmt::format("two fields stand at {}", field.address));
    if (field.item != Item::stored) {
      std::erase_if(made.fields, [&](const Field& old) {
        return old.item == field.item;
      });  // an item moves, it does not exist twice
    }
    put(made.fields, field);
  }
}

/// Fields must not overlap: a write to one would change another.
void check_whole(const TomlTable& file, const ControlTable& table) {
  const auto fail = [&](const std::string& what) { throw SetupError(file.where() + ": " + what); };
  std::size_t end = 0;
  for (const Field& field : table.fields) {
    if (field.address < end) fail(fmt::format("the field at {} begins within the one before it", field.address));
    end = field.end();
  }
  for (const auto& [name, item] : {std::pair<std::string_view, Item>{"model_number", Item::model_number},
                                   {"firmware_version", Item::firmware},
                                   {"id", Item::id},
                                   {"return_delay_time", Item::return_delay},
                                   {"status_return_level", Item::status_return_level},
                                   {"min_position_limit", Item::lowest_position},
                                   {"max_position_limit", Item::highest_position},
                                   {"torque_enable", Item::torque_enable},
                                   {"goal_position", Item::goal_position},
                                   {"goal_velocity", Item::goal_velocity},
                                   {"present_position", Item::present_position}}) {
    if (!table.find(item)) fail(fmt::format("there is no field '{}'", name));
  }
  if (!(table.units.velocity > 0 && table.units.stall_torque > 0)) fail("units need velocity and stall_torque");
  if (table.units.current > 0 && !(table.units.stall_current > 0)) fail("units with a current need stall_current");
  if (!(table.units.full_torque > 0)) fail("units need full_torque");
  const Field* baud = table.find(Item::baud_rate);
  if (baud && !(table.baud_rate(baud->initial) > 0)) fail("the baud rate from the factory is not in baud_rates");
}

/// Tables build upon others; the depth is bounded, since files could name each other.
ControlTable read_upon(const std::filesystem::path& file, int depth) {
  const toml::table root = files::parse_toml_file(file);
  const TomlTable given(root, {"base", "without", "protocol", "feetech", "operating_modes", "baud_rates", "baud_clock",
                               "fast_baud_rates", "pulses_per_turn", "middle_pulse", "units", "indirect", "table"});
  ControlTable table;
  std::string base;
  given.read("base", base);
  if (!base.empty()) {
    if (depth == 0) throw SetupError(given.where("base") + ": too many bases upon each other");
    const auto path = find_base_file(base, file.parent_path());
    if (!path) throw SetupError(given.where("base") + ": " + unknown_name("table", base, {}));
    table = read_upon(*path, depth - 1);
  }
  table.name = file.stem().string();
  table.base = base;
  std::uint64_t protocol = table.protocol == Protocol::v1 ? 1 : 2;
  given.read("protocol", protocol);
  if (protocol != 1 && protocol != 2) throw SetupError(given.where("protocol") + ": the protocol is 1 or 2");
  table.protocol = protocol == 1 ? Protocol::v1 : Protocol::v2;
  given.read("feetech", table.feetech);
  given.read("baud_clock", table.baud_clock);
  given.read("pulses_per_turn", table.pulses_per_turn);
  given.read("middle_pulse", table.middle_pulse);
  if (!(table.pulses_per_turn >= 1 && table.pulses_per_turn <= 1e7 && std::abs(table.middle_pulse) <= 1e7))
    throw SetupError(given.where() + ": pulses are from 1 to 1e7 a turn");
  read_numbers(given, "baud_rates", 1e8, table.baud_rates);
  read_numbers(given, "fast_baud_rates", 1e8, table.fast_baud_rates);
  std::vector<double> modes(table.operating_modes.begin(), table.operating_modes.end());
  read_numbers(given, "operating_modes", 255, modes);
  table.operating_modes.clear();
  for (const double mode : modes) table.operating_modes.push_back(static_cast<std::int32_t>(mode));
  read_units(given, table.units);
  std::vector<double> without;
  read_numbers(given, "without", largest_address, without);
  for (const double address : without) {
    std::erase_if(table.fields, [&](const Field& field) { return field.address == address; });
  }
  if (const auto blocks = given.tables("indirect"); !blocks.empty()) {
    for (const IndirectBlock& block : std::exchange(table.indirect, {})) drop_block(block, table.fields);
    for (const toml::table* block : blocks) put_block(*block, table);
  }
  read_fields(given, table);
  check_whole(given, table);
  return table;
}

}  // namespace

std::optional<std::filesystem::path> find_base_file(const std::string& base, const std::filesystem::path& beside) {
  const std::string name = base + ".toml";
  auto path = files::look_for_data_file("servos/tables/" + name, "", "");  // not hidden by a file of another kind
  return path ? path : files::look_for_data_file(name, "", "", beside);
}

ControlTable read_control_table(const std::filesystem::path& file) { return read_upon(file, most_bases); }

}  // namespace murosimf::serial::dynamixel
