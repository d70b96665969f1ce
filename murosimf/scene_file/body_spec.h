/// body_spec.h - a body of a scene that is no robot: a box, a sphere, a ramp; what it is, and its model.
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
  collision::ReliefPtr relief;     ///< a height field or a mesh that stands; else null
  std::optional<VisualMesh> mesh;  ///< for the eye: what the shape is the hull of
  Vec3d center;                    ///< [m] of mass, of a shape that moves, in the shape's frame
  std::string model;               ///< name or file
  double mass = 0;                 ///< [kg] of a shape that moves
  std::string material = "plastic";
  double drag = air::usual_drag;  ///< [1] C_d of a sphere that moves (air/air.h)
  double lift = air::usual_lift;  ///< [1] what its C_l comes to at high spin
  Color color{0.62, 0.62, 0.66};
  /// [m] x and y of its middle (a model: of its base), z of its lowest point; of uneven ground: of its frame.
  Vec3d position;
  double heading = 0;          ///< [rad] about the vertical, after the others
  double roll = 0, pitch = 0;  ///< [rad] about its x, then its y
  Vec3d velocity;              ///< [m/s] world, at the start
  Vec3d angular_velocity;      ///< [rad/s] world, at the start
  bool jitters = false;        ///< its place varies from seed to seed as robots' do
  bool is_static = false;      ///< it stands there for good, like a goal
  std::string contact = "implicit_stick";
  bool present = true;  ///< at the start
};

/// How it is turned at the start: body axes to world axes.
[[nodiscard]] Mat3d attitude_of(const BodySpec& body);

/// One object, called after the body. For shapes that move.
[[nodiscard]] ModelPtr body_model(const BodySpec& body);

/// The same as a branch of the field's model.
[[nodiscard]] Chain static_body(const BodySpec& body);

}  // namespace murosimf::scene_file
