#include "murosimf/scene_file/key_list.h"

#include <algorithm>
#include <utility>

#include "murosimf/scene_file/all_sections.h"

namespace murosimf::scene_file {
namespace {

/// "robots" of "[[robots]]", "views" of "[views.NAME]".
std::string_view name_in(std::string_view header) {
  const auto begin = std::min(header.find_first_not_of('['), header.size());
  return header.substr(begin, header.find_first_of(".]", begin) - begin);
}

/// [defaults] has the keys of a robot except its name.
SectionInfo defaults_info() {
  SectionInfo info = robot_section().info();
  info.like = std::exchange(info.header, "[defaults]");
  std::erase_if(info.keys, [](const KeyInfo& key) { return key.name == "name"; });
  return info;
}

}  // namespace

const std::vector<SectionInfo>& sections() {
  static const std::vector<SectionInfo> all{
      scene_section().info(),  start_section().info(),     air_section().info(),      field_section().info(),
      view_section().info(),   viewpoint_section().info(), light_section().info(),    ball_section().info(),
      team_section().info(),   robot_section().info(),     defaults_info(),           body_section().info(),
      push_section().info(),   event_section().info(),     material_section().info(), communication_section().info(),
      league_section().info(), link_section().info(),      algorithm_section().info()};
  return all;
}

const SectionInfo* find_section(std::string_view name) {
  const auto found = std::ranges::find(sections(), name, [](const SectionInfo& one) { return name_in(one.header); });
  return found == sections().end() ? nullptr : &*found;
}

std::vector<std::string_view> names_of(const SectionInfo& section) {
  std::vector<std::string_view> names;
  for (const KeyInfo& key : section.keys) names.push_back(key.name);
  return names;
}

}  // namespace murosimf::scene_file
