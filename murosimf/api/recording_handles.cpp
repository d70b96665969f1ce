// include/murosimf/recording.h.
#include "murosimf/recording.h"

#include <fmt/format.h>

#include "murosimf/api/scene_inside.h"
#include "murosimf/api/told.h"
#include "murosimf/recording/mcap/mcap_reader.h"
#include "murosimf/recording/recorded_series.h"
#include "murosimf/recording/recorder.h"
#include "murosimf/scene/scene_report.h"

namespace murosimf {

namespace api {

struct RecorderInside {
  std::shared_ptr<SceneInside> scene;
  recording::Recorder* recorder = nullptr;  // owned by the scene, since its simulation calls it
  bool finished = false;

  void finish() {
    if (finished) return;
    finished = true;
    told([&] { recorder->finish(scene::make_report(scene->scene)); });
    if (const std::string trouble = recorder->trouble(); !trouble.empty()) throw Error(trouble);
  }
};

struct RecordingInside {
  explicit RecordingInside(const std::string& name) : file(name) {}
  recording::McapReader file;
};

namespace {

/// Control software of the program is named as input from outside: the file alone cannot repeat it.
recording::RunDescription description_of(const SceneInside& inside) {
  const SceneOptions& options = inside.origin.options;
  std::vector<std::string> outside;
  if (!inside.controllers.empty()) outside.emplace_back("control software of a program (Robot::set_controller)");
  return {.scene = inside.origin.name,
          .seed = inside.scene.spec().seed,
          .overrides = options.set,
          .events = options.events,
          .pushes = options.pushes,
          .libraries = options.libraries,
          .lenient = options.lenient,
          .cameras = options.cameras,
          .pushable = true,
          .outside = std::move(outside),
          .names = inside.origin.files->names()};
}

/// "walker.torso.position.z [m]"
std::pair<std::string, std::string> name_and_unit(const std::string& title) {
  const std::size_t bracket = title.rfind(" [");
  if (bracket == std::string::npos || title.back() != ']') return {title, ""};
  return {title.substr(0, bracket), title.substr(bracket + 2, title.size() - bracket - 3)};
}

}  // namespace
}  // namespace api

inline namespace v0 {

using api::told;

/// A recorder that fails at its start leaves the scene as it was.
Recorder::Recorder(const Scene& scene, const std::string& file, double rate) {
  api::SceneInside& inside = scene.inside();
  auto recorder = told([&] {
    recording::RecorderOptions options{.file = file,
                                       .rate = rate,
                                       .program = fmt::format("libmurosimf {}", version()),
                                       .run = api::description_of(inside),
                                       .files = inside.origin.files.get(),
                                       .in_the_middle = inside.begun};
    return std::make_unique<recording::Recorder>(inside.scene, options);
  });
  inside_ = std::make_unique<api::RecorderInside>(api::RecorderInside{scene.inside_, recorder.get()});
  inside.recorders.push_back(std::move(recorder));
}

Recorder::~Recorder() {
  try {
    if (inside_) inside_->finish();
  } catch (const std::exception&) {  // errors are reported by finish() only
  }
}
Recorder::Recorder(Recorder&&) noexcept = default;
Recorder& Recorder::operator=(Recorder&&) noexcept = default;

void Recorder::finish() {
  if (!inside_) throw Error("this recorder was moved from");
  inside_->finish();
}

Recording::Recording(const std::string& file)
    : inside_(told([&] { return std::make_shared<const api::RecordingInside>(file); })) {}

std::vector<std::string> Recording::names() const {
  std::vector<std::string> names;
  for (Series& each : series()) names.push_back(std::move(each.name));
  return names;
}

std::vector<Series> Recording::series(const std::string& pattern) const {
  return told([&] {
    const std::vector<std::string> patterns = pattern.empty() ? std::vector<std::string>{} : std::vector{pattern};
    std::vector<Series> all;
    for (logging::LogSeries& found : recording::series_of(inside_->file, patterns)) {
      auto [name, unit] = api::name_and_unit(found.names.at(0));
      Series series{std::move(name), std::move(unit), {}, std::move(found.values)};
      for (const Duration time : found.times) series.times.push_back(seconds(time));
      all.push_back(std::move(series));
    }
    return all;
  });
}

}  // namespace v0
}  // namespace murosimf
