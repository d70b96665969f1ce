#include "apps/picture_source.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "apps/interruption.h"
#include "apps/option_values.h"
#include "apps/picture_overlay.h"
#include "murosimf/drawing/drawn.h"
#include "murosimf/imaging/depth_numbers.h"
#include "murosimf/model/properties.h"
#include "murosimf/recording/recorded_drawings.h"
#include "murosimf/recording/recorded_external_drawings.h"
#include "murosimf/render/image_png.h"
#include "murosimf/render/renderer.h"
#include "murosimf/render/seen_drawing.h"
#include "murosimf/scene/action_view.h"
#include "murosimf/scene/scene_pictures.h"
#include "murosimf/scene/scene_viewpoints.h"

namespace murosimf::app {
namespace {

struct Layer {
  enum class Kind { color, depth, labels };
  std::string_view name;
  Kind kind;
  bool shown = false;  ///< in colors, for people
  [[nodiscard]] bool is(Kind one) const { return kind == one; }
};
using Kind = Layer::Kind;

constexpr std::array all_layers{Layer{"color", Kind::color}, Layer{"depth", Kind::depth}, Layer{"labels", Kind::labels},
                                Layer{"depth_shown", Kind::depth, true}, Layer{"labels_shown", Kind::labels, true}};

const Layer& layer_of(const std::string& name) {
  const auto found = std::ranges::find(all_layers, name, &Layer::name);
  if (found != all_layers.end()) return *found;
  std::vector<std::string_view> names;
  for (const Layer& layer : all_layers) names.push_back(layer.name);
  throw SetupError("--layer: " + unknown_name("layer", name, names));
}

Taken taken(const imaging::DepthImage& depth, bool shown) {
  if (shown) return render::shown(depth);
  return imaging::millimeters(depth);
}
Taken taken(const imaging::LabelImage& labels, bool shown) {
  if (shown) return render::shown(labels);
  return labels;
}

/// A place from where people look.
class Eye final : public PictureSource {
 public:
  Eye(scene::Scene& scene, const RenderOptions& options, const std::shared_ptr<const recording::RecordedRun>& run)
      : scene_(scene),
        view_(options.view),
        size_(read_size(options.size)),
        layer_(layer_of(options.layer)),
        drawings_(options.drawings.begin(), options.drawings.end()),
        fps_(options.fps),
        slow_(options.slow) {
    if (!drawings_.empty() && !layer_.is(Kind::color)) throw SetupError("--drawings are drawn over colors");
    if (!options.overlay.empty() && !layer_.is(Kind::color)) throw SetupError("--overlay is drawn over colors");
    if (!options.follow.empty()) {
      follow(options.follow);
    } else {
      (void)scene::viewpoint_perspective(scene, view_, size_.width, size_.height);
    }
    const auto for_people = [shadows = !options.no_shadows](scene_file::LightSpec& light) {
      light.shadows = shadows;
      light.samples = std::max(light.samples, 4);
    };
    const auto mark_feet = [stance = options.stance](render::Renderer& renderer) {
      if (stance) renderer.mark_standing_feet({1, 0.85, 0});
    };
    painter_ = std::make_unique<scene::ScenePainter>(scene, for_people, mark_feet);
    if (run && !drawings_.empty()) recorded_.emplace(run->file());
    if (recorded_) others_.emplace(scene.simulation().world());
    if (!options.overlay.empty()) begin_overlay(options, run);
  }
  [[nodiscard]] double fps() const override { return fps_; }
  [[nodiscard]] double rate() const override { return fps_ * slow_; }
  std::optional<Taken> take(Duration /*instant*/) override {
    sensors::View view;
    const sensors::Layers layers{layer_.is(Kind::color), layer_.is(Kind::depth), layer_.is(Kind::labels)};
    render::Renderer& renderer = painter_->renderer();
    const sensors::Perspective from = perspective();
    renderer.draw(from, layers, 0, view);
    if (const std::string trouble = renderer.trouble(); !trouble.empty()) throw SetupError(trouble);
    if (!drawings_.empty()) draw_drawings(from, view.color);
    if (overlay_) overlay_->draw(from, view.color);
    if (layer_.is(Kind::depth)) return taken(view.depth, layer_.shown);
    if (layer_.is(Kind::labels)) return taken(view.labels, layer_.shown);
    return std::move(view.color);
  }

 private:
  void begin_overlay(const RenderOptions& options, const std::shared_ptr<const recording::RecordedRun>& run) {
    overlay_.emplace(scene_, options.overlay);
    if (!run) return overlay_->watch_score();
    const bool one = options.video.empty() && options.sheet.empty();
    overlay_->read_score(run, one ? from_seconds(options.time) : run->end());
  }
  void follow(const std::vector<std::string>& names) {
    std::vector<std::string> all = names;
    if (names == std::vector<std::string>{"all"}) {
      all.clear();
      for (const Entity* entity : scene_.moving_entities()) all.push_back(entity->name());
    }
    following_.emplace(scene_);
    with_context("--follow", [&] { following_->follow(all, true); });
  }
  [[nodiscard]] sensors::Perspective perspective() {
    return following_ ? following_->look(size_.width, size_.height)
                      : scene::viewpoint_perspective(scene_, view_, size_.width, size_.height);
  }

  /// By robots now, and by others then.
  [[nodiscard]] std::vector<drawing::Drawn> all_drawn() {
    const World& world = scene_.simulation().world();
    std::vector<drawing::Drawn> all = drawing::drawn_by_robots(world);
    if (!recorded_) return all;
    (void)others_->take(recorded_->news(scene_.simulation().now()));
    std::ranges::move(drawing::external_drawings(others_->shown(), drawing::teams_of(world)), std::back_inserter(all));
    return all;
  }

  /// Of those groups that are wanted.
  void draw_drawings(const sensors::Perspective& from, imaging::ColorImage& picture) {
    const World& world = scene_.simulation().world();
    std::vector<render::SeenShape> shapes;
    for (const drawing::Drawn& drawn : all_drawn()) {
      Transformd robot;
      if (drawn.entity >= 0) {
        const auto& entity = world.entities()[static_cast<std::size_t>(drawn.entity)];
        if (!entity->present()) continue;
        robot = {entity->base().get(properties::position), entity->base().get(properties::orientation)};
      }
      for (const DrawnGroup& group : drawn.groups) {
        if (!drawings_.contains("all") && !drawings_.contains(drawn.by + "/" + group.name)) continue;
        for (const DrawnShape& shape : group.shapes) {
          render::see(shape, group.of_robot ? robot : Transformd{}, from, shapes);
        }
      }
    }
    render::draw_over(picture, shapes);
  }

  scene::Scene& scene_;
  std::string view_;
  PictureSize size_;
  const Layer& layer_;
  std::set<std::string> drawings_;
  double fps_, slow_;
  std::unique_ptr<scene::ScenePainter> painter_;
  std::optional<scene::ActionView> following_;
  std::optional<recording::DrawingReader> recorded_;
  std::optional<recording::RecordedExternalDrawings> others_;
  std::optional<PictureOverlay> overlay_;
};

/// A camera that a robot carries.
class RobotCamera final : public PictureSource {
 public:
  RobotCamera(scene::Scene& scene, const RenderOptions& options)
      : simulation_(scene.simulation()),
        path_(options.camera),
        frame_(find(scene.simulation().world(), path_)),
        layer_(layer_of(options.layer)),
        slow_(options.slow) {
    if (options.size.empty()) return;
    throw SetupError(fmt::format("--size: the size of a camera is its own; {} changes it", setting("width=640")));
  }
  [[nodiscard]] double fps() const override { return rate() / slow_; }
  [[nodiscard]] double rate() const override { return 1 / seconds(frame_.info->period); }
  std::optional<Taken> take(Duration instant) override {
    // a frame of now is there after the next step, or later by its delay
    while (frame_.number == 0 || frame_.time < instant) {
      if (interrupted()) return std::nullopt;
      if (simulation_.now() > instant + frame_.info->period + std::chrono::seconds(10)) {
        throw SetupError(fmt::format("--camera '{}': it shows nothing", path_));
      }
      simulation_.run(std::chrono::milliseconds(1));
    }
    if (layer_.is(Kind::depth)) return taken(wanted(frame_.depth, "depth"), layer_.shown);
    if (layer_.is(Kind::labels)) return taken(wanted(frame_.labels, "labels"), layer_.shown);
    return frame_.mosaic.empty() ? wanted(frame_.color, "color") : render::shown(frame_.mosaic);
  }

 private:
  /// What changes the camera, for the reader of messages.
  [[nodiscard]] std::string setting(std::string_view change) const {
    const auto dot = path_.find('.');
    return fmt::format("--set '{}.sensors{}.{}'", path_.substr(0, dot), path_.substr(dot), change);
  }
  static const sensors::CameraFrame& find(World& world, const std::string& path) {
    return *with_context(fmt::format("--camera '{}'", path), [&] {
      const auto dot = path.find('.');
      Entity& robot = world.entity(path.substr(0, dot));
      if (dot == std::string::npos) refuse_robot(robot, path);
      return &sensors::want_frames(robot, path.substr(dot + 1));
    });
  }
  [[noreturn]] static void refuse_robot(const Entity& robot, const std::string& path) {
    std::string cameras;
    for (const sensors::CameraFrame* frame : sensors::frames_of(robot)) {
      cameras += fmt::format("{} {}.{}", cameras.empty() ? ", like" : ",", path, frame->info->name);
    }
    throw SetupError("write ROBOT.CAMERA" + cameras);
  }
  template <class Image>
  [[nodiscard]] const Image& wanted(const Image& image, std::string_view layer) const {
    if (!image.empty()) return image;
    throw SetupError(fmt::format("--layer {}: the camera does not draw it; {} lets it", layer,
                                 setting(fmt::format("{}=true", layer))));
  }

  Simulation& simulation_;
  std::string path_;
  const sensors::CameraFrame& frame_;
  const Layer& layer_;
  double slow_;
};

/// Throws SetupError if nothing can be drawn here: cameras would only wait.
void check_drawing() {
  const World nothing;
  const render::Renderer renderer(nothing, {}, render::appearance_of_shapes);
}

}  // namespace

bool has_numbers(const RenderOptions& options) {
  const Layer& layer = layer_of(options.layer);
  return !layer.is(Kind::color) && !layer.shown;
}

bool has_labels(const RenderOptions& options) {
  return has_numbers(options) && layer_of(options.layer).is(Kind::labels);
}

std::unique_ptr<PictureSource> make_robot_camera(scene::Scene& scene, const RenderOptions& options) {
  auto camera = std::make_unique<RobotCamera>(scene, options);
  check_drawing();
  return camera;
}

std::unique_ptr<PictureSource> make_eye(scene::Scene& scene, const RenderOptions& options,
                                        const std::shared_ptr<const recording::RecordedRun>& run) {
  return std::make_unique<Eye>(scene, options, run);
}

}  // namespace murosimf::app
