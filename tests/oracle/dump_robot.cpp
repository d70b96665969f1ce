/// dump_robot - what a robot file became, and its poses in random joint positions, as JSON, for robots_against_mujoco.py.
///
/// Usage: dump_robot FILE STATES
/// Bodies after welding: mass [kg], center [m], inertia at the center [kg m^2] (xx yy zz xy xz yz), body frame. Joints:
/// axis in the body's frame, range [rad | m] or null. Per state: joint positions q, the first all zero; position [m] and
/// orientation (rotation matrix, row by row) of every body and frame; the common center of mass [m]; base frame.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/random.h"
#include "murosimf/model/error.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/mass.h"
#include "murosimf/robot/robot_reader.h"

namespace {

using namespace murosimf;

constexpr double largest = 3;  // [rad | m] of a joint position

/// A body or frame of the file, and the object that stands for it.
struct Named {
  std::string name;
  int object = 0;
};

std::string list(const Vec3d& v) { return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x, v.y, v.z); }

std::string rows(const Mat3d& m) {
  const Mat3d t = transpose(m);
  return fmt::format("[{}, {}, {}]", list(t.x), list(t.y), list(t.z));
}

/// Names that a joint has, too, have a suffix in the model.
int object_of(const Model& model, const std::string& name, const std::string& kind) {
  const auto found = model.find_object(name + "." + kind);
  return found ? *found : model.object_index(name);
}

std::vector<Named> frames_of(const robot::RobotFile& robot) {
  std::vector<Named> frames;
  for (const robot_formats::BodyDescription& body : robot.description.bodies) {
    frames.push_back({body.name, object_of(*robot.model, body.name, "body")});
    for (const robot_formats::FrameDescription& frame : body.frames) {
      frames.push_back({frame.name, object_of(*robot.model, frame.name, frame.kind)});
    }
  }
  return frames;
}

std::string body_json(const robot_formats::BodyDescription& body) {
  const SymMat3d& I = body.solid.inertia;
  return fmt::format(
      "\"{}\": {{\"mass\": {:.17g}, \"center\": {}, \"inertia\": [{:.17g}, {:.17g}, {:.17g}, {:.17g}, {:.17g}, "
      "{:.17g}]}}",
      body.name, body.solid.mass, list(body.solid.center), I.xx, I.yy, I.zz, I.xy, I.xz, I.yz);
}

std::string joint_json(const robot_formats::JointDescription& joint) {
  const std::string range = joint.range ? fmt::format("[{:.17g}, {:.17g}]", joint.range->x, joint.range->y) : "null";
  return fmt::format("\"{}\": {{\"axis\": {}, \"range\": {}}}", joint.name, list(joint.axis), range);
}

std::string state_json(const Model& model, const std::vector<Named>& frames, const RandomStream& random, int number) {
  const auto size = static_cast<std::size_t>(model.size());
  std::vector<double> q(size);
  std::vector<Vec3d> r(size), zero(size);
  std::vector<Mat3d> R(size);
  std::vector<std::string> positions, poses;
  for (const int joint : model.joints()) {
    const auto draw = static_cast<std::uint64_t>(number) * size + static_cast<std::uint64_t>(joint);
    if (number > 0) q[joint] = random.uniform(draw, -largest, largest);
    positions.push_back(fmt::format("\"{}\": {:.17g}", model.objects()[joint].name, q[joint]));
  }
  multibody::poses<double>(model.tree(), q, r, R);
  const auto body = multibody::common_body<double>(model.tree(), r, R, zero, zero);
  for (const auto& [name, i] : frames) {
    poses.push_back(fmt::format("\"{}\": [{}, {}]", name, list(r[i]), rows(R[i])));
  }
  return fmt::format("{{\"q\": {{{}}},\n \"frames\": {{{}}},\n \"center_of_mass\": {}}}", fmt::join(positions, ", "),
                     fmt::join(poses, ",\n  "), list(body.center));
}

void dump(const std::string& file, int states) {
  const robot::RobotFile robot = robot::read_robot(file, {.guess = false});
  const auto frames = frames_of(robot);
  const RandomStream random(1, "robots_against_mujoco");
  std::vector<std::string> bodies, joints, all;
  for (const robot_formats::BodyDescription& body : robot.description.bodies) {
    bodies.push_back(body_json(body));
    for (const robot_formats::JointDescription& joint : body.joints) joints.push_back(joint_json(joint));
  }
  for (int i = 0; i < states; ++i) all.push_back(state_json(*robot.model, frames, random, i));
  fmt::print("{{\"total_mass\": {:.17g},\n\"bodies\": {{{}}},\n\"joints\": {{{}}},\n\"states\": [{}]}}\n",
             robot.model->tree().mass, fmt::join(bodies, ",\n"), fmt::join(joints, ",\n"), fmt::join(all, ",\n"));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return 2;
  try {
    dump(arguments[1], std::atoi(arguments[2]));
  } catch (const SetupError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
