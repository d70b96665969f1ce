#include "murosimf/robot_formats/mjcf/mjcf_writer.h"

#include <algorithm>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fmt/format.h>

#include "murosimf/files/xml_text.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/robot_formats/mjcf/mjcf_camera.h"
#include "murosimf/robot_formats/mjcf/mjcf_geom_writer.h"
#include "murosimf/robot_formats/mjcf/mjcf_sensor.h"

namespace murosimf::robot_formats::mjcf {
namespace {

constexpr double least_inertia = 1e-13;  // [kg m^2] readers refuse a mass without inertia
constexpr double least_mass = 1e-13;     // [kg] of a body that moves
constexpr double sole_thickness = 1e-3;  // [m] half; only for drawing

class Writer {
 public:
  Writer(const robot_formats::RobotDescription& description, const MjcfWriterOptions& options)
      : description_(description), geoms_(description, options.folder, xml_), children_(description.bodies.size()) {
    for (std::size_t i = 0; i < description.bodies.size(); ++i) {
      MUROSIMF_ASSERT(description.bodies[i].parent < static_cast<int>(i));
      if (description.bodies[i].parent >= 0) children_[description.bodies[i].parent].push_back(i);
    }
  }

  std::string write() {
    xml_.begin("mujoco").text("model", description_.name);
    write_compiler();
    write_option();
    geoms_.write_assets();
    xml_.begin("worldbody");
    description_.fixed_base ? write_world() : write_body(0);
    xml_.end();
    write_contacts();
    write_couplings();
    write_tendons();
    write_actuators();
    write_mjcf_sensors(xml_, description_);
    write_keyframes();
    xml_.end();
    return xml_.result();
  }

 private:
  /// Writes the base of a bolted robot as a body without joints, since MuJoCo's world has no mass.
  void write_world() {
    const robot_formats::BodyDescription& base = description_.bodies[0];
    if (has_fixed_part()) {
      xml_.begin("body").text("name", written_name(base.name));
      write_inertial(base.solid);
      geoms_.write_geoms(base);
      xml_.end();
    }
    for (const robot_formats::FrameDescription& frame : base.frames) write_frame(frame);
    for (const std::size_t child : children_[0]) write_body(child);
  }

  /// Writes the compiler's settings. MuJoCo refuses files with impossible inertias unless it may balance them.
  void write_compiler() {
    xml_.begin("compiler").text("angle", "radian").text("autolimits", "true").text("inertiafromgeom", "false");
    const auto is_impossible = [](const robot_formats::BodyDescription& body) {
      return body.solid.mass > 0 &&
             robot_formats::breaks_triangle_inequality(robot_formats::principal_moments(body.solid.inertia));
    };
    if (std::ranges::any_of(description_.bodies, is_impossible)) xml_.text("balanceinertia", "true");
    xml_.end();
  }

  /// Writes the integrator: MuJoCo's usual one takes the damping of servos from the last step and oscillates with the gains of real ones.
  void write_option() {
    for (const robot_formats::BodyDescription& body : description_.bodies) {
      for (const robot_formats::JointDescription& joint : body.joints) {
        if (!joint.servo || !(joint.servo->velocity_gain > 0)) continue;
        xml_.begin("option").text("integrator", "implicitfast").end();
        return;
      }
    }
  }

  void write_body(std::size_t index) {
    const robot_formats::BodyDescription& body = description_.bodies[index];
    xml_.begin("body").text("name", written_name(body.name));
    write_place(xml_, body.place);
    if (index == 0) xml_.begin("freejoint").text_unless_empty("name", description_.base_joint).end();
    for (const robot_formats::JointDescription& joint : body.joints) write_joint(joint);
    // Welded bodies may be massless in MuJoCo, moving ones may not.
    write_inertial(body.joints.empty() ? body.solid : with_least_mass(body.solid));
    geoms_.write_geoms(body);
    for (const robot_formats::FrameDescription& frame : body.frames) write_frame(frame);
    for (const std::size_t child : children_[index]) write_body(child);
    xml_.end();
  }

  void write_joint(const robot_formats::JointDescription& joint) {
    joints_.push_back(joint.name);
    xml_.begin("joint").text("name", joint.name);
    if (joint.kind == Kind::prismatic) xml_.text("type", "slide");
    xml_.vector_unless_zero("pos", joint.anchor).vector("axis", joint.axis);
    if (joint.range) xml_.numbers("range", {joint.range->x, joint.range->y});
    xml_.number_unless(0, "ref", joint.reference);
    xml_.number_unless(0, "armature", joint.armature).number_unless(0, "damping", joint.damping);
    xml_.number_unless(0, "frictionloss", joint.friction);
    xml_.number_unless(0, "stiffness", joint.stiffness).number_unless(0, "springref", joint.spring_reference);
    if (joint.effort_range) {
      xml_.numbers("actuatorfrcrange", {joint.effort_range->x, joint.effort_range->y});
    } else if (joint.effort_limit > 0) {
      xml_.numbers("actuatorfrcrange", {-joint.effort_limit, joint.effort_limit});
    }
    xml_.end();
  }

  /// Whether the base of a bolted robot has parts that the world cannot have.
  [[nodiscard]] bool has_fixed_part() const {
    const robot_formats::BodyDescription& base = description_.bodies[0];
    return base.solid.mass > 0 || !base.shapes.empty() || !base.visuals.empty();
  }

  /// Name of a body in the file. The base of a bolted robot is the world, or a body without joints in it. MuJoCo's world is "world".
  [[nodiscard]] std::string written_name(const std::string& body) const {
    if (description_.fixed_base && body == description_.bodies[0].name) {
      return has_fixed_part() ? body + ".fixed" : "world";
    }
    return body == "world" ? "world_link" : body;
  }

  /// The mass of a moving body, which MuJoCo requires to be positive.
  [[nodiscard]] static robot_formats::MassProperties with_least_mass(const robot_formats::MassProperties& solid) {
    if (solid.mass > 0) return solid;
    return {least_mass, {}, {least_inertia, least_inertia, least_inertia, 0, 0, 0}};
  }

  void write_inertial(const robot_formats::MassProperties& solid) {
    if (!(solid.mass > 0)) return;
    SymMat3d I = solid.inertia;
    if (!(robot_formats::principal_moments(I).x > 0)) I = robot_formats::with_least_moment(I, least_inertia);
    xml_.begin("inertial").vector("pos", solid.center).numbers("mass", {solid.mass});
    if (I.xy == 0 && I.xz == 0 && I.yz == 0) {
      xml_.numbers("diaginertia", {I.xx, I.yy, I.zz});
    } else {
      xml_.numbers("fullinertia", {I.xx, I.yy, I.zz, I.xy, I.xz, I.yz});
    }
    xml_.end();
  }

  void write_frame(const robot_formats::FrameDescription& frame) {
    xml_.begin(frame.kind == "camera" ? "camera" : "site").text("name", frame.name);
    write_place(xml_, frame.place);
    if (frame.kind == "camera") write_camera(frame);
    if (frame.box) {
      xml_.text("type", "box").numbers("size", {frame.box->half_length, frame.box->half_width, sole_thickness});
    }
    xml_.end();
  }

  void write_camera(const robot_formats::FrameDescription& frame) {
    for (const robot_formats::SensorDescription& sensor : description_.sensors) {
      if (is_mjcf_camera(sensor) && sensor.frame == frame.name) return write_mjcf_camera(xml_, sensor);
    }
  }

  void write_contacts() {
    if (description_.exclusions.empty() && description_.pairs.empty()) return;
    xml_.begin("contact");
    for (const robot_formats::ExclusionDescription& pair : description_.exclusions) {
      const std::string &first = body_of(pair.body1), &second = body_of(pair.body2);
      if (first != second)  // both may be welded into one body
        xml_.begin("exclude").text("body1", written_name(first)).text("body2", written_name(second)).end();
    }
    for (const robot_formats::PairDescription& pair : description_.pairs) {
      xml_.begin("pair").text("geom1", pair.shape1).text("geom2", pair.shape2).end();
    }
    xml_.end();
  }

  /// The body itself, or the one that it is welded to.
  [[nodiscard]] const std::string& body_of(const std::string& name) const {
    for (const robot_formats::BodyDescription& body : description_.bodies) {
      const auto is_it = [&](const robot_formats::FrameDescription& frame) {
        return frame.kind == "body" && frame.name == name;
      };
      if (std::ranges::any_of(body.frames, is_it)) return body.name;
    }
    return name;
  }

  void write_couplings() {
    const bool tied =
        std::ranges::any_of(description_.tendons, [](const auto& tendon) { return tendon.tie.has_value(); });
    if (description_.mimics.empty() && description_.loops.empty() && !tied) return;
    xml_.begin("equality");
    for (const robot_formats::MimicDescription& mimic : description_.mimics) {
      xml_.begin("joint").text("joint1", mimic.joint).text("joint2", mimic.leader);
      // The format counts both positions from their references.
      const double offset = mimic.offset - robot_formats::reference_of(description_, mimic.joint) +
                            mimic.ratio * robot_formats::reference_of(description_, mimic.leader);
      xml_.numbers("polycoef", {offset, mimic.ratio, 0, 0, 0}).end();
    }
    for (const robot_formats::LoopDescription& loop : description_.loops) {
      xml_.begin(loop.welded ? "weld" : "connect").text("name", loop.name);
      xml_.text("site1", loop.frame1).text("site2", loop.frame2).end();
    }
    for (const robot_formats::TendonDescription& tendon : description_.tendons) {
      if (!tendon.tie) continue;
      const auto& [other, a] = *tendon.tie;
      xml_.begin("tendon").text("tendon1", tendon.joint.name).text_unless_empty("tendon2", other);
      xml_.numbers("polycoef", {a[0], a[1], a[2], a[3], a[4]}).end();
    }
    xml_.end();
  }

  void write_tendons() {
    if (description_.tendons.empty()) return;
    xml_.begin("tendon");
    for (const robot_formats::TendonDescription& tendon : description_.tendons) {
      const robot_formats::JointDescription& joint = tendon.joint;
      xml_.begin(tendon.path.empty() ? "fixed" : "spatial").text("name", joint.name);
      if (joint.range) xml_.numbers("range", {joint.range->x, joint.range->y});
      xml_.number_unless(0, "armature", joint.armature).number_unless(0, "damping", joint.damping);
      xml_.number_unless(0, "frictionloss", joint.friction).number_unless(0, "stiffness", joint.stiffness);
      // a negative length means something else: such a spring can only be one of the pose of the file
      if (joint.stiffness > 0 && joint.spring_reference >= 0) {
        xml_.numbers("springlength", {joint.spring_reference, joint.spring_reference + joint.spring_slack});
      }
      for (const auto& [name, coefficient] : tendon.parts) {
        xml_.begin("joint").text("joint", name).numbers("coef", {coefficient}).end();
      }
      for (const robot_formats::TendonBranchDescription& branch : tendon.path) write_branch(branch, tendon);
      xml_.end();
    }
    xml_.end();
  }

  void write_branch(const robot_formats::TendonBranchDescription& branch,
                    const robot_formats::TendonDescription& tendon) {
    const bool pulley = &branch != &tendon.path.front() || branch.divisor != 1;
    if (pulley) xml_.begin("pulley").numbers("divisor", {branch.divisor}).end();
    for (const robot_formats::TendonPartDescription& part : branch.parts) {
      if (part.shape.empty()) {
        xml_.begin("site").text("site", part.site).end();
      } else {
        xml_.begin("geom").text("geom", part.shape);
        if (!part.site.empty()) xml_.text("sidesite", part.site);
        xml_.end();
      }
    }
  }

  void write_actuators() {
    for (const robot_formats::BodyDescription& body : description_.bodies) {
      for (const robot_formats::JointDescription& joint : body.joints) {
        if (joint.servo) driven_.push_back(&joint);
      }
    }
    for (const robot_formats::TendonDescription& tendon : description_.tendons) {
      if (tendon.joint.servo) driven_.push_back(&tendon.joint);
    }
    if (driven_.empty()) return;
    xml_.begin("actuator");
    for (const robot_formats::JointDescription* joint : driven_) write_actuator(*joint);
    xml_.end();
  }

  void write_keyframes() {
    if (description_.keyframes.empty()) return;
    xml_.begin("keyframe");
    for (const robot_formats::KeyframeDescription& key : description_.keyframes) {
      const auto& [p, R] = key.base;
      const Quaterniond q = from_matrix(R);
      std::vector<double> qpos, ctrl;
      if (!description_.fixed_base) qpos = {p.x, p.y, p.z, q.w, q.x, q.y, q.z};
      MUROSIMF_ASSERT(key.positions.size() >= joints_.size());
      for (const std::string& joint : joints_) qpos.push_back(key.positions.at(joint));
      for (const robot_formats::JointDescription* joint : driven_) {
        const auto target = key.targets.find(joint->name);
        ctrl.push_back(target == key.targets.end() ? 0 : target->second);
      }
      xml_.begin("key").text("name", key.name).text("qpos", fmt::format("{}", fmt::join(qpos, " ")));
      if (!key.targets.empty()) xml_.text("ctrl", fmt::format("{}", fmt::join(ctrl, " ")));
      xml_.end();
    }
    xml_.end();
  }

  void write_actuator(const robot_formats::JointDescription& joint) {
    MUROSIMF_ASSERT(joint.servo.has_value());
    const Servo& servo = *joint.servo;
    const bool holds = servo.position_gain > 0, brakes = servo.velocity_gain > 0;
    const bool fixed = joint.target_range && joint.target_range->x == joint.target_range->y;
    if ((holds || brakes) && (fixed || (!holds && servo.command_filter > 0))) {
      write_general(joint, fixed);
    } else {
      xml_.begin(holds ? "position" : brakes ? "velocity" : "motor").text("name", joint.name);
      xml_.text(transmission(joint), joint.name);
      if (holds) xml_.numbers("kp", {servo.position_gain}).number_unless(0, "timeconst", servo.command_filter);
      if (brakes) xml_.numbers("kv", {servo.velocity_gain});
    }
    if (joint.target_range && !fixed) xml_.numbers("ctrlrange", {joint.target_range->x, joint.target_range->y});
    if (servo.stall_torque > 0) {
      xml_.numbers("forcerange", {servo.lowest_share * servo.stall_torque, servo.highest_share * servo.stall_torque});
    }
    xml_.end();
  }

  [[nodiscard]] const char* transmission(const robot_formats::JointDescription& joint) const {
    const auto is_it = [&](const robot_formats::TendonDescription& tendon) { return &tendon.joint == &joint; };
    return std::ranges::any_of(description_.tendons, is_it) ? "tendon" : "joint";
  }

  /// What has no shortcut: a filter before a rate, or a control without a say.
  void write_general(const robot_formats::JointDescription& joint, bool fixed) {
    MUROSIMF_ASSERT(joint.servo.has_value() && (!fixed || joint.target_range));
    const Servo& servo = *joint.servo;
    const double kp = servo.position_gain, kv = servo.velocity_gain, per_target = kp > 0 ? kp : kv;
    xml_.begin("general").text("name", joint.name).text(transmission(joint), joint.name).text("biastype", "affine");
    xml_.numbers("gainprm", {fixed ? 0 : per_target});
    xml_.numbers("biasprm", {fixed ? per_target * joint.target_range->x : 0, 0 - kp, 0 - kv});
    if (servo.command_filter > 0) xml_.text("dyntype", "filterexact").numbers("dynprm", {servo.command_filter});
  }

  const robot_formats::RobotDescription& description_;
  files::XmlText xml_;
  MjcfGeomWriter geoms_;
  std::vector<std::vector<std::size_t>> children_;
  std::vector<std::string> joints_;                             // as they are written
  std::vector<const robot_formats::JointDescription*> driven_;  // as their actuators are written
};

}  // namespace

std::string to_mjcf(const robot_formats::RobotDescription& description, const MjcfWriterOptions& options) {
  return Writer(description, options).write();
}

}  // namespace murosimf::robot_formats::mjcf
