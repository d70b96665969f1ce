#include "murosimf/viewer/actions.h"

#include <array>

#include "murosimf/math/assert.h"

namespace murosimf::viewer {
namespace {

constexpr std::array table{
    ActionInfo{Action::run_or_pause, "run_or_pause", "Space", "run, or pause"},
    ActionInfo{Action::step, "step", "Right", "one step, then pause"},
    ActionInfo{Action::step_back, "step_back", "Left", "one step back in time"},
    ActionInfo{Action::slower, "slower", "-", "half as fast"},
    ActionInfo{Action::faster, "faster", "=", "twice as fast; above 64, as fast as possible"},
    ActionInfo{Action::real_time, "real_time", "Backslash", "real time"},
    ActionInfo{Action::reset, "reset", "Backspace", "back to the start; what was stays a branch of the time line"},
    ActionInfo{Action::reload, "reload", "R", "read the scene's file and its robots again, and start"},
    ActionInfo{Action::record, "record", "F9", "record, or no longer (view --record FILE --record-on asked)"},
    ActionInfo{Action::place_ball, "place_ball", "B", "put the ball where the mouse points"},
    ActionInfo{Action::next_level, "next_level", "L", "next level of detail of the selected robot"},
    ActionInfo{Action::next_contact, "next_contact", "K", "next contact law of what is selected"},
    ActionInfo{Action::select_1, "select_1", "1", "select the first robot"},
    ActionInfo{Action::select_2, "select_2", "2", "select the second robot"},
    ActionInfo{Action::select_3, "select_3", "3", "select the third robot"},
    ActionInfo{Action::select_4, "select_4", "4", "select the fourth robot"},
    ActionInfo{Action::select_5, "select_5", "5", "select the fifth robot"},
    ActionInfo{Action::select_6, "select_6", "6", "select the sixth robot"},
    ActionInfo{Action::select_7, "select_7", "7", "select the seventh robot"},
    ActionInfo{Action::select_8, "select_8", "8", "select the eighth robot"},
    ActionInfo{Action::select_9, "select_9", "9", "select the ninth robot"},
    ActionInfo{Action::select_ball, "select_ball", "0", "select the ball"},
    ActionInfo{Action::select_parent, "select_parent", "PageUp", "select what carries the selected object"},
    ActionInfo{Action::deselect, "deselect", "Delete", "select nothing"},
    ActionInfo{Action::next_camera, "next_camera", "]", "next view: overview, top, side, left, right, the scene's own"},
    ActionInfo{Action::orbit_camera, "orbit_camera", "Escape", "free view, led by the mouse"},
    ActionInfo{Action::follow, "follow", "T", "the free view follows what is selected, or no more"},
    ActionInfo{Action::robot_camera, "robot_camera", "V", "through the camera of the selected robot"},
    ActionInfo{Action::tv_camera, "tv_camera", "G", "as on television: from the side, after the ball"},
    ActionInfo{Action::align_camera, "align_camera", "Ctrl+A", "the free view as the scene's overview"},
    ActionInfo{Action::fly_forward, "fly_forward", "W", "fly forward; with Shift faster"},
    ActionInfo{Action::fly_back, "fly_back", "S", "fly back"},
    ActionInfo{Action::fly_left, "fly_left", "A", "fly to the left"},
    ActionInfo{Action::fly_right, "fly_right", "D", "fly to the right"},
    ActionInfo{Action::fly_up, "fly_up", "E", "fly up"},
    ActionInfo{Action::fly_down, "fly_down", "Q", "fly down"},
    ActionInfo{Action::contacts, "contacts", "C", "points of contact"},
    ActionInfo{Action::forces, "forces", "F", "forces of contact"},
    ActionInfo{Action::centers_of_mass, "centers_of_mass", "M", "centers of mass, and where they are above the ground"},
    ActionInfo{Action::frames, "frames", "F6", "axes of the selected robot's objects: x red, y green, z blue"},
    ActionInfo{Action::bounding_volumes, "bounding_volumes", "U", "shapes that collide, as their boxes"},
    ActionInfo{Action::names, "names", "F7", "names"},
    ActionInfo{Action::levels, "levels", "F8", "levels of detail as colors under the robots"},
    ActionInfo{Action::standing_feet, "standing_feet", "Y", "standing feet in yellow at kinematic_walking"},
    ActionInfo{Action::support_polygons, "support_polygons", "P",
               "what robots stand on: hull of their contacts with the ground"},
    ActionInfo{Action::zero_moment_points, "moment_points", "Z", "zero moment points: where the ground's forces act"},
    ActionInfo{Action::joint_loads, "joint_loads", "J",
               "joint torques by what the servos can give: green, yellow at half, red at all of it"},
    ActionInfo{Action::beliefs, "beliefs", "H",
               "where robots take themselves to be: ring and arrow, a line to the truth"},
    ActionInfo{Action::drawings, "drawings", "O", "what control software draws"},
    ActionInfo{Action::field_map, "field_map", "I", "the field from above in a corner"},
    ActionInfo{Action::left_panel, "left_panel", "Tab", "panels on the left"},
    ActionInfo{Action::right_panel, "right_panel", "Shift+Tab", "panels on the right"},
    ActionInfo{Action::help, "help", "F1", "keys"},
    ActionInfo{Action::full_screen, "full_screen", "F11", "the whole screen, or a window"},
    ActionInfo{Action::screenshot, "screenshot", "Ctrl+P", "the window as a PNG file in the present folder"},
    ActionInfo{Action::quit, "quit", "Ctrl+Q", "end"},
};

constexpr bool in_order() {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (static_cast<std::size_t>(table[i].action) != i) return false;
  }
  return table.size() == static_cast<std::size_t>(Action::quit) + 1;
}
static_assert(in_order());

}  // namespace

std::span<const ActionInfo> actions() { return table; }
const ActionInfo& info_of(Action action) {
  MUROSIMF_ASSERT(static_cast<std::size_t>(action) < table.size());
  return table[static_cast<std::size_t>(action)];
}

}  // namespace murosimf::viewer
