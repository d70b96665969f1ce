/// pixel_rays.h - the ray through the middle of each pixel of a view, and where it meets the ground (z = 0 of the world).
///
/// Places on the ground follow from 1 / z of the optical frame, which is linear in the pixel (u, v): D the direction of the ray, z = 1,
/// in world axes, and h the height of the eye,
///
///     1 / z = -D_z / h,    place = eye + z D
#pragma once

#include "murosimf/render/software/coverage.h"
#include "murosimf/render/software/float_lanes.h"
#include "murosimf/sensors/view_source.h"

namespace murosimf::render::software {

[[nodiscard]] inline Float3 floats(const Vec3d& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// A number that is linear in the column of a row.
struct RowLine {
  float origin = 0, per_u = 0, per_v = 0;  ///< per_v: by which the next row has more
  [[nodiscard]] Floats at(const Floats& u) const { return origin + per_u * u; }
};

/// A number that is linear in the pixel.
struct PixelPlane {
  double origin = 0, per_u = 0, per_v = 0;
  [[nodiscard]] RowLine row(int v) const {
    return {static_cast<float>(origin + per_v * v), static_cast<float>(per_u), static_cast<float>(per_v)};
  }
};

/// The ground under some pixels.
struct GroundPlaces {
  Floats z;               ///< [m] in the optical frame
  Floats x, y;            ///< [m] world
  Floats xu, xv, yu, yv;  ///< [m/px] derivatives
};

/// The rays of a row of pixels.
struct RowRays {
  RowLine way_x, way_y, way_z, ground;
  float eye_x = 0, eye_y = 0;
  float around_x = 0, around_y = 0;  ///< [m] world: where the ground has its middle
  float near_ground = 0;             ///< [1/m] 1 / z from which on the ground has not ended

  /// `per_z` [1/m]: ground.at(u), or any other number more than 0 where the ground is not seen.
  [[nodiscard]] GroundPlaces ground_places(const Floats& u, const Floats& per_z) const {
    GroundPlaces places;
    places.z = 1 / per_z;
    const Floats x = way_x.at(u) * places.z, y = way_y.at(u) * places.z;
    places.x = eye_x + x;
    places.y = eye_y + y;
    places.xu = places.z * (way_x.per_u - x * ground.per_u);
    places.xv = places.z * (way_x.per_v - x * ground.per_v);
    places.yu = places.z * (way_y.per_u - y * ground.per_u);
    places.yv = places.z * (way_y.per_v - y * ground.per_v);
    return places;
  }
  /// Directions, z = 1 of the optical frame, in world axes.
  [[nodiscard]] Floats3 directions(const Floats& u) const { return {way_x.at(u), way_y.at(u), way_z.at(u)}; }
};

class PixelRays {
 public:
  /// `around`: where the ground has its middle [m, world].
  PixelRays(const sensors::Perspective& view, const Vec3d& around);
  explicit PixelRays(const sensors::Perspective& view) : PixelRays(view, view.eye) {}

  [[nodiscard]] int width() const { return whole_.right + 1; }
  [[nodiscard]] const PixelBox& whole() const { return whole_; }  ///< all of the picture
  /// Tangents x / z and y / z.
  [[nodiscard]] Floats tangent_x(const Floats& u) const { return left_ + (u + 0.5F) * pixel_x_; }
  [[nodiscard]] float tangent_y(int v) const { return top_ + (static_cast<float>(v) + 0.5F) * pixel_y_; }
  /// Pixel coordinates of tangents.
  [[nodiscard]] float u_of(float tangent) const { return (tangent - left_) * per_pixel_x_ - 0.5F; }
  [[nodiscard]] float v_of(float tangent) const { return (tangent - top_) * per_pixel_y_ - 0.5F; }

  /// `ground`: [1/m] 1 / z; 0 or less where a ray does not meet it.
  [[nodiscard]] RowRays row(int v) const {
    return {way_x_.row(v), way_y_.row(v), way_z_.row(v), ground_.row(v), eye_.x,
            eye_.y,        around_.x,     around_.y,     near_ground_};
  }
  /// 1 / z of the plane through three places of the optical frame.
  [[nodiscard]] Slope plane(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Anchor& anchor) const;
  [[nodiscard]] const Float3& eye() const { return eye_; }
  [[nodiscard]] const Float3& around() const { return around_; }
  /// [m] A place of the world in the optical frame.
  [[nodiscard]] Float3 seen(const Vec3d& place) const { return floats(transposed_times(axes_, place - eye_place_)); }
  [[nodiscard]] bool sees_ground_from_above() const { return eye_.z > 0; }

 private:
  PixelBox whole_;
  float left_, top_, pixel_x_, pixel_y_, per_pixel_x_, per_pixel_y_;
  Vec3d eye_place_;
  Mat3d axes_;
  Float3 eye_, around_;
  float near_ground_;
  PixelPlane way_x_, way_y_, way_z_, ground_;
};

}  // namespace murosimf::render::software
