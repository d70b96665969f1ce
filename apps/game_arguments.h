/// game_arguments.h - the options of a run that is a game with the world outside (league/league.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/command.h"
#include "murosimf/league/league.h"

namespace murosimf::app {

struct GameArguments {
  std::string game_controller;          ///< address at which it is received
  std::vector<std::string> team_links;  ///< TEAM=LISTEN,SEND
  std::string log, repeat;              ///< files
};

void add_game(const Command& command, GameArguments& game);
/// Null if none is asked for. Throws SetupError, with the option.
[[nodiscard]] std::unique_ptr<league::League> game_of(scene::Scene& scene, const GameArguments& arguments);

}  // namespace murosimf::app
