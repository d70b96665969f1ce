#include "apps/camera_feed.h"

#include <utility>

#include <fmt/format.h>

#include "apps/interruption.h"
#include "murosimf/render/image_png.h"

namespace murosimf::app {
namespace {

[[noreturn]] void refuse_robot(const Entity& robot, const std::string& path) {
  std::string cameras;
  for (const sensors::CameraFrame* frame : sensors::frames_of(robot)) {
    cameras += fmt::format("{} {}.{}", cameras.empty() ? ", like" : ",", path, frame->info->name);
  }
  throw SetupError("write ROBOT.CAMERA" + cameras);
}

const sensors::CameraFrame& find(World& world, const std::string& option, const std::string& path) {
  return *with_context(fmt::format("{} '{}'", option, path), [&] {
    const auto dot = path.find('.');
    Entity& robot = world.entity(path.substr(0, dot));
    if (dot == std::string::npos) refuse_robot(robot, path);
    return &sensors::want_frames(robot, path.substr(dot + 1));
  });
}

}  // namespace

CameraFeed::CameraFeed(scene::Scene& scene, std::string option, std::string path)
    : simulation_(scene.simulation()),
      option_(std::move(option)),
      path_(std::move(path)),
      frame_(find(scene.simulation().world(), option_, path_)) {}

bool CameraFeed::wait(Duration instant) {
  while (frame_.number == 0 || frame_.time < instant) {
    if (interrupted()) return false;
    if (simulation_.now() > instant + frame_.info->period + std::chrono::seconds(10)) {
      throw SetupError(fmt::format("{} '{}': it shows nothing", option_, path_));
    }
    simulation_.run(std::chrono::milliseconds(1));
  }
  return true;
}

std::string CameraFeed::setting(std::string_view change) const {
  const auto dot = path_.find('.');
  return fmt::format("--set '{}.sensors{}.{}'", path_.substr(0, dot), path_.substr(dot), change);
}

imaging::ColorImage CameraFeed::colors() const {
  return frame_.mosaic.empty() ? wanted(frame_.color, "color") : render::shown(frame_.mosaic);
}

void CameraFeed::refuse(std::string_view layer) const {
  const std::string wish = option_ == "--camera" ? fmt::format("--layer {}", layer) : option_ + " " + path_;
  throw SetupError(fmt::format("{}: the camera does not draw {}; {} lets it", wish,
                               option_ == "--camera" ? "it" : layer, setting(fmt::format("{}=true", layer))));
}

}  // namespace murosimf::app
