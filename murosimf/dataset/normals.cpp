#include "murosimf/dataset/normals.h"

#include <cmath>
#include <limits>

namespace murosimf::dataset {
namespace {

class NormalFinder {
 public:
  NormalFinder(const imaging::DepthImage& depth, const imaging::LabelImage& labels, const imaging::Image<Vec3d>& rays)
      : depth_(depth), labels_(labels), rays_(rays) {}

  [[nodiscard]] imaging::Rgb at(int u, int v) const {
    if (!std::isfinite(depth_(u, v)) || rays_(u, v).z == 0) return {};
    const Vec3d normal = cross(along(u, v, 1, 0), along(u, v, 0, 1));
    const double size = norm(normal);
    if (!(size > 0)) return {};
    const Vec3d n = ((dot(normal, point(u, v)) > 0 ? -1 : 1) / size) * normal;
    return {byte(n.x), byte(n.y), byte(n.z)};
  }

 private:
  static std::uint8_t byte(double part) { return static_cast<std::uint8_t>(std::lround(127.5 * (part + 1))); }
  [[nodiscard]] Vec3d point(int u, int v) const { return static_cast<double>(depth_(u, v)) * rays_(u, v); }

  /// From one pixel to its neighbor, forward or backward, whichever is nearer in depth; zero: neither is of the same thing.
  [[nodiscard]] Vec3d along(int u, int v, int du, int dv) const {
    Vec3d best;
    double least = std::numeric_limits<double>::infinity();
    for (const int side : {1, -1}) {
      const int x = u + side * du, y = v + side * dv;
      if (x < 0 || y < 0 || x >= depth_.width() || y >= depth_.height()) continue;
      const double step = std::abs(static_cast<double>(depth_(x, y)) - static_cast<double>(depth_(u, v)));
      if (labels_(x, y) != labels_(u, v) || rays_(x, y).z == 0 || !(step < least)) continue;
      least = step;
      best = static_cast<double>(side) * (point(x, y) - point(u, v));
    }
    return best;
  }

  const imaging::DepthImage& depth_;
  const imaging::LabelImage& labels_;
  const imaging::Image<Vec3d>& rays_;
};

}  // namespace

imaging::Image<Vec3d> rays_of(const imaging::Lens& lens) {
  imaging::Image<Vec3d> rays(lens.spec().width, lens.spec().height);
  for (int v = 0; v < rays.height(); ++v) {
    for (int u = 0; u < rays.width(); ++u) {
      const auto ray = lens.ray({static_cast<double>(u), static_cast<double>(v)});
      if (ray && ray->z > 1e-6) rays(u, v) = (1 / ray->z) * *ray;
    }
  }
  return rays;
}

imaging::ColorImage normals_of(const imaging::DepthImage& depth, const imaging::LabelImage& labels,
                               const imaging::Image<Vec3d>& rays) {
  imaging::ColorImage normals(depth.width(), depth.height());
  const NormalFinder finder(depth, labels, rays);
  for (int v = 0; v < depth.height(); ++v) {
    for (int u = 0; u < depth.width(); ++u) normals(u, v) = finder.at(u, v);
  }
  return normals;
}

}  // namespace murosimf::dataset
