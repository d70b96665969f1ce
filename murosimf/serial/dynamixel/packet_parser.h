/// packet_parser.h - finds packets of both protocols in a stream of arbitrary bytes.
///
/// FF FF FD 00 begins a packet of 2.0 and cannot begin one of 1.0, whose length is never 0: one line carries both. If a
/// candidate turns out damaged, the search continues right after its header's first byte: a false length hides
/// no packet that follows.
#pragma once

#include <optional>

#include "murosimf/serial/dynamixel/packet.h"
#include "murosimf/world/state_archive.h"

namespace murosimf::serial::dynamixel {

class PacketParser {
 public:
  void push(ByteView bytes) { append(bytes_, bytes); }
  /// The next complete packet; nothing while there is none.
  [[nodiscard]] std::optional<Packet> next();
  /// Drops an incomplete packet: the line was silent for too long.
  void forget();

  /// Number of bytes kept because a packet may have begun: fewer than most_bytes after next() has returned nothing.
  [[nodiscard]] std::size_t pending() const { return bytes_.size() - place_; }
  /// Number of packets so far with a wrong checksum.
  [[nodiscard]] std::uint64_t damaged() const { return damaged_; }
  /// Bytes of the last packet on the line.
  [[nodiscard]] std::size_t size_of_last() const { return size_of_last_; }
  void state(StateArchive& archive);

 private:
  enum class Found { packet, nothing, more_needed };

  [[nodiscard]] Found look(ByteView bytes, Packet& packet);
  [[nodiscard]] Found look_v1(ByteView bytes, Packet& packet);
  [[nodiscard]] Found look_v2(ByteView bytes, Packet& packet);

  Bytes bytes_;
  std::size_t place_ = 0;  // bytes before it are processed
  std::size_t size_of_last_ = 0;
  std::uint64_t damaged_ = 0;
};

}  // namespace murosimf::serial::dynamixel
