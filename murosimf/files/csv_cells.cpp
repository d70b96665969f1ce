#include "murosimf/files/csv_cells.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/files/text_encoding.h"
#include "murosimf/files/text_lines.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::files {
namespace {

/// The most frequent separator between the names of a header, outside quotes and units in brackets; a comma if in doubt.
char separator_of(std::string_view header) {
  std::array<std::pair<char, int>, 3> counts{{{',', 0}, {';', 0}, {'\t', 0}}};
  bool quoted = false;
  int brackets = 0;
  for (const char c : header) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    brackets = std::max(0, brackets + (c == '[') - (c == ']'));
    for (auto& [separator, count] : counts) count += brackets == 0 && c == separator;
  }
  // The first of equal counts: the comma.
  return std::ranges::max_element(counts, {}, &std::pair<char, int>::second)->first;
}

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

CsvCells::CsvCells(const std::filesystem::path& file)
    : name_(file.string()), text_(read_text_file(file, most_table_bytes)) {
  find_separator();
}

void CsvCells::find_separator() {
  place_ = std::min(text_.find_first_not_of("\r\n"), text_.size());
  MUROSIMF_ASSERT(place_ <= text_.size());
  const std::string_view first = std::string_view(text_).substr(place_, text_.find_first_of("\r\n", place_) - place_);
  line_ =
      static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(place_), '\n'));
  if (first.size() == 5 && first.starts_with("sep=")) {
    separator_ = first.back();
    place_ = std::min(text_.find('\n', place_), text_.size() - 1) + 1;
    ++line_;
    return;
  }
  separator_ = separator_of(first);
}

std::optional<double> CsvCells::find_number(const CsvCell& cell) const {
  std::string_view text = trimmed(cell.text);
  if (text.starts_with('+')) text.remove_prefix(1);
  // from_chars does not depend on the locale of the program; a decimal comma is replaced here.
  std::string with_point(text);
  const bool decimal_comma = separator_ != ',' && text.find('.') == std::string_view::npos;
  if (const auto comma = with_point.find(','); decimal_comma && comma != std::string::npos) with_point[comma] = '.';
  double number = 0;
  const char* last = with_point.data() + with_point.size();
  const auto [end, error] = std::from_chars(with_point.data(), last, number);
  if (error != std::errc{} || end != last) return std::nullopt;
  return number;
}

bool CsvCells::next(std::vector<CsvCell>& cells) {
  cells.clear();
  while (place_ < text_.size() && cells.empty()) read_line(cells);
  return !cells.empty();
}

double CsvCells::number(const CsvCell& cell) const {
  if (const auto number = find_number(cell)) return *number;
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
  MUROSIMF_ASSERT(place_ < text_.size());
  while (!at_end_of_line() || !cells.empty()) {
    cells.push_back({{}, 1 + place_ - line_begin_});
    read_cell(cells.back());
    if (at_end_of_line()) break;
    ++place_;  // the separator
  }
  place_ = std::min(text_.size(), text_.find('\n', place_));
  if (place_ < text_.size()) ++place_;
  MUROSIMF_ASSERT(place_ > line_begin_ && place_ <= text_.size());
}

void CsvCells::read_cell(CsvCell& cell) {
  if (place_ < text_.size() && text_[place_] == '"') return read_quoted(cell);
  while (!at_end_of_line() && text_[place_] != separator_) cell.text += text_[place_++];
}

void CsvCells::read_quoted(CsvCell& cell) {
  MUROSIMF_ASSERT(text_[place_] == '"');
  for (++place_; place_ < text_.size(); ++place_) {
    // Two quotes stand for one.
    if (text_[place_] == '"' && text_.compare(place_, 2, "\"\"") == 0)
      ++place_;
    else if (text_[place_] == '"')
      break;
    if (text_[place_] == '\n') ++lines_in_cells_;
    cell.text += text_[place_];
  }
  if (place_ >= text_.size()) fail(cell.column, "this quotation has no end");
  ++place_;
  if (at_end_of_line() || text_[place_] == separator_) return;
  const std::string_view what = separator_ == ',' ? "comma" : separator_ == '\t' ? "tab" : "semicolon";
  fail(1 + place_ - line_begin_, fmt::format("a {} is missing behind the quotes", what));
}

}  // namespace murosimf::files
