// `murosimf render`: a picture or a video of a scene, from a place by name or through a robot's camera.
#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/standard_output.h"
#include "murosimf/io/output_file.h"
#include "murosimf/io/scene.h"
#include "murosimf/io/scene_eyes.h"
#include "murosimf/io/video_file.h"
#include "murosimf/render/image_png.h"
#include "murosimf/render/renderer.h"
#include "murosimf/sensors/frame.h"

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
  if (!(s >= 0 && s <= io::longest_duration))
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
  /// Between two pictures of a video [s].
  [[nodiscard]] virtual Duration period() const = 0;
  /// The picture of an instant that has come, or the first one after it; the simulation may go on for that.
  virtual sensors::ColorImage take(Duration instant) = 0;
};

/// A place from where people look.
class Eye final : public PictureSource {
 public:
  Eye(io::Scene& scene, const RenderOptions& options)
      : scene_(scene),
        view_(options.view),
        size_(size_of(options.size)),
        layer_(layer_of(options.layer)),
        period_(from_seconds(1 / options.fps)) {
    (void)io::eye_perspective(scene, view_, size_.width, size_.height);
    io::LightSpec light = scene.spec().light;
    light.shadows = !options.no_shadows;
    light.samples = std::max(light.samples, 4);
    renderer_ = scene.make_renderer(light);
  }
  [[nodiscard]] Duration period() const override { return period_; }
  sensors::ColorImage take(Duration /*instant*/) override {
    sensors::View view;
    const sensors::Layers layers{layer_ == Layer::color, layer_ == Layer::depth, layer_ == Layer::labels};
    renderer_->draw(io::eye_perspective(scene_, view_, size_.width, size_.height), layers, 0, view);
    if (const std::string trouble = renderer_->trouble(); !trouble.empty()) throw SetupError(trouble);
    if (layer_ == Layer::depth) return render::shown(view.depth);
    return layer_ == Layer::labels ? render::shown(view.labels) : std::move(view.color);
  }

 private:
  io::Scene& scene_;
  std::string view_;
  Size size_;
  Layer layer_;
  Duration period_;
  std::unique_ptr<render::Renderer> renderer_;
};

/// A camera that a robot carries.
class RobotCamera final : public PictureSource {
 public:
  RobotCamera(io::Scene& scene, const RenderOptions& options)
      : simulation_(scene.simulation()),
        path_(options.camera),
        frame_(find(scene.simulation().world(), path_)),
        layer_(layer_of(options.layer)) {
    if (options.size.empty()) return;
    throw SetupError(fmt::format("--size: the size of a camera is its own; {} changes it", setting("width=640")));
  }
  [[nodiscard]] Duration period() const override { return frame_.info->period; }
  sensors::ColorImage take(Duration instant) override {
    // a frame of now is there after the next step, or later by its delay
    while (frame_.number == 0 || frame_.time < instant) {
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
  static const sensors::Frame& find(World& world, const std::string& path) {
    return *at(fmt::format("--camera '{}'", path), [&] {
      const auto dot = path.find('.');
      Entity& robot = world.entity(path.substr(0, dot));
      if (dot == std::string::npos) refuse_robot(robot, path);
      return &sensors::want_frames(robot, path.substr(dot + 1));
    });
  }
  [[noreturn]] static void refuse_robot(const Entity& robot, const std::string& path) {
    std::string cameras;
    for (const sensors::Frame* frame : sensors::frames_of(robot)) {
      cameras += fmt::format("{} {}.{}", cameras.empty() ? ", like" : ",", path, frame->info->name);
    }
    throw SetupError("write ROBOT.CAMERA" + cameras);
  }
  static sensors::ColorImage colors(const sensors::ColorImage& image) { return image; }
  template <class Image>
  static sensors::ColorImage colors(const Image& image) {
    return render::shown(image);
  }
  template <class Image>
  [[nodiscard]] sensors::ColorImage wanted(const Image& image, std::string_view layer) const {
    if (!image.empty()) return colors(image);
    throw SetupError(fmt::format("--layer {}: the camera does not draw it; {} lets it", layer,
                                 setting(fmt::format("{}=true", layer))));
  }

  Simulation& simulation_;
  std::string path_;
  const sensors::Frame& frame_;
  Layer layer_;
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
  if (options.duration && time_of("--duration", *options.duration) == Duration{}) refuse_no_time();
  if (!options.light.empty()) check_light(options.light);
  if (options.video.empty()) {
    io::check_writable(options.out);
  } else {
    io::check_video(options.video);
  }
}

/// Throws SetupError if nothing can be drawn here: cameras would only wait.
void check_drawing() {
  const World nothing;
  const render::Renderer renderer(nothing, {}, render::looks_of_shapes);
}

void write_video(PictureSource& source, io::Scene& scene, const RenderOptions& options) {
  Simulation& simulation = scene.simulation();
  const Duration end = simulation.now() + from_seconds(options.duration.value_or(scene.spec().duration));
  std::optional<io::VideoFile> video;
  for (Duration next = simulation.now(); next < end; next += source.period()) {
    simulation.run(std::max(Duration{}, next - simulation.now()));
    const sensors::ColorImage picture = source.take(next);
    if (!video) video.emplace(options.video, picture.width(), picture.height(), 1 / seconds(source.period()));
    video->add(picture);
  }
  if (!video) refuse_no_time();
  video->finish();
}

}  // namespace

int render(RenderOptions options) {
  check(options);
  if (options.view.empty() && options.camera.empty()) options.view = "overview";
  if (options.camera.empty() && options.size.empty()) options.size = "1280x720";
  const Duration time = time_of("--time", options.time);
  if (!options.light.empty()) options.overrides.push_back("light.name=" + options.light);
  io::Scene scene(options.scene, {.threads = options.threads,
                                  .seed = options.seed,
                                  .overrides = options.overrides,
                                  .events = options.events,
                                  .pushes = options.pushes,
                                  .lenient = options.lenient});
  std::unique_ptr<PictureSource> source;
  if (!options.camera.empty()) {
    source = std::make_unique<RobotCamera>(scene, options);
    check_drawing();
  }
  scene.simulation().initialize();
  if (!source) source = std::make_unique<Eye>(scene, options);
  for (const std::string& warning : scene.report({}).warnings) fmt::print(stderr, "warning: {}\n", warning);
  scene.simulation().run(time);
  if (!options.video.empty()) {
    write_video(*source, scene, options);
  } else {
    io::write_file(options.out, render::image_png(source->take(scene.simulation().now())));
  }
  return 0;
}

}  // namespace murosimf::app
