#include "murosimf/league/game_packet.h"

#include <fmt/format.h>

#include "murosimf/league/humanoid_packet.h"
#include "murosimf/league/packet_bytes.h"
#include "murosimf/league/soccer_packet.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::league {
namespace {

constexpr std::size_t shortest = 24;  // of heads of all versions

}  // namespace

GameState read_game_packet(std::string_view bytes) {
  if (!bytes.starts_with(game_magic))
    throw SetupError("this is no packet of a GameController: it does not begin with RGme");
  if (bytes.size() < shortest) {
    throw SetupError(fmt::format("a packet of {} bytes, too short for any GameController", bytes.size()));
  }
  MUROSIMF_ASSERT(bytes.size() >= shortest);
  const PacketBytes head(bytes);
  if (head.two(4) == humanoid_version) return read_humanoid_packet(bytes);  // its version has two bytes
  const int version = head.one(4);
  if (version >= first_soccer_version && version <= last_soccer_version) return read_soccer_packet(bytes);
  throw SetupError(
      fmt::format("version {} of the GameController's packets; known are {} of the Humanoid League, {} to {} of the "
                  "Humanoid Soccer League",
                  version, humanoid_version, first_soccer_version, last_soccer_version));
}

}  // namespace murosimf::league
