/// crc32.h - the checksum of MCAP files: CRC-32 of ISO 3309, as zlib has it.
#pragma once

#include <cstdint>
#include <string_view>

namespace murosimf::recording {

/// Of bytes that follow others whose checksum is `before`; 0 where nothing comes before.
[[nodiscard]] std::uint32_t crc32(std::string_view bytes, std::uint32_t before = 0) noexcept;

}  // namespace murosimf::recording
