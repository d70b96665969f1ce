/// srgb.h - from the numbers of a picture to light and back. Source: IEC 61966-2-1 (sRGB).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace murosimf::imaging {

/// Light from 0 to 1 of a value from 0 to 1, and back.
[[nodiscard]] double light_of_srgb(double value);
[[nodiscard]] double srgb_of_light(double light);

inline constexpr int full_light = 65535;  ///< light as a whole number: white

/// Light of the values 0 to 255, from 0 to full_light.
[[nodiscard]] const std::array<std::uint16_t, 256>& light_table();
/// The value nearest to light from 0 to full_light. The value of the light of a value is that value.
[[nodiscard]] const std::vector<std::uint8_t>& value_table();

}  // namespace murosimf::imaging
