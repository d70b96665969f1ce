#include "murosimf/scene_file/body_spec.h"

#include <memory>
#include <utility>
#include <variant>

#include "murosimf/air/air_properties.h"
#include "murosimf/collision/ground_points.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/robot_formats/mass_properties.h"

namespace murosimf::scene_file {
namespace {

PlacedShape shape_of(const BodySpec& body) {
  MUROSIMF_ASSERT(body.shape.has_value());
  PlacedShape placed;
  placed.shape = *body.shape;
  placed.position = -body.center;
  placed.surface.material = body.material;
  placed.color = body.color;
  return placed;
}

Chain uneven_ground(const BodySpec& body) {
  MUROSIMF_ASSERT(body.relief != nullptr);
  Chain chain;
  chain.translation(body.position).rotation(attitude_of(body), body.name);
  chain.with(properties::shapes, body.relief->prisms({.material = body.material}, body.color));
  return chain.with(properties::relief, body.relief).endpoint();
}

}  // namespace

Mat3d attitude_of(const BodySpec& body) {
  // fixed axes: pitch first, then roll, then heading, as the keys are documented
  return rotation_z(body.heading) * (rotation_y(body.pitch) * rotation_x(body.roll));
}

ModelPtr body_model(const BodySpec& body) {
  MUROSIMF_ASSERT(body.shape.has_value());
  Chain chain;
  chain.base(body.name)
      .with(properties::mass, body.mass)
      .with(properties::inertia, body.mass * robot_formats::unit_inertia(*body.shape))
      .with(properties::shapes, Shapes{shape_of(body)});
  if (body.mesh) chain.with(properties::visuals, Visuals{*body.mesh});
  if (std::holds_alternative<Sphere>(*body.shape)) {
    chain.with(properties::drag_coefficient, body.drag).with(properties::lift_coefficient, body.lift);
  }
  return std::make_shared<const Model>(shape_name(*body.shape), std::move(chain));
}

Chain static_body(const BodySpec& body) {
  if (body.relief) return uneven_ground(body);
  const PlacedShape shape = shape_of(body);
  const Mat3d R = attitude_of(body);
  // `position` has the lowest point; the frame is raised by its distance below the origin
  const double lowest = collision::lowest_point(collision::ground_shape(0, shape, 0), {}, R, {});
  Chain chain;
  chain.translation({body.position.x, body.position.y, body.position.z - lowest});
  return chain.rotation(R, body.name).with(properties::shapes, {shape}).endpoint();
}

}  // namespace murosimf::scene_file
