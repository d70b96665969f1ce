#include "murosimf/imaging/srgb.h"

#include <cmath>

namespace murosimf::imaging {

double light_of_srgb(double value) { return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4); }

double srgb_of_light(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

const std::array<std::uint16_t, 256>& light_table() {
  static const auto table = [] {
    std::array<std::uint16_t, 256> made{};
    for (std::size_t i = 0; i < made.size(); ++i) {
      made[i] = static_cast<std::uint16_t>(std::lround(full_light * light_of_srgb(static_cast<double>(i) / 255)));
    }
    return made;
  }();
  return table;
}

const std::vector<std::uint8_t>& value_table() {
  static const auto table = [] {
    std::vector<std::uint8_t> made(full_light + 1);
    for (std::size_t i = 0; i < made.size(); ++i) {
      made[i] = static_cast<std::uint8_t>(std::lround(255 * srgb_of_light(static_cast<double>(i) / full_light)));
    }
    return made;
  }();
  return table;
}

}  // namespace murosimf::imaging
