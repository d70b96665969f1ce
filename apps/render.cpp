// `murosimf render`: a picture or a video of a scene, from a place by name or through a robot's camera.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/option_values.h"
#include "apps/picture_files.h"
#include "apps/picture_overlay.h"
#include "apps/picture_sheet.h"
#include "apps/picture_source.h"
#include "apps/render_dataset.h"
#include "apps/render_options.h"
#include "apps/repeat_arguments.h"
#include "apps/results.h"
#include "murosimf/appearance/video_file.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/recording/recorded_series.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_labels.h"
#include "murosimf/scene/scene_report.h"

namespace murosimf::app {
namespace {

void define_dataset(const Command& command, RenderOptions& options) {
  const Option dataset =
      command.add("--dataset", options.dataset,
                  "Folder for labelled pictures to train vision with (COCO, YOLO, depths, masks); continues it");
  command.add("--frames", options.frames, "Pictures of a data set")
      .needs(dataset)
      .within(1, 10'000'000)
      .shows_default();
  command
      .add("--randomise", options.randomise,
           "What varies in a data set: a file (TOML), or the name of one that comes with the program")
      .needs(dataset)
      .offers_list("datasets")
      .shows_default();
  command.add("--normals", options.normals, "Pictures of a data set have normals of surfaces, too").needs(dataset);
}

void define(const Command& command, RenderOptions& options) {
  add_scene(command, options.scene,
            "Scene file (TOML), the name of one that comes with the program, or a recording or state (MCAP)");
  command.add("--time", options.time, "Simulated seconds before the picture, or before the video begins");
  command.add("--view", options.view,
              "From where: overview (usual), top, side, left, right, a robot's name, or a view of the scene");
  const Option camera = command.add("--camera", options.camera, "ROBOT.CAMERA: through a camera that a robot carries");
  command
      .add("--follow", options.follow,
           "From near, with these robots or the ball in the picture as they move; 'all': everything that moves")
      .separated_by(',')
      .excludes(camera);
  command.add("--size", options.size, "WIDTHxHEIGHT in pixels; 1280x720 if not given, 640x480 of a data set");
  command
      .add("--layer", options.layer,
           "color; depth (16 bits, mm, 0: nothing) or labels (16 bits, FILE.labels.json has their names), as PNG or "
           ".mkv; depth_shown or labels_shown: in colors, for people")
      .shows_default();
  command.add("--light", options.light,
              "hall, day, evening, spots, night or plain: surroundings and lamps, instead of the scene's");
  command.add("--no-shadows", options.no_shadows, "No shadows in pictures from a view").excludes(camera);
  command
      .add("--stance", options.stance, "Yellow feet where a robot stands at kinematic_walking, in pictures from a view")
      .excludes(camera);
  command
      .add("--drawings", options.drawings,
           "What control software draws, in pictures from a view: groups as ROBOT/NAME, or all of them; of recordings "
           "also what other programs drew: roboviz/NAME")
      .value_if_alone("all")
      .separated_by(',')
      .excludes(camera);
  add_overlay(command, options.overlay).excludes(camera);
  command
      .add("--inset", options.inset,
           "ROBOT.CAMERA: what a robot sees, in a corner of pictures from a view, with its name")
      .excludes(camera);
  const Option out = command.add("--out", options.out, "PNG file to write");
  command
      .add(
          "--sheet", options.sheet,
          "COLUMNSxROWS: so many pictures of --size over the duration, row by row, each with its time, in one PNG file")
      .needs(out)
      .excludes(camera);
  const Option video = command.add("--video", options.video, "Video file to write, .mp4, .webm or .gif (needs ffmpeg)");
  command.add("--fps", options.fps, "Pictures per second of a video; a camera has its own")
      .needs(video)
      .excludes(camera)
      .shows_default();
  command.add("--slow", options.slow, "Slow motion: a video takes so many times longer than what it shows")
      .needs(video)
      .shows_default();
  command.add("--duration", options.duration, "Simulated seconds of a video or a sheet, instead of the scene's");
  define_dataset(command, options);
}

Duration time_of(const char* option, double s) {
  if (!(s >= 0 && s <= scene_file::longest_duration))
    throw SetupError(fmt::format("{} {}: must be a number from 0", option, s));
  return from_seconds(s);
}

/// "seen.labels.json" beside "seen.png".
std::string label_file(const RenderOptions& options) {
  const std::filesystem::path picture = options.video.empty() ? options.out : options.video;
  return std::filesystem::path(picture).replace_extension(".labels.json").string();
}

/// What can be found out before anything is computed.
void check(const RenderOptions& options) {
  if (options.out.empty() == options.video.empty()) {
    throw SetupError(
        "say where the picture goes: either --out FILE.png or --video FILE.mp4; a data set: --dataset FOLDER");
  }
  if (!options.view.empty() && !options.camera.empty()) throw SetupError("either --view or --camera, not both");
  if (!options.view.empty() && !options.follow.empty()) throw SetupError("either --view or --follow, not both");
  check_rates(options.fps, options.slow);
  if (options.duration && options.video.empty() && options.sheet.empty()) {
    throw SetupError("--duration: a picture has none; --time says when it is taken");
  }
  if (!options.sheet.empty()) (void)read_sheet(options);
  if (options.duration && time_of("--duration", *options.duration) == Duration{}) refuse_no_time();
  if (!options.light.empty()) check_light(options.light);
  if (options.video.empty()) {
    claim_picture("--out", options.out);
  } else {
    has_numbers(options) ? appearance::check_number_video(options.video) : appearance::check_video(options.video);
    files::claim_output("--video", options.video);
  }
  if (has_labels(options)) files::claim_output("--layer labels", label_file(options));
}

/// Tells the user, after an interruption, up to where the output is complete.
void say_stopped(const RenderOptions& options, const Simulation& simulation, bool written) {
  const std::string file = options.video.empty() ? options.out : options.video;
  say_error(fmt::format("stopped by {} at {:.3f} s; {}", signal_name(), seconds(simulation.now()),
                        written ? fmt::format("'{}' ends there", file) : fmt::format("there is no '{}'", file)));
}

/// The recording that is drawn; nothing: a scene is.
std::shared_ptr<const recording::RecordedRun> run_of(const SceneArguments& arguments) {
  if (!recording::is_recording(arguments.file)) return nullptr;
  refuse_changes(arguments);
  auto run = std::make_shared<const recording::RecordedRun>(arguments.file);
  check_plugins(*run, repeat_arguments(arguments));
  return run;
}

/// Whether robots' cameras are in the pictures.
bool looks_through(const RenderOptions& options) { return !options.camera.empty() || !options.inset.empty(); }

std::vector<std::string> overrides_of(const RenderOptions& options) {
  return options.light.empty() ? std::vector<std::string>{} : std::vector{"light.name=" + options.light};
}

std::shared_ptr<scene::Scene> build(const RenderOptions& options) {
  scene::SceneOptions scene_options = options_of(options.scene);
  for (const std::string& change : overrides_of(options)) scene_options.overrides.push_back(change);
  return std::make_shared<scene::Scene>(options.scene.file, scene_options);
}

std::shared_ptr<scene::Scene> build(const recording::RecordedRun& run, const RenderOptions& options) {
  load_plugins(options.scene.plugins);
  recording::RepeatOptions repeat = options_of(repeat_arguments(options.scene));
  repeat.overrides = overrides_of(options);
  if (looks_through(options)) repeat.cameras = true;
  return run.build(repeat);
}

/// Another light, or cameras that were off, are in none of the recorded states: the run is repeated from its start then.
void begin(const recording::RecordedRun& run, scene::Scene& scene, const RenderOptions& options) {
  const bool as_then = options.light.empty() && (!looks_through(options) || run.description().cameras);
  // states have no pictures of cameras that were not used then; from then on these are drawn
  const Duration time = time_of("--time", options.time) - (looks_through(options) ? 1 : 0) * std::chrono::seconds(1);
  if (time_of("--time", options.time) > run.end()) {
    throw SetupError(fmt::format("--time {}: the recording ends at {} s", options.time, seconds(run.end())));
  }
  run.begin(scene, std::max(Duration{}, time), as_then);
}

int render(const RenderOptions& given) {
  if (!given.dataset.empty()) return render_dataset(given);
  check(given);
  end_gently();
  RenderOptions options = given;
  if (options.view.empty() && options.camera.empty() && options.follow.empty()) options.view = "overview";
  if (options.camera.empty() && options.size.empty()) options.size = options.sheet.empty() ? "1280x720" : sheet_picture;
  const Duration time = time_of("--time", options.time);
  const std::shared_ptr<const recording::RecordedRun> run = run_of(options.scene);
  const std::shared_ptr<scene::Scene> built = run ? build(*run, options) : build(options);
  scene::Scene& scene = *built;
  Simulation& simulation = scene.simulation();
  std::unique_ptr<PictureSource> source;
  if (!options.camera.empty()) source = make_robot_camera(scene, options);
  std::unique_ptr<CameraFeed> inset;
  if (!options.inset.empty()) inset = std::make_unique<CameraFeed>(scene, "--inset", options.inset);
  if (run) {
    begin(*run, scene, options);
  } else {
    simulation.initialize();
  }
  if (!source) source = make_eye(scene, options, run, std::move(inset));
  for (const std::string& warning : make_report(scene).warnings) say_warning(warning);
  run_with_progress(simulation, time);
  const double duration =
      options.duration.value_or(run ? seconds(run->end() - simulation.now()) : scene.spec().duration);
  const bool written = !options.video.empty()   ? write_video(*source, simulation, options, duration)
                       : !options.sheet.empty() ? write_sheet(*source, simulation, options, duration)
                                                : write_picture(*source, simulation, options);
  if (written && has_labels(options)) files::write_file(label_file(options), scene::label_table_json(scene) + "\n");
  if (const auto line = events_to_come(scene); !run && !interrupted() && !line.empty()) say_warning(line);
  if (interrupted()) say_stopped(options, simulation, written);
  return exit_code();
}

}  // namespace

void add_render(CommandLine& line) {
  line.add<RenderOptions>("render", "Draw a scene or a recording: a picture or a video, for people or through a camera",
                          define, render);
}

}  // namespace murosimf::app
