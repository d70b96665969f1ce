/// text_table.h - rows of cells, as aligned columns for users and as lines of CSV for programs.
#pragma once

#include <string>
#include <vector>

namespace murosimf::studies {

class TextTable {
 public:
  /// The first one is the head. As many cells as that has.
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  /// The first column at the left, the others at the right; two blanks between.
  [[nodiscard]] std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// As of RFC 4180, with "\n" at its end.
[[nodiscard]] std::string csv_line(const std::vector<std::string>& cells);

}  // namespace murosimf::studies
