// `murosimf check`: reads a model and shows what is in it.
#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/standard_output.h"
#include "murosimf/io/data_path.h"
#include "murosimf/io/robot_reader.h"
#include "murosimf/io/model_report.h"

namespace murosimf::app {

int check(const CheckOptions& options) {
  check_json_file(options.json);
  const auto file = io::find_data_file(options.model, "models", ".xml");
  const io::RobotFile result = io::read_robot(file, {.lenient = options.lenient});
  const io::ModelReport report = io::make_report(*result.model, result.warnings, result.notes);
  write_result(options.json, io::to_text(report), io::to_json(report));
  return 0;
}

}  // namespace murosimf::app
