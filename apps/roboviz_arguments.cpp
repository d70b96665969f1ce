#include "apps/roboviz_arguments.h"

#include <fmt/format.h>

#include "apps/error_output.h"
#include "murosimf/model/error.h"

namespace murosimf::app {

void add_roboviz(const Command& command, std::string& where) {
  command
      .add("--roboviz", where,
           "Show what other programs draw for RoboViz (UDP): PORT of this computer alone, or HOST:PORT")
      .value_if_alone(std::to_string(drawing::RobovizServer::usual_port));
}

std::unique_ptr<drawing::RobovizServer> roboviz_server(const std::string& where) {
  if (where.empty()) return nullptr;
  try {
    auto door = std::make_unique<drawing::RobovizServer>(network::parse_address(where));
    say_note(fmt::format("drawings for RoboViz on {} (UDP)", to_text(door->address())));
    return door;
  } catch (const network::NetworkError& error) {
    throw SetupError(fmt::format("--roboviz: {}", error.what()));
  }
}

std::optional<scene::DrawingPackets> packets_of(const drawing::RobovizServer* door) {
  return door ? std::optional(scene::DrawingPackets{door->packets(), door->ignored()}) : std::nullopt;
}

}  // namespace murosimf::app
