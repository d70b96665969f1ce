#include "murosimf/render/software/shadow_map.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "murosimf/math/assert.h"

namespace murosimf::render::software {
namespace {

constexpr double widest_edge = 15;  // [texels] half of it: all of an edge is narrower than a tile

/// Places of the samples of a soft edge, in halves of its width.
constexpr std::array<std::array<float, 2>, 9> soft_taps{{{0, 0},
                                                         {0.9F, 0.4F},
                                                         {-0.9F, -0.4F},
                                                         {-0.4F, 0.9F},
                                                         {0.4F, -0.9F},
                                                         {0.5F, -0.2F},
                                                         {-0.5F, 0.2F},
                                                         {0.2F, 0.5F},
                                                         {-0.2F, -0.5F}}};

bool same(const LampView& a, const LampView& b) {
  return norm(a.eye - b.eye) == 0 && norm(a.axes.z - b.axes.z) == 0 && a.half_width == b.half_width &&
         a.half_height == b.half_height;
}

}  // namespace

ShadowMap::ShadowMap(int side)
    : side_(side),
      tiles_((side + tile - 1) / tile + 2),
      stride_(static_cast<std::size_t>(side + 2 * pixel_lanes)),
      nearness_(stride_ * static_cast<std::size_t>(side), -nothing),
      marked_(static_cast<std::size_t>(tiles_) * static_cast<std::size_t>(tiles_), 0) {
  MUROSIMF_ASSERT(side > 0);
}

/// Forgets what was drawn into the marked tiles.
void ShadowMap::clear() {
  for (int i = 0; i < tiles_ * tiles_; ++i) {
    std::uint8_t& marked = marked_[static_cast<std::size_t>(i)];
    if (marked == 0) continue;
    marked = 0;
    const int first_v = (i / tiles_ - 1) * tile, first_u = (i % tiles_ - 1) * tile;
    const int width = std::min(tile, side_ - first_u);
    if (first_u < 0 || width <= 0) continue;
    for (int v = std::max(0, first_v); v < std::min(side_, first_v + tile); ++v)
      std::fill_n(&nearness_[row(v) + static_cast<std::size_t>(first_u)], width, -nothing);
  }
}

/// The texels in it, and their left and upper neighbors, may have a shadow.
void ShadowMap::mark(const PixelBox& box) {
  for (int row = (box.top - 1 + tile) / tile; row <= (box.bottom + tile) / tile; ++row) {
    for (int column = (box.left - 1 + tile) / tile; column <= (box.right + tile) / tile; ++column)
      marked_[static_cast<std::size_t>(row * tiles_ + column)] = 1;
  }
}

bool ShadowMap::has_content(const Ints& u, const Ints& v) const {
  const Ints index = (v + tile) / tile * tiles_ + (u + tile) / tile;
  std::uint8_t content = 0;
  for (int i = 0; i < pixel_lanes; ++i) content |= marked_[static_cast<std::size_t>(index[i])];
  return content != 0;
}

void ShadowMap::draw(const LampView& lamp, const MeshCatalog& catalog, const InstanceList& list) {
  clear();
  lamp_ = lamp;
  texel_ = 2 * std::max(lamp.half_width, lamp.half_height) / side_;
  const auto per_x = static_cast<float>(0.5 * side_ / lamp.half_width),
             per_y = static_cast<float>(0.5 * side_ / lamp.half_height);
  const float middle = 0.5F * static_cast<float>(side_) - 0.5F;
  const PixelBox whole{0, side_ - 1, 0, side_ - 1};
  for (const InstanceGroup& group : list.solid_groups()) {
    const RenderMesh& mesh = catalog.meshes[group.solid];
    for (std::size_t i = group.first; i < group.first + group.count; ++i) {
      const Instance& instance = list.instances()[i];
      see(mesh, instance, KeptPlaces::none, corners_);
      for (SeenCorner& corner : corners_)
        corner.in_picture = {middle + per_x * corner.x, middle + per_y * corner.y, -corner.z};
      for (std::size_t k = 0; k < mesh.triangles.size(); k += 3) {
        // the other way round: far sides
        const std::array<Corner, 3> c{corners_[mesh.triangles[k]].in_picture,
                                      corners_[mesh.triangles[k + 1]].in_picture,
                                      corners_[mesh.triangles[k + 2]].in_picture};
        const float turn = turn_of(c);
        if (!(turn > 0)) continue;
        const Anchor anchor(c[0], whole);
        const Slope slope = Slopes(c, turn, anchor).of(c[0].per_z, c[1].per_z, c[2].per_z);
        for_covered(c, slope, anchor, whole, [&](int v, int u, const Ints& inside, const Floats& nearness) {
          float* to = &nearness_[row(v) + static_cast<std::size_t>(u)];
          const auto old = load_lanes<Floats>(to);
          store_lanes(choose(inside & (nearness > old), nearness, old), to);
        });
        mark(box_of(c, whole));
      }
    }
  }
}

ShadowLookup::ShadowLookup(std::shared_ptr<const ShadowMap> map, const sensors::Perspective& view, double edge)
    : map_(std::move(map)), gap_(static_cast<float>(1.5 * map_->texel())) {
  const LampView& lamp = map_->lamp();
  // from optical axes to those of the lamp, then to texels
  const Mat3d turn = transpose(lamp.axes) * view.axes;
  const Vec3d shift = transposed_times(lamp.axes, view.eye - lamp.eye);
  const double middle = 0.5 * map_->side() - 0.5;
  const double per_x = 0.5 * map_->side() / lamp.half_width, per_y = 0.5 * map_->side() / lamp.half_height;
  u_ = {floats(per_x * Vec3d{turn.x.x, turn.y.x, turn.z.x}), static_cast<float>(middle + per_x * shift.x)};
  v_ = {floats(per_y * Vec3d{turn.x.y, turn.y.y, turn.z.y}), static_cast<float>(middle + per_y * shift.y)};
  depth_ = {floats(Vec3d{turn.x.z, turn.y.z, turn.z.z}), static_cast<float>(shift.z)};
  edge_u_ = static_cast<float>(std::min(per_x * edge, widest_edge));
  edge_v_ = static_cast<float>(std::min(per_y * edge, widest_edge));
}

Floats ShadowLookup::lit_at(const Floats3& p) const {
  const Spot spot{dot(p, u_.turn) + u_.shift, dot(p, v_.turn) + v_.shift, dot(p, depth_.turn) + depth_.shift};
  if (edge_u_ == 0) return lit_at(spot);
  if (!may_be_shaded(spot)) return all_lanes(1.0F);
  Floats sum{};
  for (const auto& [u, v] : soft_taps) sum += lit_at(Spot{spot.u + u * edge_u_, spot.v + v * edge_v_, spot.depth});
  return sum * (1.0F / static_cast<float>(soft_taps.size()));
}

/// A soft edge is narrower than a tile: what its corners do not touch, nothing in it does.
bool ShadowLookup::may_be_shaded(const Spot& spot) const {
  const auto side = static_cast<float>(map_->side());
  const auto texel = [&](const Floats& x) { return whole_numbers(floor_of(limited(x, -2, side + 1))); };
  const Ints left = texel(spot.u - edge_u_), right = texel(spot.u + edge_u_), top = texel(spot.v - edge_v_),
             bottom = texel(spot.v + edge_v_);
  return map_->has_content(left, top) || map_->has_content(right, top) || map_->has_content(left, bottom) ||
         map_->has_content(right, bottom);
}

Floats ShadowLookup::lit_at(const Spot& spot) const {
  const auto side = static_cast<float>(map_->side());
  const Floats u = limited(spot.u, -2, side + 1), v = limited(spot.v, -2, side + 1);
  const Floats low_u = floor_of(u), low_v = floor_of(v);
  const Ints first_u = whole_numbers(low_u), first_v = whole_numbers(low_v);
  if (!map_->has_content(first_u, first_v)) return all_lanes(1.0F);
  const Floats share_u = u - low_u, share_v = v - low_v;
  const auto is_lit = [&](int du, int dv) {
    Floats stored;
    for (int i = 0; i < pixel_lanes; ++i) stored[i] = map_->depth(first_u[i] + du, first_v[i] + dv);
    return choose(spot.depth <= stored, all_lanes(1.0F), Floats{});
  };
  return mixed(mixed(is_lit(0, 0), is_lit(1, 0), share_u), mixed(is_lit(0, 1), is_lit(1, 1), share_u), share_v);
}

/// A spare one, or a new one, which takes long. The last view of it gives it back.
std::shared_ptr<ShadowMap> ShadowMaps::take(int side) {
  std::unique_ptr<ShadowMap> map;
  {
    const std::scoped_lock lock(spare_->mutex);
    if (!spare_->maps.empty()) {
      map = std::move(spare_->maps.back());
      spare_->maps.pop_back();
    }
  }
  if (!map || map->side() != side) map = std::make_unique<ShadowMap>(side);
  return {map.release(), [spare = spare_](ShadowMap* used) {
            const std::scoped_lock lock(spare->mutex);
            spare->maps.emplace_back(used);
          }};
}

std::shared_ptr<const ShadowMap> ShadowMaps::at(const RenderScene& scene, const MeshCatalog& catalog,
                                                const Vec3d& toward, int side, double ahead) {
  const LampView lamp = lamp_view(scene, toward, ahead);
  const std::scoped_lock lock(mutex_);
  list_.fill_all(scene, lamp.eye, lamp.axes, ahead, catalog);
  const std::span<const Instance> pieces = list_.instances();
  const bool known = latest_ && latest_->side() == side && same(latest_->lamp(), lamp) &&
                     pieces.size() == drawn_.size() &&
                     std::memcmp(pieces.data(), drawn_.data(), pieces.size_bytes()) == 0;
  if (known) return latest_;
  drawn_.assign(pieces.begin(), pieces.end());
  latest_ = nullptr;  // other threads may still look into it
  latest_ = take(side);
  latest_->draw(lamp, catalog, list_);
  return latest_;
}

}  // namespace murosimf::render::software
