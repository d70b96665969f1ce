/// crc32.h - the checksum of MCAP files: CRC-32 of ISO 3309, as in zlib.
#pragma once

#include <cstdint>
#include <string_view>

namespace murosimf::recording {

/// Checksum of bytes that follow others with the checksum `before`; 0 for the first ones.
[[nodiscard]] std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0) noexcept;

}  // namespace murosimf::recording
