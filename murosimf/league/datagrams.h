/// datagrams.h - interface for datagrams from and to the outside of the simulation: from a socket (udp_port.h), or a record (game_log.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/world/time.h"

namespace murosimf::league {

class Datagrams {
 public:
  virtual ~Datagrams() = default;

  /// At the beginning of the tick at `now`: datagrams received since the last call, in their order. Never waits.
  [[nodiscard]] virtual std::vector<std::string> take(Duration now) = 0;
  /// Sends one; loss is no error.
  virtual void give(std::string_view bytes) = 0;
};

}  // namespace murosimf::league
