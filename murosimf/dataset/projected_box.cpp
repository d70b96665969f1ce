#include "murosimf/dataset/projected_box.h"

#include <cmath>

#include "murosimf/math/scalar.h"

namespace murosimf::dataset {
namespace {

constexpr int round_points = 48;
constexpr double middle_of_pixel = 0.5;  // [px] pixels count from the middle of the first one, boxes from its corner

/// Two unit vectors at right angles to `way` and to each other.
std::pair<Vec3d, Vec3d> across(const Vec3d& way) {
  const Vec3d other = std::abs(way.x) < 0.5 * norm(way) ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d one = cross(way, other), two = cross(way, one);
  return {(1 / norm(one)) * one, (1 / norm(two)) * two};
}

}  // namespace

void ProjectedBox::add_point(const Vec3d& in_camera) {
  const auto pixel = view_->lens.project(in_camera);
  if (!pixel) {
    whole_ = false;
    return;
  }
  box_.add(pixel->u + middle_of_pixel, pixel->v + middle_of_pixel);
}

/// The circle along which rays touch it.
void ProjectedBox::add_sphere(const Vec3d& middle, double radius) {
  const double square = dot(middle, middle), share = radius * radius / square;
  if (!(share < 1)) {
    whole_ = false;
    return;
  }
  const auto [one, two] = across(middle);
  const double r = radius * std::sqrt(1 - share);
  for (int i = 0; i < round_points; ++i) {
    const double angle = 2 * pi * i / round_points;
    add_point((1 - share) * middle + r * (std::cos(angle) * one + std::sin(angle) * two));
  }
}

void ProjectedBox::add(const render::Drawable& piece, const Transformd& pose,
                       const std::vector<render::RenderMesh>& meshes) {
  const Vec3d& s = piece.scale;
  const auto point = [&](const Vec3d& p) {
    add_point(view_->in_camera(pose.position + pose.orientation * Vec3d{s.x * p.x, s.y * p.y, s.z * p.z}));
  };
  const auto ring = [&](double z, double radius) {
    for (int i = 0; i < round_points; ++i) {
      const double angle = 2 * pi * i / round_points;
      point({radius * std::cos(angle), radius * std::sin(angle), z});
    }
  };
  switch (piece.form) {
    case render::Form::sphere:
    case render::Form::half_sphere:
      if (s.x == s.y && s.x == s.z) return add_sphere(view_->in_camera(pose.position), s.x);
      for (int i = -round_points / 4; i <= round_points / 4; ++i) {
        const double angle = 2 * pi * i / round_points;
        ring(std::sin(angle), std::cos(angle));
      }
      return;
    case render::Form::tube:
    case render::Form::cylinder: ring(-1, 1); return ring(1, 1);
    case render::Form::box:
      for (int i = 0; i < 8; ++i) point({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
      return;
    case render::Form::mesh:
      for (const render::Vertex& corner : meshes[static_cast<std::size_t>(piece.mesh)].corners) {
        point({corner.place[0], corner.place[1], corner.place[2]});
      }
      return;
  }
}

std::optional<PixelBox> ProjectedBox::box() const {
  if (!whole_ || box_.left > box_.right) return std::nullopt;
  return box_;
}

}  // namespace murosimf::dataset
