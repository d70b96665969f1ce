#include "murosimf/files/csv_file.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/files/csv_cells.h"
#include "murosimf/math/assert.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;

using Cell = CsvCell;

CsvColumn column_named(std::string_view header) {
  CsvHeader said = csv_header(header);
  return {std::move(said.name), std::move(said.unit), {}, {}};
}

CsvTable read_header(CsvCells& reader, std::vector<Cell>& cells) {
  if (!reader.next(cells)) reader.fail(1, "the file is empty");
  CsvTable table;
  table.time = cells[0].text;
  for (const Cell& cell : cells) {
    if (reader.find_number(cell)) reader.fail(cell.column, "a number where the first line should have a name");
    if (&cell != &cells[0]) table.columns.push_back(column_named(cell.text));
  }
  if (table.columns.empty()) reader.fail(1, "there must be a column of time and at least one more");
  return table;
}

void read_row(const CsvCells& reader, const std::vector<Cell>& cells, CsvTable& table) {
  MUROSIMF_ASSERT(!cells.empty());
  if (cells.size() != table.columns.size() + 1) {
    reader.fail(1, fmt::format("{} cells, where the first line has {}", cells.size(), table.columns.size() + 1));
  }
  const double time = reader.number(cells[0]);
  if (!std::isfinite(time)) reader.fail(1, "the time must be a finite number");
  for (std::size_t i = 1; i < cells.size(); ++i) {
    // An empty cell is a missing sample: columns may have different times.
    if (is_blank(cells[i])) continue;
    table.columns[i - 1].times.push_back(time);
    table.columns[i - 1].values.push_back(reader.number(cells[i]));
  }
  MUROSIMF_ASSERT(table.columns.front().times.size() == table.columns.front().values.size());
}

}  // namespace

CsvTable read_csv(const fs::path& file) {
  CsvCells reader(file);
  std::vector<Cell> cells;
  CsvTable table = read_header(reader, cells);
  while (reader.next(cells)) read_row(reader, cells, table);
  return table;
}

}  // namespace murosimf::files
