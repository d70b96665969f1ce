#include "murosimf/recording/scene_message.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/appearance/entity_appearance.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/recording/foxglove_messages.h"
#include "murosimf/render/render_scene.h"

namespace murosimf::recording {
namespace {

// Fields of foxglove.SceneEntity.
enum SceneField { arrows = 7, cubes = 8, spheres = 9, cylinders = 10, lines = 11, triangles = 12 };

constexpr std::string_view world_frame = "world";

void put_solid(ProtobufWriter& out, SceneField field, const Transformd& place, const Vec3d& size, const Color& color) {
  out.message(field, [&](ProtobufWriter& in) {
    put_pose(in, 1, place);
    put_vector(in, 2, size);
    if (field == cylinders) {
      in.number(3, 1);
      in.number(4, 1);
    }
    put_color(in, field == cylinders ? 5 : 3, color);
  });
}

/// Corners in each triangle: viewers need no indices then.
void put_triangles(ProtobufWriter& out, const Transformd& place, const render::RenderMesh& mesh, const Color& color) {
  out.message(triangles, [&](ProtobufWriter& in) {
    put_pose(in, 1, place);
    for (const render::Vertex& corner : mesh.corners) {
      put_vector(in, 2, rounded({corner.place[0], corner.place[1], corner.place[2]}, pose_step));
    }
    put_color(in, 3, color);
    in.packed_fixed32(5, mesh.triangles);
  });
}

void put_drawable(ProtobufWriter& out, const render::Drawable& drawable, const Transformd& place,
                  const std::vector<render::RenderMesh>& meshes) {
  const Vec3d size = 2.0 * drawable.scale;
  switch (drawable.form) {
    case render::Form::sphere:
    case render::Form::half_sphere:  // the end of a capsule: its other half is inside of the tube
      return put_solid(out, spheres, place, size, drawable.color);
    case render::Form::tube:
    case render::Form::cylinder: return put_solid(out, cylinders, place, size, drawable.color);
    case render::Form::box: return put_solid(out, cubes, place, size, drawable.color);
    case render::Form::mesh:
      MUROSIMF_ASSERT(static_cast<std::size_t>(drawable.mesh) < meshes.size());
      return put_triangles(out, place, meshes[static_cast<std::size_t>(drawable.mesh)], drawable.color);
  }
}

void put_stroke(ProtobufWriter& out, const Stroke& stroke) {
  out.message(lines, [&](ProtobufWriter& in) {
    in.number(3, stroke.width);
    for (const Vec3d& point : stroke.points) put_vector(in, 5, rounded(point, pose_step));
    put_color(in, 6, stroke.color);
  });
}

/// The rotation that maps x to the direction of `v`.
Mat3d along(const Vec3d& v) {
  MUROSIMF_ASSERT(norm(v) > 0);
  const Vec3d x = (1 / norm(v)) * v;
  const Vec3d helper = std::abs(x.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0};
  const Vec3d side = cross(helper, x);
  const Vec3d y = (1 / norm(side)) * side;
  return {x, y, cross(x, y)};
}

void put_arrow(ProtobufWriter& out, const ContactMark& contact) {
  constexpr double meters_per_newton = 1.0 / 500,
                   thickness = 0.006;  // those of a standing robot are about as long as its feet
  const double length = norm(contact.force);
  if (!(length > 0)) return;
  out.message(arrows, [&](ProtobufWriter& in) {
    put_pose(in, 1, {contact.point, along(contact.force)}, point_step);
    in.number(2, rounded(length * meters_per_newton, point_step));
    in.number(3, thickness);
    in.number(4, 2 * thickness);
    in.number(5, 2 * thickness);
    put_color(in, 6, {0.9, 0.3, 0.1});
  });
}

void put_head(ProtobufWriter& out, Duration time, std::string_view frame, std::string_view id) {
  put_time(out, 1, time);
  out.text(2, frame);
  out.text(3, id);
}

}  // namespace

SceneLooks::SceneLooks(const scene::Scene& scene, const std::vector<RecordedEntity>& entities) {
  appearance::AppearanceLibrary library(appearance::PictureUse::by_triangle);
  render::RenderScene looks(scene.simulation().world(), scene.moving_entities(),
                            [&](const Entity& entity) { return library.appearance(entity); });
  const auto part_named = [this](int entity, const std::string& id, std::string_view frame) -> std::string& {
    const auto found = std::ranges::find(parts_, id, &Part::id);
    if (found != parts_.end()) return found->contents;
    parts_.push_back({.entity = entity, .id = id, .frame = std::string(frame), .contents = {}});
    return parts_.back().contents;
  };
  for (const render::Drawable& drawable : looks.drawables()) {
    const Entity* owner = looks.owner(drawable);
    const auto moving = std::ranges::find(entities, owner, &RecordedEntity::entity);
    const bool moves = moving != entities.end();
    MUROSIMF_ASSERT(owner != nullptr);
    const FixedObject at = owner->model().placement(drawable.object);
    const Transformd in_link = Transformd{at.offset, at.turn} * drawable.place;
    std::string& contents = moves ? part_named(static_cast<int>(moving - entities.begin()),
                                               moving->links[at.link].frame, moving->links[at.link].frame)
                                  : part_named(-1, owner->name(), world_frame);
    ProtobufWriter out(contents);
    put_drawable(out, drawable, in_link, looks.meshes());
  }
  if (const Markings* markings = looks.markings()) {
    ProtobufWriter out(part_named(-1, "lines", world_frame));
    for (const Stroke& stroke : markings->strokes) put_stroke(out, stroke);
  }
}

std::string SceneLooks::message(Duration time, const std::vector<char>& present) const {
  std::string bytes;
  ProtobufWriter out(bytes);
  for (const Part& part : parts_) {
    const auto entity_number = static_cast<std::size_t>(std::max(part.entity, 0));
    const bool there = part.entity < 0 || (entity_number < present.size() && present[entity_number] != 0);
    if (there) {
      std::string entity;
      ProtobufWriter in(entity);
      put_head(in, time, part.frame, part.id);
      in.varint(5, 1);  // frame_locked: moves with its frame
      out.bytes(2, entity + part.contents);
    } else {
      out.message(1, [&](ProtobufWriter& deletion) {
        put_time(deletion, 1, time);
        deletion.text(3, part.id);
      });
    }
  }
  return bytes;
}

/// One entity of the message: it replaces the arrows of the frame before.
std::string force_arrows(Duration time, const std::vector<ContactMark>& contacts) {
  std::string bytes;
  ProtobufWriter(bytes).message(2, [&](ProtobufWriter& entity) {
    put_head(entity, time, world_frame, "forces");
    for (const ContactMark& contact : contacts) put_arrow(entity, contact);
  });
  return bytes;
}

}  // namespace murosimf::recording
