#include "murosimf/dds/unitree/motor_order.h"

#include <algorithm>
#include <array>

#include "murosimf/model/error.h"

namespace murosimf::dds::unitree {
namespace {

constexpr std::array<std::string_view, 29> g1{"left_hip_pitch",      "left_hip_roll",        "left_hip_yaw",
                                              "left_knee",           "left_ankle_pitch",     "left_ankle_roll",
                                              "right_hip_pitch",     "right_hip_roll",       "right_hip_yaw",
                                              "right_knee",          "right_ankle_pitch",    "right_ankle_roll",
                                              "waist_yaw",           "waist_roll",           "waist_pitch",
                                              "left_shoulder_pitch", "left_shoulder_roll",   "left_shoulder_yaw",
                                              "left_elbow",          "left_wrist_roll",      "left_wrist_pitch",
                                              "left_wrist_yaw",      "right_shoulder_pitch", "right_shoulder_roll",
                                              "right_shoulder_yaw",  "right_elbow",          "right_wrist_roll",
                                              "right_wrist_pitch",   "right_wrist_yaw"};

std::string_view plain_name(std::string_view joint) {
  constexpr std::string_view last = "_joint";
  if (joint.ends_with(last)) joint.remove_suffix(last.size());
  return joint;
}

}  // namespace

std::span<const std::string_view> motor_order() { return g1; }

std::vector<std::size_t> place_joints(std::span<const std::string> joints) {
  std::vector<std::size_t> places;
  for (const std::string_view name : g1) {
    const auto found = std::ranges::find(joints, name, plain_name);
    if (found != joints.end()) places.push_back(static_cast<std::size_t>(found - joints.begin()));
  }
  if (places.size() == g1.size() && joints.size() == g1.size()) return places;
  throw SetupError("controller 'unitree' is for a Unitree G1 with 29 joints, by the vendor's names of its joints");
}

}  // namespace murosimf::dds::unitree
