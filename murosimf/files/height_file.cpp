#include "murosimf/files/height_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/files/csv_cells.h"
#include "murosimf/files/gray_png.h"
#include "murosimf/files/input_file.h"
#include "murosimf/files/lower_case.h"
#include "murosimf/files/npy_array.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

HeightTable read_csv_heights(const std::filesystem::path& file) {
  files::check_input_file(file, files::most_mesh_bytes);
  files::CsvCells lines(file);
  HeightTable table;
  std::vector<files::CsvCell> cells;
  while (lines.next(cells)) {
    if (table.rows > 0 && cells.size() != table.columns) {
      lines.fail(1, fmt::format("{} numbers, where the lines before have {}", cells.size(), table.columns));
    }
    table.columns = cells.size();
    ++table.rows;
    for (const files::CsvCell& cell : cells) {
      const double height = lines.number(cell);
      if (!std::isfinite(height)) lines.fail(cell.column, "a height must be finite");
      table.heights.push_back(height);
    }
    // Checked in every line: a file of a gigabyte of numbers is not read to its end.
    if (table.heights.size() > most_heights) break;
  }
  return table;
}

}  // namespace

void check_heights(std::string_view file, const HeightTable& table) {
  if (table.heights.size() > most_heights) {
    throw SetupError(fmt::format("{}: more than {} heights; make the grid coarser", file, most_heights));
  }
  if (table.rows < 2 || table.columns < 2) {
    throw SetupError(
        fmt::format("{}: {} rows of {} heights; at least two of two are needed", file, table.rows, table.columns));
  }
  const auto bad = std::ranges::find_if_not(table.heights, [](double height) { return std::isfinite(height); });
  if (bad == table.heights.end()) return;
  MUROSIMF_ASSERT(table.columns > 0);
  const auto place = static_cast<std::size_t>(bad - table.heights.begin());
  throw SetupError(fmt::format("{}: the height in row {}, column {} is not finite", file, place / table.columns + 1,
                               place % table.columns + 1));
}

HeightTable read_height_file(const std::filesystem::path& file) {
  const std::string kind = files::lower_case(file.extension().string());
  HeightTable table;
  if (kind == ".csv") {
    table = read_csv_heights(file);
  } else if (kind == ".npy") {
    table = npy_heights(file.string(), files::read_input_file(file, files::most_mesh_bytes));
  } else if (kind == ".png") {
    table = png_heights(file.string(), files::read_input_file(file, files::most_mesh_bytes));
  } else {
    throw SetupError(fmt::format("{}: heights are read from .png, .npy and .csv files", file.string()));
  }
  check_heights(file.string(), table);
  return table;
}

}  // namespace murosimf::files
