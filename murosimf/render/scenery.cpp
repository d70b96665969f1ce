#include "murosimf/render/scenery.h"

#include <algorithm>

#include "murosimf/collision/colliding_shapes.h"
#include "murosimf/model/properties.h"
#include "murosimf/sensors/view_source.h"

namespace murosimf::render {
namespace {

bool is_default(const Color& color) {
  const Color gray;
  return color.red == gray.red && color.green == gray.green && color.blue == gray.blue;
}

double farthest(const Solid& solid) {
  double square = 0;
  for (const Corner& corner : solid.corners) {
    const auto& [x, y, z] = corner.place;
    square = std::max(square, static_cast<double>(x * x + y * y + z * z));
  }
  return std::sqrt(square);
}

}  // namespace

Scenery::Scenery(const World& world, const std::vector<Entity*>& movers, const LooksOf& looks)
    : movers_(movers), labels_{"background", "ground", "line", "goal"} {
  for (const Entity* mover : movers) labels_.push_back(mover->name());
  for (const auto& entity : world.entities()) add_entity(*entity, movers, looks);
  std::stable_sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) {
    return a.owner != b.owner ? a.owner < b.owner : a.object < b.object;
  });
}

void Scenery::declare(Setup& setup) {
  for (Entity* mover : movers_) {
    Setup other = setup.of(*mover);
    (void)other.read(properties::position);
    (void)other.read(properties::orientation);
    (void)other.read(properties::linear_velocity);
    (void)other.read(properties::angular_velocity);
  }
  locate();
}

void Scenery::locate() {
  for (Owner& owner : owners_) {
    const auto values = [&](const auto& property) {
      const auto* column = owner.entity->find(property);
      return column ? std::span(column->values) : decltype(std::span(column->values)){};
    };
    if (!owner.entity->find(properties::orientation)) continue;
    owner.r = values(properties::position);
    owner.R = values(properties::orientation);
    owner.v = values(properties::linear_velocity);
    owner.w = values(properties::angular_velocity);
  }
}

void Scenery::add_entity(Entity& entity, const std::vector<Entity*>& movers, const LooksOf& looks) {
  const auto mover = std::find(movers.begin(), movers.end(), &entity);
  const bool moves = mover != movers.end();
  const int owner = static_cast<int>(owners_.size());
  owners_.push_back({&entity, collision::rest_poses(entity.model()), {}, {}, {}, {}});
  const auto label =
      static_cast<std::uint16_t>(moves ? static_cast<int>(sensors::label_mover) + (mover - movers.begin())
                                       : static_cast<int>(sensors::label_goal));
  const Model& model = entity.model();
  for (const int i : model.having(properties::markings)) {
    if (!markings_) markings_ = model.find(properties::markings, i);
  }
  const ModelLooks own = looks ? looks(entity) : ModelLooks{};
  for (const int i : model.having(properties::shapes)) {
    if (std::find(own.instead.begin(), own.instead.end(), i) != own.instead.end()) continue;
    for (const PlacedShape& shape : *model.find(properties::shapes, i)) {
      add_shape(owner, i, shape, is_default(shape.color) ? entity.options().color : shape.color, label);
    }
  }
  add_looks(owner, entity, own, label);
}

void Scenery::add_looks(int owner, const Entity& entity, const ModelLooks& looks, std::uint16_t label) {
  for (const Looks& part : looks.parts) {
    Piece piece{.owner = owner, .object = part.object, .form = Form::mesh, .label = label};
    piece.color = is_default(part.color) ? entity.options().color : part.color;
    piece.radius = farthest(part.solid);
    piece.mesh = add_mesh(part.solid, nullptr);
    pieces_.push_back(piece);
  }
}

/// Meshes are told apart by their corners: equal robots share them.
int Scenery::add_mesh(Solid solid, const void* identity) {
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    const bool same = identity ? identities_[i] == identity
                               : meshes_[i].triangles == solid.triangles &&
                                     std::equal(meshes_[i].corners.begin(), meshes_[i].corners.end(),
                                                solid.corners.begin(), solid.corners.end(),
                                                [](const Corner& a, const Corner& b) { return !(a < b || b < a); });
    if (same) return static_cast<int>(i);
  }
  meshes_.push_back(std::move(solid));
  identities_.push_back(identity);
  return static_cast<int>(meshes_.size()) - 1;
}

void Scenery::add_shape(int owner, int object, const PlacedShape& shape, const Color& color, std::uint16_t label) {
  Piece piece{
      .owner = owner, .object = object, .place = {shape.position, shape.orientation}, .color = color, .label = label};
  const auto add = [&](Form form, const Vec3d& scale) {
    piece.form = form;
    piece.scale = scale;
    pieces_.push_back(piece);
  };
  piece.radius = bounding_radius(shape.shape);
  if (const auto* sphere = std::get_if<Sphere>(&shape.shape)) {
    add(Form::sphere, {sphere->radius, sphere->radius, sphere->radius});
  } else if (const auto* ellipsoid = std::get_if<Ellipsoid>(&shape.shape)) {
    add(Form::sphere, ellipsoid->semi_axes);
  } else if (const auto* box = std::get_if<Box>(&shape.shape)) {
    add(Form::box, box->half_size);
  } else if (const auto* cylinder = std::get_if<Cylinder>(&shape.shape)) {
    add(Form::cylinder, {cylinder->radius, cylinder->radius, cylinder->half_length});
  } else if (const auto* capsule = std::get_if<Capsule>(&shape.shape)) {
    const double r = capsule->radius, h = capsule->half_length;
    add(Form::tube, {r, r, h});
    piece.radius = r;
    for (const double side : {1.0, -1.0}) {
      piece.place.position = shape.position + shape.orientation * Vec3d{0, 0, side * h};
      piece.place.orientation = side > 0 ? shape.orientation : shape.orientation * rotation_x(pi);
      add(Form::half_sphere, {r, r, r});
    }
  } else if (const auto* convex = std::get_if<Convex>(&shape.shape)) {
    piece.mesh = add_mesh(solid_of(*convex->hull), convex->hull.get());
    add(Form::mesh, {1, 1, 1});
  }
}

geometry::Pose Scenery::pose_of(const Owner& owner, int object, double ahead) const {
  const auto i = static_cast<std::size_t>(object);
  if (owner.r.empty() || owner.R.empty()) return owner.rest[i];
  geometry::Pose pose{owner.r[i], owner.R[i]};
  if (ahead == 0) return pose;
  if (!owner.v.empty()) pose.position += ahead * owner.v[i];
  const double rate = owner.w.empty() ? 0 : norm(owner.w[i]);
  if (rate > 0) pose.orientation = rotation((1 / rate) * owner.w[i], ahead * rate) * pose.orientation;
  return pose;
}

}  // namespace murosimf::render
