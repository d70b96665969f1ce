/// robot_description.h - a robot as a file describes it, before it becomes a Model: output of the readers of MJCF, URDF, SDF and PROTO,
/// and input of the checks and the converter.
///
/// Everything is resolved: SI units, angles in rad, classes and includes applied, meshes read. Every part has the place where it
/// is written ("robot.xml:12"), for later diagnostics. Names are those of the file.
///
/// Bodies form a tree, parents first; body 0 is the base and has no joints. A body is placed in the frame of its parent
/// and then moved by its joints in their order; a body without joints is welded to its parent (lump_fixed_joints).
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/math/transform.h"
#include "murosimf/model/object.h"
#include "murosimf/model/servo.h"
#include "murosimf/model/shape.h"
#include "murosimf/robot_formats/mass_properties.h"
#include "murosimf/sensors/signal_spec.h"

namespace murosimf::robot_formats {

struct JointDescription {
  std::string name, where;
  Kind kind = Kind::revolute;   ///< or prismatic
  Vec3d anchor;                 ///< [m] body frame
  Vec3d axis;                   ///< any length but zero, body frame
  std::optional<Vec3d> range;   ///< [rad | m] lowest, highest, 0
  double reference = 0;         ///< [rad | m] joint position in the pose of the file
  double armature = 0;          ///< [kg m^2 | kg]
  double damping = 0;           ///< [N m s/rad | N s/m]
  double friction = 0;          ///< [N m | N] dry
  double stiffness = 0;         ///< [N m/rad | N/m] of a spring at the joint
  double spring_reference = 0;  ///< [rad | m] joint position at which that spring is at rest
  double spring_slack = 0;      ///< [rad | m] up to this much beyond it, too
  /// [N m | N] The file's own limit of the drive (URDF effort, MJCF actuatorfrcrange); 0: none.
  double effort_limit = 0;
  std::optional<Vec3d> effort_range;  ///< [N m | N] lowest, highest, 0: where that limit differs between directions
  double rate_limit = 0;              ///< [rad/s | m/s] URDF velocity; 0: none
  std::optional<Servo> servo;         ///< of its actuators
  /// [rad | m] Lowest, highest, 0: bounds of targets (MJCF ctrlrange); of a servo without position gain rates.
  std::optional<Vec3d> target_range;
  /// [1] Damping of its position servo over the critical one; 0: the servo's velocity_gain holds. Resolved by the reader.
  double damping_ratio = 0;
};

/// A joint that follows another: position = offset + ratio * position of the other.
struct MimicDescription {
  std::string joint, leader, where;
  double ratio = 1;   ///< [1]
  double offset = 0;  ///< [rad | m]
};

/// A site that a string runs through, or a sphere or cylinder that it runs around, between two sites.
struct TendonPartDescription {
  std::string site;   ///< a frame of this kind; with a shape: on which side of it the string is, or empty
  std::string shape;  ///< ShapeDescription::name, or empty
};

/// A part of a spatial tendon from one pulley to the next.
struct TendonBranchDescription {
  double divisor = 1;  ///< [1] of its length
  std::vector<TendonPartDescription> parts;
};

/// A tendon that is held at the length that another one says: polynomial of that one's; both are counted from their lengths in the pose of
/// the file.
struct TieDescription {
  std::string other;  ///< slider of the other tendon; empty: none
  std::array<double, 5> polynomial{0, 1, 0, 0, 0};
};

/// A tendon over several joints, whose length is the sum of their positions times coefficients (multibody/joint_tendon.h), or through sites
/// (multibody/spatial_tendon.h).
struct TendonDescription {
  JointDescription
      joint;  ///< what acts along it: a slider without a body; its reference is the length in the pose of the file
  std::vector<std::pair<std::string, double>>
      parts{};                                  ///< joints and coefficients [m/rad | 1]; of one through sites none
  std::vector<TendonBranchDescription> path{};  ///< of one through sites
  std::optional<TieDescription> tie{};
};

/// Two frames of the robot that stand in one place, which closes a loop of its bodies.
struct LoopDescription {
  std::string name, where;
  std::string frame1, frame2;  ///< FrameDescription::name
  bool welded = false;         ///< their axes agree, too
};

/// One shape; of a mesh with several convex parts one for each.
struct ShapeDescription {
  std::string name, where;  ///< name may be empty
  PlacedShape placed;       ///< in the frame of the body
  std::string mesh;         ///< name of the mesh that it is made of; empty: a primitive
  Vec3d middle{};           ///< [m] of a part of a mesh: where the shape's origin is in the mesh frame
};

/// A mesh that is only drawn: it is read on first use.
struct VisualDescription {
  std::string name, where;
  std::string mesh;  ///< among the description's meshes
  Transformd place;  ///< of the mesh frame in the frame of the body
  Color color;
  bool mesh_colors = false;  ///< the mesh's materials count, where it has some
  std::string picture{};     ///< file of the picture that colors the mesh, instead of its materials; empty: none
  std::array<double, 2> picture_repeat{1, 1};  ///< VisualMesh
};

/// A named frame on a body.
struct FrameDescription {
  std::string name, where;
  std::string kind = "site";  ///< site, body (welded to this one), camera or loop (an end of one)
  Transformd place;           ///< in the frame of the body
  std::optional<Sole> box;    ///< of a box site: it may be a sole
};

struct BodyDescription {
  std::string name, where;
  int parent = -1;   ///< index; -1: the base
  Transformd place;  ///< in the parent's frame, joints in the pose of the file
  std::vector<JointDescription> joints;
  MassProperties solid;     ///< mass 0: massless
  std::string solid_where;  ///< where its mass is written; empty: nowhere, or computed from shapes
  std::vector<ShapeDescription> shapes;
  std::vector<VisualDescription> visuals;  ///< meshes; other visual shapes are shapes that do not collide
  std::vector<FrameDescription> frames;
};

/// A mesh of the file. A vertex v of the mesh file stands at scale * (orientation^T (v - position)) in the mesh frame.
struct MeshDescription {
  std::string name, where;
  std::filesystem::path file;  ///< empty: the vertices stand in the robot file
  Vec3d scale{1, 1, 1};        ///< [1]
  Transformd origin;           ///< of the mesh frame, in the file's frame
};

/// A sensor or camera of the file.
struct SensorDescription {
  std::string kind, name, frame, where;  ///< kind as the file calls it; frame: site, body, link or joint
  Transformd place;                      ///< in that frame
  double rate = 0;                       ///< [Hz] 0: the file has none
  std::string object_kind{};             ///< of `frame` in MJCF: site, xbody, body, joint, ...
  std::map<std::string, sensors::SignalSpec> signals{};  ///< by output of the sensor that it becomes; "": of all
  std::map<std::string, double> numbers{};               ///< SensorSpec::numbers
  std::map<std::string, std::string> texts{};  ///< SensorSpec::texts; what names objects, by names of the file
  std::string behind{};    ///< of a sensor of forces inside the robot: the body at which it is cut; empty: none
  std::string obstacle{};  ///< why it is not simulated; empty: no reason known
  std::string becomes{};   ///< SensorSpec::name (robot_sensors.h); empty: none
};

/// A posture of the file (MJCF key).
struct KeyframeDescription {
  std::string name, where;
  std::map<std::string, double> positions;  ///< [rad | m] of all joints, by name
  std::map<std::string, double> targets;    ///< [rad | m] of joints with a position servo; empty: the positions
  Transformd base;                          ///< in the world of the file
};

/// Two bodies with shapes that never touch each other (MJCF exclude).
struct ExclusionDescription {
  std::string body1, body2, where;
};

/// Two shapes of the robot, by name, that touch each other regardless of other rules (MJCF pair).
struct PairDescription {
  std::string shape1, shape2, where;
};

/// A part of the file without effect here: `murosimf check` shows the line, `murosimf run` the word.
struct Unused {
  std::string word;  ///< "geom.condim", "option", "world geom 'floor'"
  std::string line;  ///< "robot.xml:12: attribute 'condim' of geom is not used"
};

struct RobotDescription {
  std::string name;
  std::string base_joint;   ///< name of the joint that makes the base free; empty: none
  bool fixed_base = false;  ///< the base is bolted to the world (model/fixed_base.h)
  std::filesystem::path file;
  std::vector<BodyDescription> bodies;
  std::vector<MimicDescription> mimics;
  std::vector<TendonDescription> tendons;
  std::vector<LoopDescription> loops;
  std::vector<MeshDescription> meshes;
  std::vector<SensorDescription> sensors;
  std::vector<ExclusionDescription> exclusions;
  std::vector<PairDescription> pairs;
  std::vector<KeyframeDescription> keyframes;
  std::vector<std::string> warnings;  ///< file:line: what looks wrong, or is dropped because of `lenient`
  std::vector<std::string> notes;     ///< file:line: what was guessed, or used instead
  std::vector<Unused> unused;         ///< parts without effect here, each once
};

/// [rad | m] Position of a joint in the pose of the file; 0 if there is no such joint.
[[nodiscard]] double reference_of(const RobotDescription& description, const std::string& joint);

}  // namespace murosimf::robot_formats
