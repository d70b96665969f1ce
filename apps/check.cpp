// `murosimf check`: reads a model and shows what is in it.
#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/standard_output.h"
#include "murosimf/io/data_path.h"
#include "murosimf/io/mjcf_reader.h"
#include "murosimf/io/model_report.h"

namespace murosimf::app {

int check(const CheckOptions& options) {
  const auto file = io::find_data_file(options.model, "models", ".xml");
  const io::MjcfResult result = io::read_mjcf(file, {.lenient = options.lenient});
  const io::ModelReport report = io::make_report(*result.model, result.warnings, result.notes);
  write_standard_output(options.json ? io::to_json(report) : io::to_text(report));
  return 0;
}

}  // namespace murosimf::app
