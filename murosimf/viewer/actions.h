/// actions.h - all actions of keys in the viewer, with their default keys.
#pragma once

#include <span>
#include <string_view>

namespace murosimf::viewer {

enum class Action {
  run_or_pause,
  step,
  step_back,
  slower,
  faster,
  real_time,
  reset,
  reload,
  record,
  place_ball,
  next_level,
  next_contact,
  select_1,
  select_2,
  select_3,
  select_4,
  select_5,
  select_6,
  select_7,
  select_8,
  select_9,
  select_ball,
  select_parent,
  deselect,
  next_camera,
  orbit_camera,
  follow,
  robot_camera,
  tv_camera,
  align_camera,
  fly_forward,
  fly_back,
  fly_left,
  fly_right,
  fly_up,
  fly_down,
  contacts,
  forces,
  centers_of_mass,
  frames,
  bounding_volumes,
  names,
  levels,
  standing_feet,
  support_polygons,
  zero_moment_points,
  joint_loads,
  beliefs,
  drawings,
  field_map,
  left_panel,
  right_panel,
  help,
  full_screen,
  screenshot,
  quit,
};

struct ActionInfo {
  Action action;
  std::string_view name;  ///< name in the file of keys
  std::string_view key;   ///< default: "Space", "Ctrl+P"
  std::string_view meaning;
};

/// In the order of the enumeration, so that it can be indexed by it.
[[nodiscard]] std::span<const ActionInfo> actions();
[[nodiscard]] const ActionInfo& info_of(Action action);

}  // namespace murosimf::viewer
