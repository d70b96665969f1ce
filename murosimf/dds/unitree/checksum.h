/// checksum.h - the CRC that low-level messages of Unitree carry: CRC-32/MPEG-2 over their words.
///
///     polynomial 0x04C11DB7, first value 0xFFFFFFFF, neither reflected nor inverted at the end; of each word of 32 bits the highest bit first
///
/// Source: Crc32Core in the vendor's examples (unitree_sdk2, example/g1/low_level), and unitree_sdk2py/utils/crc.py, which names the variant.
#pragma once

#include <cstdint>
#include <span>

namespace murosimf::dds::unitree {

/// Of words of four bytes, little endian; bytes behind the last whole word do not count.
[[nodiscard]] std::uint32_t checksum(std::span<const std::uint8_t> words) noexcept;

}  // namespace murosimf::dds::unitree
