// A robot's own eyes: an algorithm finds the ball in the pictures of a camera (docs/cameras.md).
#include <cmath>
#include <cstdio>
#include <optional>

#include <murosimf/math/quaternion.h>
#include <murosimf/model/properties.h>
#include <murosimf/scene/scene.h>
#include <murosimf/scene/scene_report.h>
#include <murosimf/sensors/camera.h>
#include <murosimf/sensors/reading.h>

using namespace murosimf;

namespace {
/// What is known of the ball, in the optical frame: x right, y down, z forward.
struct Sighting {
  double time = 0;  // [s] of the exposure
  double pixels = 0;
  std::optional<Vec3d> seen;  // unit, towards the middle of the ball's pixels
  Vec3d truth;                // unit, towards the ball
};

class BallFinder final : public Algorithm {
 public:
  BallFinder(Setup& setup, Entity& ball)
      : frame_(sensors::read_frame(setup, "camera")),  // from now on the camera draws
        eye_(sensors::read_output(setup, "camera.position")),
        axes_(sensors::read_output(setup, "camera.orientation")),
        ball_(setup.of(ball).read(properties::position)) {}

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void step(const Instant&) noexcept override {
    if (frame_.number == last_) return;  // no new frame
    last_ = frame_.number;
    const auto& names = frame_.info->labels;
    double u = 0, v = 0, pixels = 0;
    for (int row = 0; row < frame_.labels.height(); ++row) {
      for (int column = 0; column < frame_.labels.width(); ++column) {
        if (names[frame_.labels(column, row)] != "ball") continue;
        pixels += 1;
        u += column;
        v += row;
      }
    }
    sighting_ = {seconds(frame_.time), pixels, {}, true_direction()};
    if (pixels > 0) sighting_.seen = frame_.info->lens.ray({u / pixels, v / pixels});
  }
  [[nodiscard]] const Sighting& sighting() const { return sighting_; }

 private:
  [[nodiscard]] Vec3d true_direction() const noexcept {
    const Mat3d camera = to_matrix(Quaterniond{axes_[0], axes_[1], axes_[2], axes_[3]});
    const Vec3d away = ball_[0] - Vec3d{eye_[0], eye_[1], eye_[2]};
    return (1 / norm(away)) * transposed_times(camera * sensors::optical_axes, away);
  }

  const sensors::CameraFrame& frame_;
  std::span<const double> eye_, axes_;
  std::span<const Vec3d> ball_;
  std::uint64_t last_ = 0;
  Sighting sighting_;
};
}  // namespace

int main() {
  scene::Scene scene("duel", {.overrides = {"blue1.sensors.camera.labels=true"}});
  Simulation& simulation = scene.simulation();
  Entity& robot = simulation.world().entity("blue1");
  const auto& finder = simulation.attach<BallFinder>("ball_finder", robot, 100, simulation.world().entity("ball"));
  for (int i = 0; i < 5; ++i) {
    simulation.run(std::chrono::milliseconds(500));
    const auto& [time, pixels, seen, truth] = finder.sighting();
    if (!seen) continue;  // out of sight, or pictures cannot be drawn here: then a warning gives the reason
    std::printf("%.2f s: %5.0f pixels, %5.1f deg to the right, %4.1f deg down, off by %.2f deg\n", time, pixels,
                std::atan2(seen->x, seen->z) * 180 / pi, std::asin(seen->y) * 180 / pi,
                std::asin(norm(cross(*seen, truth))) * 180 / pi);
  }
  for (const std::string& warning : make_report(scene).warnings) std::printf("%s\n", warning.c_str());
}
