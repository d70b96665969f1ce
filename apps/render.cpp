// `murosimf render`: a picture or a video of a scene, from a place by name or through a robot's camera.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/interruption.h"
#include "apps/last_words.h"
#include "apps/progress.h"
#include "apps/standard_output.h"
#include "murosimf/appearance/video_file.h"
#include "murosimf/files/output_file.h"
#include "murosimf/render/image_png.h"
#include "murosimf/render/renderer.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_viewpoints.h"
#include "murosimf/sensors/camera_frame.h"

namespace murosimf::app {
namespace {

constexpr int largest_side = 8192;  // [px]

struct Size {
  int width = 0, height = 0;
};

Size size_of(const std::string& text) {
  Size size;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  bool good = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
  if (good) {
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    good = height.ec == std::errc{} && height.ptr == end;
  }
  if (!good || std::min(size.width, size.height) < 1 || std::max(size.width, size.height) > largest_side) {
    throw SetupError(
        fmt::format("--size '{}': write WIDTHxHEIGHT in pixels, each from 1 to {}, like 1280x720", text, largest_side));
  }
  return size;
}

Duration time_of(const char* option, double s) {
  if (!(s >= 0 && s <= scene::longest_duration))
    throw SetupError(fmt::format("{} {}: must be a number from 0", option, s));
  return from_seconds(s);
}

enum class Layer { color, depth, labels };

Layer layer_of(const std::string& name) {
  if (name == "color") return Layer::color;
  if (name == "depth") return Layer::depth;
  if (name == "labels") return Layer::labels;
  throw SetupError("--layer: " + unknown_name("layer", name, {"color", "depth", "labels"}));
}

/// Where pictures come from.
class PictureSource {
 public:
  virtual ~PictureSource() = default;
  /// Pictures per second of a video, and per second of simulated time.
  [[nodiscard]] virtual double fps() const = 0;
  [[nodiscard]] virtual double rate() const = 0;
  /// The picture of an instant that has come, or the first one after it; the simulation may go on for that. Nothing if it
  /// was interrupted.
  virtual std::optional<imaging::ColorImage> take(Duration instant) = 0;
};

/// A place from where people look.
class Viewpoint final : public PictureSource {
 public:
  Viewpoint(scene::Scene& scene, const RenderOptions& options)
      : scene_(scene),
        view_(options.view),
        size_(size_of(options.size)),
        layer_(layer_of(options.layer)),
        fps_(options.fps),
        slow_(options.slow) {
    (void)scene::viewpoint_perspective(scene, view_, size_.width, size_.height);
    scene::LightSpec light = scene.spec().light;
    light.shadows = !options.no_shadows;
    light.samples = std::max(light.samples, 4);
    renderer_ = scene.make_renderer(light);
  }
  [[nodiscard]] double fps() const override { return fps_; }
  [[nodiscard]] double rate() const override { return fps_ * slow_; }
  std::optional<imaging::ColorImage> take(Duration /*instant*/) override {
    sensors::View view;
    const sensors::Layers layers{layer_ == Layer::color, layer_ == Layer::depth, layer_ == Layer::labels};
    renderer_->draw(scene::viewpoint_perspective(scene_, view_, size_.width, size_.height), layers, 0, view);
    if (const std::string trouble = renderer_->trouble(); !trouble.empty()) throw SetupError(trouble);
    if (layer_ == Layer::depth) return render::shown(view.depth);
    return layer_ == Layer::labels ? render::shown(view.labels) : std::move(view.color);
  }

 private:
  scene::Scene& scene_;
  std::string view_;
  Size size_;
  Layer layer_;
  double fps_, slow_;
  std::unique_ptr<render::Renderer> renderer_;
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
  std::optional<imaging::ColorImage> take(Duration instant) override {
    // a frame of now is there after the next step, or later by its delay
    while (frame_.number == 0 || frame_.time < instant) {
      if (interrupted()) return std::nullopt;
      if (simulation_.now() > instant + frame_.info->period + std::chrono::seconds(10)) {
        throw SetupError(fmt::format("--camera '{}': it shows nothing", path_));
      }
      simulation_.run(std::chrono::milliseconds(1));
    }
    if (layer_ == Layer::depth) return wanted(frame_.depth, "depth");
    if (layer_ == Layer::labels) return wanted(frame_.labels, "labels");
    return frame_.mosaic.empty() ? wanted(frame_.color, "color") : render::shown(frame_.mosaic);
  }

 private:
  /// What changes the camera, for who reads messages.
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
  static imaging::ColorImage colors(const imaging::ColorImage& image) { return image; }
  template <class Image>
  static imaging::ColorImage colors(const Image& image) {
    return render::shown(image);
  }
  template <class Image>
  [[nodiscard]] imaging::ColorImage wanted(const Image& image, std::string_view layer) const {
    if (!image.empty()) return colors(image);
    throw SetupError(fmt::format("--layer {}: the camera does not draw it; {} lets it", layer,
                                 setting(fmt::format("{}=true", layer))));
  }

  Simulation& simulation_;
  std::string path_;
  const sensors::CameraFrame& frame_;
  Layer layer_;
  double slow_;
};

void check_light(const std::string& name) {
  std::vector<std::string_view> names;
  for (const render::NamedLight& light : render::lights()) names.push_back(light.name);
  if (std::ranges::find(names, name) != names.end()) return;
  throw SetupError("--light: " + unknown_name("light", name, names));
}

[[noreturn]] void refuse_no_time() { throw SetupError("--duration 0: a video needs some time"); }

/// What can be found out before anything is computed.
void check(const RenderOptions& options) {
  if (options.out.empty() == options.video.empty()) {
    throw SetupError("say where the picture goes: either --out FILE.png or --video FILE.mp4");
  }
  if (!options.view.empty() && !options.camera.empty()) throw SetupError("either --view or --camera, not both");
  if (!(options.fps >= 1 && options.fps <= 240)) {
    throw SetupError(fmt::format("--fps {}: must be from 1 to 240", options.fps));
  }
  if (!(options.slow >= 0.01 && options.slow <= 1000)) {
    throw SetupError(
        fmt::format("--slow {}: must be from 0.01 to 1000; 1 shows things as fast as they are", options.slow));
  }
  if (options.duration && time_of("--duration", *options.duration) == Duration{}) refuse_no_time();
  if (!options.light.empty()) check_light(options.light);
  if (options.video.empty()) {
    files::check_writable(options.out);
  } else {
    appearance::check_video(options.video);
  }
}

/// Throws SetupError if nothing can be drawn here: cameras would only wait.
void check_drawing() {
  const World nothing;
  const render::Renderer renderer(nothing, {}, render::appearance_of_shapes);
}

/// Runs to the steps that are nearest to given times, and shows how far it is on the way to `end`.
class PacedScene {
 public:
  PacedScene(Simulation& simulation, Duration end)
      : simulation_(simulation), begin_(seconds(simulation.now())), end_(seconds(end)) {}
  void run_to(Duration time) {
    const Duration tick = simulation_.tick(), away = time - simulation_.now();
    Clock as_fast_as_possible;
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

/// False if it was interrupted before the first picture.
bool write_video(PictureSource& source, Simulation& simulation, const RenderOptions& options, double duration) {
  const Duration begin = simulation.now(), end = begin + from_seconds(duration);
  PacedScene scene(simulation, end);
  std::optional<appearance::VideoFile> video;
  for (std::int64_t i = 0;; ++i) {
    const Duration next = begin + from_seconds(static_cast<double>(i) / source.rate());
    if (next >= end) break;
    scene.run_to(next);
    const auto picture = interrupted() ? std::nullopt : source.take(next);
    if (!picture) break;
    if (!video) video.emplace(options.video, picture->width(), picture->height(), source.fps());
    video->add(*picture);
  }
  if (!video && !interrupted()) refuse_no_time();
  if (video) video->finish();
  return video.has_value();
}

/// False if it was interrupted.
bool write_picture(PictureSource& source, Simulation& simulation, const RenderOptions& options) {
  const auto picture = interrupted() ? std::nullopt : source.take(simulation.now());
  if (picture) files::write_file(options.out, render::image_png(*picture));
  return picture.has_value();
}

/// What is there, for who has interrupted it.
void say_stopped(const RenderOptions& options, const Simulation& simulation, bool written) {
  const std::string file = options.video.empty() ? options.out : options.video;
  say_error(fmt::format("stopped by {} at {:.3f} s; {}", signal_name(), seconds(simulation.now()),
                        written ? fmt::format("'{}' ends there", file) : fmt::format("there is no '{}'", file)));
}

}  // namespace

int render(RenderOptions options) {
  check(options);
  end_gently();
  if (options.view.empty() && options.camera.empty()) options.view = "overview";
  if (options.camera.empty() && options.size.empty()) options.size = "1280x720";
  const Duration time = time_of("--time", options.time);
  if (!options.light.empty()) options.overrides.push_back("light.name=" + options.light);
  scene::Scene scene(options.scene, {.threads = options.threads,
                                     .seed = options.seed,
                                     .overrides = options.overrides,
                                     .events = options.events,
                                     .pushes = options.pushes,
                                     .lenient = options.lenient,
                                     .stop = interrupted});
  std::unique_ptr<PictureSource> source;
  if (!options.camera.empty()) {
    source = std::make_unique<RobotCamera>(scene, options);
    check_drawing();
  }
  scene.simulation().initialize();
  if (!source) source = std::make_unique<Viewpoint>(scene, options);
  for (const std::string& warning : scene.report({}).warnings) say_warning(warning);
  PacedScene(scene.simulation(), time).run_to(time);
  const bool written = options.video.empty() ? write_picture(*source, scene.simulation(), options)
                                             : write_video(*source, scene.simulation(), options,
                                                           options.duration.value_or(scene.spec().duration));
  if (const auto line = scene.events_to_come(); !interrupted() && !line.empty()) say_warning(line);
  if (interrupted()) say_stopped(options, scene.simulation(), written);
  return exit_code();
}

}  // namespace murosimf::app
