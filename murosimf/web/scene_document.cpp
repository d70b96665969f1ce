#include "murosimf/web/scene_document.h"

#include <algorithm>
#include <array>
#include <map>

#include "murosimf/appearance/entity_appearance.h"
#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/files/json_document.h"
#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/model/properties.h"
#include "murosimf/render/render_scene.h"
#include "murosimf/scene/scene_cameras.h"
#include "murosimf/sensors/camera_frame.h"
#include "murosimf/web/json_line.h"
#include "murosimf/web/little_endian.h"
#include "murosimf/web/look_document.h"

namespace murosimf::web {
namespace {

using nlohmann::json;

double short_number(double value) { return std::round(value * 1e5) / 1e5; }

json numbers(const Vec3d& v) { return {short_number(v.x), short_number(v.y), short_number(v.z)}; }

json color_of(const Color& color) {
  json rgba{short_number(color.red), short_number(color.green), short_number(color.blue)};
  if (color.alpha < 1) rgba.push_back(short_number(color.alpha));
  return rgba;
}

json place_of(const Transformd& place) {
  const Quaterniond q = from_matrix(place.orientation);
  return {short_number(place.position.x),
          short_number(place.position.y),
          short_number(place.position.z),
          short_number(q.x),
          short_number(q.y),
          short_number(q.z),
          short_number(q.w)};
}

const char* form_name(render::Form form) {
  switch (form) {
    case render::Form::sphere: return "sphere";
    case render::Form::half_sphere: return "half_sphere";
    case render::Form::tube: return "tube";
    case render::Form::cylinder: return "cylinder";
    case render::Form::box: return "box";
    case render::Form::mesh: return "mesh";
  }
  return "";
}

bool moves(const Entity& entity) { return entity.find(properties::position) && entity.find(properties::orientation); }

std::string kind_of(const scene::SceneParts& parts, const Entity& entity) {
  if (std::ranges::find(parts.robots, &entity) != parts.robots.end()) return "robot";
  if (&entity == parts.ball) return "ball";
  return &entity == parts.field ? "field" : "body";
}

/// Collects text and numbers of a document.
class Writer {
 public:
  explicit Writer(const scene::Scene& scene) : scene_(scene) {}

  SceneDocument write() {
    const World& world = scene_.simulation().world();
    appearance::AppearanceLibrary library(appearance::PictureUse::by_triangle);
    const render::RenderScene looks(world, scene_.moving_entities(),
                                    [&](const Entity& entity) { return library.appearance(entity); });
    document_.entities = world.entities().size();
    for (std::size_t i = 0; i < world.entities().size(); ++i) add_entity(*world.entities()[i], i);
    for (const render::Drawable& drawable : looks.drawables()) add_part(looks, drawable);
    for (const ShownEntity& shown : document_.moving) add_bodies(world, shown);
    for (const render::RenderMesh& mesh : looks.meshes()) add_mesh(mesh);
    if (const Markings* markings = looks.markings()) add_ground(*markings);
    text_["look"] = look_document(scene::light_of(scene_.spec().light), looks, data_);
    text_["schema"] = files::json_schema("web_scene");
    text_["name"] = scene_.spec().name;
    text_["warnings"] = library.warnings();
    for (const catalog::LevelType& level : catalog::levels()) text_["levels"].push_back(level.name);
    for (const catalog::ContactLawType& law : catalog::contacts()) text_["contacts"].push_back(law.name);
    assemble();
    return std::move(document_);
  }

  /// The order of the entities is that of the poses.
 private:
  void add_entity(const Entity& entity, std::size_t index) {
    json one{{"name", entity.name()},
             {"kind", kind_of(scene_.parts(), entity)},
             {"team", entity.options().team},
             {"color", color_of(entity.options().color)},
             {"moves", moves(entity)}};
    for (const sensors::CameraFrame* frame : sensors::frames_of(entity)) one["cameras"].push_back(frame->info->name);
    rows_[&entity] = moves(entity) ? static_cast<int>(document_.moving.size()) : -1;
    if (moves(entity)) document_.moving.push_back({.index = index, .objects = {0}});
    text_["entities"].push_back(std::move(one));
    entities_[&entity] = static_cast<int>(index);
  }

  /// Index of the link among the sent ones of its entity; adds it if missing.
  int body_of(int row, int link) {
    MUROSIMF_ASSERT(row >= 0 && static_cast<std::size_t>(row) < document_.moving.size());
    std::vector<int>& objects = document_.moving[static_cast<std::size_t>(row)].objects;
    const auto found = std::ranges::find(objects, link);
    if (found != objects.end()) return static_cast<int>(found - objects.begin());
    objects.push_back(link);
    return static_cast<int>(objects.size()) - 1;
  }

  void add_part(const render::RenderScene& looks, const render::Drawable& drawable) {
    const Entity* owner = looks.owner(drawable);
    MUROSIMF_ASSERT(owner != nullptr);
    const FixedObject at = owner->model().placement(drawable.object);
    const Transformd in_link = Transformd{at.offset, at.turn} * drawable.place;
    json part{{"entity", entities_[owner]},
              {"form", form_name(drawable.form)},
              {"place", place_of(in_link)},
              {"scale", numbers(drawable.scale)},
              {"color", color_of(drawable.color)}};
    if (const int row = rows_[owner]; row >= 0) {
      part["body"] = body_of(row, owner->model().tree().links[static_cast<std::size_t>(at.link)].object);
    }
    if (drawable.mesh >= 0) part["mesh"] = drawable.mesh;
    if (drawable.paneled) part["panels"] = true;
    text_["parts"].push_back(std::move(part));
  }

  void add_bodies(const World& world, const ShownEntity& shown) {
    const Model& model = world.entities()[shown.index]->model();
    json& bodies = text_["entities"][shown.index]["bodies"];
    for (const int object : shown.objects) bodies.push_back(model.objects()[static_cast<std::size_t>(object)].name);
  }

  void add_mesh(const render::RenderMesh& mesh) {
    text_["meshes"].push_back(
        {{"at", data_.size()}, {"corners", mesh.corners.size()}, {"triangles", mesh.triangle_count()}});
    for (const render::Vertex& corner : mesh.corners) {
      for (const float number : corner.place) put_f32(data_, number);
    }
    for (const std::uint32_t corner : mesh.triangles) put_u32(data_, corner);
  }

  void add_ground(const Markings& markings) {
    json& ground = text_["ground"] = {{"half_length", markings.half_length}, {"half_width", markings.half_width}};
    for (const Stroke& stroke : markings.strokes) {
      json line{{"width", stroke.width}, {"color", color_of(stroke.color)}};
      for (const Vec3d& point : stroke.points) line["points"].push_back(numbers(point));
      ground["lines"].push_back(std::move(line));
    }
  }

  /// Padded to four bytes: the page reads the numbers behind the text in place.
  void assemble() {
    std::string text = json_line(text_);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    put_u32(document_.bytes, static_cast<std::uint32_t>(text.size()));
    document_.bytes += text;
    MUROSIMF_ASSERT(document_.bytes.size() % 4 == 0);
    document_.bytes += data_;
  }

  const scene::Scene& scene_;
  SceneDocument document_;
  json text_{{"parts", json::array()}, {"meshes", json::array()}, {"entities", json::array()}};
  std::string data_;
  std::map<const Entity*, int> entities_, rows_;
};

}  // namespace

SceneDocument scene_document(const scene::Scene& scene) { return Writer(scene).write(); }

}  // namespace murosimf::web
