#include "murosimf/sensors/joint_wrench.h"

#include <cmath>

#include <fmt/format.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::sensors {
namespace {

/// The joint or body that an object belongs to: the nearest of its ancestors, or itself.
int body_of(const Model& model, int object) {
  const auto carries = [&](int i) {
    return model.objects()[i].is_joint() || model.find(properties::mass, i) || model.find(properties::shapes, i);
  };
  // structural objects belong to the body above them
  while (object > 0 && !carries(object)) object = model.objects()[object].parent;
  return object;
}

int cut_of(const Model& model, const SensorSpec& spec, const JointWrenchOptions& options) {
  return options.behind.empty() ? body_of(model, mounted_on(model, spec)) : model.object_index(options.behind);
}

}  // namespace

const OptionTable<JointWrenchOptions>& joint_wrench_options() {
  using Options = JointWrenchOptions;
  static const OptionTable<Options> table{
      {"behind", &Options::behind, "",
       "joint or body at which the robot is cut; without it the one that has the frame"},
      {"direction", &Options::direction, "", "of which on which its wrench is",
       std::vector<std::string>{"child_to_parent", "parent_to_child"}},
      {"axes", &Options::axes, "", "object in whose axes it is shown; without it the sensor's own"},
  };
  return table;
}

JointWrench::JointWrench(Setup& setup, const SensorSpec& spec, const SensorSurroundings& surroundings)
    : Sensor(setup, spec, surroundings, {{"force", "N", xyz()}, {"torque", "N m", xyz()}}, Watch::always),
      model_(setup.model()),
      mounting_(setup, spec),
      axes_turn_(mounting_.orientation_on_link()),
      axes_link_(mounting_.link_object()),
      feet_(feet_of(setup.model())),
      behind_(static_cast<std::size_t>(setup.model().size())),
      gravity_(setup.world().gravity),
      period_(seconds(setup.period())),
      r_(setup.read(properties::position)),
      v_(setup.read(properties::linear_velocity)),
      w_(setup.read(properties::angular_velocity)),
      R_(setup.read(properties::orientation)),
      external_(setup.input(properties::external_force, {})),
      dynamic_(setup.input(properties::dynamic, 1)),
      stance_foot_(setup.observe(properties::stance_foot)) {
  const JointWrenchOptions options = options_of(spec, joint_wrench_options());
  // child on parent is the opposite of what holds the child
  sign_ = options.direction == "parent_to_child" ? 1 : -1;
  if (!options.axes.empty()) {
    const FixedObject shown = model_.placement(model_.object_index(options.axes));
    axes_link_ = model_.tree().links[shown.link].object;
    axes_turn_ = shown.turn;
  }
  find_parts(cut_of(model_, spec, options));
}

void JointWrench::find_parts(int cut) {
  MUROSIMF_ASSERT(cut >= 0 && cut < model_.size());
  // parents come first: one pass finds all that is behind the cut
  for (int i = cut; i < model_.size(); ++i) {
    const int parent = model_.objects()[i].parent;
    behind_[i] = i == cut || (parent >= 0 && behind_[parent]);
    if (!behind_[i]) continue;
    const double* mass = model_.find(properties::mass, i);
    if (mass || model_.find(properties::shapes, i)) bodies_.push_back(i);
    // bodies without mass can be touched, but have no momentum
    if (!mass) continue;
    Part part{.object = i, .mass = *mass, .center = {}, .inertia = {}};
    if (const Vec3d* center = model_.find(properties::center_of_mass, i)) part.center = *center;
    if (const SymMat3d* inertia = model_.find(properties::inertia, i)) part.inertia = *inertia;
    parts_.push_back(part);
  }
  if (model_.objects()[cut].kind != Kind::endpoint) return;  // else a frame
  throw SetupError(fmt::format(
      "nothing is behind '{}', which is a part of the body that it is fixed to; it stays one of its own if the "
      "sensor stands in the robot's own file or in the TOML file beside it",
      model_.objects()[cut].name));
}

std::string JointWrench::diagnostic(const LevelTraits& level) const {
  if (level.dynamic) return {};
  return "there are no contact forces: it takes the whole weight to be on the foot that stands";
}

JointWrench::Momentum JointWrench::momentum() const noexcept {
  Momentum sum;
  for (const Part& part : parts_) {
    const int i = part.object;
    const Vec3d arm = R_[i] * part.center;
    const Vec3d linear = part.mass * (v_[i] + cross(w_[i], arm));
    sum.linear += linear;
    sum.angular += rotated(R_[i], part.inertia) * w_[i] + cross(r_[i] + arm, linear);
  }
  return sum;
}

Wrenchd JointWrench::carried_weight(const Vec3d& place) const noexcept {
  const double stance = stance_foot_[0];
  if (std::isnan(stance)) return {};  // no level writes a standing foot
  const auto foot = static_cast<std::size_t>(stance);
  if (foot >= feet_.size() || !behind_[feet_[foot].object]) return {};
  const int link = model_.tree().links[feet_[foot].place.link].object;
  const Vec3d weight = -model_.tree().mass * gravity_;
  return {cross(r_[link] + R_[link] * feet_[foot].place.offset - place, weight), weight};
}

/// Gravity, contacts and pushes on all that is behind the cut, about `place`.
Wrenchd JointWrench::outside_forces(const Vec3d& place) const noexcept {
  Wrenchd sum;
  for (const Part& part : parts_) {
    const Vec3d weight = part.mass * gravity_;
    sum += Wrenchd{cross(r_[part.object] + R_[part.object] * part.center - place, weight), weight};
  }
  // without dynamics there are no contact forces
  if (dynamic_[0] == 0) return sum + carried_weight(place);
  for (const int k : bodies_) {
    sum += Wrenchd{external_[k].n + cross(r_[k] - place, external_[k].f), external_[k].f};
  }
  return sum;
}

void JointWrench::measure(std::span<double> values) noexcept {
  MUROSIMF_ASSERT(values.size() == 6 && period_ > 0);
  const Vec3d place = mounting_.position();
  const Momentum now = momentum();
  Vec3d force, moment;  // that change the momentum
  if (known_ != 0) {    // the first call has no preceding momentum
    force = (1 / period_) * (now.linear - last_.linear);
    moment = (1 / period_) * (now.angular - last_.angular) - cross(place, force);
  }
  last_ = now;
  known_ = 1;
  const Wrenchd outside = outside_forces(place);
  const Mat3d to_axes = transpose(R_[axes_link_] * axes_turn_);
  write(sign_ * (to_axes * (force - outside.f)), values);
  write(sign_ * (to_axes * (moment - outside.n)), values.subspan(3));
}

}  // namespace murosimf::sensors
