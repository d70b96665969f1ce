#include "murosimf/soccer/line_points.h"

#include <algorithm>

#include "murosimf/math/assert.h"

namespace murosimf::soccer {
namespace {

using imaging::Pixel;
using imaging::Rgb;

/// Pixels [first, last] along a scan line.
struct Run {
  int first = 0, last = 0;
};

double whiteness(const Rgb& p) { return std::min({p.red, p.green, p.blue}) / 255.0; }

/// Calls `found` with runs that are not green but white somewhere, between green on both sides. `at(i)` returns a pixel.
template <class At, class Found>
void for_white_runs(int size, const LineScan& scan, const At& at, const Found& found) {
  MUROSIMF_ASSERT(size >= 0 && scan.fewest_green > 0);
  int green = 0;  // pixels since the last other one
  Run run;
  double white = 0;
  bool open = false;  // a run that began after green
  for (int i = 0; i < size; ++i) {
    const Rgb& pixel = at(i);
    if (scan.green.contains(pixel)) {
      // The run counts only when enough green follows: a line at the border of the picture has an unknown width.
      if (++green == scan.fewest_green && open) {
        if (white >= scan.least_white) found(run);
        open = false;
      }
      continue;
    }
    if (green >= scan.fewest_green) {
      run.first = i;
      white = 0;
      open = true;
    }
    run.last = i;
    white = std::max(white, whiteness(pixel));
    green = 0;
  }
}

class Collector {
 public:
  Collector(const imaging::Lens& lens, const CameraPose& pose, const LineScan& scan, std::vector<LinePoint>& points)
      : lens_(lens), pose_(pose), scan_(scan), points_(points) {}

  /// Adds the run between the borders `a` and `b`, `pixels` long.
  void add(const Pixel& a, const Pixel& b, int pixels) {
    MUROSIMF_ASSERT(pixels > 0);
    if (points_.size() >= scan_.most) return;  // bounded: the cost of a picture and the reserved memory
    const auto from = on_ground(lens_, pose_, a), to = on_ground(lens_, pose_, b);
    if (!from || !to) return;
    const Vec3d place = 0.5 * (*from + *to), across = *to - *from;
    const double certain = norm(across) * std::max(0, pixels - 2) / pixels;  // the outer two may be mixed
    if (certain > scan_.widest || norm(place) > scan_.farthest) return;
    points_.push_back({place, {0.5 * (a.u + b.u), 0.5 * (a.v + b.v)}});
  }

 private:
  const imaging::Lens& lens_;
  const CameraPose& pose_;
  const LineScan& scan_;
  std::vector<LinePoint>& points_;
};

}  // namespace

void find_line_points(const imaging::ColorImage& picture, const imaging::Lens& lens, const CameraPose& pose,
                      const LineScan& scan, std::vector<LinePoint>& points) noexcept {
  MUROSIMF_ASSERT(scan.spacing > 0);
  points.clear();
  Collector collector(lens, pose, scan, points);
  for (int u = scan.spacing / 2; u < picture.width(); u += scan.spacing) {
    for_white_runs(
        picture.height(), scan, [&](int v) -> const Rgb& { return picture(u, v); },
        [&](const Run& run) {
          const double x = u;
          collector.add({x, run.first - 0.5}, {x, run.last + 0.5}, run.last - run.first + 1);
        });
  }
  for (int v = scan.spacing / 2; v < picture.height(); v += scan.spacing) {
    for_white_runs(
        picture.width(), scan, [&](int u) -> const Rgb& { return picture(u, v); },
        [&](const Run& run) {
          const double y = v;
          collector.add({run.first - 0.5, y}, {run.last + 0.5, y}, run.last - run.first + 1);
        });
  }
}

}  // namespace murosimf::soccer
