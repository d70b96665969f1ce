#include "murosimf/robot_formats/sdf/sdf_assembly.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/urdf/urdf_sensor.h"

namespace murosimf::robot_formats::sdf {
namespace {

constexpr const char* world = "world";

std::string type_of(const SdfPart& joint) { return joint.element.attribute("type").value_or(""); }

/// Fixed joints cannot close loops well, balls can best.
/// Preference of a joint as the closure of a loop: least for fixed joints, greatest for balls, which a `connect` replaces exactly.
int rank_of(const std::string& type) { return type == "fixed" ? 0 : type == "ball" ? 2 : 1; }

}  // namespace

int SdfAssembly::number_of(const std::string& link) const {
  const auto found = numbers_.find(link);
  return found == numbers_.end() ? -1 : found->second;
}

void SdfAssembly::find_links() {
  for (const SdfPart& link : model_.links) {
    if (!poses_.links.contains(link.name)) {
      log_.refuse(link.element, fmt::format("libsdformat does not read link '{}'", link.name));
      continue;
    }
    MUROSIMF_ASSERT(numbers_.size() == used_links_.size());
    if (!numbers_.emplace(link.name, static_cast<int>(used_links_.size())).second) {
      link.element.fail(fmt::format("link '{}' is already there; choose another name", link.name));
    }
    used_links_.push_back(link);
  }
  if (used_links_.empty()) model_.element.fail("there is no link; a robot needs one");
}

void SdfAssembly::find_joints() {
  for (const SdfPart& joint : model_.joints) {
    const auto pose = poses_.joints.find(joint.name);
    if (pose == poses_.joints.end()) {
      log_.refuse(joint.element, fmt::format("libsdformat does not read joint '{}'", joint.name));
    } else if (const std::string type = type_of(joint); !is_known_type(type)) {
      log_.refuse(joint.element, fmt::format("joint '{}' of type '{}' is not supported", joint.name, type));
    } else {
      const auto& [place, parent, child, axes, sensors] = pose->second;
      // The world has no link: number_of() gives -1 for it, as edges need it.
      for (const std::string& link : {parent, child}) {
        if (link != world && number_of(link) < 0) {
          joint.element.fail(fmt::format("joint '{}' joins link '{}', which is not there", joint.name, link));
        }
      }
      if (parent == child) joint.element.fail(fmt::format("joint '{}' joins '{}' to itself", joint.name, child));
      edges_.push_back({number_of(parent), number_of(child), rank_of(type)});
      // Edges and used joints have the same numbers.
      used_joints_.push_back(joint);
      MUROSIMF_ASSERT(used_joints_.size() == edges_.size());
    }
  }
}

/// Place of a node in the frame of the model, which is that of the world here.
Transformd SdfAssembly::place_of(const SdfNode& node) const {
  MUROSIMF_ASSERT(node.link < static_cast<int>(used_links_.size()));
  return node.link < 0 ? Transformd{} : poses_.links.at(used_links_[node.link].name).place;
}

void SdfAssembly::add_body(const SdfNode& node) {
  robot_formats::BodyDescription body;
  if (node.link < 0) {
    body.name = world;
    body.where = model_.element.where();
  } else {
    const SdfPart& link = used_links_[node.link];
    body = links_.read(link, poses_.links.at(link.name));
  }
  if (node.parent >= 0) {
    MUROSIMF_ASSERT(node.joint >= 0 && node.parent < static_cast<int>(description_.bodies.size()));
    const SdfPart& joint = used_joints_[node.joint];
    SdfJointSpot spot{place_of(node), node.reversed};
    // A joint that is held at an angle moves the spot: the body's place is taken after reading it.
    body.joints = read_joints(joint, poses_.joints.at(joint.name), spot, log_);
    body.parent = node.parent;
    body.place = seen_from(place_of(tree_.nodes[node.parent]), spot.body);
  }
  description_.bodies.push_back(std::move(body));
}

int SdfAssembly::body_of(const std::string& link) const {
  const auto found = std::ranges::find(description_.bodies, link, &robot_formats::BodyDescription::name);
  return found == description_.bodies.end() ? -1 : static_cast<int>(found - description_.bodies.begin());
}

/// Adds a loop of two frames. `place`: common place of both, in the frame of the model.
void SdfAssembly::add_connect(const SdfPart& joint, const std::string& name, const Transformd& place, bool welded) {
  const SdfJointPose& pose = poses_.joints.at(joint.name);
  robot_formats::LoopDescription loop{name, joint.element.where(), name + ".end1", name + ".end2", welded};
  for (const auto& [link, frame] : {std::pair{pose.parent, loop.frame1}, std::pair{pose.child, loop.frame2}}) {
    const Transformd base = link == world ? Transformd{} : poses_.links.at(link).place;
    MUROSIMF_ASSERT(body_of(link) >= 0);
    description_.bodies[body_of(link)].frames.push_back({frame, loop.where, "loop", seen_from(base, place), {}});
  }
  description_.loops.push_back(loop);
}

void SdfAssembly::add_loop(const SdfPart& joint) {
  const std::string type = type_of(joint);
  const SdfJointPose& pose = poses_.joints.at(joint.name);
  if (type == "ball") return add_connect(joint, joint.name, pose.place, false);
  if (type == "fixed") return add_connect(joint, joint.name, pose.place, true);
  if (type == "revolute" || type == "continuous") {
    constexpr double apart = 0.1;  // [m] of two points on the axis: two connects leave the turn about it free
    const Vec3d axis = pose.axes.empty() ? Vec3d{0, 0, 1} : pose.axes[0];
    add_connect(joint, joint.name, pose.place, false);
    const Transformd other{pose.place.position + apart * axis, pose.place.orientation};
    add_connect(joint, joint.name + ".axis", other, false);
    log_.note(joint.element,
              fmt::format("joint '{}' closes a loop: it has neither range nor damping, and nothing drives it",
                          joint.name));
    return;
  }
  log_.refuse(joint.element,
              fmt::format("joint '{}' of type '{}' closes a loop, which is not supported; balls, hinges and fixed "
                          "joints can",
                          joint.name, type));
}

void SdfAssembly::add_frames() {
  for (const SdfFramePose& frame : poses_.frames) {
    const int body = body_of(frame.body);
    // Names with _merged__ are made by libsdformat, not by the file.
    if (body < 0 || frame.name.find("_merged__") != std::string::npos) continue;
    const Transformd base = frame.body == world ? Transformd{} : poses_.links.at(frame.body).place;
    description_.bodies[body].frames.push_back(
        {frame.name, model_.element.where(), "site", seen_from(base, frame.place), {}});
  }
}

void SdfAssembly::add_sensors() {
  for (const SdfNode& node : tree_.nodes) {
    if (node.link < 0) continue;
    const SdfPart& link = used_links_[node.link];
    MUROSIMF_ASSERT(node.parent < static_cast<int>(description_.bodies.size()));
    const std::string parent = node.parent < 0 ? "" : description_.bodies[node.parent].name;
    for (const files::XmlElement& sensor : link.element.children("sensor")) {
      const auto& places = poses_.links.at(link.name).sensors;
      const auto place = places.find(sensor.attribute("name").value_or(""));
      const Transformd known = place == places.end() ? Transformd{} : place->second;
      description_.sensors.push_back(urdf::read_sensor(sensor, {link.name, parent, link.name, known}, log_));
    }
    if (node.joint < 0) continue;
    // A sensor of a joint is attached to the joint's frame, which turns with the child.
    const SdfPart& joint = used_joints_[node.joint];
    const SdfJointPose& pose = poses_.joints.at(joint.name);
    for (const files::XmlElement& sensor : joint.element.children("sensor")) {
      const auto place = pose.sensors.find(sensor.attribute("name").value_or(""));
      const Transformd inside = place == pose.sensors.end() ? Transformd{} : place->second;
      const Transformd seen = seen_from(place_of(node), pose.place * inside);
      description_.sensors.push_back(urdf::read_sensor(sensor, {link.name, pose.parent, pose.child, seen}, log_));
    }
  }
}

void SdfAssembly::assemble() {
  // Links and joints first: the tree needs their numbers, and all others need the bodies.
  find_links();
  find_joints();
  tree_ = make_tree(static_cast<int>(used_links_.size()), edges_);
  for (const int loose : tree_.loose) {
    const SdfPart& link = used_links_[loose];
    log_.refuse(link.element,
                fmt::format("link '{}' hangs on no joint; add one, or give it a file of its own", link.name));
  }
  MUROSIMF_ASSERT(!tree_.nodes.empty());
  description_.bodies.reserve(tree_.nodes.size());
  for (const SdfNode& node : tree_.nodes) add_body(node);
  for (const int joint : tree_.closers) add_loop(used_joints_[joint]);
  add_frames();
  read_mimics(used_joints_, description_, log_);
  add_sensors();
  description_.fixed_base = tree_.nodes[0].link < 0 || model_.is_static;
  if (tree_.nodes[0].link < 0) log_.note(model_.element, "the robot is bolted to the world, by a joint of the file");
  if (model_.is_static)
    log_.note(model_.element, "the robot is bolted to the world, since it is static; its joints move for all that");
}

}  // namespace murosimf::robot_formats::sdf
