/// packet_bytes.h - numbers in a packet of a GameController, little-endian and without gaps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::league {

inline constexpr std::string_view game_magic = "RGme";
inline constexpr int last_game_state = 4;  ///< finished

/// Offsets must be within the packet, whose length the caller has checked.
class PacketBytes {
 public:
  explicit PacketBytes(std::string_view bytes) : bytes_(bytes) {}
  [[nodiscard]] std::uint8_t one(std::size_t offset) const {
    MUROSIMF_ASSERT(offset < bytes_.size());
    return static_cast<std::uint8_t>(bytes_[offset]);
  }
  [[nodiscard]] int two(std::size_t offset) const { return one(offset) + 256 * one(offset + 1); }
  [[nodiscard]] int signed_two(std::size_t offset) const { return static_cast<std::int16_t>(two(offset)); }
  [[nodiscard]] PacketBytes from(std::size_t offset) const {
    MUROSIMF_ASSERT(offset <= bytes_.size());
    return PacketBytes(bytes_.substr(offset));
  }

 private:
  std::string_view bytes_;
};

/// Returns the value. Throws SetupError if it exceeds `highest`.
inline int checked(int value, int highest, std::string_view what) {
  if (value > highest) throw SetupError(fmt::format("{} {}; the last one is {}", what, value, highest));
  return value;
}

}  // namespace murosimf::league
