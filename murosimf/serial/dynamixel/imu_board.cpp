#include "murosimf/serial/dynamixel/imu_board.h"

#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::serial::dynamixel {
namespace {

ControlTable table_of(Protocol protocol) {
  using enum Access;
  const std::int32_t most = 32767;
  ControlTable table;
  table.name = "imu";
  table.protocol = protocol;
  table.fields.push_back({0, 2, read_only, imu_model_number, 0, 0, Item::model_number});
  const bool old = protocol == Protocol::v1;
  const std::uint16_t first = old ? 2 : 6;
  table.fields.push_back({first, 1, read_only, 1, 0, 0, Item::firmware});
  table.fields.push_back({static_cast<std::uint16_t>(first + 1), 1, eeprom, 200, 0, 252, Item::id});
  if (old) {
    table.baud_clock = 2e6;
    table.fast_baud_rates = {2.25e6, 2.5e6, 3e6};
  } else {
    table.baud_rates = {9600, 57600, 115200, 1e6, 2e6, 3e6, 4e6, 4.5e6};
  }
  table.fields.push_back(
      {static_cast<std::uint16_t>(first + 2), 1, eeprom, old ? 1 : 3, 0, old ? 252 : 7, Item::baud_rate});
  table.fields.push_back({static_cast<std::uint16_t>(first + 3), 1, eeprom, 250, 0, 254, Item::return_delay});
  table.fields.push_back({16, 1, ram, 2, 0, 2, Item::status_return_level});
  table.fields.push_back({36, 2, read_only, 0, 0, 65535, Item::sample});
  table.fields.push_back({38, 2, read_only, 0, 0, 65535, Item::sample_time});
  std::uint16_t address = 40;
  for (const Item item : {Item::gyroscope_x, Item::gyroscope_y, Item::gyroscope_z, Item::accelerometer_x,
                          Item::accelerometer_y, Item::accelerometer_z}) {
    table.fields.push_back({address, 2, read_only, 0, -most - 1, most, item});
    address += 2;
  }
  return table;
}

const ControlTable& imu_table(Protocol protocol) {
  static const ControlTable old = table_of(Protocol::v1), modern = table_of(Protocol::v2);
  return protocol == Protocol::v1 ? old : modern;
}

std::int32_t counts(double value, double unit) {
  constexpr double most = 1e6;
  return std::isfinite(value) ? static_cast<std::int32_t>(std::lround(std::fmax(-most, std::fmin(most, value / unit))))
                              : 0;
}

}  // namespace

ImuBoard::ImuBoard(Protocol protocol, std::uint8_t id, bool answers_broadcast)
    : BusDevice(imu_table(protocol), id), answers_broadcast_(answers_broadcast) {}

void ImuBoard::sense(const ImuSample& sample) {
  MUROSIMF_ASSERT(sample.gyroscope.size() == 3 && sample.accelerometer.size() == 3);
  constexpr double rate_unit = 0.001, acceleration_unit = 0.01;
  memory().set(Item::sample, static_cast<std::int32_t>(sample.count % 65536));
  memory().set(Item::sample_time, static_cast<std::int32_t>(std::llround(1000 * sample.time) % 65536));
  constexpr Item rates[] = {Item::gyroscope_x, Item::gyroscope_y, Item::gyroscope_z},
                 accelerations[] = {Item::accelerometer_x, Item::accelerometer_y, Item::accelerometer_z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    memory().set(rates[axis], counts(sample.gyroscope[axis], rate_unit));
    memory().set(accelerations[axis], counts(sample.accelerometer[axis], acceleration_unit));
  }
}

}  // namespace murosimf::serial::dynamixel
