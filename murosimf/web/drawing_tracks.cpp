#include "murosimf/web/drawing_tracks.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "murosimf/math/assert.h"
#include "murosimf/render/polygon_triangles.h"
#include "murosimf/web/json_line.h"

namespace murosimf::web {
namespace {

using nlohmann::json;

constexpr double farthest = 1e6;  // [m]

std::int64_t millimeters(double x) { return std::llround(1000 * std::clamp(x, -farthest, farthest)); }

double rounded(double x, double per_unit) { return std::round(per_unit * x) / per_unit; }

}  // namespace

std::int64_t DrawingTracks::look_of(const DrawnShape& shape) {
  constexpr double lengths = 1e4, shares = 1e3;  // steps to a unit
  const Color& color = shape.color;
  json look = json::array({drawn_kind_names[shape.kind], rounded(shape.size, lengths), rounded(color.red, shares),
                           rounded(color.green, shares), rounded(color.blue, shares), rounded(shape.opacity, shares),
                           shape.words, shape.points.size()});
  if (shape.kind == DrawnShape::polygon) look.push_back(render::polygon_triangles(shape.points));
  const auto [known, is_new] = looks_.try_emplace(json_line(look), static_cast<std::int64_t>(looks_.size()));
  if (is_new) looks_in_order_.push_back(known->first);
  return known->second;
}

/// A version for each change only: most drawings stay the same for many frames.
void DrawingTracks::add(Track& track, std::size_t frame, Numbers looks, Numbers points) {
  if (track.looks == looks && track.points == points) return;
  MUROSIMF_ASSERT(track.versions.empty() || track.versions.back().frame <= frame);
  MUROSIMF_ASSERT(points.size() % 3 == 0);
  Version version{.frame = frame, .same_looks = track.looks == looks, .looks = looks, .points = points};
  if (version.same_looks) version.looks.clear();
  for (std::size_t i = 0; i < points.size() && points.size() == track.points.size(); ++i) {
    version.points[i] -= track.points[i];
  }
  track.looks = std::move(looks);
  track.points = std::move(points);
  track.versions.push_back(std::move(version));
}

void DrawingTracks::take(std::size_t frame, const std::vector<drawing::Drawn>& all) {
  std::set<Key> there;
  for (const drawing::Drawn& drawn : all) {
    for (const DrawnGroup& group : drawn.groups) {
      Numbers looks, points;
      for (const DrawnShape& shape : group.shapes) {
        looks.push_back(look_of(shape));
        for (const Vec3d& p : shape.points) {
          for (const double x : {p.x, p.y, p.z}) points.push_back(millimeters(x));
        }
      }
      const Key key{drawn.entity, drawn.by, group.name, group.of_robot};
      there.insert(key);
      add(tracks_[key], frame, std::move(looks), std::move(points));
    }
  }
  for (auto& [key, track] : tracks_) {
    if (!there.contains(key)) add(track, frame, {}, {});
  }
}

json DrawingTracks::object() const {
  json looks = json::array(), tracks = json::array();
  for (const std::string& look : looks_in_order_) looks.push_back(json::parse(look));
  for (const auto& [key, track] : tracks_) {
    json one{{"entity", std::get<0>(key)},   {"by", std::get<1>(key)},  {"name", std::get<2>(key)},
             {"of_robot", std::get<3>(key)}, {"frames", json::array()}, {"looks", json::array()},
             {"points", json::array()}};
    std::size_t before = 0;
    for (const Version& version : track.versions) {
      one["frames"].push_back(version.frame - std::exchange(before, version.frame));
      one["looks"].push_back(version.same_looks ? json(nullptr) : json(version.looks));
      one["points"].push_back(version.points);
    }
    tracks.push_back(std::move(one));
  }
  return {{"looks", std::move(looks)}, {"tracks", std::move(tracks)}};
}

}  // namespace murosimf::web
