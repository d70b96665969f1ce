// `murosimf repair`: makes a recording whole that was cut off.
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/standard_output.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/recording/mcap/growing_file.h"
#include "murosimf/recording/mcap/mcap_repair.h"

namespace murosimf::app {
namespace {

struct RepairOptions {
  std::string file;  ///< MCAP
  std::string out;   ///< likewise; empty: in its place
};

void define(const Command& command, RepairOptions& options) {
  command.add("file", options.file, "Recording (MCAP) that was cut off or damaged").required();
  command.add("--out", options.out, "File to write, instead of replacing the damaged one");
}

int repair(const RepairOptions& options) {
  const std::string out = options.out.empty() ? options.file : options.out;
  if (!options.out.empty()) files::claim_output("--out", options.out);
  const recording::RepairReport report = recording::repair(options.file, out);
  std::string text = fmt::format("{}\n", report.damage.empty() ? "nothing was wrong" : report.damage);
  if (!report.other_run.empty()) text += report.other_run + "; the first one is written\n";
  text += fmt::format("'{}' is whole: {} messages up to {:.3f} s\n", out, report.messages, report.last_time);
  write_standard_output(text);
  if (const std::string diagnostic = recording::part_diagnostic(options.file); !diagnostic.empty())
    say_note(diagnostic);
  return 0;
}

}  // namespace

void add_repair(CommandLine& line) {
  line.add<RepairOptions>("repair", "Make a recording whole that was cut off or damaged", define, repair);
}

}  // namespace murosimf::app
