#include "apps/picture_source.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "apps/option_values.h"
#include "apps/picture_overlay.h"
#include "murosimf/drawing/drawn.h"
#include "murosimf/imaging/depth_numbers.h"
#include "murosimf/model/properties.h"
#include "murosimf/recording/recorded_drawings.h"
#include "murosimf/recording/recorded_external_drawings.h"
#include "murosimf/render/image_png.h"
#include "murosimf/render/inset.h"
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
  Eye(scene::Scene& scene, const RenderOptions& options, const std::shared_ptr<const recording::RecordedRun>& run,
      std::unique_ptr<CameraFeed> inset)
      : scene_(scene),
        view_(options.view),
        size_(read_size(options.size)),
        layer_(layer_of(options.layer)),
        drawings_(options.drawings.begin(), options.drawings.end()),
        fps_(options.fps),
        slow_(options.slow),
        inset_(std::move(inset)) {
    if (!drawings_.empty() && !layer_.is(Kind::color)) throw SetupError("--drawings are drawn over colors");
    if (!options.overlay.empty() && !layer_.is(Kind::color)) throw SetupError("--overlay is drawn over colors");
    if (inset_ && !layer_.is(Kind::color)) throw SetupError("--inset is drawn over colors");
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
    // the newest frame, or the first one that comes
    if (inset_ && inset_->frame().number == 0 && !inset_->wait(scene_.simulation().now())) return std::nullopt;
    sensors::View view;
    const sensors::Layers layers{layer_.is(Kind::color), layer_.is(Kind::depth), layer_.is(Kind::labels)};
    render::Renderer& renderer = painter_->renderer();
    const sensors::Perspective from = perspective();
    renderer.draw(from, layers, 0, view);
    if (const std::string trouble = renderer.trouble(); !trouble.empty()) throw SetupError(trouble);
    if (!drawings_.empty()) draw_drawings(from, view.color);
    if (overlay_) overlay_->draw(from, view.color);
    if (inset_) render::draw_inset(view.color, inset_->colors(), inset_->path());
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
  std::unique_ptr<CameraFeed> inset_;
};

/// A camera that a robot carries.
class RobotCamera final : public PictureSource {
 public:
  RobotCamera(scene::Scene& scene, const RenderOptions& options)
      : feed_(scene, "--camera", options.camera), layer_(layer_of(options.layer)), slow_(options.slow) {
    if (options.size.empty()) return;
    throw SetupError(fmt::format("--size: the size of a camera is its own; {} changes it", feed_.setting("width=640")));
  }
  [[nodiscard]] double fps() const override { return rate() / slow_; }
  [[nodiscard]] double rate() const override { return 1 / seconds(feed_.frame().info->period); }
  std::optional<Taken> take(Duration instant) override {
    if (!feed_.wait(instant)) return std::nullopt;
    const sensors::CameraFrame& frame = feed_.frame();
    if (layer_.is(Kind::depth)) return taken(feed_.wanted(frame.depth, "depth"), layer_.shown);
    if (layer_.is(Kind::labels)) return taken(feed_.wanted(frame.labels, "labels"), layer_.shown);
    return feed_.colors();
  }

 private:
  CameraFeed feed_;
  const Layer& layer_;
  double slow_;
};

}  // namespace

bool has_numbers(const RenderOptions& options) {
  const Layer& layer = layer_of(options.layer);
  return !layer.is(Kind::color) && !layer.shown;
}

bool has_labels(const RenderOptions& options) {
  return has_numbers(options) && layer_of(options.layer).is(Kind::labels);
}

std::unique_ptr<PictureSource> make_robot_camera(scene::Scene& scene, const RenderOptions& options) {
  return std::make_unique<RobotCamera>(scene, options);
}

std::unique_ptr<PictureSource> make_eye(scene::Scene& scene, const RenderOptions& options,
                                        const std::shared_ptr<const recording::RecordedRun>& run,
                                        std::unique_ptr<CameraFeed> inset) {
  return std::make_unique<Eye>(scene, options, run, std::move(inset));
}

}  // namespace murosimf::app
