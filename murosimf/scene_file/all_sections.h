/// all_sections.h - the sections of a scene file (section.h), each in the source that reads it.
///
/// For .cpp files only: it includes toml++.
#pragma once

#include <string>
#include <vector>

#include "murosimf/scene_file/scene_spec.h"
#include "murosimf/scene_file/section.h"

namespace murosimf::scene_file {

/// [[events]] as written in the file.
struct EventTable {
  double time = -1;                  ///< [s]
  std::vector<std::string> changes;  ///< "PATH = VALUE"
};

[[nodiscard]] const Section<SceneSpec>& scene_section();  ///< the keys before all sections
[[nodiscard]] const Section<SceneSpec>& start_section();
[[nodiscard]] const Section<AirSpec>& air_section();
[[nodiscard]] const Section<FieldSpec>& field_section();
[[nodiscard]] const Section<ViewSpec>& view_section();
[[nodiscard]] const Section<ViewpointSpec>& viewpoint_section();
[[nodiscard]] const Section<LightSpec>& light_section();
[[nodiscard]] const Section<BallSpec>& ball_section();
[[nodiscard]] const Section<TeamSpec>& team_section();
[[nodiscard]] const Section<RobotSpec>& robot_section();
[[nodiscard]] const Section<control_software::ControlLinkOptions>& link_section();  ///< the key `link` of a robot
[[nodiscard]] const Section<BodySpec>& body_section();
[[nodiscard]] const Section<PushSpec>& push_section();
[[nodiscard]] const Section<EventTable>& event_section();
[[nodiscard]] const Section<PairSurface>& material_section();
[[nodiscard]] const Section<control_software::RadioOptions>& communication_section();
[[nodiscard]] const Section<LeagueSpec>& league_section();
[[nodiscard]] const Section<AlgorithmSpec>& algorithm_section();

}  // namespace murosimf::scene_file
