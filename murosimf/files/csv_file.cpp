#include "murosimf/files/csv_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/files/text_lines.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;

/// A cell and where it begins in its line.
struct Cell {
  std::string text;
  std::size_t column = 1;
};

/// The cells of a text, line by line.
class CellReader {
 public:
  explicit CellReader(const fs::path& file) : name_(file.string()) {
    text_ = read_input_file(file, most_table_bytes);
    if (text_.starts_with("\xef\xbb\xbf")) place_ = 3;  // byte order mark
  }

  /// Writes the cells of the next line that has any; false at the end of the file.
  bool next(std::vector<Cell>& cells) {
    cells.clear();
    while (place_ < text_.size() && cells.empty()) read_line(cells);
    return !cells.empty();
  }

  [[noreturn]] void fail(std::size_t column, const std::string& message) const {
    throw SetupError(one_line(fmt::format("{}:{}:{}: {}", name_, std::max<std::size_t>(1, line_), column, message)));
  }

 private:
  [[nodiscard]] bool at_end_of_line() const {
    return place_ >= text_.size() || text_[place_] == '\n' || text_.compare(place_, 2, "\r\n") == 0;
  }

  void read_line(std::vector<Cell>& cells) {
    line_ += 1 + lines_in_cells_;
    lines_in_cells_ = 0;
    line_begin_ = place_;
    while (!at_end_of_line() || !cells.empty()) {
      cells.push_back({{}, 1 + place_ - line_begin_});
      read_cell(cells.back());
      if (at_end_of_line()) break;
      ++place_;  // the comma
    }
    place_ = std::min(text_.size(), text_.find('\n', place_));
    if (place_ < text_.size()) ++place_;
  }

  void read_cell(Cell& cell) {
    if (place_ < text_.size() && text_[place_] == '"') return read_quoted(cell);
    while (!at_end_of_line() && text_[place_] != ',') cell.text += text_[place_++];
  }

  void read_quoted(Cell& cell) {
    for (++place_; place_ < text_.size(); ++place_) {
      if (text_[place_] == '"' && text_.compare(place_, 2, "\"\"") == 0)
        ++place_;
      else if (text_[place_] == '"')
        break;
      if (text_[place_] == '\n') ++lines_in_cells_;
      cell.text += text_[place_];
    }
    if (place_ >= text_.size()) fail(cell.column, "this quotation has no end");
    ++place_;
    if (!at_end_of_line() && text_[place_] != ',')
      fail(1 + place_ - line_begin_, "a comma is missing behind the quotes");
  }

  std::string name_, text_;
  std::size_t place_ = 0, line_begin_ = 0, line_ = 0, lines_in_cells_ = 0;
};

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  return begin == std::string_view::npos ? "" : text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

std::optional<double> number_of(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

CsvColumn column_named(std::string_view header) {
  header = trimmed(header);
  const auto bracket = header.rfind(" [");
  if (bracket == std::string_view::npos || !header.ends_with(']')) return {std::string(header), {}, {}, {}};
  return {std::string(header.substr(0, bracket)),
          std::string(header.substr(bracket + 2, header.size() - bracket - 3)),
          {},
          {}};
}

CsvTable read_header(CellReader& reader, std::vector<Cell>& cells) {
  if (!reader.next(cells)) reader.fail(1, "the file is empty");
  CsvTable table;
  table.time = cells[0].text;
  for (const Cell& cell : cells) {
    if (number_of(cell.text)) reader.fail(cell.column, "a number where the first line should have a name");
    if (&cell != &cells[0]) table.columns.push_back(column_named(cell.text));
  }
  if (table.columns.empty()) reader.fail(1, "there must be a column of time and at least one more");
  return table;
}

double number_in(const CellReader& reader, const Cell& cell) {
  if (const auto number = number_of(cell.text)) return *number;
  reader.fail(cell.column, fmt::format("{} is no number", files::quoted(cell.text)));
}

void read_row(const CellReader& reader, const std::vector<Cell>& cells, CsvTable& table) {
  if (cells.size() != table.columns.size() + 1) {
    reader.fail(1, fmt::format("{} cells, where the first line has {}", cells.size(), table.columns.size() + 1));
  }
  const double time = number_in(reader, cells[0]);
  if (!std::isfinite(time)) reader.fail(1, "the time must be a finite number");
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (trimmed(cells[i].text).empty()) continue;
    table.columns[i - 1].times.push_back(time);
    table.columns[i - 1].values.push_back(number_in(reader, cells[i]));
  }
}

}  // namespace

CsvTable read_csv(const fs::path& file) {
  CellReader reader(file);
  std::vector<Cell> cells;
  CsvTable table = read_header(reader, cells);
  while (reader.next(cells)) read_row(reader, cells, table);
  return table;
}

}  // namespace murosimf::files
