/// murosimf_peer_pictures FOLDER --seconds 5 - what a picture of FOLDER's scene costs our renderer: 640 x 480 pixels, colors, from the side.
/// Prints processor time of all threads per picture [ms], triangles, and the share of pixels that show a robot.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "benchmarks/peers/options.h"
#include "murosimf/render/software_renderer.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_cameras.h"
#include "murosimf/scene/scene_parts.h"
#include "murosimf/scene_file/scene_spec.h"

namespace {

using namespace murosimf;

/// From `eye` along +y, down by `down` [rad]; 84 degrees wide. mujoco_pictures.py has the same numbers.
sensors::Perspective from_the_side() {
  const double down = 0.25, s = std::sin(down), c = std::cos(down);
  sensors::Perspective view;
  view.eye = {-0.25, -6.0, 1.2};
  view.axes = {{1, 0, 0}, {0, -s, -c}, {0, c, -s}};
  view.right = 0.9;
  view.left = -view.right;
  view.bottom = 0.75 * view.right;
  view.top = -view.bottom;
  view.width = 640;
  view.height = 480;
  return view;
}

nlohmann::json measure(const peers::Options& options) {
  scene::Scene scene(options.folder / "scene.toml", {.cameras = false});
  scene.simulation().initialize();
  const auto renderer = scene::make_camera_renderer(scene.parts(), {});
  const sensors::Perspective perspective = from_the_side();
  sensors::View view;
  renderer->draw(perspective, {.color = true, .labels = true}, 0, view);
  const auto labels = view.labels.pixels();
  const auto robots =
      std::ranges::count_if(labels, [](const auto label) { return label >= sensors::label_moving_entity; });
  const std::size_t before = renderer->totals().triangles;
  const double processor = peers::processor_seconds();
  int pictures = 0;
  for (; peers::processor_seconds() - processor < options.seconds; ++pictures) renderer->draw(perspective, {}, 0, view);
  const double took = peers::processor_seconds() - processor;
  return {{"engine", "MuRoSimF"},
          {"ms_per_picture", 1e3 * took / pictures},
          {"observed",
           {{"triangles", static_cast<double>(renderer->totals().triangles - before) / pictures},
            {"robots_share", static_cast<double>(robots) / static_cast<double>(labels.size())},
            {"by", "the processor"}}}};
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const peers::Options options = peers::read_options({arguments, static_cast<std::size_t>(count)}, {"colors"});
    std::printf("%s\n", measure(options).dump().c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "murosimf_peer_pictures: %s\n", error.what());
    return 1;
  }
}
