#include "murosimf/robot_formats/urdf/urdf_writer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/robot_formats/urdf/urdf_place_writer.h"
#include "murosimf/robot_formats/urdf/urdf_sensor_writer.h"
#include "murosimf/robot_formats/urdf/urdf_shape.h"
#include "murosimf/robot_formats/urdf/urdf_shape_writer.h"

namespace murosimf::robot_formats::urdf {
namespace {

constexpr double least_inertia = 1e-13;      // [kg m^2] readers refuse a mass without inertia
constexpr const char* world_link = "world";  // an empty root of this name bolts a robot
constexpr double endless = 1e3;              // [m] range of a slider without one: URDF requires it

/// A link of the file, and its place.
struct Link {
  std::string name;
  Transformd body;  ///< the frame of the description's body in that of the link
};

class Writer {
 public:
  Writer(const robot_formats::RobotDescription& description, const UrdfWriterOptions& options)
      : description_(description), shapes_(description, options, xml_, result_) {
    for (const robot_formats::BodyDescription& body : description.bodies) link_names_.insert(body.name);
  }

  UrdfText write() {
    xml_.begin("robot").text("name", description_.name);
    for (const robot_formats::BodyDescription& body : description_.bodies) write_body(body);
    for (std::size_t i = 0; i < links_.size(); ++i) write_gazebo(description_.bodies[i], links_[i]);
    for (const robot_formats::SensorDescription& sensor : description_.sensors) write_sensor_block(sensor);
    xml_.end();
    name_the_rest();
    result_.text = xml_.result();
    return std::move(result_);
  }

 private:
  void write_body(const robot_formats::BodyDescription& body) {
    Link link{body.name, {}};
    MUROSIMF_ASSERT(body.parent < static_cast<int>(links_.size()));
    if (body.parent < 0 && description_.fixed_base) bolt(body, link);
    std::string parent = body.parent < 0 ? "" : links_[body.parent].name;
    Transformd place = body.parent < 0 ? Transformd{} : links_[body.parent].body * body.place;
    // URDF has one joint between two links: joints of one body get massless links between them.
    for (std::size_t i = 0; i < body.joints.size(); ++i) {
      const robot_formats::JointDescription& joint = body.joints[i];
      const bool last = i + 1 == body.joints.size();
      const std::string child = last ? body.name : free_link(joint.name + "_link");
      if (!last) xml_.begin("link").text("name", child).end();
      write_joint(joint, parent, child, place * Transformd{joint.anchor, {}} * back_to_zero(joint));
      parent = child;
      // The link's frame is that of its joint: the body's own is shifted in it.
      place = Transformd{-joint.anchor, {}};
    }
    if (!body.joints.empty()) {
      link.body = place;
    } else if (body.parent >= 0) {
      write_fixed(body.name, parent, place);
    }
    write_link(body, link);
    for (const robot_formats::FrameDescription& frame : body.frames) write_frame(frame, link);
    links_.push_back(std::move(link));
  }

  /// Adds the world of a bolted robot: an empty root called "world", to which a base with mass or shapes is attached.
  void bolt(const robot_formats::BodyDescription& base, Link& link) {
    const bool empty = !(base.solid.mass > 0) && base.shapes.empty() && base.visuals.empty();
    if (empty && base.name == world_link) return;
    xml_.begin("link").text("name", world_link).end();
    link_names_.insert(world_link);
    if (base.name == world_link) link.name = free_link("base");
    write_fixed(link.name, world_link, {});
  }

  /// Turns a joint from its reference, where it is in the pose of the file, to zero, where it is in URDF.
  [[nodiscard]] static Transformd back_to_zero(const robot_formats::JointDescription& joint) {
    MUROSIMF_ASSERT(norm(joint.axis) > 0);
    const Vec3d axis = (1.0 / norm(joint.axis)) * joint.axis;
    if (joint.reference == 0) return {};
    if (joint.kind == Kind::prismatic) return {-joint.reference * axis, {}};
    return {{}, rotation(axis, -joint.reference)};
  }

  void write_link(const robot_formats::BodyDescription& body, const Link& link) {
    xml_.begin("link").text("name", link.name);
    write_inertial(robot_formats::moved(body.solid, link.body.position, link.body.orientation));
    shapes_.write(body, link.body);
    xml_.end();
  }

  void write_inertial(const robot_formats::MassProperties& solid) {
    if (!(solid.mass > 0)) return;
    SymMat3d I = solid.inertia;
    // Readers refuse a mass without inertia.
    if (!(robot_formats::principal_moments(I).x > 0)) I = robot_formats::with_least_moment(I, least_inertia);
    xml_.begin("inertial");
    write_origin(xml_, {solid.center, {}});
    xml_.begin("mass").numbers("value", {solid.mass}).end();
    xml_.begin("inertia").numbers("ixx", {I.xx}).numbers("ixy", {I.xy}).numbers("ixz", {I.xz});
    xml_.numbers("iyy", {I.yy}).numbers("iyz", {I.yz}).numbers("izz", {I.zz}).end();
    xml_.end();
  }

  void write_frame(const robot_formats::FrameDescription& frame, const Link& link) {
    const std::string name = free_link(frame.name);
    frame_links_.emplace(frame.name, name);
    write_fixed(name, link.name, link.body * frame.place);
    xml_.begin("link").text("name", name).end();
  }

  void write_fixed(const std::string& child, const std::string& parent, const Transformd& place) {
    begin_joint(free_joint(child + "_fixed"), "fixed", parent, child, place);
    xml_.end();
  }

  void begin_joint(const std::string& name, const char* type, const std::string& parent, const std::string& child,
                   const Transformd& place) {
    xml_.begin("joint").text("name", name).text("type", type);
    write_origin(xml_, place);
    xml_.begin("parent").text("link", parent).end();
    xml_.begin("child").text("link", child).end();
  }

  void write_joint(const robot_formats::JointDescription& joint, const std::string& parent, const std::string& child,
                   const Transformd& place) {
    const bool slides = joint.kind == Kind::prismatic;
    const char* type = slides ? "prismatic" : joint.range ? "revolute" : "continuous";
    begin_joint(joint.name, type, parent, child, place);
    xml_.begin("axis").vector("xyz", (1.0 / norm(joint.axis)) * joint.axis).end();
    write_limit(joint);
    if (joint.damping > 0 || joint.friction > 0) {
      xml_.begin("dynamics").number_unless(0, "damping", joint.damping);
      xml_.number_unless(0, "friction", joint.friction).end();
    }
    for (const robot_formats::MimicDescription& mimic : description_.mimics) {
      if (mimic.joint == joint.name) write_mimic(mimic);
    }
    xml_.end();
  }

  void write_limit(const robot_formats::JointDescription& joint) {
    const double effort = largest_effort(joint);
    if (!joint.range && joint.kind == Kind::revolute && effort == 0 && joint.rate_limit == 0) return;
    xml_.begin("limit");
    if (joint.range) {
      xml_.numbers("lower", {joint.range->x}).numbers("upper", {joint.range->y});
    } else if (joint.kind == Kind::prismatic) {
      xml_.numbers("lower", {-endless}).numbers("upper", {endless});
      leave_out(joint.where,
                fmt::format("joint '{}' slides without an end: {} m to either side are written", joint.name, endless));
    }
    xml_.numbers("effort", {effort}).numbers("velocity", {joint.rate_limit}).end();
  }

  /// [N m | N] Limit of the file, else of the joint's servo.
  [[nodiscard]] double largest_effort(const robot_formats::JointDescription& joint) {
    if (joint.effort_limit > 0) return joint.effort_limit;
    double lowest = 0, highest = 0;
    if (joint.effort_range) {
      lowest = joint.effort_range->x;
      highest = joint.effort_range->y;
    } else if (joint.servo) {
      lowest = joint.servo->lowest_share * joint.servo->stall_torque;
      highest = joint.servo->highest_share * joint.servo->stall_torque;
    }
    if (lowest != -highest) {
      leave_out(joint.where, fmt::format("torque of joint '{}' from {} to {}: the larger one holds both ways",
                                         joint.name, lowest, highest));
    }
    // Limits of URDF are the same in both directions.
    return std::max({std::fabs(lowest), std::fabs(highest), 0.0});
  }

  void write_mimic(const robot_formats::MimicDescription& mimic) {
    xml_.begin("mimic").text("joint", mimic.leader);
    xml_.number_unless(1, "multiplier", mimic.ratio).number_unless(0, "offset", mimic.offset).end();
  }

  void write_gazebo(const robot_formats::BodyDescription& body, const Link& link) {
    std::optional<double> friction;
    bool differs = false;
    for (const robot_formats::ShapeDescription& shape : body.shapes) {
      if (!shape.placed.collides) continue;
      differs = differs || (friction && *friction != shape.placed.surface.friction);
      if (!friction) friction = shape.placed.surface.friction;
    }
    if (differs) {
      leave_out(body.where,
                fmt::format("frictions of body '{}': {} of its first shape is written for all", body.name, *friction));
    }
    if (friction && *friction != standard_friction) write_numbers(link.name, {{"mu1", *friction}, {"mu2", *friction}});
    for (const robot_formats::JointDescription& joint : body.joints) {
      if (joint.stiffness == 0) continue;
      write_numbers(joint.name, {{"springStiffness", joint.stiffness}, {"springReference", joint.spring_reference}});
    }
  }

  void write_numbers(const std::string& reference, const std::vector<std::pair<const char*, double>>& numbers) {
    xml_.begin("gazebo").text("reference", reference);
    for (const auto& [tag, number] : numbers) xml_.begin(tag).content(fmt::format("{}", number)).end();
    xml_.end();
  }

  void write_sensor_block(const robot_formats::SensorDescription& sensor) {
    if (!is_urdf_sensor(sensor)) return;
    if (const auto frame = frame_links_.find(sensor.frame); frame != frame_links_.end()) {
      return write_sensor(xml_, sensor, frame->second, sensor.place);
    }
    for (std::size_t i = 0; i < links_.size(); ++i) {
      MUROSIMF_ASSERT(links_.size() == description_.bodies.size());
      const robot_formats::BodyDescription& body = description_.bodies[i];
      const bool of_joint = !body.joints.empty() && body.joints.back().name == sensor.frame;
      if (body.name != sensor.frame && !of_joint) continue;
      return write_sensor(xml_, sensor, links_[i].name, links_[i].body * sensor.place);
    }
    leave_out(sensor.where, fmt::format("sensor {} '{}' at '{}'", sensor.kind, sensor.name, sensor.frame));
  }

  void name_the_rest() {
    int rotors = 0, masks = 0;
    for (const robot_formats::BodyDescription& body : description_.bodies) {
      for (const robot_formats::JointDescription& joint : body.joints) rotors += joint.armature > 0 && !joint.servo;
      for (const robot_formats::ShapeDescription& shape : body.shapes)
        masks += shape.placed.collides && !is_usual(shape.placed);
    }
    const std::string& where = description_.bodies[0].where;
    if (rotors > 0) leave_out(where, fmt::format("armature of {} joints that nothing drives", rotors));
    if (masks > 0) leave_out(where, fmt::format("contype and conaffinity of {} shapes: they touch everything", masks));
    if (!description_.exclusions.empty()) {
      leave_out(where, fmt::format("{} pairs of bodies that never touch each other", description_.exclusions.size()));
    }
    if (!description_.pairs.empty()) {
      leave_out(where, fmt::format("{} pairs of shapes that touch whatever forbids it", description_.pairs.size()));
    }
    if (!description_.tendons.empty()) {
      leave_out(where, fmt::format("{} tendons over several joints", description_.tendons.size()));
    }
    if (!description_.loops.empty()) {
      leave_out(where, fmt::format("{} loops of bodies: they are open", description_.loops.size()));
    }
    if (!description_.keyframes.empty()) leave_out(where, fmt::format("{} keys", description_.keyframes.size()));
  }

  void leave_out(const std::string& where, const std::string& what) {
    result_.left_out.push_back(fmt::format("{}: {}", where, what));
  }

  std::string free_link(std::string name) {
    while (!link_names_.insert(name).second) name += "_frame";
    return name;
  }

  std::string free_joint(std::string name) {
    const auto taken = [&](const std::string& wanted) {
      return std::ranges::any_of(description_.bodies, [&](const robot_formats::BodyDescription& body) {
        return std::ranges::find(body.joints, wanted, &robot_formats::JointDescription::name) != body.joints.end();
      });
    };
    while (taken(name)) name += "_fixed";
    return name;
  }

  const robot_formats::RobotDescription& description_;
  files::XmlText xml_;
  UrdfText result_;
  UrdfShapeWriter shapes_;
  std::vector<Link> links_;                         // of each body
  std::set<std::string> link_names_;                // also those of later bodies
  std::map<std::string, std::string> frame_links_;  // by the name of the frame
};

}  // namespace

UrdfText to_urdf(const robot_formats::RobotDescription& description, const UrdfWriterOptions& options) {
  return Writer(description, options).write();
}

}  // namespace murosimf::robot_formats::urdf
