/// projected_box.h - where all of a body would be seen, if nothing stood in front of it and the picture had no borders.
#pragma once

#include <algorithm>
#include <limits>

#include "murosimf/dataset/viewpoint.h"
#include "murosimf/render/render_scene.h"

namespace murosimf::dataset {

/// A rectangle in a picture [px], from the top left corner of the first pixel.
struct PixelBox {
  double left = std::numeric_limits<double>::infinity(), top = left, right = -left, bottom = -left;

  void add(double u, double v) {
    left = std::min(left, u);
    right = std::max(right, u);
    top = std::min(top, v);
    bottom = std::max(bottom, v);
  }
};

/// Grows around the projected pieces of one body.
class ProjectedBox {
 public:
  explicit ProjectedBox(const Viewpoint& view) : view_(&view) {}

  /// `pose`: of the piece, in the world. Round pieces are taken at points of their outline: boxes are right to 0.3 % of a radius.
  void add(const render::Drawable& piece, const Transformd& pose, const std::vector<render::RenderMesh>& meshes);
  /// Nothing if a part of it cannot be seen through the lens at all, as it is behind the camera; or if there are no pieces.
  [[nodiscard]] std::optional<PixelBox> box() const;

 private:
  void add_point(const Vec3d& in_camera);
  void add_sphere(const Vec3d& middle, double radius);

  const Viewpoint* view_;
  PixelBox box_;
  bool whole_ = true;
};

}  // namespace murosimf::dataset
