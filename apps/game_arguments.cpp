#include "apps/game_arguments.h"

#include "murosimf/model/error.h"

namespace murosimf::app {

void add_game(const Command& command, GameArguments& game) {
  command.add("--game-controller", game.game_controller,
              "Be refereed by a GameController (Humanoid League) that sends to this UDP port: 3838, or HOST:PORT");
  command
      .add("--team-udp", game.team_links,
           "TEAM=LISTEN,SEND: messages of the team go to UDP port SEND and come from LISTEN, each PORT or HOST:PORT")
      .one_at_a_time();
  command.add("--game-log", game.log, "Write to this file all that came from GameController and teams, with the times");
  command.add("--game-repeat", game.repeat, "Take it from such a file instead, so that the run is the same again");
}

std::unique_ptr<league::League> game_of(scene::Scene& scene, const GameArguments& arguments) {
  league::LeagueOptions options{.repeat = arguments.repeat, .outside = scene.parts().outside};
  if (!arguments.game_controller.empty()) {
    options.game_controller =
        with_context("--game-controller", [&] { return league::UdpAddress::parse(arguments.game_controller); });
  }
  for (const std::string& link : arguments.team_links) {
    options.team_links.push_back(with_context("--team-udp", [&] { return league::TeamLink::parse(link); }));
  }
  if (!options.game_controller && options.team_links.empty() && options.repeat.empty()) {
    if (arguments.log.empty()) return nullptr;
    throw SetupError("--game-log: nothing comes from outside; it goes with --game-controller or --team-udp");
  }
  return std::make_unique<league::League>(scene, options);
}

}  // namespace murosimf::app
