#include "murosimf/serial/dynamixel/packet.h"

#include "murosimf/math/assert.h"
#include "murosimf/serial/dynamixel/packet_checksum.h"

namespace murosimf::serial::dynamixel {
namespace {

/// Appends a byte of instruction or parameters, with a stuffing byte where a header would appear.
void append_stuffed(Bytes& bytes, std::size_t begin, std::uint8_t byte) {
  bytes.push_back(byte);
  const std::size_t size = bytes.size();
  const bool header = size >= begin + 3 && byte == 0xFD && bytes[size - 2] == 0xFF && bytes[size - 3] == 0xFF;
  if (header) bytes.push_back(0xFD);
}

Bytes to_bytes_v1(const Packet& packet) {
  Bytes bytes{0xFF, 0xFF, packet.id, static_cast<std::uint8_t>(packet.parameters.size() + 2), packet.instruction};
  append(bytes, packet.parameters);
  bytes.push_back(checksum(ByteView(bytes).subspan(2)));
  return bytes;
}

/// The length is written last: stuffed bytes count.
Bytes to_bytes_v2(const Packet& packet) {
  Bytes bytes{0xFF, 0xFF, 0xFD, 0x00, packet.id, 0, 0};
  const std::size_t begin = bytes.size();
  append_stuffed(bytes, begin, packet.instruction);
  for (const std::uint8_t byte : packet.parameters) append_stuffed(bytes, begin, byte);
  const std::size_t length = bytes.size() - begin + 2;
  MUROSIMF_ASSERT(length <= 0xFFFF);
  bytes[5] = static_cast<std::uint8_t>(length & 0xFF);
  bytes[6] = static_cast<std::uint8_t>(length >> 8);
  append_word(bytes, crc16(bytes));
  return bytes;
}

}  // namespace

Packet status_packet(Protocol protocol, std::uint8_t id, std::uint8_t error, ByteView data) {
  Packet packet{protocol, id, protocol == Protocol::v1 ? error : status_instruction, {}};
  if (protocol == Protocol::v2) packet.parameters.push_back(error);
  append(packet.parameters, data);
  return packet;
}

Bytes to_bytes(const Packet& packet) {
  return packet.protocol == Protocol::v1 ? to_bytes_v1(packet) : to_bytes_v2(packet);
}

}  // namespace murosimf::serial::dynamixel
