#include "apps/picture_sequence.h"

#include <algorithm>
#include <cmath>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"
#include "murosimf/render/image_png.h"
#include "murosimf/render/renderer.h"
#include "murosimf/scene/scene_viewpoints.h"

namespace murosimf::app {
namespace {

constexpr double shortest = 1e-3;          // [s]
constexpr int columns = 1280, rows = 720;  // [px]

Duration checked(double every) {
  if (!(every >= shortest && every <= scene_file::longest_duration)) {
    throw SetupError(fmt::format("--picture-every {}: must be at least {} s", every, shortest));
  }
  return from_seconds(every);
}

}  // namespace

PictureSequence::PictureSequence(std::filesystem::path folder, double every)
    : folder_(std::move(folder)), every_(checked(every)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw SetupError(fmt::format("cannot make the folder '{}': {}", folder_.string(), error.message()));
  files::claim_output("--pictures", file());
}

void PictureSequence::show(scene::Scene& scene) {
  painter_ = std::make_unique<scene::ScenePainter>(scene, [](scene_file::LightSpec& light) {
    light.shadows = true;
    light.samples = std::max(light.samples, 4);
  });
  scene_ = &scene;
}

void PictureSequence::take() {
  sensors::View view;
  render::Renderer& renderer = painter_->renderer();
  renderer.draw(scene::parallel_view(*scene_, columns, rows), {}, 0, view);
  if (const std::string trouble = renderer.trouble(); !trouble.empty()) throw SetupError(trouble);
  const std::string title = fmt::format("{}: {:.2f} s", scene_->spec().name, seconds(scene_->simulation().now()));
  files::write_file(file(), render::image_png(view.color, title));
  next_ += every_;
  ++count_;
}

std::filesystem::path PictureSequence::file() const { return folder_ / fmt::format("{:04}.png", count_); }

}  // namespace murosimf::app
