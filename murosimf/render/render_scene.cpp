#include "murosimf/render/render_scene.h"

#include <algorithm>

#include "murosimf/collision/colliding_shapes.h"
#include "murosimf/collision/contact_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/feet.h"
#include "murosimf/model/properties.h"
#include "murosimf/sensors/view_source.h"

namespace murosimf::render {
namespace {

double farthest(const RenderMesh& solid) {
  double square = 0;
  for (const Vertex& corner : solid.corners) {
    const auto& [x, y, z] = corner.place;
    square = std::max(square, static_cast<double>(x * x + y * y + z * z));
  }
  return std::sqrt(square);
}

/// A model that is nothing but one sphere.
bool is_ball(const Model& model) {
  const Shapes* shapes = model.size() == 1 ? model.find(properties::shapes, 0) : nullptr;
  return shapes && shapes->size() == 1 && std::holds_alternative<Sphere>(shapes->front().shape);
}

/// Gray: the color of shapes without one.
bool is_default(const Color& color) {
  const Color gray;
  return color.red == gray.red && color.green == gray.green && color.blue == gray.blue;
}

void find_box(const std::vector<RenderMesh>& meshes, Drawable& drawable) {
  drawable.box_half = drawable.scale;
  if (drawable.form != Form::mesh) return;
  Vec3d low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
  for (const Vertex& corner : meshes[static_cast<std::size_t>(drawable.mesh)].corners) {
    const Vec3d p{corner.place[0], corner.place[1], corner.place[2]};
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  drawable.box_middle = 0.5 * (low + high);
  drawable.box_half = 0.5 * (high - low);
}

}  // namespace

Color color_on(const Entity& entity, const Color& color) {
  Color shown = is_default(color) ? entity.options().color : color;
  shown.alpha = color.alpha;
  return shown;
}

EntityAppearance appearance_of_shapes(const Entity& entity) {
  EntityAppearance appearance;
  for (const int i : entity.model().having(properties::shapes)) {
    for (const PlacedShape& shape : *entity.model().find(properties::shapes, i))
      appearance.shapes.push_back({i, shape});
  }
  return appearance;
}

RenderScene::RenderScene(const World& world, const std::vector<Entity*>& moving_entities,
                         const AppearanceOf& appearance) {
  for (const auto& entity : world.entities()) add_entity(*entity, moving_entities, appearance);
  for (Drawable& drawable : drawables_) {
    find_box(meshes_, drawable);
    drawable.paneled = drawable.form == Form::sphere && is_ball(owner(drawable)->model());
  }
  // By owner and object: for_drawables() computes each pose once.
  std::stable_sort(drawables_.begin(), drawables_.end(), [](const Drawable& a, const Drawable& b) {
    return a.owner != b.owner ? a.owner < b.owner : a.object < b.object;
  });
}

void RenderScene::locate() {
  for (Owner& owner : owners_) {
    const auto values = [&](const auto& property) {
      const auto* column = owner.entity->find(property);
      return column ? std::span(column->values) : decltype(std::span(column->values)){};
    };
    // Entities without an orientation column do not move: they stay at their rest poses.
    if (!owner.entity->find(properties::orientation)) continue;
    owner.r = values(properties::position);
    owner.R = values(properties::orientation);
    owner.v = values(properties::linear_velocity);
    owner.w = values(properties::angular_velocity);
    owner.stance_foot = values(properties::stance_foot);
    owner.dynamic = values(properties::dynamic);
    MUROSIMF_ASSERT(owner.r.empty() || owner.r.size() == owner.R.size());
  }
}

void RenderScene::mark_standing_feet(const Color& color) {
  standing_ = color;
  for (Drawable& drawable : drawables_) {
    const Model& model = owners_[drawable.owner].entity->model();
    const std::vector<Foot> feet = feet_of(model);
    for (std::size_t i = 0; i < feet.size(); ++i) {
      if (belongs_to(model, feet[i], drawable.object)) drawable.foot = static_cast<int>(i);
    }
  }
}

void RenderScene::add_entity(Entity& entity, const std::vector<Entity*>& moving_entities,
                             const AppearanceOf& appearance) {
  const auto moving_entity = std::find(moving_entities.begin(), moving_entities.end(), &entity);
  const bool moves = moving_entity != moving_entities.end();
  const int owner = static_cast<int>(owners_.size());
  owners_.push_back({&entity, collision::rest_poses(entity.model()), {}, {}, {}, {}});
  const auto label = static_cast<std::uint16_t>(moves ? static_cast<int>(sensors::label_moving_entity) +
                                                            (moving_entity - moving_entities.begin())
                                                      : static_cast<int>(sensors::label_goal));
  const Model& model = entity.model();
  for (const int i : model.having(properties::markings)) {
    if (!markings_) markings_ = model.find(properties::markings, i);
  }
  const EntityAppearance own = appearance(entity);
  for (const ShownShape& shown : own.shapes) {
    if (shown.placed.color.alpha <= 0) continue;
    if (!moves && shown.placed.surface.material == "net") {
      add_net(owners_.back().rest[static_cast<std::size_t>(shown.object)] * shown.placed.place(), shown.placed.shape);
    }
    add_shape({.owner = owner,
               .object = shown.object,
               .color = color_on(entity, shown.placed.color),
               .own_color = is_default(shown.placed.color),
               .label = label},
              shown.placed);
  }
  for (const ShownMesh& part : own.meshes) {
    if (part.color.alpha <= 0) continue;
    Drawable drawable{.owner = owner,
                      .object = part.object,
                      .form = Form::mesh,
                      .color = part.as_it_is ? part.color : color_on(entity, part.color),
                      .own_color = !part.as_it_is && is_default(part.color),
                      .label = label};
    drawable.radius = farthest(part.solid);
    drawable.mesh = add_mesh(part.solid);
    drawables_.push_back(drawable);
  }
}

/// Adds a mesh. Meshes of equal corners are shared: those of equal robots. Equal `identity` makes the comparison faster.
int RenderScene::add_mesh(const RenderMesh& solid, const void* identity) {
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    const bool same = identity ? identities_[i] == identity
                               : meshes_[i].triangles == solid.triangles && meshes_[i].corners == solid.corners &&
                                     meshes_[i].picture == solid.picture && meshes_[i].places == solid.places;
    if (same) return static_cast<int>(i);
  }
  meshes_.push_back(solid);
  identities_.push_back(identity);
  MUROSIMF_ASSERT(meshes_.size() == identities_.size());
  return static_cast<int>(meshes_.size()) - 1;
}

void RenderScene::add_net(const Transformd& at, const Shape& shape) {
  const Box* box = std::get_if<Box>(&shape);
  if (!box || box->half_size.z > std::min(box->half_size.x, box->half_size.y)) return;  // the net's walls
  const double x = std::abs(at.position.x);
  nets_.push_back({.side = at.position.x > 0 ? 1.0 : -1.0,
                   .front = x - box->half_size.x,
                   .rear = x + box->half_size.x,
                   .half_width = box->half_size.y,
                   .high = at.position.z,
                   .low = 0});
}

void RenderScene::add_shape(Drawable drawable, const PlacedShape& shape) {
  drawable.place = {shape.position, shape.orientation};
  drawable.radius = bounding_radius(shape.shape);
  const auto add = [&](Form form, const Vec3d& scale) {
    drawable.form = form;
    drawable.scale = scale;
    drawables_.push_back(drawable);
  };
  if (const auto* sphere = std::get_if<Sphere>(&shape.shape)) {
    add(Form::sphere, {sphere->radius, sphere->radius, sphere->radius});
  } else if (const auto* ellipsoid = std::get_if<Ellipsoid>(&shape.shape)) {
    add(Form::sphere, ellipsoid->semi_axes);
  } else if (const auto* box = std::get_if<Box>(&shape.shape)) {
    add(Form::box, box->half_size);
  } else if (const auto* cylinder = std::get_if<Cylinder>(&shape.shape)) {
    add(Form::cylinder, {cylinder->radius, cylinder->radius, cylinder->half_length});
  } else if (const auto* capsule = std::get_if<Capsule>(&shape.shape)) {
    add_round(drawable, *capsule);
  } else if (const auto* convex = std::get_if<Convex>(&shape.shape)) {
    drawable.mesh = add_mesh(render_mesh_of(*convex->hull), convex->hull.get());
    add(Form::mesh, {1, 1, 1});
  }
}

/// Adds a capsule: a tube with two half spheres.
void RenderScene::add_round(Drawable drawable, const Capsule& capsule) {
  const double r = capsule.radius, h = capsule.half_length;
  const Transformd middle = drawable.place;
  drawable.form = Form::tube;
  drawable.scale = {r, r, h};
  drawables_.push_back(drawable);
  drawable.form = Form::half_sphere;
  drawable.scale = {r, r, r};
  drawable.radius = r;
  for (const double side : {1.0, -1.0}) {
    drawable.place.position = middle.position + middle.orientation * Vec3d{0, 0, side * h};
    drawable.place.orientation = side > 0 ? middle.orientation : middle.orientation * rotation_x(pi);
    drawables_.push_back(drawable);
  }
}

void RenderScene::label_pieces() {
  for (std::size_t i = 0; i < drawables_.size(); ++i)
    drawables_[i].label = static_cast<std::uint16_t>(first_piece_label + i);
}

bool RenderScene::is_present(int owner) const {
  const auto i = static_cast<std::size_t>(owner);
  MUROSIMF_ASSERT(i < owners_.size() && (!moment_ || moment_->frame != nullptr));
  if (!moment_) return owners_[i].entity->present();
  return i < moment_->frame->present.size() && moment_->frame->present[i];
}

int RenderScene::standing_foot(int owner) const {
  const auto i = static_cast<std::size_t>(owner);
  MUROSIMF_ASSERT(i < owners_.size());
  if (!moment_) return owners_[i].standing_foot();
  return i < moment_->standing_feet.size() ? moment_->standing_feet[i] : -2;
}

/// A piece that the moment shows otherwise; nothing: it is shown as it is.
std::optional<Drawable> RenderScene::as_shown(const Drawable& drawable) const {
  const auto owner = static_cast<std::size_t>(drawable.owner);
  const bool stands = drawable.foot >= 0 && drawable.foot == standing_foot(drawable.owner);
  const bool dressed = moment_ && drawable.own_color && owner < moment_->colors.size() && moment_->colors[owner];
  const bool plain = moment_ && drawable.paneled && !moment_->panels;
  if (!stands && !dressed && !plain) return std::nullopt;
  Drawable shown = drawable;
  if (dressed) shown.color = *moment_->colors[owner];
  if (stands) shown.color = standing_;
  if (plain) shown.paneled = false;
  return shown;
}

Transformd RenderScene::pose_of(int number, int object, double ahead) const {
  MUROSIMF_ASSERT(static_cast<std::size_t>(number) < owners_.size());
  const auto i = static_cast<std::size_t>(object);
  const Owner& owner = owners_[static_cast<std::size_t>(number)];
  MUROSIMF_ASSERT(i < owner.rest.size());
  if (owner.r.empty() || owner.R.empty()) return owner.rest[i];
  if (moment_) {
    const std::size_t row = moment_->frame->first[static_cast<std::size_t>(number)] + i;
    MUROSIMF_ASSERT(row < moment_->frame->position.size() && row < moment_->frame->orientation.size());
    return {moment_->frame->position[row], moment_->frame->orientation[row]};
  }
  MUROSIMF_ASSERT(i < owner.r.size() && i < owner.R.size());
  Transformd pose{owner.r[i], owner.R[i]};
  if (ahead == 0) return pose;
  if (!owner.v.empty()) pose.position += ahead * owner.v[i];
  const double rate = owner.w.empty() ? 0 : norm(owner.w[i]);
  if (rate > 0) pose.orientation = rotation((1 / rate) * owner.w[i], ahead * rate) * pose.orientation;
  return pose;
}

}  // namespace murosimf::render
