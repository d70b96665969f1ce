#include "murosimf/locomotion/walk_options.h"

#include <array>
#include <limits>
#include <string_view>

#include "murosimf/math/assert.h"

namespace murosimf::locomotion {
namespace {

struct Row {
  std::string_view name;
  double& (*place)(WalkParameters&);
  std::string_view unit, meaning;
  LowestValue lowest;
  double highest;
};

constexpr double longest = 10;    // [m]
constexpr double fastest = 10;    // [m/s, rad/s]
constexpr double sharpest = 100;  // [m/s^2, rad/s^2]

const std::array rows{
    Row{"period", [](auto& p) -> double& { return p.period; }, "s", "of two steps", 0.05, 10},
    Row{"lift", [](auto& p) -> double& { return p.lift; }, "m", "height of the swinging foot", 0, longest},
    Row{"lean", [](auto& p) -> double& { return p.pitch; }, "rad", "of the pelvis, forward", -0.5, 0.5},
    Row{"hip_roll", [](auto& p) -> double& { return p.hip_roll; }, "rad", "that lifts the swinging side, against droop",
        0, 0.5},
    Row{"sway", [](auto& p) -> double& { return p.sway; }, "m", "sideways, to either side", 0, longest},
    Row{"lead", [](auto& p) -> double& { return p.lead; }, "rad", "of the sway before the steps", -1.5, 1.5},
    Row{"setback", [](auto& p) -> double& { return p.setback; }, "m", "of the feet behind the hips", -longest, longest},
    Row{"hip_height", [](auto& p) -> double& { return p.hip_height; }, "m", "of the hips above the soles", above(0),
        longest},
    Row{"half_width", [](auto& p) -> double& { return p.half_width; }, "m", "of the ankles from the middle", 0,
        longest},
    Row{"double_support", [](auto& p) -> double& { return p.double_support; }, "1",
        "share of the period with both feet on the ground", 0, 0.5},
    Row{"splay", [](auto& p) -> double& { return p.splay; }, "1",
        "of half the turn of a step, by which both feet point outward: 1 for legs that turn outward only", -1, 1},
    Row{"arm_swing", [](auto& p) -> double& { return p.arm_swing; }, "1",
        "of the swing of arms that balances the legs about the vertical", 0, 3},
    Row{"speed", [](auto& p) -> double& { return p.fastest.x; }, "m/s", "largest, forward and back", 0, fastest},
    Row{"speed_sideways", [](auto& p) -> double& { return p.fastest.y; }, "m/s", "largest", 0, fastest},
    Row{"speed_turning", [](auto& p) -> double& { return p.fastest.z; }, "rad/s", "largest", 0, fastest},
    Row{"slew", [](auto& p) -> double& { return p.slew.x; }, "m/s^2", "of the speed forward", above(0), sharpest},
    Row{"slew_sideways", [](auto& p) -> double& { return p.slew.y; }, "m/s^2", "of the speed sideways", above(0),
        sharpest},
    Row{"slew_turning", [](auto& p) -> double& { return p.slew.z; }, "rad/s^2", "of the turning rate", above(0),
        sharpest},
};

std::vector<OptionInfo> make_infos() {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<OptionInfo> infos;
  for (const Row& row : rows) {
    MUROSIMF_ASSERT(row.place != nullptr);
    infos.push_back(
        {std::string(row.name), none, std::string(row.unit), std::string(row.meaning), row.lowest, row.highest});
  }
  return infos;
}

}  // namespace

const std::vector<OptionInfo>& walk_options() {
  static const std::vector<OptionInfo> infos = make_infos();
  return infos;
}

void apply_walk_options(const OptionValues& given, WalkParameters& parameters) {
  check_options("the walk", walk_options(), given);
  for (const Row& row : rows) {
    if (const auto value = given.find(row.name); value != given.end())
      row.place(parameters) = std::get<double>(value->second);
  }
}

OptionValues walk_option_values(const WalkParameters& parameters) {
  OptionValues values;
  WalkParameters copy = parameters;
  for (const Row& row : rows) values[std::string(row.name)] = row.place(copy);
  return values;
}

}  // namespace murosimf::locomotion
