/// packet.h - one packet of either protocol, and its bytes on the line.
///
///     1.0: FF FF ID LENGTH INSTRUCTION parameters CHECKSUM
///     2.0: FF FF FD 00 ID LENGTH(2) INSTRUCTION parameters CRC(2)
///
/// In 2.0 the header never occurs within a packet: where instruction and parameters have FF FF FD, another FD follows.
#pragma once

#include "murosimf/serial/dynamixel/protocol.h"

namespace murosimf::serial::dynamixel {

struct Packet {
  Protocol protocol = Protocol::v2;
  std::uint8_t id = 0;
  std::uint8_t instruction = 0;  ///< of an answer: the error byte in 1.0, status_instruction in 2.0
  Bytes parameters;              ///< of an answer in 2.0 the error byte first

  bool operator==(const Packet&) const = default;
};

/// The answer of a device.
[[nodiscard]] Packet status_packet(Protocol protocol, std::uint8_t id, std::uint8_t error, ByteView data = {});

/// Bytes on the line. The packet must not be longer than its length field allows: 253 parameters in 1.0, most_bytes in
/// 2.0.
[[nodiscard]] Bytes to_bytes(const Packet& packet);

/// A longer packet of protocol 2.0 is invalid: the vendor's software sends no longer ones.
inline constexpr std::size_t most_bytes = 1024;

}  // namespace murosimf::serial::dynamixel
