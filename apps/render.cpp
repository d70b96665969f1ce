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
  /// The picture of now, or the first one after it; the simulation may go on for that.
  virtual sensors::ColorImage take() = 0;
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
  [[nodiscard]] std::string drawn_by() const { return renderer_->name(); }
  [[nodiscard]] Duration period() const override { return period_; }
  sensors::ColorImage take() override {
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
      : simulation_(scene.simulation()), frame_(find(scene, options.camera)), layer_(layer_of(options.layer)) {
    if (!options.size.empty()) {
      throw SetupError(fmt::format("--size: the size of a camera is its own; --set '{}.width=640' changes it",
                                   with_sensors(options.camera)));
    }
  }
  [[nodiscard]] Duration period() const override { return frame_.info->period; }
  sensors::ColorImage take() override {
    const Duration begin = simulation_.now();
    // a frame of now is there after the next step, or later by its delay
    while (frame_.number == 0 || frame_.time < begin) {
      if (simulation_.now() > begin + frame_.info->period + std::chrono::seconds(10)) {
        throw SetupError(fmt::format("camera '{}' shows nothing", frame_.info->name));
      }
      simulation_.run(std::chrono::milliseconds(1));
    }
    if (layer_ == Layer::depth) return wanted(frame_.depth, "depth");
    if (layer_ == Layer::labels) return wanted(frame_.labels, "labels");
    if (!frame_.mosaic.empty()) return render::shown(frame_.mosaic);
    return frame_.color;
  }

 private:
  static std::string with_sensors(const std::string& path) {
    const auto dot = path.find('.');
    return path.substr(0, dot) + ".sensors" + path.substr(dot);
  }
  static const sensors::Frame& find(io::Scene& scene, const std::string& path) {
    const auto dot = path.find('.');
    if (dot == std::string::npos) throw SetupError(fmt::format("--camera '{}': write ROBOT.CAMERA", path));
    Entity& robot = scene.simulation().world().entity(path.substr(0, dot));
    return sensors::want_frames(robot, path.substr(dot + 1));
  }
  template <class Image>
  static sensors::ColorImage wanted(const Image& image, const char* layer) {
    if (image.empty()) {
      throw SetupError(
          fmt::format("--layer {}: the camera does not draw it; --set 'ROBOT.sensors.CAMERA.{}=true' lets it", layer,
                      layer));
    }
    return render::shown(image);
  }

  Simulation& simulation_;
  const sensors::Frame& frame_;
  Layer layer_;
};

void check(const RenderOptions& options) {
  if (options.out.empty() == options.video.empty()) {
    throw SetupError("say where the picture goes: either --out FILE.png or --video FILE.mp4");
  }
  if (!options.view.empty() && !options.camera.empty()) throw SetupError("either --view or --camera, not both");
  if (!(options.fps >= 1 && options.fps <= 240)) throw SetupError("--fps: must be from 1 to 240");
}

void write_video(PictureSource& source, io::Scene& scene, const RenderOptions& options) {
  const Duration length = time_of("--duration", options.duration.value_or(scene.spec().duration));
  Simulation& simulation = scene.simulation();
  const Duration end = simulation.now() + length;
  std::optional<io::VideoFile> video;
  for (Duration next = simulation.now(); next < end; next += source.period()) {
    simulation.run(std::max(Duration{}, next - simulation.now()));
    const sensors::ColorImage picture = source.take();
    if (!video) video.emplace(options.video, picture.width(), picture.height(), 1 / seconds(source.period()));
    video->add(picture);
  }
  if (!video) throw SetupError("--duration 0: a video needs some time");
  video->finish();
}

}  // namespace

int render(RenderOptions options) {
  check(options);
  if (options.view.empty() && options.camera.empty()) options.view = "overview";
  if (options.camera.empty() && options.size.empty()) options.size = "1280x720";
  io::check_writable(options.out.empty() ? options.video : options.out);
  const Duration time = time_of("--time", options.time);
  if (!options.light.empty()) options.overrides.push_back("light.name=" + options.light);
  io::Scene scene(options.scene, {.threads = options.threads,
                                  .seed = options.seed,
                                  .overrides = options.overrides,
                                  .events = options.events,
                                  .lenient = options.lenient});
  std::unique_ptr<PictureSource> source;
  if (!options.camera.empty()) source = std::make_unique<RobotCamera>(scene, options);
  scene.simulation().initialize();
  if (!source) source = std::make_unique<Eye>(scene, options);
  for (const std::string& warning : scene.report({}).warnings) fmt::print(stderr, "warning: {}\n", warning);
  scene.simulation().run(time);
  if (!options.video.empty()) {
    write_video(*source, scene, options);
  } else {
    io::write_file(options.out, render::image_png(source->take()));
  }
  return 0;
}

}  // namespace murosimf::app
