// `murosimf plot`: draws a table of numbers over time.
#include <filesystem>

#include <fmt/format.h>

#include "apps/commands.h"
#include "murosimf/files/csv_file.h"
#include "murosimf/logging/log_plot.h"
#include "murosimf/model/error.h"

namespace murosimf::app {

int plot(const PlotOptions& options) {
  namespace fs = std::filesystem;
  const fs::path file = options.file;
  const fs::path picture = options.out.empty() ? fs::path(file).replace_extension(".png") : fs::path(options.out);
  if (picture == file)
    throw SetupError(fmt::format("'{}' is the table itself; name a picture: --out FILE.png", options.file));
  const files::CsvTable table = files::read_csv(file);
  logging::write_plot(picture, with_context(options.file, [&] {
                        return logging::plot_of(table, file.filename().string(), options.patterns);
                      }));
  return 0;
}

}  // namespace murosimf::app
