// `murosimf compare`: which level of detail is adequate for an experiment.
#include <optional>

#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/interruption.h"
#include "apps/last_words.h"
#include "apps/progress.h"
#include "apps/standard_output.h"
#include "murosimf/compare/compare_report.h"

namespace murosimf::app {
int compare(const CompareCommand& command) {
  compare::Thresholds thresholds;
  for (const std::string& text : command.thresholds) thresholds.set(text);
  // where results go is checked before anything is computed, so that no result is lost
  check_json_file(command.json);
  if (!command.plots.empty()) compare::check_plots(command.plots);

  end_gently();
  std::optional<Progress> progress(std::in_place);
  compare::CompareOptions options = command.options;
  options.progress = [&](double share, const std::string& what) { progress->show(share, what); };
  options.stop = interrupted;
  const compare::Comparison comparison = compare::compare(options);
  progress.reset();
  if (comparison.stopped) say_error(fmt::format("stopped by {}; what had not ended is missing", signal_name()));
  const compare::Recommendation recommendation = compare::recommend(comparison, thresholds);
  write_result(command.json, compare::to_text(comparison, recommendation),
               compare::to_json(comparison, recommendation, thresholds));
  if (!command.plots.empty() && !comparison.stopped) compare::write_plots(comparison, command.plots);
  return comparison.stopped ? exit_code() : 0;
}

}  // namespace murosimf::app
