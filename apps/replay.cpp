// `murosimf replay`: what a recording says of its run.
#include <algorithm>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/last_words.h"
#include "apps/standard_output.h"
#include "murosimf/model/time.h"
#include "murosimf/recording/mcap_reader.h"

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

/// What is attached under this name; empty if nothing is.
std::string attached(const recording::McapReader& file, const std::string& name) {
  const auto& all = file.contents().attachments;
  const auto found = std::ranges::find(all, name, &recording::AttachmentIndex::name);
  return found == all.end() ? std::string{} : file.attachment(*found).data;
}

recording::TextMap described(const recording::McapReader& file, const std::string& name) {
  const auto& all = file.contents().metadata;
  const auto found = std::ranges::find(all, name, &recording::MetadataIndex::name);
  return found == all.end() ? recording::TextMap{} : file.metadata(*found).values;
}

std::string summary(const recording::McapReader& file) {
  const recording::McapContents& contents = file.contents();
  std::string text = fmt::format("{}: {} messages from {:.3f} to {:.3f} s, by {}\n", file.file().string(),
                                 contents.statistics.message_count, seconds(Duration(contents.statistics.start_time)),
                                 seconds(Duration(contents.statistics.end_time)), contents.header.library);
  for (const auto& [key, value] : described(file, "murosimf")) {
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
  const std::string text = attached(file, "report.txt"), json = attached(file, "report.json");
  const std::string missing = "there is no report in it: its run did not come to its end\n";
  write_result(options.json, summary(file) + "\n" + (text.empty() ? missing : text), json.empty() ? "null\n" : json);
  return 0;
}

}  // namespace

void add_replay(CommandLine& line) {
  line.add<ReplayOptions>("replay", "Say what a recording holds, with the report of its run", define, replay);
}

}  // namespace murosimf::app
