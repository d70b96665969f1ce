#include "murosimf/web/look_document.h"

#include <cmath>
#include <string_view>

#include "murosimf/math/assert.h"
#include "murosimf/render/look.h"
#include "murosimf/render/look_patterns.h"
#include "murosimf/web/little_endian.h"

namespace murosimf::web {
namespace {

using nlohmann::json;

json rounded(const std::vector<double>& values) {
  json all = json::array();
  for (const double value : values) all.push_back(std::round(value * 1e5) / 1e5);
  return all;
}

json rgb(const Color& color) { return rounded({color.red, color.green, color.blue}); }

json lamp_of(const Vec3d& toward, const Color& color) {
  return {{"toward", rounded({toward.x, toward.y, toward.z})}, {"color", rgb(color)}};
}

/// Five numbers for each corner: place, and where it is on the surface.
json surface_of(const render::LookSurface& surface, std::string& data) {
  json one{{"at", data.size()}, {"corners", surface.corners.size()}, {"triangles", surface.triangles.size() / 3}};
  for (const render::LookCorner& corner : surface.corners) {
    for (const float number : corner.place) put_f32(data, number);
    for (const float number : corner.at) put_f32(data, number);
  }
  for (const std::uint32_t corner : surface.triangles) put_u32(data, corner);
  return one;
}

const char* kind_name(render::Surroundings::Kind kind) {
  switch (kind) {
    case render::Surroundings::Kind::nothing: return "nothing";
    case render::Surroundings::Kind::hall: return "hall";
    case render::Surroundings::Kind::outdoors: return "outdoors";
  }
  return "";
}

}  // namespace

json look_document(const render::Light& light, const render::RenderScene& looks, std::string& data) {
  MUROSIMF_ASSERT(data.size() % 4 == 0);
  json look{{"patterns", std::string(render::look_patterns) + std::string(render::fine_pile)},
            {"surroundings", kind_name(light.surroundings.kind)},
            {"lamps", {lamp_of(light.toward, light.lamp)}},
            {"sky", rgb(light.sky)},
            {"earth", rgb(light.ground)},
            {"gloss", light.gloss},
            {"background", rgb(light.background)},
            {"floor", rgb(light.surroundings.floor)},
            {"grass", rgb(light.field.grass)},
            {"net", rgb(render::shown_in(render::thread, render::brightness_upwards(light, true)))}};
  for (const render::Lamp& lamp : light.others) look["lamps"].push_back(lamp_of(lamp.toward, lamp.lamp));
  for (const render::LookNumber& number : render::look_numbers(light, looks.markings())) {
    look["numbers"][number.name] = rounded(number.values);
  }
  look["walls"] = surface_of(render::hall_walls(light.surroundings, looks.markings()), data);
  look["ceiling"] = surface_of(render::hall_ceiling(light.surroundings, looks.markings()), data);
  look["nets"] = surface_of(render::hanging_nets(looks.nets()), data);
  look["pile"] = {{"at", data.size()}, {"side", render::pile_side}};
  data.append(render::pile().begin(), render::pile().end());
  MUROSIMF_ASSERT(data.size() % 4 == 0);
  return look;
}

}  // namespace murosimf::web
