/// body_spec.h - a body of a scene other than a robot: a box, a sphere, a ramp; its description and its model.
#pragma once

#include <optional>
#include <string>

#include "murosimf/air/air_options.h"
#include "murosimf/collision/relief/relief.h"
#include "murosimf/math/mat3.h"
#include "murosimf/model/model.h"
#include "murosimf/model/shape.h"
#include "murosimf/model/visual_mesh.h"

namespace murosimf::scene_file {

struct BodySpec {
  std::string name;
  std::string where;               ///< place in the scene file, for messages
  std::optional<Shape> shape;      ///< empty: the body is a model, or uneven ground
  collision::ReliefPtr relief;     ///< a height field or a static mesh; else null
  std::optional<VisualMesh> mesh;  ///< visual mesh; the shape is its convex hull
  Vec3d center;                    ///< [m] center of mass of a moving shape, in the shape's frame
  std::string model;               ///< name or file
  double mass = 0;                 ///< [kg] of a moving shape
  std::string material = "plastic";
  double drag = air::usual_drag;  ///< [1] C_d of a moving sphere (air/air.h)
  double lift = air::usual_lift;  ///< [1] limit of its C_l at high spin
  Color color{0.62, 0.62, 0.66};
  /// [m] x and y of its middle (a model: of its base), z of its lowest point; of uneven ground: of its frame.
  Vec3d position;
  double heading = 0;          ///< [rad] about the vertical, after roll and pitch
  double roll = 0, pitch = 0;  ///< [rad] about its x, then its y
  Vec3d velocity;              ///< [m/s] world, at the start
  Vec3d angular_velocity;      ///< [rad/s] world, at the start
  bool jitters = false;        ///< its place varies with the seed, like that of robots
  bool is_static = false;      ///< immovable, like a goal
  std::string contact = "implicit_stick";
  bool present = true;  ///< at the start
};

/// Initial attitude: body axes to world axes.
[[nodiscard]] Mat3d attitude_of(const BodySpec& body);

/// A model of one object with the body's name. For moving shapes.
[[nodiscard]] ModelPtr body_model(const BodySpec& body);

/// The same as a branch of the field's model, for static shapes.
[[nodiscard]] Chain static_body(const BodySpec& body);

}  // namespace murosimf::scene_file
