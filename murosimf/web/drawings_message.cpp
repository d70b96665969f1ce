#include "murosimf/web/drawings_message.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "murosimf/render/polygon_triangles.h"
#include "murosimf/web/json_line.h"
#include "murosimf/world/drawing.h"

namespace murosimf::web {
namespace {

using nlohmann::json;

double rounded_length(double x) { return std::round(1e4 * x) / 1e4; }

json shape_object(const DrawnShape& shape) {
  json points = json::array();
  for (const Vec3d& p : shape.points) points.push_back({rounded_length(p.x), rounded_length(p.y), rounded_length(p.z)});
  json object{{"kind", drawn_kind_names[shape.kind]},
              {"points", std::move(points)},
              {"size", rounded_length(shape.size)},
              {"color", {shape.color.red, shape.color.green, shape.color.blue}},
              {"opacity", shape.opacity},
              {"words", shape.words}};
  if (shape.kind == DrawnShape::polygon) object["triangles"] = render::polygon_triangles(shape.points);
  return object;
}

json group_object(const DrawnGroup& group) {
  json shapes = json::array();
  for (const DrawnShape& shape : group.shapes) shapes.push_back(shape_object(shape));
  return {{"name", group.name}, {"of_robot", group.of_robot}, {"shapes", std::move(shapes)}};
}

}  // namespace

std::string drawings_message(const std::vector<drawing::Drawn>& all) {
  json drawings = json::array();
  for (const drawing::Drawn& drawn : all) {
    json groups = json::array();
    for (const DrawnGroup& group : drawn.groups) groups.push_back(group_object(group));
    drawings.push_back({{"entity", drawn.entity}, {"by", drawn.by}, {"groups", std::move(groups)}});
  }
  return json_line({{"is", "drawings"}, {"drawings", std::move(drawings)}});
}

}  // namespace murosimf::web
