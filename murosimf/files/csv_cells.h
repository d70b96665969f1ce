/// csv_cells.h - the cells of a file of comma-separated values (RFC 4180), line by line, with their places.
///
/// Semicolons and tabs separate cells, too, as spreadsheets of many countries write them: the separator is the most frequent one of the
/// first line, outside quotes and brackets, or that of a line "sep=;" before it. Where it is no comma, numbers may have a decimal
/// comma: 0,5. The file may be in any encoding of Unicode (text_encoding.h).
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace murosimf::files {

struct CsvCell {
  std::string text;
  std::size_t column = 1;  ///< where it begins in its line, from 1
};

/// Contents of a cell of the first line: "name [unit]", or a name alone.
struct CsvHeader {
  std::string name, unit;
};
[[nodiscard]] CsvHeader csv_header(std::string_view cell);

/// Whether the cell is empty, or only blanks and tabs.
[[nodiscard]] bool is_blank(const CsvCell& cell);
class CsvCells {
 public:
  /// Throws SetupError if the file cannot be read.
  explicit CsvCells(const std::filesystem::path& file);

  /// Writes the cells of the next line that has any; false at the end of the file. Throws SetupError.
  bool next(std::vector<CsvCell>& cells);
  /// The number of a cell, nothing if it is no number; nan and inf are numbers.
  [[nodiscard]] std::optional<double> find_number(const CsvCell& cell) const;
  /// The number of a cell. Throws SetupError if it is no number.
  [[nodiscard]] double number(const CsvCell& cell) const;

  /// Throws SetupError: file:line:column: message.
  [[noreturn]] void fail(std::size_t column, const std::string& message) const;

 private:
  void find_separator();
  [[nodiscard]] bool at_end_of_line() const;
  void read_line(std::vector<CsvCell>& cells);
  void read_cell(CsvCell& cell);
  void read_quoted(CsvCell& cell);

  std::string name_, text_;
  char separator_ = ',';
  std::size_t place_ = 0, line_begin_ = 0, line_ = 0, lines_in_cells_ = 0;
};

}  // namespace murosimf::files
