#include "murosimf/serial/dynamixel/control_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "murosimf/math/assert.h"

namespace murosimf::serial::dynamixel {
namespace {

constexpr std::int32_t last_divider = 249;

}  // namespace

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

double ControlTable::baud_rate(std::int32_t value) const {
  if (value < 0) return 0;
  if (baud_clock > 0 && value <= last_divider) return baud_clock / (value + 1);
  const std::vector<double>& rates = baud_clock > 0 ? fast_baud_rates : baud_rates;
  const auto place = static_cast<std::size_t>(baud_clock > 0 ? value - last_divider - 1 : value);
  return place < rates.size() ? rates[place] : 0;
}

std::optional<std::int32_t> ControlTable::baud_value(double rate) const {
  const Field* field = find(Item::baud_rate);
  std::optional<std::int32_t> nearest;
  for (std::int32_t value = 0; field && value <= field->highest; ++value) {
    if (!same_rate(baud_rate(value), rate)) continue;
    // rates of a divider may lie closer than the tolerance, hence the nearest
    const auto error = [&](std::int32_t one) { return std::abs(baud_rate(one) - rate); };
    if (!nearest || error(value) < error(*nearest)) nearest = value;
  }
  return nearest;
}

double ControlTable::pulses_per_radian() const {
  MUROSIMF_ASSERT(pulses_per_turn > 0);
  return pulses_per_turn / (2 * std::numbers::pi);
}

bool same_rate(double first, double second) {
  constexpr double tolerance = 0.03;
  return first > 0 && second > 0 && std::abs(first - second) <= tolerance * std::max(first, second);
}

}  // namespace murosimf::serial::dynamixel
