// Bytes on a serial line. The first byte says into how large pieces they fall.
#include <algorithm>

#include "murosimf/serial/dynamixel/packet_parser.h"
#include "tests/fuzz/fuzz.h"

namespace {

using namespace murosimf::serial::dynamixel;

/// What was found is a packet again when it is sent.
void check(const Packet& packet) {
  const Bytes bytes = to_bytes(packet);
  if (bytes.size() > most_bytes) return;  // stuffed where the sender had not
  PacketParser parser;
  parser.push(bytes);
  const auto again = parser.next();
  if (!again || *again != packet || parser.pending() != 0) std::abort();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::size_t piece = 1U + data[0];
  PacketParser parser;
  for (std::size_t place = 1; place < size; place += piece) {
    parser.push({data + place, std::min(piece, size - place)});
    while (const auto packet = parser.next()) check(*packet);
    if (parser.pending() >= most_bytes) std::abort();
  }
  return 0;
}
