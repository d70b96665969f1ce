#include "apps/picture_files.h"

#include <cstdint>

#include <fmt/format.h>

#include "apps/interruption.h"
#include "apps/progress.h"
#include "murosimf/appearance/video_file.h"
#include "murosimf/files/output_file.h"
#include "murosimf/render/image_png.h"
#include "murosimf/render/png_bytes.h"

namespace murosimf::app {
namespace {

std::string png_of(const Taken& picture) {
  if (const auto* numbers = std::get_if<imaging::NumberImage>(&picture)) return render::png_bytes(*numbers);
  return render::image_png(std::get<imaging::ColorImage>(picture));
}

/// Runs to the steps that are nearest to given times, and shows how far it is on the way to `end`.
class PacedScene {
 public:
  PacedScene(Simulation& simulation, Duration end)
      : simulation_(simulation), begin_(seconds(simulation.now())), end_(seconds(end)) {}
  void run_to(Duration time) {
    const Duration tick = simulation_.tick(), away = time - simulation_.now();
    Pacer as_fast_as_possible;
    if (2 * away >= tick) {
      simulation_.run((away + tick / 2) / tick * tick, as_fast_as_possible, [this](Duration now) { show(now); });
    }
    show(simulation_.now());
  }

 private:
  void show(Duration now) {
    if (end_ <= begin_) return;
    line_.show((seconds(now) - begin_) / (end_ - begin_), fmt::format("{:.2f} of {:.2f} s", seconds(now), end_));
  }

  Simulation& simulation_;
  Progress line_;
  double begin_, end_;  // [s]
};

}  // namespace

void run_with_progress(Simulation& simulation, Duration time) { PacedScene(simulation, time).run_to(time); }

bool write_picture(PictureSource& source, Simulation& simulation, const RenderOptions& options) {
  const auto picture = interrupted() ? std::nullopt : source.take(simulation.now());
  if (picture) files::write_file(options.out, png_of(*picture));
  return picture.has_value();
}

bool write_video(PictureSource& source, Simulation& simulation, const RenderOptions& options, double duration) {
  const Duration begin = simulation.now(), end = begin + from_seconds(duration);
  PacedScene scene(simulation, end);
  using Pixels = appearance::VideoFile::Pixels;
  const Pixels pixels = has_numbers(options) ? Pixels::numbers : Pixels::colors;
  std::optional<appearance::VideoFile> video;
  for (std::int64_t i = 0;; ++i) {
    const Duration next = begin + from_seconds(static_cast<double>(i) / source.rate());
    if (next >= end) break;
    scene.run_to(next);
    const auto picture = interrupted() ? std::nullopt : source.take(next);
    if (!picture) break;
    std::visit(
        [&](const auto& image) {
          if (!video) video.emplace(options.video, pixels, image.width(), image.height(), source.fps());
          video->add(image);
        },
        *picture);
  }
  if (!video && !interrupted()) refuse_no_time();
  if (video) video->finish();
  return video.has_value();
}

void refuse_no_time() { throw SetupError("--duration 0: a video needs some time"); }

}  // namespace murosimf::app
