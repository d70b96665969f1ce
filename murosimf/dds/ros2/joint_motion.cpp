#include "murosimf/dds/ros2/joint_motion.h"

#include <algorithm>

#include "murosimf/math/assert.h"
#include "murosimf/model/feet.h"
#include "murosimf/model/properties.h"

namespace murosimf::dds::ros2 {
namespace {

/// Joints between the base and a sole.
std::vector<char> legs_of(const Model& model) {
  const auto& links = model.tree().links;
  std::vector<char> by_object(static_cast<std::size_t>(model.size()));
  for (const Foot& foot : feet_of(model)) {
    for (int link = foot.place.link; link >= 0; link = links[static_cast<std::size_t>(link)].parent)
      by_object[static_cast<std::size_t>(links[static_cast<std::size_t>(link)].object)] = 1;
  }
  std::vector<char> by_joint;
  for (const int joint : model.joints()) by_joint.push_back(by_object[static_cast<std::size_t>(joint)]);
  return by_joint;
}

}  // namespace

JointMotion::JointMotion(Setup& setup, control_software::RobotPort& port, bool engine)
    : is_leg_(legs_of(setup.model())),
      own_target_(setup.input(properties::joint_target, 0.0)),
      engine_(engine ? port.command("motion.joints") : nullptr),
      target_(port.command("joint.target")),
      rate_(port.command("joint.velocity_target")),
      target_range_(port.range("joint.target")),
      rate_range_(port.range("joint.velocity_target")) {
  for (const int joint : setup.model().joints()) {
    objects_.push_back(joint);
    names_.push_back(setup.model().objects()[static_cast<std::size_t>(joint)].name);
  }
  joints_.resize(names_.size());
}

NamedPlaces JointMotion::places_of(const std::vector<std::string>& names) const {
  NamedPlaces found;
  for (const std::string& name : names) {
    const auto place = static_cast<std::size_t>(std::ranges::find(names_, name) - names_.begin());
    const bool twice = std::ranges::find(found.places, place) != found.places.end();
    if (place == names_.size() || twice) return {{}, name};
    found.places.push_back(place);
  }
  return found;
}

void JointMotion::restart() {
  std::ranges::fill(joints_, Joint{});
  started_ = false;
}

void JointMotion::set(const std::vector<std::size_t>& places, const std::vector<double>& positions,
                      const std::vector<double>& rates) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    Joint& joint = joints_[places[i]];
    joint.commanded = true;
    joint.nodes.clear();
    if (i < positions.size()) joint.target = positions[i];
    joint.rate = i < rates.size() ? rates[i] : 0;
  }
}

void JointMotion::follow(const std::vector<std::size_t>& places, const TrajectoryMessage& trajectory, Duration now) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    Joint& joint = joints_[places[i]];
    joint.commanded = true;
    joint.start = now;
    joint.nodes = {{.position = joint.target, .smooth = true}};
    for (const TrajectoryPoint& point : trajectory.points) {
      const bool smooth = !point.velocities.empty();
      joint.nodes.push_back({point.time, point.positions[i], smooth ? point.velocities[i] : 0, smooth});
    }
  }
}

void JointMotion::halt(const std::vector<std::size_t>& places) {
  for (const std::size_t place : places) {
    joints_[place].nodes.clear();
    joints_[place].rate = 0;
  }
}

void JointMotion::leave_legs() {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (is_leg_[i] != 0) joints_[i] = {};
  }
}

/// Cubic Hermite polynomial, or a line.
void JointMotion::sample(Joint& joint, double time) {
  const auto next = std::ranges::upper_bound(joint.nodes, time, {}, &Node::time);
  if (next == joint.nodes.end()) {
    joint.target = joint.nodes.back().position;
    joint.rate = 0;
    joint.nodes.clear();
    return;
  }
  if (next == joint.nodes.begin()) return;
  const Node &a = *(next - 1), &b = *next;
  const double span = b.time - a.time, s = (time - a.time) / span;
  const double way = b.position - a.position;
  if (!a.smooth || !b.smooth) {
    joint.target = a.position + s * way;
    joint.rate = way / span;
    return;
  }
  const double c = 3 * way - span * (2 * a.velocity + b.velocity), d = span * (a.velocity + b.velocity) - 2 * way;
  joint.target = a.position + s * (span * a.velocity + s * (c + s * d));
  joint.rate = a.velocity + s * (2 * c + 3 * s * d) / span;
}

void JointMotion::command(Duration now) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    Joint& joint = joints_[i];
    const double own = own_target_[static_cast<std::size_t>(objects_[i])];
    if (!joint.commanded && (engine_ || !started_)) joint.target = own;
    if (!joint.nodes.empty()) sample(joint, seconds(now - joint.start));
    target_->values[i] = std::clamp(joint.target, target_range_.lowest[i], target_range_.highest[i]);
    rate_->values[i] = std::clamp(joint.rate, rate_range_.lowest[i], rate_range_.highest[i]);
    if (engine_) engine_->values[i] = joint.commanded ? 0 : 1;
  }
  started_ = true;
}

}  // namespace murosimf::dds::ros2
