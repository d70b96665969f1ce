#include "apps/render_dataset.h"

#include <chrono>

#include <fmt/format.h>

#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/option_values.h"
#include "apps/progress.h"
#include "apps/standard_output.h"
#include "apps/version.h"
#include "murosimf/dataset/dataset.h"
#include "murosimf/recording/recorded_series.h"

namespace murosimf::app {
namespace {

/// Every picture has a camera, a light and an instant of its own.
void refuse_other_options(const RenderOptions& options) {
  const std::pair<const char*, bool> others[]{{"--out", !options.out.empty()},
                                              {"--video", !options.video.empty()},
                                              {"--view", !options.view.empty()},
                                              {"--camera", !options.camera.empty()},
                                              {"--follow", !options.follow.empty()},
                                              {"--sheet", !options.sheet.empty()},
                                              {"--duration", options.duration.has_value()},
                                              {"--layer", options.layer != "color"},
                                              {"--light", !options.light.empty()},
                                              {"--drawings", !options.drawings.empty()},
                                              {"--time", options.time != 0},
                                              {"--stance", options.stance},
                                              {"--no-shadows", options.no_shadows}};
  for (const auto& [name, given] : others) {
    if (given) throw SetupError(fmt::format("{} says nothing of a data set: --randomise has what varies in it", name));
  }
  if (recording::is_recording(options.scene.file)) throw SetupError("--dataset: of a scene, not of a recording");
}

dataset::Request request_of(const RenderOptions& options) {
  const PictureSize size = read_size(options.size.empty() ? "640x480" : options.size);
  return {.folder = options.dataset,
          .scene = options.scene.file,
          .randomisation = options.randomise,
          .pictures = static_cast<std::uint64_t>(options.frames),
          .width = size.width,
          .height = size.height,
          .normals = options.normals,
          .options = options_of(options.scene),
          .plugins = options.scene.plugins,
          .version = fmt::format("{} {}", version_number(), version_commit())};
}

}  // namespace

int render_dataset(const RenderOptions& options) {
  refuse_other_options(options);
  end_gently();
  Progress line;
  const auto begin = std::chrono::steady_clock::now();
  dataset::Request request = request_of(options);
  request.progress = [&](std::uint64_t there) {
    line.show(static_cast<double>(there) / static_cast<double>(request.pictures),
              fmt::format("{} of {} pictures", there, request.pictures));
  };
  const dataset::Outcome outcome = dataset::write_dataset(request);
  line.hide();
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!outcome.complete) {
    say_error(fmt::format("stopped by {}: {} of {} pictures are in '{}'; the same call goes on", signal_name(),
                          outcome.drawn + outcome.already, request.pictures, options.dataset));
    return exit_code();
  }
  const std::string before = outcome.already > 0 ? fmt::format(", {} were there", outcome.already) : "";
  write_standard_output(fmt::format("{} pictures in '{}': {} drawn in {:.1f} s{}\n", request.pictures, options.dataset,
                                    outcome.drawn, took, before));
  return 0;
}

}  // namespace murosimf::app
