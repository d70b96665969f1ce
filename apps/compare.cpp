// `murosimf compare`: which level of detail is adequate for an experiment.
#include <unistd.h>

#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/standard_output.h"
#include "murosimf/io/compare_report.h"

namespace murosimf::app {
namespace {

/// One line on the terminal that says what runs; nothing if standard error is no terminal.
void show_progress(const std::string& what) {
  if (isatty(STDERR_FILENO) == 0) return;
  fmt::print(stderr, "\r\033[K{}{}", what.empty() ? "" : "compare: ", what);
  std::fflush(stderr);
}

}  // namespace

int compare(const CompareCommand& command) {
  io::Thresholds thresholds;
  for (const std::string& text : command.thresholds) thresholds.set(text);
  // where results go is checked before anything is computed, so that no result is lost
  check_json_file(command.json);
  if (!command.plots.empty()) io::check_plots(command.plots);

  io::CompareOptions options = command.options;
  options.progress = show_progress;
  const io::Comparison comparison = io::compare(options);
  show_progress({});
  const io::Recommendation recommendation = io::recommend(comparison, thresholds);
  write_result(command.json, io::to_text(comparison, recommendation),
               io::to_json(comparison, recommendation, thresholds));
  if (!command.plots.empty()) io::write_plots(comparison, command.plots);
  return 0;
}

}  // namespace murosimf::app
