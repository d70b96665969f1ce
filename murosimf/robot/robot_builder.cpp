#include "murosimf/robot/robot_builder.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/passive_joint.h"
#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/mirrored_motion.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/fixed_base.h"
#include "murosimf/model/keyframe.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/joint_tendon.h"
#include "murosimf/robot/robot_soles.h"
#include "murosimf/robot/tendon_properties.h"
#include "murosimf/robot_formats/robot_visuals.h"

namespace murosimf::robot {
namespace {

/// One object to add, with the joint that it is made from.
struct Step {
  Object object;
  const robot_formats::JointDescription* joint = nullptr;
};

class Builder {
 public:
  Builder(robot_formats::RobotDescription& description, const RobotConfig& table)
      : description_(description), table_(table), children_(description.bodies.size()) {
    for (std::size_t i = 0; i < description.bodies.size(); ++i) {
      const robot_formats::BodyDescription& body = description.bodies[i];
      bodies_.insert(body.name);
      for (const robot_formats::JointDescription& joint : body.joints) joints_.insert(joint.name);
      if (body.parent >= 0) children_[body.parent].push_back(i);
      MUROSIMF_ASSERT(body.parent < static_cast<int>(i));
      for (const robot_formats::FrameDescription& frame : body.frames)
        (frame.kind == "body" ? bodies_ : frames_).insert(frame.name);
    }
    for (const robot_formats::TendonDescription& tendon : description.tendons) joints_.insert(tendon.joint.name);
  }

  [[nodiscard]] Chain build() {
    Chain chain;
    const std::string& base = description_.bodies[0].name;
    const std::string& base_joint = description_.base_joint;
    if (base_joint != base) joints_.insert(base_joint);
    chain.base(free_name(base, description_.bodies[0].where, "body"));
    if (!base_joint.empty() && base_joint != base) chain.alias(base_joint);
    if (description_.fixed_base) chain.with(properties::fixed_base, 1);
    if (!frames_.contains(base)) add_other_names(chain, table_.frames, base);
    add_pairs(chain);
    add_keyframes(chain);
    if (!table_.walk.empty()) chain.with(properties::given_walk, table_.walk);
    if (!table_.balance.empty()) chain.with(properties::given_balance, table_.balance);
    if (table_.steps) chain.with(properties::given_steps, table_.steps);
    finish(chain, 0);
    return chain;
  }

 private:
  /// Completes the base or the last object of a body: mass and shapes, then all branches.
  void finish(Chain& chain, std::size_t index) {
    const robot_formats::BodyDescription& body = description_.bodies[index];
    MUROSIMF_ASSERT(index < description_.bodies.size());
    add_mass(chain, body);
    add_shapes(chain, body);
    std::vector<Chain> branches;
    for (const std::size_t child : children_[index]) branches.push_back(build_body(child));
    for (const robot_formats::FrameDescription& frame : body.frames) branches.push_back(build_frame(frame));
    if (index == 0) {
      for (const robot_formats::TendonDescription& tendon : description_.tendons)
        branches.push_back(build_tendon(tendon));
    }
    chain.fork(branches);
  }

  [[nodiscard]] Chain build_body(std::size_t index) {
    const robot_formats::BodyDescription& body = description_.bodies[index];
    MUROSIMF_ASSERT(index > 0 && index < children_.size());
    Chain chain;
    for (const Step& step : name_last(steps(body), body)) add(chain, step);
    if (chain.objects().back().is_joint()) add_alias(chain, body);
    if (!frames_.contains(body.name)) add_other_names(chain, table_.frames, body.name);
    finish(chain, index);
    return chain;
  }

  [[nodiscard]] Chain build_tendon(const robot_formats::TendonDescription& tendon) {
    Chain chain;
    chain.prismatic(tendon.joint.name, tendon.joint.axis);
    add_joint_constants(chain, tendon.joint);
    if (!tendon.path.empty()) {
      const auto object = [&](const std::string& body) { return object_of(body); };
      chain.with(properties::spatial_tendon, spatial_tendon_of(description_, tendon, object));
    } else {
      JointTendon over;
      for (const auto& [joint, coefficient] : tendon.parts) over.parts.push_back({joint, coefficient});
      chain.with(properties::joint_tendon, over);
    }
    if (tendon.tie) chain.with(properties::tendon_tie, tie_of(description_, tendon));
    return chain;
  }

  [[nodiscard]] static std::vector<Step> steps(const robot_formats::BodyDescription& body) {
    const auto& [offset, turn] = body.place;
    std::vector<Step> result;
    if (!is_zero(offset)) result.push_back({{Kind::translation, -1, offset, {}, body.name + ".offset", true}});
    if (!is_identity(turn)) result.push_back({{Kind::rotation, -1, {}, turn, body.name + ".turn", true}});
    for (const robot_formats::JointDescription& joint : body.joints) {
      const bool away = !is_zero(joint.anchor);
      if (away) result.push_back({{Kind::translation, -1, joint.anchor, {}, joint.name + ".anchor", true}});
      if (joint.reference != 0) result.push_back({back_to_zero(joint)});
      result.push_back({{joint.kind, -1, joint.axis, {}, joint.name}, &joint});
      if (away) result.push_back({{Kind::translation, -1, -joint.anchor, {}, joint.name + ".back", true}});
    }
    if (result.empty()) result.push_back({{Kind::translation, -1, {}, {}, {}}});
    // A body at the place of its parent is still an object, with the body's name.
    return result;
  }

  /// In the pose of the file the joint is at `reference`; this turns it back to zero.
  [[nodiscard]] static Object back_to_zero(const robot_formats::JointDescription& joint) {
    const Vec3d axis = (1.0 / norm(joint.axis)) * joint.axis;
    const std::string name = joint.name + ".zero";
    if (joint.kind == Kind::prismatic) return {Kind::translation, -1, -joint.reference * axis, {}, name, true};
    return {Kind::rotation, -1, {}, rotation(axis, -joint.reference), name, true};
  }

  /// Gives the body's name to the last object, if it is no joint.
  [[nodiscard]] std::vector<Step> name_last(std::vector<Step> steps, const robot_formats::BodyDescription& body) {
    Object& last = steps.back().object;
    MUROSIMF_ASSERT(!steps.empty());
    if (!steps.back().joint) last.name = free_name(body.name, body.where, "body");
    last.structural = false;  // it is the body, which users look up by name
    return steps;
  }

  void add(Chain& chain, const Step& step) {
    const Object& object = step.object;
    if (object.kind == Kind::translation) chain.translation(object.vector, object.name);
    if (object.kind == Kind::rotation) chain.rotation(object.turn, object.name);
    if (object.kind == Kind::revolute) chain.revolute(object.name, object.vector);
    if (object.kind == Kind::prismatic) chain.prismatic(object.name, object.vector);
    if (object.structural) chain.structural();
    if (!step.joint) return;
    add_joint_constants(chain, *step.joint);
    add_other_names(chain, table_.joints, step.joint->name);
    const bool is_free = !bodies_.contains(step.joint->name) && !frames_.contains(step.joint->name);
    if (is_free) add_other_names(chain, table_.frames, step.joint->name);
  }

  void add_rest_position(Chain& chain, const robot_formats::JointDescription& joint) const {
    const auto found = table_.rest_positions.find(joint.name);
    if (found == table_.rest_positions.end()) return;
    const auto& [rest, where] = found->second;
    if (joint.range && (rest < joint.range->x || rest > joint.range->y))
      throw SetupError(fmt::format("{}: the rest position of '{}', {}, is not in its range, {} to {}", where,
                                   joint.name, rest, joint.range->x, joint.range->y));
    chain.with(properties::rest_position, rest);
  }

  /// A servo of the table has rotor, friction and speed-torque line of its own: the file's describe the same part.
  void add_joint_constants(Chain& chain, const robot_formats::JointDescription& joint) const {
    if (joint.range) chain.with(properties::joint_range, *joint.range);
    if (joint.reference != 0) chain.with(properties::joint_start, joint.reference);
    if (joint.rate_limit > 0) chain.with(properties::joint_rate_limit, joint.rate_limit);
    if (joint.stiffness > 0) {
      chain.with(properties::joint_stiffness, joint.stiffness);
      chain.with(properties::joint_spring_reference, joint.spring_reference);
      if (joint.spring_slack > 0) chain.with(properties::joint_spring_slack, joint.spring_slack);
    }
    for (const robot_formats::MimicDescription& mimic : description_.mimics) {
      if (mimic.joint == joint.name) {
        chain.with(properties::joint_coupling, {mimic.leader, mimic.ratio, mimic.offset});
      }
    }
    if (std::ranges::count(table_.commanded, joint.name, &TableName::name) > 0) {
      chain.with(properties::loop_commanded, 1.0);
    }
    add_rest_position(chain, joint);
    const auto found = table_.servos.find(joint.name);
    const bool of_table = found != table_.servos.end();
    const bool same_kind = !of_table || !joint.servo ||
                           dynamics::follows_rate(*joint.servo) == dynamics::follows_rate(found->second.servo);
    if (joint.target_range && same_kind) chain.with(properties::joint_target_range, *joint.target_range);
    // Ranges of targets are in their unit: those for positions are not valid for rates.
    if (of_table) {
      chain.with(properties::servo, found->second.servo);
      return;
    }
    if (joint.armature > 0) chain.with(properties::joint_armature, joint.armature);
    if (joint.damping > 0) chain.with(properties::joint_damping, joint.damping);
    if (joint.friction > 0) chain.with(properties::joint_friction, joint.friction);
    if (joint.servo) chain.with(properties::servo, *joint.servo);
  }

  /// The table's other names for `name` of the file, each once: joints, bodies and frames may share it.
  void add_other_names(Chain& chain, const std::map<std::string, TableName>& others, const std::string& name) {
    for (const auto& [other, meant] : others) {
      if (meant.name == name && other != name && other_names_.insert(other).second) chain.alias(other);
    }
  }

  void add_alias(Chain& chain, const robot_formats::BodyDescription& body) {
    if (chain.objects().back().name != body.name) chain.alias(free_name(body.name, body.where, "body"));
  }

  void add_pairs(Chain& chain) const {
    ExcludedPairs excluded;
    for (const robot_formats::ExclusionDescription& pair : description_.exclusions) {
      excluded.emplace_back(object_of(pair.body1), object_of(pair.body2));
    }
    AllowedPairs allowed;
    for (const robot_formats::PairDescription& pair : description_.pairs) {
      for (const ShapeOfObject& a : find_shapes(pair.shape1)) {
        for (const ShapeOfObject& b : find_shapes(pair.shape2)) allowed.emplace_back(a, b);
      }
    }
    if (!excluded.empty()) chain.with(properties::excluded_pairs, excluded);
    if (!allowed.empty()) chain.with(properties::allowed_pairs, allowed);
  }

  void add_keyframes(Chain& chain) const {
    Keyframes keyframes;
    for (const robot_formats::KeyframeDescription& key : description_.keyframes) {
      keyframes.push_back({key.name,
                           {key.positions.begin(), key.positions.end()},
                           {key.targets.begin(), key.targets.end()},
                           key.base.orientation});
    }
    if (!keyframes.empty()) chain.with(properties::keyframes, keyframes);
  }

  /// Name of the object of a body, or of the frame of a body that is welded to another.
  [[nodiscard]] std::string object_of(const std::string& body) const {
    return joints_.contains(body) ? body + ".body" : body;
  }

  /// Several for a mesh of several parts.
  [[nodiscard]] std::vector<ShapeOfObject> find_shapes(const std::string& name) const {
    std::vector<ShapeOfObject> shapes;
    for (const robot_formats::BodyDescription& body : description_.bodies) {
      for (std::size_t i = 0; i < body.shapes.size(); ++i) {
        if (body.shapes[i].name == name) shapes.push_back({object_of(body.name), i});
      }
    }
    return shapes;
  }

  /// Name of a body or frame; with a suffix if another object has it: a joint, for a frame also a body, or another frame.
  [[nodiscard]] std::string free_name(const std::string& name, const std::string& where, const std::string& kind) {
    const bool is_frame = kind != "body";
    const char* owner = joints_.contains(name)               ? "joint"
                        : is_frame && bodies_.contains(name) ? "body"
                        : given_.contains(name)              ? "frame"
                                                             : nullptr;
    std::string free = owner ? name + "." + kind : name;
    while (given_.contains(free)) free += "2";
    given_.insert(free);
    if (owner) {
      description_.warnings.push_back(
          files::one_line(fmt::format("{}: {} '{}' is called '{}' here, since a {} has the same name", where, kind,
                                      name, free, owner)));
    }
    return free;
  }

  void add_shapes(Chain& chain, const robot_formats::BodyDescription& body) const {
    Shapes shapes;
    for (const robot_formats::ShapeDescription& shape : body.shapes) shapes.push_back(shape.placed);
    if (!shapes.empty()) chain.with(properties::shapes, shapes);
    const Visuals visuals = robot_formats::visuals_of(description_, body);
    if (!visuals.empty()) chain.with(properties::visuals, visuals);
  }

  void add_mass(Chain& chain, const robot_formats::BodyDescription& body) {
    if (body.solid.mass > 0) {
      chain.with(properties::mass, body.solid.mass);
      chain.with(properties::center_of_mass, body.solid.center);
      chain.with(properties::inertia, body.solid.inertia);
    } else if (!body.joints.empty() || (body.parent < 0 && !description_.fixed_base)) {
      description_.warnings.push_back(
          files::one_line(fmt::format("{}: body '{}' moves but has no mass; add an inertial", body.where, body.name)));
    }
  }

  [[nodiscard]] Chain build_frame(const robot_formats::FrameDescription& frame) {
    const std::string name = free_name(frame.name, frame.where, frame.kind);
    const auto& [offset, turn] = frame.place;
    Chain chain;
    if (!is_zero(offset)) chain.translation(offset, name + ".offset").structural();
    if (!is_identity(turn)) chain.rotation(turn, name + ".turn").structural();
    chain.endpoint(name);
    if (is_sole(frame, table_)) chain.with(properties::sole, *frame.box);
    add_other_names(chain, table_.frames, frame.name);
    close_loops(chain, frame);
    return chain;
  }

  /// The second frame of a loop refers to the first by its own alias, since the first may be added later.
  void close_loops(Chain& chain, const robot_formats::FrameDescription& frame) const {
    if (frame.kind != "site" && frame.kind != "loop") return;
    for (std::size_t i = 0; i < description_.loops.size(); ++i) {
      const robot_formats::LoopDescription& loop = description_.loops[i];
      const std::string first = fmt::format("loop.{}", i);
      if (loop.frame1 == frame.name) chain.alias(first);
      if (loop.frame2 == frame.name) chain.with(properties::loop_closure, {first, loop.welded});
    }
  }

  robot_formats::RobotDescription& description_;
  const RobotConfig& table_;
  std::vector<std::vector<std::size_t>> children_;
  std::set<std::string> joints_, bodies_, frames_;  // bodies include those that are welded to others
  std::set<std::string> given_;                     // names that free_name has returned
  std::set<std::string> other_names_;               // that add_other_names has used
};

/// The motions of the table, for the joints of the model.
locomotion::NamedMotions motions_of(const RobotConfig& table, const Model& model) {
  locomotion::NamedMotions motions;
  for (const auto& [name, given] : table.motions) {
    motions.push_back({name, with_context(given.where, [&] { return locomotion::played_by(model, given.motion); })});
  }
  return motions;
}

}  // namespace

ModelPtr build_model(robot_formats::RobotDescription& description, const RobotConfig& table) {
  const Chain chain = Builder(description, table).build();
  auto model =
      with_context(description.bodies[0].where, [&] { return std::make_shared<const Model>(description.name, chain); });
  if (table.motions.empty()) return model;
  ConstantTable constants = model->constants();
  constants.set(properties::given_motions, 0, motions_of(table, *model));
  return std::make_shared<const Model>(model->with(std::move(constants)));
}

}  // namespace murosimf::robot
