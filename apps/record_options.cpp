#include "apps/record_options.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/error_output.h"
#include "apps/results.h"
#include "apps/version.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/files/output_place.h"
#include "murosimf/model/error.h"

namespace murosimf::app {
namespace {

/// As it could be typed again: words with anything unusual in them are quoted.
std::string quoted(const std::string& word) {
  const std::string_view usual = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=.,:/+@%";
  if (!word.empty() && word.find_first_not_of(usual) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// Of "game.mcap": "game.foxglove.json".
std::filesystem::path layout_file(const std::filesystem::path& recording) {
  return std::filesystem::path(recording).replace_extension(".foxglove.json");
}

Duration span_of(const char* option, double s) {
  if (s >= 0.001 && s <= scene_file::longest_duration) return from_seconds(s);
  throw SetupError(fmt::format("{} {}: must be at least 0.001 s", option, s));
}

std::optional<recording::TimeSpan> ticks_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto dots = text.find("..");
  const auto number = [&](const std::string& word) {
    double s = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), s);
    const bool good = error == std::errc{} && end == word.data() + word.size() && s >= 0;
    if (dots == std::string::npos || !good || s > scene_file::longest_duration) {
      throw SetupError(fmt::format("--record-ticks '{}': write BEGIN..END in seconds, like 2.5..3", text));
    }
    return from_seconds(s);
  };
  const recording::TimeSpan span{number(text.substr(0, dots)),
                                 number(dots == std::string::npos ? "" : text.substr(dots + 2))};
  if (span.end < span.begin) throw SetupError(fmt::format("--record-ticks '{}': it ends before it begins", text));
  return span;
}

std::set<std::string> what_of(const RecordOptions& options) {
  if (options.what.empty()) return recording::usually_recorded();
  return {options.what.begin(), options.what.end()};
}

recording::RecorderOptions recorder_options(const RecordOptions& options) {
  return {.file = options.file,
          .rate = options.rate,
          .what = what_of(options),
          .program = this_program(),
          .command_line = command_line(),
          .state_period = span_of("--record-states", options.states),
          .ticks = ticks_of(options.ticks),
          .record_on = {options.on.begin(), options.on.end()},
          .keep = span_of("--keep", options.keep)};
}

}  // namespace

std::string this_program() { return fmt::format("murosimf {} ({})", version_number(), version_commit()); }

std::string command_line() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  const std::string words{std::istreambuf_iterator<char>(file), {}};
  std::string line;
  for (std::size_t begin = 0; begin < words.size();) {
    const std::string word = words.c_str() + begin;  // each ends with a zero
    line += (line.empty() ? "" : " ") + quoted(word);
    begin += word.size() + 1;
  }
  return line;
}

void add_record(const Command& command, RecordOptions& options) {
  const Option record = command.add("--record", options.file, "Record the run to this file (MCAP)");
  command.add("--record-rate", options.rate, "How often poses, joints and contacts are recorded, in Hz")
      .needs(record)
      .shows_default();
  command
      .add("--record-what", options.what,
           fmt::format("What is recorded, of {}; all but sensors and pictures if not given",
                       fmt::join(recording::recordable(), ", ")))
      .needs(record)
      .separated_by(',')
      .one_of(recording::recordable())
      .offers(recording::recordable());
  command.add("--record-states", options.states, "Seconds from one whole state to the next, from which a run can go on")
      .needs(record)
      .shows_default();
  command
      .add("--record-ticks", options.ticks,
           "BEGIN..END in seconds: the whole state of every step between, so that 'rerun' finds the first that differs")
      .needs(record);
  const Option on =
      command
          .add("--record-on", options.on,
               fmt::format("Record only what is around one of these: {} (for, by supervisors or in the window)",
                           fmt::join(recording::watchable(), ", ")))
          .needs(record)
          .separated_by(',')
          .one_of(recording::watchable())
          .offers(recording::watchable());
  command.add("--keep", options.keep, "Seconds before that, at least; two seconds after it are recorded, too")
      .needs(on)
      .shows_default();
}

recording::RunDescription description_of(const SceneArguments& arguments, const scene::Scene& scene,
                                         const scene::SceneOptions& options) {
  return {.scene = arguments.file,
          .seed = scene.spec().seed,
          .overrides = options.overrides,
          .events = options.events,
          .pushes = options.pushes,
          .plugins = arguments.plugins,
          .libraries = options.libraries,
          .lenient = options.lenient,
          .cameras = options.cameras,
          .pushable = options.pushable};
}

bool is_asked_for(const RecordOptions& options) { return std::ranges::find(options.on, "asked") != options.on.end(); }

void check(const RecordOptions& options, bool somebody_asks) {
  if (options.file.empty()) return;
  if (is_asked_for(options) && !somebody_asks) {
    throw SetupError(
        "--record-on asked: nothing can ask here; supervisors can (run --supervise PORT), and the window (view)");
  }
  ticks_of(options.ticks);
  span_of("--record-states", options.states);
  span_of("--keep", options.keep);
  files::claim_output("--record", options.file);
  if (!files::OutputPlace(options.file).is_replaced()) return;
  files::claim_output("--record (its layout for Foxglove)", layout_file(options.file));
}

std::unique_ptr<recording::Recorder> make_recorder(scene::Scene& scene, const RecordOptions& options,
                                                   const files::FilesRead& files, const recording::RunDescription& run,
                                                   const drawing::DebugDrawSource* others) {
  recording::RecorderOptions all = recorder_options(options);
  all.others = others;
  all.run = run;
  all.files = &files;
  return options.file.empty() ? nullptr : std::make_unique<recording::Recorder>(scene, all);
}

std::unique_ptr<recording::Recorder> make_recorder(scene::Scene& scene, const RecordOptions& options,
                                                   const recording::RecordedRun& run) {
  recording::RecorderOptions all = recorder_options(options);
  all.run = run.description();
  all.files_of = &run.file();
  return options.file.empty() ? nullptr : std::make_unique<recording::Recorder>(scene, all);
}

void say_trouble(const recording::Recorder& recorder) {
  if (!recorder.trouble().empty()) say_warning("nothing is recorded any more: " + recorder.trouble());
}

bool finish(recording::Recorder& recorder, const scene::RunReport& report, const RecordOptions& options) {
  const bool was_good = recorder.trouble().empty();
  recorder.finish(report);
  const std::string trouble = recorder.trouble();
  const std::filesystem::path place = recorder.file().grows_at(), aside = recorder.file().set_aside();
  if (!aside.empty()) {
    say_note(
        fmt::format("'{}': this is what an earlier run had recorded that did not come to its end", aside.string()));
  }
  if (!trouble.empty()) {
    if (was_good) say_warning("the recording has no end: " + trouble);
    if (!place.empty() && place.extension() == ".part") {
      say_note(fmt::format("'{}' is as it was; what was recorded is in '{}'", options.file, place.string()));
    }
    return false;
  }
  if (!options.on.empty() && recorder.happened() == 0) {
    say_note(fmt::format("nothing of this happened: {}; nothing of the run is in '{}'", fmt::join(options.on, ", "),
                         options.file));
  }
  if (!files::OutputPlace(options.file).is_replaced()) return true;
  std::vector<std::string> robots;
  for (const scene::EntityReport& entity : report.entities) {
    if (!entity.level.empty()) robots.push_back(entity.name);
  }
  Results results;
  results.write([&] { files::write_file(layout_file(options.file), recording::foxglove_layout(robots)); });
  return results.all();
}

}  // namespace murosimf::app
