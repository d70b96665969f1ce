#include "murosimf/imaging/lens_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace murosimf::imaging {
namespace {

constexpr double one_view = 60 * pi / 180;  // [rad] from the axis
constexpr int most_pixels = 8192;           // to a side
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Columns: axes of the faces' frames in the camera's; front, right, left, down, up, back.
const std::array<Mat3d, 6>& faces() {
  static const std::array<Mat3d, 6> axes{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                          {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}},
                                          {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}},
                                          {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                                          {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                          {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}};
  return axes;
}

int face_of(const Vec3d& ray) {
  const double x = std::fabs(ray.x), y = std::fabs(ray.y), z = std::fabs(ray.z);
  if (z >= x && z >= y) return ray.z > 0 ? 0 : 5;
  if (x >= y) return ray.x > 0 ? 1 : 2;
  return ray.y > 0 ? 3 : 4;
}

/// What the lens sees of one face.
struct Part {
  double left = infinity, right = -infinity, top = infinity, bottom = -infinity;
  double density = 0;  ///< [px] of the picture per unit of x / z or y / z, where it is finest

  [[nodiscard]] bool used() const { return left <= right; }
  void see(double x, double y) {
    left = std::min(left, x);
    right = std::max(right, x);
    top = std::min(top, y);
    bottom = std::max(bottom, y);
  }
};

class Choice {
 public:
  explicit Choice(const Lens& lens) : lens_(lens), cube_(!lens.plain() && lens.corner_angle() > one_view) {}

  LensViews made(double resolution) {
    place_pixels();
    measure_density();
    LensViews views{{}, std::move(places_)};
    std::array<int, 6> number{};
    for (std::size_t face = 0; face < parts_.size(); ++face) {
      if (!parts_[face].used()) continue;
      number[face] = static_cast<int>(views.windows.size());
      views.windows.push_back(window(face, resolution));
    }
    for (ViewPlace& place : views.places) {
      if (place.view != ViewPlace::none) place.view = number[static_cast<std::size_t>(place.view)];
    }
    return views;
  }

 private:
  [[nodiscard]] std::size_t face(const Vec3d& ray) const { return cube_ ? static_cast<std::size_t>(face_of(ray)) : 0; }

  void place_pixels() {
    const LensSpec& spec = lens_.spec();
    places_.resize(static_cast<std::size_t>(spec.width) * spec.height);
    auto place = places_.begin();
    for (int v = 0; v < spec.height; ++v) {
      for (int u = 0; u < spec.width; ++u, ++place) {
        const auto ray = lens_.ray({static_cast<double>(u), static_cast<double>(v)});
        if (!ray) continue;
        const std::size_t at = face(*ray);
        const Vec3d p = transposed_times(faces()[at], *ray);
        *place = {static_cast<float>(p.x / p.z), static_cast<float>(p.y / p.z), static_cast<int>(at)};
        parts_[at].see(p.x / p.z, p.y / p.z);
      }
    }
  }

  /// On a grid of pixels, by the steps to their right and lower neighbors.
  void measure_density() {
    const LensSpec& spec = lens_.spec();
    const int step = std::max(1, std::min(spec.width, spec.height) / 64);
    for (int v = 0; v < spec.height; v += step) {
      for (int u = 0; u < spec.width; u += step) {
        measure_density({static_cast<double>(u), static_cast<double>(v)});
      }
    }
  }

  void measure_density(const Pixel& pixel) {
    const auto ray = lens_.ray(pixel);
    if (!ray) return;
    const std::size_t at = face(*ray);
    const Vec3d p = transposed_times(faces()[at], *ray);
    for (const Pixel& neighbor : {Pixel{pixel.u + 1, pixel.v}, Pixel{pixel.u, pixel.v + 1}}) {
      const auto other = lens_.ray(neighbor);
      if (!other) continue;
      const Vec3d q = transposed_times(faces()[at], *other);
      const double step = std::hypot(q.x / q.z - p.x / p.z, q.y / q.z - p.y / p.z);
      parts_[at].density = std::max(parts_[at].density, 1 / step);
    }
  }

  [[nodiscard]] ViewWindow window(std::size_t face, double resolution) const {
    const Part& part = parts_[face];
    const double largest = std::max(part.right - part.left, part.bottom - part.top);
    constexpr int margins = 4;
    // a part that the grid of pixels has missed is at most a few pixels large
    const double wanted = resolution * (part.density > 0 ? part.density : std::max(lens_.spec().fx, lens_.spec().fy));
    const double density = std::min(wanted, (most_pixels - margins) / std::max(largest, 1e-9));
    ViewWindow made{.axes = faces()[face], .left = part.left - 1 / density, .top = part.top - 1 / density};
    made.width = static_cast<int>(std::ceil((part.right - made.left) * density)) + 2;
    made.height = static_cast<int>(std::ceil((part.bottom - made.top) * density)) + 1;
    made.right = made.left + made.width / density;
    made.bottom = made.top + made.height / density;
    return made;
  }

  const Lens& lens_;
  bool cube_;
  std::array<Part, 6> parts_{};
  std::vector<ViewPlace> places_;
};

}  // namespace

LensViews choose_views(const Lens& lens, double resolution) { return Choice(lens).made(resolution); }

}  // namespace murosimf::imaging
