#include "apps/sweep_arguments.h"

#include "apps/standard_output.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"

namespace murosimf::app {

bool is_manifest(const SweepArguments& arguments) { return arguments.runs.scene.file.ends_with(manifest_ending); }

void claim_tables(const SweepArguments& arguments) {
  check_json_file(arguments.runs.json);
  if (!arguments.csv.empty()) files::claim_output("--csv", arguments.csv);
  if (!arguments.summary.empty()) files::claim_output("--summary", arguments.summary);
}

void write_tables(Results& results, const SweepArguments& arguments, const studies::Sweep& sweep) {
  results.write([&] { write_result(arguments.runs.json, to_text(sweep), to_json(sweep)); });
  if (!arguments.csv.empty()) results.write([&] { files::write_file(arguments.csv, to_csv(sweep)); });
  if (!arguments.summary.empty()) results.write([&] { files::write_file(arguments.summary, summary_csv(sweep)); });
}

}  // namespace murosimf::app
