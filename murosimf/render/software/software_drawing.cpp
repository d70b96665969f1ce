#include "murosimf/render/software/software_drawing.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "murosimf/math/assert.h"
#include "murosimf/render/software/row_bytes.h"

namespace murosimf::render::software {
namespace {

constexpr float thread_cover = 0.85F;  // [1] of a net's thread

std::vector<StrokePiece> pieces_of(const Markings* markings) {
  return markings ? stroke_pieces(*markings) : std::vector<StrokePiece>{};
}

template <class Visit>
void for_triangles(const std::vector<SeenCorner>& corners, const LookSurface& surface, const Visit& visit) {
  for (std::size_t i = 0; i < surface.triangles.size(); i += 3) {
    visit(std::array<const SeenCorner*, 3>{&corners[surface.triangles[i]], &corners[surface.triangles[i + 1]],
                                           &corners[surface.triangles[i + 2]]});
  }
}

template <class Visit>
void for_lanes_of(unsigned bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(std::countr_zero(bits));
}

}  // namespace

Stage::Stage(const RenderScene& scene, const RendererOptions& options, ShadowMaps& maps)
    : look(options.light, scene.markings(), options.fine),
      light(options.light),
      fine(options.fine),
      ground(options.ground),
      shadow_side(options.shadow_side),
      samples(options.samples),
      shadows(maps) {
  if (!light.patterns || !ground) return;
  if (light.surroundings.kind == Surroundings::Kind::hall) {
    walls = hall_walls(light.surroundings, scene.markings());
    ceiling = hall_ceiling(light.surroundings, scene.markings());
  }
  nets = hanging_nets(scene.nets());
}

/// One view.
struct SoftwareDrawing::Picture {
  const Stage& stage;
  const FarEye& eye;
  const sensors::Perspective& view;
  PixelRays rays;
  SolidShading shading;
  const ShadowLookup* shadows;
  [[nodiscard]] bool has_ground() const { return stage.ground && !eye.is_level() && rays.sees_ground_from_above(); }
  /// Ground that is cut open, behind everything.
  [[nodiscard]] bool has_cut_ground() const { return stage.ground && eye.is_level(); }
  [[nodiscard]] Ints shows_cut_ground(const RowRays& row, const Floats& column) const {
    return row.way_z.at(column) * static_cast<float>(eye.distance) + rays.eye().z < 0;
  }
  /// Parallel rays come from outside of any hall.
  [[nodiscard]] bool has_surroundings() const { return stage.look.patterns && stage.ground && !eye.parallel; }
};

SoftwareDrawing::SoftwareDrawing(const RenderScene& scene)
    : scene_(scene), catalog_(solid_catalog(scene.meshes())), ground_(pieces_of(scene.markings())) {}

DrawCount SoftwareDrawing::draw(const Stage& stage, const Projection& wanted, const sensors::Layers& layers,
                                double ahead, sensors::View& into) {
  FarEye eye(wanted);
  sensors::Perspective& view = eye.view;
  if (view.rows == 0) view.rows = view.height - view.first_row;
  draw_part(stage, eye, layers, ahead, nullptr, into);
  // Several samples to a pixel apply to colors only: a mean of depths or labels is meaningless.
  if (stage.samples > 1 && layers.color) {
    const Samples samples(stage.samples);
    FarEye enlarged = eye;
    enlarged.view = samples.enlarged(view);
    draw_part(stage, enlarged, {.color = true}, ahead, &samples, fine_);
    samples.average(surfaces_, fine_.color, view.first_row, view.rows, into.color);
  }
  DrawCount drawn{list_.instances().size(), 0};
  for (const InstanceGroup& group : list_.groups())
    drawn.triangles += group.count * catalog_.meshes[group.solid].triangle_count();
  return drawn;
}

/// With `samples` only the pixels of the finer view that edges need.
void SoftwareDrawing::draw_part(const Stage& stage, const FarEye& eye, const sensors::Layers& layers, double ahead,
                                const Samples* samples, sensors::View& into) {
  const sensors::Perspective& view = eye.view;
  std::optional<ShadowLookup> cast;
  if (stage.light.shadows && layers.color)
    cast.emplace(stage.shadows.at(scene_, catalog_, stage.light.toward, stage.shadow_side, ahead), view,
                 stage.fine ? soft_edge : 0);
  const ShadowLookup* shadows = cast ? &*cast : nullptr;
  const Picture picture{stage,
                        eye,
                        view,
                        PixelRays(view, eye.around),
                        SolidShading(stage.light, stage.look, view, stage.ground, shadows),
                        shadows};
  list_.fill(scene_, view, layers.depth, ahead, catalog_);
  begin(picture, layers.color || layers.labels, ahead);
  draw_solids(picture);
  const int end = view.first_row + view.rows;
  if (layers.color) {
    if (picture.has_surroundings()) {
      draw_scenery(picture, stage.walls, Surface::Kind::wall);
      draw_scenery(picture, stage.ceiling, Surface::Kind::ceiling);
    }
    draw_nets(picture);
    if (samples) samples->leave_out_what_is_alike(surfaces_);
    imaging::fit(into.color, view.width, view.height);
    for (int v = view.first_row; v < end; ++v) paint_row(picture, v, into.color);
    lay_clear(picture, into.color);
  }
  if (layers.depth || layers.labels) {
    if (layers.depth) imaging::fit(into.depth, view.width, view.height);
    if (layers.labels) imaging::fit(into.labels, view.width, view.height);
    for (int v = view.first_row; v < end; ++v) measure_row(picture, layers, v, into);
    measure_clear(picture, layers, into);
  }
}

/// 1 / z of all pixels is that of the ground, or 0.
void SoftwareDrawing::begin(const Picture& picture, bool strokes, double ahead) {
  const sensors::Perspective& view = picture.view;
  surfaces_.begin(view.width, view.height, view.first_row, view.rows);
  colors_.resize(view.width);
  const Floats lanes = lane_numbers();
  for (int v = view.first_row; v < view.first_row + view.rows; ++v) {
    float* per_z = surfaces_.per_z(v);
    const RowLine ground = picture.has_ground() ? picture.rays.row(v).ground : RowLine{};
    for (int u = 0; u < view.width; u += pixel_lanes)
      store_lanes(greatest(Floats{}, ground.at(lanes + static_cast<float>(u))), per_z + u);
  }
  if (!strokes || !picture.has_ground()) return;
  std::vector<ContactShadow> contacts;
  if (picture.stage.look.patterns) contacts = contact_shadows(scene_, ahead, view.without);
  ground_.begin(picture.rays, surfaces_.box(), std::move(contacts), picture.shadows);
}

void SoftwareDrawing::draw_solids(const Picture& picture) {
  solids_.for_triangles(picture.rays, catalog_, list_, list_.solid_groups(), picture.stage.look.patterns,
                        [&](const std::array<const SeenCorner*, 3>& corners, const Surface& surface) {
                          surfaces_.draw(picture.rays, corners, surface);
                        });
}

void SoftwareDrawing::draw_scenery(const Picture& picture, const LookSurface& surface, Surface::Kind kind) {
  see(surface, picture.rays, corners_);
  Surface as;
  as.kind = kind;
  for_triangles(corners_, surface,
                [&](const std::array<const SeenCorner*, 3>& corners) { surfaces_.draw(picture.rays, corners, as); });
}

/// Finds how much of the light passes the nets that hang before what is drawn.
void SoftwareDrawing::draw_nets(const Picture& picture) {
  const LookSurface& nets = picture.stage.nets;
  const sensors::Perspective& view = picture.view;
  has_nets_.assign(static_cast<std::size_t>(view.rows), 0);
  if (nets.triangles.empty()) return;
  net_stride_ = static_cast<std::size_t>(view.width + 2 * pixel_lanes);
  through_nets_.resize(net_stride_ * static_cast<std::size_t>(view.rows));
  see(nets, picture.rays, corners_);
  Surface as;
  as.kind = Surface::Kind::net;
  for_triangles(corners_, nets, [&](const std::array<const SeenCorner*, 3>& corners) {
    surfaces_.for_not_hidden(picture.rays, corners, as, true,
                             [&](const Surface& surface, int v, int u, const Ints& seen, const Floats& per_z) {
                               const auto row = static_cast<std::size_t>(v - view.first_row);
                               float* first = &through_nets_[row * net_stride_];
                               if (has_nets_[row] == 0) std::fill_n(first, net_stride_, 1.0F);
                               has_nets_[row] = 1;
                               const auto old = load_lanes<Floats>(first + u);
                               const Floats cover = net_cover_of(surface, v, u, per_z);
                               store_lanes(choose(seen, old * (1 - thread_cover * cover), old), first + u);
                             });
  });
}

void SoftwareDrawing::paint_row(const Picture& picture, int v, imaging::ColorImage& into) {
  paint_background(picture, v);
  if (picture.has_ground()) ground_.paint(picture.rays, picture.stage.look, v, surfaces_.numbers(v), colors_);
  paint_solids(picture, v);
  if (has_nets_[static_cast<std::size_t>(v - picture.view.first_row)] != 0) lay_nets(picture, v);
  write_bytes(colors_, surfaces_.numbers(v), into.row(v));
}

void SoftwareDrawing::paint_background(const Picture& picture, int v) {
  const LookValues& look = picture.stage.look;
  const bool sky = picture.has_surroundings() && look.kind == Surroundings::Kind::outdoors;
  const std::int32_t* numbers = surfaces_.numbers(v);
  const float* per_z = surfaces_.per_z(v);
  const RowRays rays = picture.rays.row(v);
  const Floats lanes = lane_numbers();
  for (int u = 0; u < picture.view.width; u += pixel_lanes) {
    if (!any((load_lanes<Ints>(numbers + u) == 0) & (load_lanes<Floats>(per_z + u) < rays.near_ground))) continue;
    const Floats column = lanes + static_cast<float>(u);
    Floats3 color = sky ? sky_look(look, rays.directions(column)) : all_lanes(look.background);
    if (picture.has_cut_ground())
      color = choose(picture.shows_cut_ground(rays, column), all_lanes(look.floor.lit), color);
    colors_.store(u, color);
  }
}

void SoftwareDrawing::paint_solids(const Picture& picture, int v) {
  const std::int32_t* numbers = surfaces_.numbers(v);
  for (int u = 0; u < picture.view.width; u += pixel_lanes) {
    const auto number = load_lanes<Ints>(numbers + u);
    const Ints seen = (number != 0) & (number != left_out);
    if (!any(seen)) continue;
    const Ints surface = seen & (number < 0 ? -number : number);
    const auto per_z = load_lanes<Floats>(surfaces_.per_z(v) + u);
    const Floats3 color = picture.shading.colors(picture.rays, surfaces_.surfaces(), surface, seen, v, u,
                                                 choose(seen, per_z, all_lanes(1.0F)));
    colors_.store(u, choose(seen, color, colors_.load(u)));
  }
}

void SoftwareDrawing::lay_nets(const Picture& picture, int v) {
  const float* through = &through_nets_[static_cast<std::size_t>(v - picture.view.first_row) * net_stride_];
  const Floats3 net = all_lanes(picture.stage.look.net);
  for (int u = 0; u < picture.view.width; u += pixel_lanes)
    colors_.store(u, mixed(net, colors_.load(u), load_lanes<Floats>(through + u)));
}

/// Lays transparent pieces over the picture, the farthest first.
void SoftwareDrawing::lay_clear(const Picture& picture, imaging::ColorImage& into) {
  if (list_.clear_groups().empty()) return;
  const auto lay = [&](const Surface& surface, int v, int u, const Ints& seen, const Floats& per_z) {
    const Floats3 color = picture.shading.colors(picture.rays, surface, v, u, choose(seen, per_z, all_lanes(1.0F)));
    for_lanes_of(bits_of(seen), [&](int i) {
      lay_over({color.x[i], color.y[i], color.z[i]}, surface.alpha, into(u + i, v));
    });
  };
  solids_.for_triangles(picture.rays, catalog_, list_, list_.clear_groups(), false,
                        [&](const std::array<const SeenCorner*, 3>& corners, const Surface& surface) {
                          surfaces_.for_not_hidden(picture.rays, corners, surface, false, lay);
                        });
}

/// Depths and labels of opaque pieces and ground. What is only looked at leaves the buffer: 1 / z becomes that of the ground behind it.
void SoftwareDrawing::measure_row(const Picture& picture, const sensors::Layers& layers, int v, sensors::View& into) {
  const int width = picture.view.width;
  const std::int32_t* numbers = surfaces_.numbers(v);
  float* per_z = surfaces_.per_z(v);
  const Floats lanes = lane_numbers();
  const RowRays row = picture.rays.row(v);
  const auto behind = static_cast<float>(picture.eye.distance);
  for (int u = 0; u < width; u += pixel_lanes) {
    const auto number = load_lanes<Ints>(numbers + u);
    Ints solid = number > 0, there = Ints{};
    Floats at = load_lanes<Floats>(per_z + u);
    if (picture.has_ground() && !all(solid)) {
      const Floats column = lanes + static_cast<float>(u), ground = row.ground.at(column);
      const GroundPlaces places = row.ground_places(column, choose(ground > 0, ground, all_lanes(1.0F)));
      there = GroundShading::is_there(row, places, ground) & ~solid;
      at = choose(solid, at, choose(there, ground, Floats{}));
    } else {
      at = choose(solid, at, Floats{});
    }
    if (picture.has_cut_ground()) there = picture.shows_cut_ground(row, lanes + static_cast<float>(u)) & ~solid;
    store_lanes(at, per_z + u);
    const int count = std::min(pixel_lanes, width - u);
    if (layers.depth) {
      const Floats far = all_lanes(std::numeric_limits<float>::infinity());
      const Floats z = choose(at > 0, 1 / at - behind, far);
      std::memcpy(&into.depth(u, v), &z, static_cast<std::size_t>(count) * sizeof(float));
    }
    if (!layers.labels) continue;
    for (int i = 0; i < count; ++i) {
      const std::uint16_t backdrop = there[i] != 0 ? sensors::label_ground : sensors::label_background;
      into.labels(u + i, v) =
          solid[i] != 0 ? surfaces_.surfaces()[static_cast<std::size_t>(number[i])].label : backdrop;
    }
  }
  if (layers.labels && picture.has_ground())
    ground_.mark_lines(picture.rays, v, numbers, sensors::label_line, into.labels.row(v));
}

/// Depths and labels of transparent pieces: those of the nearest one.
void SoftwareDrawing::measure_clear(const Picture& picture, const sensors::Layers& layers, sensors::View& into) {
  if (list_.clear_groups().empty()) return;
  const auto behind = static_cast<float>(picture.eye.distance);
  const auto measure = [&](const Surface& surface, int v, int u, const Ints& seen, const Floats& at) {
    float* per_z = surfaces_.per_z(v) + u;
    store_lanes(choose(seen, at, load_lanes<Floats>(per_z)), per_z);
    for_lanes_of(bits_of(seen), [&](int i) {
      if (layers.depth) into.depth(u + i, v) = 1 / at[i] - behind;
      if (layers.labels) into.labels(u + i, v) = surface.label;
    });
  };
  solids_.for_triangles(picture.rays, catalog_, list_, list_.clear_groups(), false,
                        [&](const std::array<const SeenCorner*, 3>& corners, const Surface& surface) {
                          surfaces_.for_not_hidden(picture.rays, corners, surface, false, measure);
                        });
}

}  // namespace murosimf::render::software
