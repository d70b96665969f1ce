#include "apps/record_options.h"

#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "apps/last_words.h"
#include "apps/version.h"
#include "murosimf/files/output_file.h"

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

/// Empty where the system does not tell.
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

/// Of "game.mcap": "game.foxglove.json".
std::filesystem::path layout_file(const std::filesystem::path& recording) {
  return std::filesystem::path(recording).replace_extension(".foxglove.json");
}

std::set<std::string> what_of(const RecordOptions& options) {
  if (options.what.empty()) return recording::usually_recorded();
  return {options.what.begin(), options.what.end()};
}

}  // namespace

void add_record(const Command& command, RecordOptions& options) {
  const Option record = command.add("--record", options.file, "Record the run to this file (MCAP)");
  command.add("--record-rate", options.rate, "How often poses, joints and contacts are recorded, in Hz")
      .needs(record)
      .shows_default();
  command
      .add("--record-what", options.what,
           fmt::format("What is recorded, of {}; all but sensors and hashes if not given",
                       fmt::join(recording::recordable(), ", ")))
      .needs(record)
      .separated_by(',')
      .one_of(recording::recordable())
      .offers(recording::recordable());
}

void check(const RecordOptions& options) {
  if (options.file.empty()) return;
  files::check_writable(options.file);
  if (std::filesystem::is_other(options.file)) return;
  files::check_writable(layout_file(options.file));
}

std::unique_ptr<recording::Recorder> make_recorder(scene::Scene& scene, const RecordOptions& options,
                                                   const files::FilesRead& files) {
  if (options.file.empty()) return nullptr;
  return std::make_unique<recording::Recorder>(
      scene, recording::RecorderOptions{.file = options.file,
                                        .rate = options.rate,
                                        .what = what_of(options),
                                        .program = fmt::format("murosimf {} ({})", version_number(), version_commit()),
                                        .command_line = command_line(),
                                        .files = &files});
}

bool finish(recording::Recorder& recorder, const scene::RunReport& report, const RecordOptions& options) {
  const bool was_good = recorder.trouble().empty();
  recorder.finish(report);
  const std::string trouble = recorder.trouble();
  if (!trouble.empty()) {
    if (was_good) say_warning("the recording has no end: " + trouble);
    return false;
  }
  if (std::filesystem::is_other(options.file)) return true;
  std::vector<std::string> robots;
  for (const scene::EntityReport& entity : report.entities) {
    if (!entity.level.empty()) robots.push_back(entity.name);
  }
  files::write_file(layout_file(options.file), recording::foxglove_layout(robots));
  return true;
}

}  // namespace murosimf::app
