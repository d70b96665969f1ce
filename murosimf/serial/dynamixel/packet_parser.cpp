#include "murosimf/serial/dynamixel/packet_parser.h"

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/serial/dynamixel/packet_checksum.h"

namespace murosimf::serial::dynamixel {
namespace {

/// Removes the FD that follows each FF FF FD.
Bytes unstuffed(ByteView stuffed) {
  Bytes bytes;
  for (std::size_t i = 0; i < stuffed.size(); ++i) {
    const bool stuffing =
        i >= 3 && stuffed[i] == 0xFD && stuffed[i - 1] == 0xFD && stuffed[i - 2] == 0xFF && stuffed[i - 3] == 0xFF;
    if (!stuffing) bytes.push_back(stuffed[i]);
  }
  return bytes;
}

}  // namespace

/// Where no packet begins, one byte is skipped: the next one may begin a packet.
std::optional<Packet> PacketParser::next() {
  Packet packet;
  while (place_ < bytes_.size()) {
    const Found found = look(ByteView(bytes_).subspan(place_), packet);
    if (found == Found::more_needed) break;
    place_ += found == Found::packet ? size_of_last_ : 1;
    if (found == Found::packet) return packet;
  }
  MUROSIMF_ASSERT(place_ <= bytes_.size());
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(place_));
  place_ = 0;
  return std::nullopt;
}

void PacketParser::forget() {
  bytes_.clear();
  place_ = 0;
}

PacketParser::Found PacketParser::look(ByteView bytes, Packet& packet) {
  MUROSIMF_ASSERT(!bytes.empty());
  if (bytes[0] != 0xFF) return Found::nothing;
  if (bytes.size() < 2) return Found::more_needed;
  if (bytes[1] != 0xFF) return Found::nothing;
  if (bytes.size() < 4) return bytes.size() == 3 && bytes[2] == 0xFF ? Found::nothing : Found::more_needed;
  return bytes[2] == 0xFD && bytes[3] == 0x00 ? look_v2(bytes, packet) : look_v1(bytes, packet);
}

/// A wrong checksum does not skip the whole length, which may be wrong itself.
PacketParser::Found PacketParser::look_v1(ByteView bytes, Packet& packet) {
  const std::size_t length = bytes[3], size = length + 4;
  if (bytes[2] == 0xFF || length < 2) return Found::nothing;
  if (bytes.size() < size) return Found::more_needed;
  if (checksum(bytes.subspan(2, size - 3)) != bytes[size - 1]) {
    ++damaged_;
    return Found::nothing;
  }
  const ByteView parameters = bytes.subspan(5, length - 2);
  packet = {Protocol::v1, bytes[2], bytes[4], {parameters.begin(), parameters.end()}};
  size_of_last_ = size;
  return Found::packet;
}

/// A length beyond the largest packet is noise: waiting for its end would block the line.
PacketParser::Found PacketParser::look_v2(ByteView bytes, Packet& packet) {
  if (bytes.size() < 7) return Found::more_needed;
  const std::size_t length = word(bytes, 5), size = length + 7;
  if (length < 3 || size > most_bytes) return Found::nothing;
  if (bytes.size() < size) return Found::more_needed;
  if (crc16(bytes.first(size - 2)) != word(bytes, size - 2)) {
    ++damaged_;
    return Found::nothing;
  }
  Bytes body = unstuffed(bytes.subspan(7, length - 2));
  MUROSIMF_ASSERT(!body.empty());
  packet = {Protocol::v2, bytes[4], body.front(), {body.begin() + 1, body.end()}};
  size_of_last_ = size;
  return Found::packet;
}

void PacketParser::state(StateArchive& archive) {
  archive(bytes_, place_, size_of_last_, damaged_);
  if (place_ > bytes_.size()) throw SetupError("a packet on its way is damaged");
}

}  // namespace murosimf::serial::dynamixel
