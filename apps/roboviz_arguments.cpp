#include "apps/roboviz_arguments.h"

#include <fmt/format.h>

#include "apps/last_words.h"
#include "murosimf/model/error.h"

namespace murosimf::app {

void add_roboviz(const Command& command, std::string& where) {
  command
      .add("--roboviz", where,
           "Show what other programs draw for RoboViz (UDP): PORT of this computer alone, or HOST:PORT")
      .value_if_alone(std::to_string(drawing::RobovizDoor::usual_port));
}

std::unique_ptr<drawing::RobovizDoor> roboviz_door(const std::string& where) {
  if (where.empty()) return nullptr;
  try {
    auto door = std::make_unique<drawing::RobovizDoor>(wire::parse_address(where));
    say_note(fmt::format("drawings for RoboViz on {} (UDP)", to_text(door->address())));
    return door;
  } catch (const wire::WireError& error) {
    throw SetupError(fmt::format("--roboviz: {}", error.what()));
  }
}

std::optional<scene::DrawingPackets> packets_of(const drawing::RobovizDoor* door) {
  return door ? std::optional(scene::DrawingPackets{door->packets(), door->ignored()}) : std::nullopt;
}

}  // namespace murosimf::app
