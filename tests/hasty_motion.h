/// hasty_motion.h - a motion with which kid21 gets up from its back, faster than its servos can, and now and then: one to be made better.
#pragma once

namespace murosimf::fixtures {

inline constexpr const char* hasty_motion = R"(
columns = [["j_l_sh_pitch", "j_r_sh_pitch"], ["j_l_upper_arm", "-j_r_upper_arm"], ["j_l_forearm", "j_r_forearm"],
           ["j_l_thigh", "j_r_thigh"], ["j_l_shin", "j_r_shin"], ["j_l_ankle", "j_r_ankle"]]
start = [0.3, 0.25, -0.6, 0.0, 0.1, 0.0]
[[frames]]
duration = 0.16
values = [0.751, 0.05, -0.751, 0.023, 2.323, -0.658]
[[frames]]
duration = 0.193
values = [1.81, 0.547, -1.238, 0.196, 2.529, -0.332]
[[frames]]
duration = 0.164
values = [1.637, 0.181, -0.852, -1.587, 2.546, -0.269]
[[frames]]
duration = 0.253
values = [0.747, 0.027, -0.083, -0.71, 2.492, -1.181]
[[frames]]
duration = 0.158
values = [-2.346, 0.091, -0.65, -1.17, 2.5, -1.015]
[[frames]]
duration = 0.393
values = [-1.541, 0.303, -0.242, -1.685, 2.6, -1.005]
[[frames]]
duration = 0.9
values = [0.0, 0.0, 0.0, -0.368, 0.789, -0.452]
)";

}  // namespace murosimf::fixtures
