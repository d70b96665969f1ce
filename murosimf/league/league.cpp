#include "murosimf/league/league.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "murosimf/appearance/entity_appearance.h"
#include "murosimf/control_software/message_exchange.h"
#include "murosimf/league/game_controller.h"
#include "murosimf/league/side_line.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::league {
namespace {

constexpr std::size_t teams_of_a_game = 2;

std::size_t team_number(const scene_file::SceneSpec& spec, std::string_view team) {
  const auto found = std::ranges::find(spec.teams, team, &scene_file::TeamSpec::name);
  return static_cast<std::size_t>(found - spec.teams.begin());
}

/// Robots of both teams with a number at the end of their names.
std::vector<Player> players_of(scene::Scene& scene) {
  std::vector<Player> players;
  for (Entity* robot : scene.parts().robots) {
    const Player player{robot, team_number(scene.spec(), robot->options().team),
                        appearance::jersey_number(robot->name())};
    if (player.team >= teams_of_a_game) continue;
    if (player.number < 1 || player.number > static_cast<int>(most_players)) {
      throw SetupError(fmt::format("in a game a robot has a number from 1 to {} at the end of its name; '{}' has none",
                                   most_players, robot->name()));
    }
    for (const Player& other : players) {
      if (other.team != player.team || other.number != player.number) continue;
      throw SetupError(fmt::format("{} and {} of one team have the same number", other.robot->name(), robot->name()));
    }
    players.push_back(player);
  }
  return players;
}

}  // namespace

TeamLink TeamLink::parse(std::string_view text) {
  const auto equals = text.find('='), comma = text.find(',');
  if (equals == std::string_view::npos || comma == std::string_view::npos || comma < equals) {
    throw SetupError(
        fmt::format("'{}': write TEAM=LISTEN,SEND, like blue=10001,10002 or blue=0.0.0.0:10001,10.0.0.7:10001", text));
  }
  TeamLink link{std::string(text.substr(0, equals)), UdpAddress::parse(text.substr(equals + 1, comma - equals - 1)),
                UdpAddress::parse(text.substr(comma + 1))};
  if (link.listen == link.send_to) throw SetupError(fmt::format("'{}' sends messages back to itself", text));
  return link;
}

/// Effects of penalties on the scene.
class League::BetweenSteps final : public GameTask::Scene {
 public:
  explicit BetweenSteps(scene::Scene& scene) : scene_(&scene) {}
  void record(std::string event) override { scene_->simulation().record(std::move(event)); }
  void warn(std::string warning) override { scene_->parts().diagnostics.warn(std::move(warning)); }

  /// Free places depend on where all others are at this moment.
  scene::Placement place(const Player& player) override {
    std::vector<Vec3d> others;
    for (const Entity* entity : scene_->moving_entities()) {
      if (entity == player.robot || !entity->present()) continue;
      others.push_back(entity->find(properties::position)->values[0]);
      MUROSIMF_ASSERT(player.team < scene_->spec().teams.size());
    }
    const scene_file::SceneSpec& spec = scene_->spec();
    const scene::Placement placement = place_at_side_line(scene_file::field_size(spec.field.size),
                                                          spec.teams[player.team].attacks, side_for(player), others);
    scene::place(scene_->parts(), player.robot->name(), placement);
    return placement;
  }

 private:
  /// The touch line that is farther from the ball, so that no robot comes back beside it; without a ball the nearer one.
  [[nodiscard]] double side_for(const Player& player) const {
    const Entity* ball = scene_->parts().ball;
    if (ball && ball->present()) return ball->find(properties::position)->values[0].y > 0 ? -1 : 1;
    return player.robot->find(properties::position)->values[0].y < 0 ? -1 : 1;
  }

  scene::Scene* scene_;
};

League::League(scene::Scene& scene, const LeagueOptions& options) : scene_(&scene), outside_(options.outside) {
  outside_.memory = scene.parts().outside.memory;
  const ExternalInputLog* recorded = outside_.repeated.get();
  if (recorded) repeated_ = GameLog::of(*recorded);
  if (!options.repeat.empty()) repeated_ = GameLog::read(options.repeat);
  const auto repeats = [&](const std::string& channel) {
    return repeated_ && (!repeated_->channel(channel).empty() || (recorded && recorded->find(channel)));
  };
  if (options.referee) {
    referee_by(*options.referee);
  } else if (options.game_controller || repeats("game")) {
    Datagrams& datagrams = open("game", {.listen = options.game_controller.value_or(UdpAddress{}),
                                         .answer_port = static_cast<std::uint16_t>(scene.spec().league.answer_port)});
    referee_ = std::make_unique<GameController>(datagrams);
    referee_by(*referee_);
  }
  for (const TeamLink& link : options.team_links) forward(link);
  if (repeated_ && options.team_links.empty()) {
    for (const scene_file::TeamSpec& team : scene.spec().teams) {
      if (repeats("team:" + team.name)) forward({team.name, {}, {}});
    }
  }
}

League::~League() {
  if (scene_->parts().messages) scene_->parts().messages->connect(nullptr);
}

Datagrams& League::open(const std::string& channel, const UdpPort::Options& options) {
  std::unique_ptr<Datagrams> source;
  if (repeated_) {
    source = std::make_unique<RepeatedDatagrams>(*repeated_, channel, from_seconds(1 / scene_->spec().rate));
  } else {
    auto port = std::make_unique<UdpPort>(options);
    if (channel == "game") game_port_ = port->port();
    source = std::move(port);
    outside_.memory->expect(channel == "game" ? "the GameController" : fmt::format("programs of {}", channel));
  }
  // From the source outwards: history, game log, recording. Only live input passes the history.
  datagrams_.push_back(std::move(source));
  datagrams_.push_back(std::make_unique<RememberedDatagrams>(*datagrams_.back(), outside_.memory->channel(channel)));
  datagrams_.push_back(std::make_unique<RecordedDatagrams>(*datagrams_.back(), log_, channel));
  if (ExternalInputLog::Channel* notes = outside_.channel(channel)) {
    datagrams_.push_back(std::make_unique<NotedDatagrams>(*datagrams_.back(), *notes));
  }
  MUROSIMF_ASSERT(!datagrams_.empty());
  return *datagrams_.back();
}

void League::referee_by(Referee& referee) {
  const scene_file::SceneSpec& spec = scene_->spec();
  if (spec.teams.size() != teams_of_a_game) {
    throw SetupError(fmt::format("a game has two teams, but the scene has {}", spec.teams.size()));
  }
  between_steps_ = std::make_unique<BetweenSteps>(*scene_);
  Simulation& simulation = scene_->simulation();
  MUROSIMF_ASSERT(scene_->parts().spec.rate > 0);
  GameTask::Options options{.place_penalized = spec.league.place_penalized};
  options.ball = scene_->parts().ball;
  for (std::size_t i = 0; i < teams_of_a_game; ++i) {
    options.attacks[i] = spec.teams[i].attacks;
    options.team_names[i] = spec.teams[i].name;
    options.team_numbers[i] = static_cast<int>(spec.teams[i].number);
  }
  options.ask_for_call = [this, &simulation] { simulation.at({}, [this] { task_->between_steps(*between_steps_); }); };
  task_ = &simulation.attach<GameTask>("game", spec.rate, players_of(*scene_), referee, options);
}

/// Unknown teams are refused here: their messages would get lost without a sign.
void League::forward(const TeamLink& link) {
  std::vector<std::string_view> teams;
  for (const scene_file::TeamSpec& team : scene_->spec().teams) teams.push_back(team.name);
  if (std::ranges::find(teams, link.team) == teams.end()) throw SetupError(unknown_name("team", link.team, teams));
  if (!scene_->parts().messages) {
    throw SetupError(
        fmt::format("no robot's software sends messages, so there are none of team '{}' for a socket", link.team));
  }
  forwarder_.add(link.team, open("team:" + link.team, {.listen = link.listen, .send_to = link.send_to}));
  scene_->parts().messages->connect(&forwarder_);
}

}  // namespace murosimf::league
