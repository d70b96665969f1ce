#include "murosimf/dds/booster/joint_order.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "murosimf/files/lower_case.h"
#include "murosimf/model/error.h"

namespace murosimf::dds::booster {
namespace {

constexpr std::array<std::string_view, 22> k1{
    "head_yaw",          "head_pitch",           "left_shoulder_pitch", "left_shoulder_roll", "left_elbow_pitch",
    "left_elbow_yaw",    "right_shoulder_pitch", "right_shoulder_roll", "right_elbow_pitch",  "right_elbow_yaw",
    "left_hip_pitch",    "left_hip_roll",        "left_hip_yaw",        "left_knee_pitch",    "left_ankle_pitch",
    "left_ankle_roll",   "right_hip_pitch",      "right_hip_roll",      "right_hip_yaw",      "right_knee_pitch",
    "right_ankle_pitch", "right_ankle_roll"};
constexpr std::array<std::string_view, 23> t1{"head_yaw",
                                              "head_pitch",
                                              "left_shoulder_pitch",
                                              "left_shoulder_roll",
                                              "left_elbow_pitch",
                                              "left_elbow_yaw",
                                              "right_shoulder_pitch",
                                              "right_shoulder_roll",
                                              "right_elbow_pitch",
                                              "right_elbow_yaw",
                                              "waist",
                                              "left_hip_pitch",
                                              "left_hip_roll",
                                              "left_hip_yaw",
                                              "left_knee_pitch",
                                              "left_ankle_pitch",
                                              "left_ankle_roll",
                                              "right_hip_pitch",
                                              "right_hip_roll",
                                              "right_hip_yaw",
                                              "right_knee_pitch",
                                              "right_ankle_pitch",
                                              "right_ankle_roll"};
constexpr std::array orders{JointOrder{"K1", k1}, JointOrder{"T1", t1}};

/// "ALeft_Shoulder_Pitch" and "Left_Shoulder_Pitch_Joint" as "left_shoulder_pitch": the vendor's files put an A before the names of joints that
/// shall come first in alphabetical order. Newer files call the waist "waist_yaw_joint".
std::string plain_name(std::string_view joint) {
  std::string name = files::lower_case(std::string(joint));
  for (const std::string_view first : {"aahead_", "aleft_", "aright_"}) {
    if (name.starts_with(first)) name.erase(0, name.find_first_not_of('a'));
  }
  constexpr std::string_view last = "_joint";
  if (name.ends_with(last)) name.resize(name.size() - last.size());
  if (name == "waist_yaw") name = "waist";
  return name;
}

}  // namespace

std::span<const JointOrder> joint_orders() { return orders; }

PlacedJoints place_joints(std::span<const std::string> joints) {
  std::vector<std::string> plain;
  for (const std::string& joint : joints) plain.push_back(plain_name(joint));
  std::string missing;
  for (const JointOrder& order : orders) {
    PlacedJoints placed{&order, {}};
    missing.clear();
    for (const std::string_view name : order.names) {
      const auto found = std::ranges::find(plain, name);
      if (found == plain.end()) missing = name;
      placed.places.push_back(static_cast<std::size_t>(found - plain.begin()));
    }
    if (missing.empty() && joints.size() == order.names.size()) return placed;
  }
  throw SetupError(
      "controller 'booster' is for a Booster K1 (22 joints) or T1 (23), by the vendor's names of their joints");
}

}  // namespace murosimf::dds::booster
