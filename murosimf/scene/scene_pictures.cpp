#include "murosimf/scene/scene_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/appearance/entity_appearance.h"
#include "murosimf/files/output_file.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/render/field_picture.h"
#include "murosimf/render/renderer.h"

namespace murosimf::scene {
namespace {

/// [m] Path in the world frame; ends at the present place.
std::vector<Vec3d> points_of(const SceneParts& parts, Entity& entity) {
  std::vector<Vec3d> points;
  if (parts.recorder) {
    points = std::ranges::find(parts.recorder->paths(), &entity, &PathRecorder::Path::entity)->points;
  }
  points.push_back(entity.base().get(properties::position));
  return points;
}

/// [m] For shapes in the orientation of their frame: cylinders and capsules upright.
double radius_from_above(const Shape& shape) {
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape)) return cylinder->radius;
  if (const Capsule* capsule = std::get_if<Capsule>(&shape)) return capsule->radius;
  if (const Box* box = std::get_if<Box>(&shape)) return std::hypot(box->half_size.x, box->half_size.y);
  return bounding_radius(shape);
}

render::Path path_of(const SceneParts& parts, Entity& entity) {
  render::Path path;
  path.name = entity.name();
  path.color = entity.options().color;
  path.points = points_of(parts, entity);
  path.heading = heading(entity.base().get(properties::orientation));
  path.is_ball = &entity == parts.ball;
  path.number = appearance::jersey_number(entity.name());
  if (path.is_ball) path.size = parts.spec.ball->radius;
  if (const scene_file::BodySpec* body = body_spec(parts.spec, entity)) {  // drawn as discs, like the ball
    path.is_ball = true;
    if (body->shape) path.size = radius_from_above(*body->shape);
  }
  return path;
}

}  // namespace

void write_picture(const Scene& scene, const std::filesystem::path& file) {
  const SceneParts& parts = scene.parts();
  std::vector<render::Path> paths;
  for (Entity* entity : parts.moving_entities) {
    if (entity->present()) paths.push_back(path_of(parts, *entity));
  }
  const Markings* markings = parts.field->model().find(properties::markings, 0);
  MUROSIMF_ASSERT(markings != nullptr);
  const std::string title = fmt::format("{}: {:.0f} s", parts.spec.name, seconds(parts.simulation->now()));
  files::write_file(file, render::field_picture_png(*markings, paths, {.title = title}));
}

std::unique_ptr<render::Renderer> make_renderer(Scene& scene, const scene_file::LightSpec& light) {
  return make_renderer(scene.parts(), light);
}

ScenePainter::ScenePainter(Scene& scene, ForPeople for_people, Prepare prepare)
    : scene_(scene), for_people_(std::move(for_people)), prepare_(std::move(prepare)) {
  (void)renderer();
}

ScenePainter::~ScenePainter() = default;

render::Renderer& ScenePainter::renderer() {
  const int changes = scene_.parts().changes_to_see;
  if (renderer_ && changes == changes_seen_) return *renderer_;
  // a new renderer for any change: meshes, instances and light are built in its constructor only
  scene_file::LightSpec light = scene_.spec().light;
  for_people_(light);
  renderer_ = make_renderer(scene_, light);
  if (prepare_) prepare_(*renderer_);
  changes_seen_ = changes;
  return *renderer_;
}

}  // namespace murosimf::scene
