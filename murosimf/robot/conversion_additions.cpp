#include "murosimf/robot/conversion_additions.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "murosimf/geometry/collide.h"
#include "murosimf/math/assert.h"
#include "murosimf/robot/body_overlaps.h"
#include "murosimf/robot/lump_fixed_joints.h"
#include "murosimf/robot/robot_soles.h"

namespace murosimf::robot {
namespace {

constexpr double negative = 1e-12;  // [kg m^2] a smaller moment is rounding

const Servo* guessed_servo_of(const robot_formats::RobotDescription& description, const std::string& joint) {
  for (const robot_formats::BodyDescription& body : description.bodies) {
    for (const robot_formats::JointDescription& other : body.joints) {
      if (other.name == joint && other.servo) return &*other.servo;
    }
  }
  return nullptr;
}

/// The properties of a drive that files have: gain, damping and limits.
Servo plain_servo(const Servo& servo) {
  Servo plain;
  plain.law = "ideal_pd";
  plain.stall_torque = servo.stall_torque;
  plain.lowest_share = servo.lowest_share;
  plain.highest_share = servo.highest_share;
  plain.position_gain = servo.position_gain;
  plain.velocity_gain = servo.velocity_gain;
  if (servo.law == "dc_motor" && servo.no_load_speed > 0) {
    // The slope of the speed-torque line of a DC motor acts as damping.
    plain.velocity_gain = servo.stall_torque / servo.no_load_speed;
  }
  return plain;
}

void give_servo(robot_formats::JointDescription& joint, const Servo& servo, bool of_table) {
  joint.servo = plain_servo(servo);
  if (joint.range && servo.position_gain > 0) joint.target_range = joint.range;
  if (!of_table) return;
  joint.armature = servo.rotor_inertia;
  joint.damping = servo.friction.viscous;
  joint.friction = servo.friction.coulomb;
}

/// Moving body to which each body is fixed.
std::vector<int> links_of(const robot_formats::RobotDescription& description) {
  std::vector<int> links;
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    const robot_formats::BodyDescription& body = description.bodies[i];
    links.push_back(body.parent < 0 || !body.joints.empty() ? static_cast<int>(i) : links[body.parent]);
    MUROSIMF_ASSERT(body.parent < static_cast<int>(i));
  }
  return links;
}

bool same_solid(const robot_formats::MassProperties& a, const robot_formats::MassProperties& b) {
  const SymMat3d &I = a.inertia, &J = b.inertia;
  return a.mass == b.mass && I.xx == J.xx && I.yy == J.yy && I.zz == J.zz && I.xy == J.xy && I.xz == J.xz &&
         I.yz == J.yz;
}

/// For one part: formats have no element for inertia without mass, and readers refuse negative moments.
bool can_be_written(const robot_formats::MassProperties& solid) {
  const Vec3d moments = robot_formats::principal_moments(solid.inertia);
  return moments.x >= -negative && (solid.mass > 0 || moments.z <= negative);
}

/// As collision/inner_pairs.h has it.
bool overlap(const robot_formats::BodyDescription& a, const Transformd& at_a, const robot_formats::BodyDescription& b,
             const Transformd& at_b) {
  geometry::Manifold manifold;
  return any_touching_pair(a, at_a, b, at_b,
                           [&](const Shape& one, const Transformd& at_one, const Shape& other, const Transformd& at) {
                             return geometry::collide(one, at_one, other, at, manifold);
                           });
}

/// [m] Of all shapes that collide, in the frame of the base turned as in the file; infinite without any.
double lowest_point_turned(const robot_formats::RobotDescription& description, const Mat3d& turn) {
  const auto places = body_places(description);
  double z = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i) {
    z = std::min(z, lowest(low_points(description.bodies[i], Transformd{{}, turn} * places[i])));
  }
  return z;
}

}  // namespace

void give_servos(robot_formats::RobotDescription& description, const RobotFile& robot) {
  std::set<std::string> followers;
  for (const robot_formats::MimicDescription& mimic : description.mimics) followers.insert(mimic.joint);
  for (robot_formats::BodyDescription& body : description.bodies) {
    for (robot_formats::JointDescription& joint : body.joints) {
      const auto of_table = robot.table.servos.find(joint.name);
      const bool in_table = of_table != robot.table.servos.end();
      const Servo* servo = in_table ? &of_table->second.servo : guessed_servo_of(robot.description, joint.name);
      if (!servo || followers.contains(joint.name)) continue;
      // Joints that follow others are driven by their coupling.
      if (!joint.servo) {
        give_servo(joint, *servo, in_table);
      } else if (in_table && servo->position_gain > 0) {
        joint.servo->position_gain = servo->position_gain;
      }
    }
  }
}

void give_soles(robot_formats::RobotDescription& description, RobotFile& robot) {
  for (TableName& sole : robot.table.soles) {
    for (const robot_formats::BodyDescription& from : robot.description.bodies) {
      const auto frame = std::ranges::find(from.frames, sole.name + ".sole", &robot_formats::FrameDescription::name);
      // Placed soles have their own frames with this ending (role_inference.h).
      const auto body = std::ranges::find(description.bodies, from.name, &robot_formats::BodyDescription::name);
      if (frame == from.frames.end() || !frame->box || body == description.bodies.end()) continue;
      body->frames.push_back(*frame);
      sole.name = frame->name;
      break;
    }
  }
}

void take_repaired_solids(robot_formats::RobotDescription& description, const RobotFile& robot) {
  robot_formats::RobotDescription welded = description;
  std::set<std::string> kept;
  for (const robot_formats::BodyDescription& body : robot.description.bodies) kept.insert(body.name);
  lump_fixed_joints(welded, kept);
  // Compared after the same welding as in the reader, which repairs welded bodies.
  std::set<std::string> repaired;  // bodies that stay
  for (std::size_t i = 0; i < welded.bodies.size(); ++i) {
    MUROSIMF_ASSERT(welded.bodies.size() <= robot.description.bodies.size());
    if (!same_solid(robot.description.bodies[i].solid, welded.bodies[i].solid)) repaired.insert(welded.bodies[i].name);
  }
  std::vector<std::string> owners;  // of each body
  for (const robot_formats::BodyDescription& body : description.bodies) {
    owners.push_back(kept.contains(body.name) ? body.name : owners[static_cast<std::size_t>(body.parent)]);
    MUROSIMF_ASSERT(kept.contains(body.name) || (body.parent >= 0 && body.parent < static_cast<int>(owners.size())));
    if (!can_be_written(body.solid)) repaired.insert(owners.back());
  }
  for (std::size_t i = 0; i < owners.size(); ++i) {
    if (repaired.contains(owners[i])) description.bodies[i].solid = {};
  }
  for (const robot_formats::BodyDescription& body : robot.description.bodies) {
    const auto owner = std::ranges::find(description.bodies, body.name, &robot_formats::BodyDescription::name);
    if (repaired.contains(body.name)) owner->solid = body.solid;
    MUROSIMF_ASSERT(owner != description.bodies.end() || !repaired.contains(body.name));
  }
}

void exclude_overlaps(robot_formats::RobotDescription& description) {
  const auto places = body_places(description);
  const std::vector<int> links = links_of(description);
  MUROSIMF_ASSERT(links.size() == places.size());
  const auto parent_link = [&](int link) {
    const int parent = description.bodies[link].parent;
    MUROSIMF_ASSERT(link >= 0 && link < static_cast<int>(description.bodies.size()));
    return parent < 0 ? -1 : links[parent];
  };
  for (std::size_t a = 0; a < places.size(); ++a) {
    for (std::size_t b = a + 1; b < places.size(); ++b) {
      const robot_formats::BodyDescription &first = description.bodies[a], &second = description.bodies[b];
      const bool neighbors =
          links[a] == links[b] || parent_link(links[a]) == links[b] || parent_link(links[b]) == links[a];
      if (neighbors || is_excluded(description, first.name, second.name)) continue;
      if (overlap(first, places[a], second, places[b])) {
        description.exclusions.push_back({first.name, second.name, second.where});
      }
    }
  }
}

void give_key(robot_formats::RobotDescription& description) {
  if (!description.keyframes.empty()) return;
  const robot_formats::BodyDescription& base = description.bodies[0];
  MUROSIMF_ASSERT(!description.bodies.empty());
  const double lowest = lowest_point_turned(description, base.place.orientation);
  robot_formats::KeyframeDescription key;
  key.name = "stand";
  key.where = base.where;
  key.base = {{0, 0, std::isfinite(lowest) ? -lowest : 0}, base.place.orientation};
  for (const robot_formats::BodyDescription& body : description.bodies) {
    for (const robot_formats::JointDescription& joint : body.joints) {
      key.positions[joint.name] = joint.reference;
      if (joint.servo && joint.servo->position_gain > 0) key.targets[joint.name] = joint.reference;
    }
  }
  description.keyframes.push_back(std::move(key));
}

}  // namespace murosimf::robot
