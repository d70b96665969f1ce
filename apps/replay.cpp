// `murosimf replay`: what a recording says of its run; the recording in browsers, or as a page that plays it.
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/option_values.h"
#include "apps/repeat_arguments.h"
#include "apps/results.h"
#include "apps/standard_output.h"
#include "apps/web_arguments.h"
#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/recording/mcap/growing_file.h"
#include "murosimf/recording/recorded_source.h"
#include "murosimf/world/time.h"

namespace murosimf::app {
namespace {

struct ReplayOptions {
  std::string file;  ///< MCAP
  std::string json;  ///< file, "-" for standard output
  std::string speed = "1";
  std::vector<std::string> plugins;
  WebArguments web;
};

void define(const Command& command, ReplayOptions& options) {
  command.add("file", options.file, "Recording (MCAP) of 'murosimf run --record'").required();
  add_web(command, options.web);
  command.add("--speed", options.speed, "Of --web: simulated seconds per second, or 'max'").shows_default();
  add_plugins(command, options.plugins);
  add_json(command, options.json);
}

std::string summary(const recording::McapReader& file) {
  const recording::McapContents& contents = file.contents();
  std::string text = fmt::format("{}: {} messages from {:.3f} to {:.3f} s, by {}\n", file.file().string(),
                                 contents.statistics.message_count, seconds(Duration(contents.statistics.start_time)),
                                 seconds(Duration(contents.statistics.end_time)), contents.header.library);
  for (const auto& [key, value] : recording::described(file, "murosimf")) {
    if (key != "program") text += fmt::format("{}: {}\n", key, value);
  }
  return text;
}

void write_html(const std::shared_ptr<const recording::RecordedRun>& run, const recording::RepeatOptions& repeat,
                const WebArguments& arguments) {
  const auto others = std::make_shared<drawing::DebugDrawBuffer>();
  recording::RecordedSource source(run, repeat, others);
  web::HtmlRecording page(
      source.scene(), {.file = arguments.html, .rate = arguments.html_rate, .by_hand = true, .others = others.get()});
  source.begin();
  for (Duration time = source.first(); time < source.last() && !interrupted(); time += page.period()) {
    source.seek(time, {}, [] { return false; });
    page.take_frame();
  }
  if (!interrupted()) source.seek(source.last(), {}, [] { return false; });
  page.finish();
}

void show_in_browsers(const std::shared_ptr<const recording::RecordedRun>& run, const recording::RepeatOptions& repeat,
                      const ReplayOptions& options) {
  const auto others = std::make_shared<drawing::DebugDrawBuffer>();
  session::Session session(std::make_unique<recording::RecordedSource>(run, repeat, others),
                           {.speed = read_speed(options.speed)});
  const auto view = web_view_of(session.scene(), session, options.web, {.others = others.get()});
  session.run(run->end());
}

int replay(const ReplayOptions& options) {
  check_json_file(options.json);
  check(options.web);
  const recording::McapReader file(options.file);
  if (!file.contents().damage.empty()) {
    say_warning(fmt::format("{}: {}; 'murosimf repair' mends it", options.file, file.contents().damage));
  }
  if (!file.contents().other_run.empty()) say_warning(fmt::format("{}: {}", options.file, file.contents().other_run));
  if (const std::string diagnostic = recording::part_diagnostic(options.file); !diagnostic.empty())
    say_note(diagnostic);
  Results results;
  if (!options.web.web.empty() || !options.web.html.empty()) {
    end_gently();
    const RepeatArguments arguments{.plugins = options.plugins};
    const auto run = recorded_run_of(options.file, arguments);
    if (!options.web.html.empty()) results.write([&] { write_html(run, options_of(arguments), options.web); });
    if (!options.web.web.empty()) show_in_browsers(run, options_of(arguments), options);
  }
  const std::string text = recording::attached_text(file, "report.txt"),
                    json = recording::attached_text(file, "report.json");
  const std::string missing = "there is no report in it: its run did not come to its end\n";
  results.write([&] {
    write_result(options.json, summary(file) + "\n" + (text.empty() ? missing : text), json.empty() ? "null\n" : json);
  });
  return results.exit_code(exit_code());
}

}  // namespace

void add_replay(CommandLine& line) {
  line.add<ReplayOptions>("replay", "Say what a recording holds, with the report of its run; show it in browsers",
                          define, replay);
}

}  // namespace murosimf::app
