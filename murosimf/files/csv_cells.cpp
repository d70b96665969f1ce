#include "murosimf/files/csv_cells.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/files/text_lines.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  return begin == std::string_view::npos ? "" : text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

}  // namespace

CsvHeader csv_header(std::string_view cell) {
  cell = trimmed(cell);
  const auto bracket = cell.rfind(" [");
  if (bracket == std::string_view::npos || !cell.ends_with(']')) return {std::string(cell), {}};
  return {std::string(cell.substr(0, bracket)), std::string(cell.substr(bracket + 2, cell.size() - bracket - 3))};
}

bool is_blank(const CsvCell& cell) { return trimmed(cell.text).empty(); }

std::optional<double> number_in_cell(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

CsvCells::CsvCells(const std::filesystem::path& file) : name_(file.string()) {
  text_ = read_input_file(file, most_table_bytes);
  if (text_.starts_with("\xef\xbb\xbf")) place_ = 3;  // byte order mark
}

bool CsvCells::next(std::vector<CsvCell>& cells) {
  cells.clear();
  while (place_ < text_.size() && cells.empty()) read_line(cells);
  return !cells.empty();
}

double CsvCells::number(const CsvCell& cell) const {
  if (const auto number = number_in_cell(cell.text)) return *number;
  fail(cell.column, fmt::format("{} is no number", files::quoted(cell.text)));
}

void CsvCells::fail(std::size_t column, const std::string& message) const {
  throw SetupError(one_line(fmt::format("{}:{}:{}: {}", name_, std::max<std::size_t>(1, line_), column, message)));
}

bool CsvCells::at_end_of_line() const {
  return place_ >= text_.size() || text_[place_] == '\n' || text_.compare(place_, 2, "\r\n") == 0;
}

void CsvCells::read_line(std::vector<CsvCell>& cells) {
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

void CsvCells::read_cell(CsvCell& cell) {
  if (place_ < text_.size() && text_[place_] == '"') return read_quoted(cell);
  while (!at_end_of_line() && text_[place_] != ',') cell.text += text_[place_++];
}

void CsvCells::read_quoted(CsvCell& cell) {
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
  if (!at_end_of_line() && text_[place_] != ',') fail(1 + place_ - line_begin_, "a comma is missing behind the quotes");
}

}  // namespace murosimf::files
