// `murosimf highlights`: finds the goals, kicks, falls and get-ups of a recording, and cuts them to one video.
#include <algorithm>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/option_values.h"
#include "apps/picture_overlay.h"
#include "apps/progress.h"
#include "apps/repeat_arguments.h"
#include "apps/results.h"
#include "apps/standard_output.h"
#include "murosimf/appearance/video_file.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/recording/moments.h"
#include "murosimf/render/caption.h"
#include "murosimf/render/renderer.h"
#include "murosimf/scene/action_view.h"
#include "murosimf/scene/scene_pictures.h"
#include "murosimf/studies/text_table.h"
#include "murosimf/web/html_recording.h"

namespace murosimf::app {
namespace {

using recording::Clip;
using recording::Moment;

struct HighlightOptions {
  std::string file;   ///< MCAP
  std::string video;  ///< empty: only the table
  std::string html;   ///< empty: none
  std::string json;   ///< file, "-" for standard output
  std::vector<std::string> what = recording::moment_kinds();
  int most = 8;
  std::string size = "1280x720";
  double fps = 25;
  double slow = 1;
  std::string light;
  std::vector<std::string> overlay;
  RepeatArguments repeat;
};

void define(const Command& command, HighlightOptions& options) {
  command.add("file", options.file, "Recording (MCAP) of 'murosimf run --record'").required();
  command.add("--video", options.video,
              "Video file to write, .mp4, .webm or .gif (needs ffmpeg); without: only the table");
  command.add("--html", options.html,
              "HTML file to write: the clips in a page that plays them in any browser and jumps to moments");
  command
      .add("--what", options.what, "Kinds of moments: " + fmt::format("{}", fmt::join(recording::moment_kinds(), ", ")))
      .separated_by(',')
      .one_of(recording::moment_kinds())
      .offers(recording::moment_kinds());
  command.add("--most", options.most, "At most so many moments, those most worth seeing")
      .within(1, 1000)
      .shows_default();
  command.add("--size", options.size, "WIDTHxHEIGHT in pixels").shows_default();
  command.add("--fps", options.fps, "Pictures per second").shows_default();
  command.add("--slow", options.slow, "Slow motion: the video takes so many times longer than what it shows")
      .shows_default();
  command.add("--light", options.light, "hall, day, evening, spots, night or plain, instead of the scene's");
  add_overlay(command, options.overlay);
  add_repeat(command, options.repeat);
  add_json(command, options.json);
}

void check(const HighlightOptions& options) {
  (void)read_size(options.size);
  check_rates(options.fps, options.slow);
  if (!options.light.empty()) check_light(options.light);
  check_json_file(options.json);
  if (!options.html.empty()) files::claim_output("--html", options.html);
  if (options.video.empty()) return;
  appearance::check_video(options.video);
  files::claim_output("--video", options.video);
}

std::string table_of(const std::vector<Moment>& moments, const std::vector<Clip>& clips) {
  studies::TextTable table;
  table.add({"moment", "at", "clip"});
  for (const Moment& moment : moments) {
    const auto shows = [&](const Clip& clip) {
      return std::ranges::any_of(clip.moments, [&](const Moment& one) {
        return one.time == moment.time && one.kind == moment.kind && one.robot == moment.robot;
      });
    };
    const auto clip = std::ranges::find_if(clips, shows);
    table.add({text_of(moment), fmt::format("{:.2f} s", seconds(moment.time)),
               clip == clips.end() ? "-" : fmt::format("{}", clip - clips.begin() + 1)});
  }
  return moments.empty() ? "no moments of these kinds\n" : table.text();
}

std::string json_of(const std::vector<Moment>& moments, const std::vector<Clip>& clips) {
  nlohmann::ordered_json json{{"moments", nlohmann::json::array()}, {"clips", nlohmann::json::array()}};
  for (const Moment& one : moments) {
    nlohmann::ordered_json moment{{"kind", name_of(one.kind)}, {"time", seconds(one.time)}};
    if (!one.robot.empty()) moment["robot"] = one.robot;
    if (one.kind == Moment::Kind::kick) moment["ball_speed"] = one.speed;
    json["moments"].push_back(moment);
  }
  for (const Clip& clip : clips) json["clips"].push_back({{"begin", seconds(clip.begin)}, {"end", seconds(clip.end)}});
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// The last one that has begun to show itself, or else the first.
const Moment& shown_moment(const Clip& clip, Duration now) {
  const Moment* shown = &clip.moments.front();
  for (const Moment& moment : clip.moments) {
    if (moment.time - std::chrono::milliseconds(400) <= now) shown = &moment;
  }
  return *shown;
}

[[noreturn]] void refuse_nothing(const HighlightOptions& options, std::string_view file) {
  throw SetupError(
      fmt::format("{}: there is nothing of this in it: {}; no {}", options.file, fmt::join(options.what, ", "), file));
}

/// Draws clips into a video.
class Cutter {
 public:
  /// `overlay`: null, or with the scene of the source.
  Cutter(recording::RecordedSource& source, const HighlightOptions& options, PictureOverlay* overlay)
      : source_(source),
        options_(options),
        size_(read_size(options.size)),
        step_(1 / (options.fps * options.slow)),
        painter_(source.scene(),
                 [light = options.light](scene_file::LightSpec& spec) {
                   if (!light.empty()) spec.name = light;
                   spec.shadows = true;
                   spec.samples = std::max(spec.samples, 4);
                 }),
        view_(source.scene()),
        overlay_(overlay),
        video_(options.video, appearance::VideoFile::Pixels::colors, size_.width, size_.height, options.fps) {}

  /// Until it is interrupted.
  void cut(const std::vector<Clip>& clips) {
    double length = 0, done = 0;
    for (const Clip& clip : clips) length += seconds(clip.end - clip.begin);
    for (const Clip& clip : clips) {
      followed_ = nullptr;
      for (std::int64_t i = 0;; ++i) {
        const Duration time = clip.begin + from_seconds(static_cast<double>(i) * step_);
        if (time > clip.end || interrupted()) break;
        draw(clip, time);
        line_.show(std::min(1.0, (done + seconds(time - clip.begin)) / length), fmt::format("{:.2f} s", seconds(time)));
      }
      done += seconds(clip.end - clip.begin);
    }
    video_.finish();
  }

 private:
  void draw(const Clip& clip, Duration time) {
    source_.seek(time, {}, [] { return false; });
    const Moment& moment = shown_moment(clip, time);
    if (followed_ != &moment) {
      const Entity* ball = source_.scene().parts().ball;
      view_.follow({moment.robot.empty() && ball ? ball->name() : moment.robot}, followed_ == nullptr);
      followed_ = &moment;
    }
    sensors::View seen;
    render::Renderer& renderer = painter_.renderer();
    const sensors::Perspective from = view_.look(size_.width, size_.height);
    renderer.draw(from, {.color = true}, 0, seen);
    if (const std::string trouble = renderer.trouble(); !trouble.empty()) throw SetupError(trouble);
    if (overlay_) overlay_->draw(from, seen.color);
    const bool has_time = has_word(options_.overlay, "time");
    render::draw_caption(seen.color, (has_time ? "" : fmt::format("{:.2f} s   ", seconds(time))) + text_of(moment));
    video_.add(seen.color);
  }

  recording::RecordedSource& source_;
  const HighlightOptions& options_;
  PictureSize size_;
  double step_;  // [s] of simulated time
  scene::ScenePainter painter_;
  scene::ActionView view_;
  PictureOverlay* overlay_;
  appearance::VideoFile video_;
  const Moment* followed_ = nullptr;
  Progress line_;
};

/// Writes clips and moments into a page, until it is interrupted.
void write_html(recording::RecordedSource& source, const HighlightOptions& options, const std::vector<Clip>& clips) {
  web::HtmlRecording page(source.scene(), {.file = options.html, .rate = options.fps, .by_hand = true});
  for (const Clip& clip : clips) {
    for (Duration time = clip.begin; time <= clip.end && !interrupted(); time += page.period()) {
      source.seek(time, {}, [] { return false; });
      page.take_frame();
    }
    for (const Moment& moment : clip.moments) page.note(moment.time, text_of(moment));
  }
  page.finish();
}

int highlights(const HighlightOptions& options) {
  check(options);
  end_gently();
  const auto run = recorded_run_of(options.file, options.repeat);
  recording::RecordedSource source(run, options_of(options.repeat));
  std::optional<PictureOverlay> overlay;
  if (!options.overlay.empty()) overlay.emplace(source.scene(), options.overlay);
  std::vector<Moment> moments = find_moments(source, interrupted);
  if (overlay) overlay->read_score(*run, moments);
  const std::set<std::string> kinds(options.what.begin(), options.what.end());
  std::erase_if(moments, [&](const Moment& one) { return !kinds.contains(std::string(name_of(one.kind))); });
  const std::vector<Clip> clips =
      clips_of(moments, kinds, static_cast<std::size_t>(options.most), source.first(), source.last());
  Results results;
  results.write([&] { write_result(options.json, table_of(moments, clips), json_of(moments, clips)); });
  if (!options.video.empty() && !interrupted()) {
    results.write([&] {
      if (clips.empty()) refuse_nothing(options, "video");
      Cutter(source, options, overlay ? &*overlay : nullptr).cut(clips);
    });
  }
  if (!options.html.empty() && !interrupted()) {
    results.write([&] {
      if (clips.empty()) refuse_nothing(options, "page");
      write_html(source, options, clips);
    });
  }
  if (interrupted()) say_error(fmt::format("stopped by {}", signal_name()));
  return results.exit_code(exit_code());
}

}  // namespace

void add_highlights(CommandLine& line) {
  line.add<HighlightOptions>("highlights", "Cut the goals, kicks, falls and get-ups of a recording to one video",
                             define, highlights);
}

}  // namespace murosimf::app
