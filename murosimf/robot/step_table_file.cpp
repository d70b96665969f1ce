#include "murosimf/robot/step_table_file.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/files/csv_cells.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::robot {
namespace {

using namespace locomotion;

constexpr std::array<std::string_view, 2> joint_kinds{"rigid", "compliant"};
constexpr std::array<std::string_view, 7> step_columns{"joints",  "bin",      "signal", "constant",
                                                       "forward", "sideways", "turning"};
constexpr std::size_t first_factor = 3;

class StepTableReader {
 public:
  explicit StepTableReader(const std::filesystem::path& file) : cells_(file), name_(file.string()) {}

  [[nodiscard]] StepTablePtr read() {
    std::vector<files::CsvCell> line;
    if (!cells_.next(line)) throw SetupError(fmt::format("{}: it is empty", name_));
    read_header(line);
    while (cells_.next(line)) read_line(line);
    const std::size_t wanted = joint_kinds.size() * step_bins * step_signals;
    // Each line has its own key: so many lines are all of them.
    if (seen_.size() == wanted) return std::make_shared<const StepTable>(table_);
    throw SetupError(fmt::format("{}: {} of {} lines of a table of steps", name_, seen_.size(), wanted));
  }

 private:
  void read_header(const std::vector<files::CsvCell>& line) const {
    for (std::size_t i = 0; i < step_columns.size(); ++i) {
      if (i < line.size() && line[i].text == step_columns[i]) continue;
      cells_.fail(i < line.size() ? line[i].column : 1,
                  fmt::format("a table of steps has the columns {}", fmt::join(step_columns, ",")));
    }
  }

  void read_line(const std::vector<files::CsvCell>& line) {
    if (line.size() != step_columns.size())
      cells_.fail(1, fmt::format("{} cells, not {}", line.size(), step_columns.size()));
    const std::size_t kind = one_of(line[0], joint_kinds), signal = one_of(line[2], signal_names);
    const double bin = cells_.number(line[1]);
    if (!(bin >= 0 && bin < step_bins) || bin != std::floor(bin))
      cells_.fail(line[1].column, fmt::format("a bin is a whole number below {}", step_bins));
    const auto row = static_cast<std::size_t>(bin);
    if (!seen_.insert({kind, row, signal}).second) cells_.fail(1, "this line was there before");
    auto& factors = (kind == 0 ? table_.rigid : table_.compliant)[row][signal];
    MUROSIMF_ASSERT(first_factor + factors.size() == step_columns.size());
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const files::CsvCell& cell = line[first_factor + i];
      factors[i] = cells_.number(cell);
      if (!std::isfinite(factors[i])) cells_.fail(cell.column, "the number is not finite");
    }
  }

  template <std::size_t N>
  [[nodiscard]] std::size_t one_of(const files::CsvCell& cell, const std::array<std::string_view, N>& words) const {
    const auto found = std::ranges::find(words, cell.text);
    if (found == words.end()) cells_.fail(cell.column, unknown_name("word", cell.text, {words.begin(), words.end()}));
    return static_cast<std::size_t>(found - words.begin());
  }

  files::CsvCells cells_;
  std::string name_;
  StepTable table_;
  std::set<std::array<std::size_t, 3>> seen_;  // kind, bin, signal
};

}  // namespace

StepTablePtr read_step_table(const std::filesystem::path& file) { return StepTableReader(file).read(); }

std::string to_csv(const StepTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(step_columns, ","));
  for (const std::string_view kind : joint_kinds) {
    const StepCourse& course = kind == joint_kinds[0] ? table.rigid : table.compliant;
    for (std::size_t bin = 0; bin < step_bins; ++bin) {
      MUROSIMF_ASSERT(course.size() == step_bins);
      for (std::size_t signal = 0; signal < step_signals; ++signal)
        text += fmt::format("{},{},{},{:.6g}\n", kind, bin, signal_names[signal], fmt::join(course[bin][signal], ","));
    }
  }
  return text;
}

}  // namespace murosimf::robot
