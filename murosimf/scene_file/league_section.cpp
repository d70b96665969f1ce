// [league] of a scene file: a game with a referee.
#include "murosimf/scene_file/all_sections.h"
#include "murosimf/scene_file/section_readers.h"

namespace murosimf::scene_file {
namespace {

void read_answer_port(const files::TomlTable& table, std::string_view key, LeagueSpec& league) {
  table.read(key, league.answer_port);
  require(league.answer_port >= 1 && league.answer_port <= 65535, table, key, "must be from 1 to 65535");
}

}  // namespace

const Section<LeagueSpec>& league_section() {
  static const Section<LeagueSpec> section(
      "[league]",
      {{"place_penalized", &LeagueSpec::place_penalized, "",
        "robots with a penalty stand at the side line until it ends"},
       {"answer_port", read_answer_port, "", "UDP port of the GameController's machine for answers", {}, "3939"}});
  return section;
}

void read_league(const files::TomlTable& scene, SceneSpec& spec) {
  if (const toml::table* node = scene.table("league")) league_section().read(*node, spec.league);
}

}  // namespace murosimf::scene_file
