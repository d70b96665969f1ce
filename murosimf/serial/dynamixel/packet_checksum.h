/// packet_checksum.h - checksums that detect damaged packets.
#pragma once

#include "murosimf/serial/dynamixel/protocol.h"

namespace murosimf::serial::dynamixel {

/// Protocol 2.0: CRC-16 with the polynomial 0x8005, start value 0, bits not reflected, over the whole packet before it.
[[nodiscard]] std::uint16_t crc16(ByteView bytes);

/// Protocol 1.0: complement of the lower byte of the sum, from the id to the last parameter.
[[nodiscard]] std::uint8_t checksum(ByteView bytes);

}  // namespace murosimf::serial::dynamixel
