// `murosimf replay`: what a recording says of its run.
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/last_words.h"
#include "apps/standard_output.h"
#include "murosimf/model/time.h"
#include "murosimf/recording/recorded_run.h"

namespace murosimf::app {
namespace {

struct ReplayOptions {
  std::string file;  ///< MCAP
  std::string json;  ///< file, "-" for standard output
};

void define(const Command& command, ReplayOptions& options) {
  command.add("file", options.file, "Recording (MCAP) of 'murosimf run --record'").required();
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

int replay(const ReplayOptions& options) {
  check_json_file(options.json);
  const recording::McapReader file(options.file);
  if (!file.contents().damage.empty()) {
    say_warning(fmt::format("{}: {}; 'murosimf repair' mends it", options.file, file.contents().damage));
  }
  const std::string text = recording::attached_text(file, "report.txt"),
                    json = recording::attached_text(file, "report.json");
  const std::string missing = "there is no report in it: its run did not come to its end\n";
  write_result(options.json, summary(file) + "\n" + (text.empty() ? missing : text), json.empty() ? "null\n" : json);
  return 0;
}

}  // namespace

void add_replay(CommandLine& line) {
  line.add<ReplayOptions>("replay", "Say what a recording holds, with the report of its run", define, replay);
}

}  // namespace murosimf::app
