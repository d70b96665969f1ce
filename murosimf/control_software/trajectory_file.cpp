#include "murosimf/control_software/trajectory_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "murosimf/files/csv_cells.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {
namespace {

using files::CsvCell;
using files::CsvCells;
using Joint = JointTrajectory::Joint;

class TrajectoryReader {
 public:
  TrajectoryReader(const std::filesystem::path& file, const Model& model) : cells_(file), model_(&model) {}

  JointTrajectory read(const LogColumns& log) {
    if (!cells_.next(line_)) cells_.fail(1, "the file is empty");
    header_ = trajectory_columns(cells_, line_, *model_, log);
    // one joint per column, in the same order: read_row relies on it
    for (const auto& column : header_.columns) trajectory_.joints.push_back({column.object, {}, {}});
    while (cells_.next(line_)) read_row();
    for (const Joint& joint : trajectory_.joints) {
      if (joint.times.empty()) cells_.fail(1, fmt::format("there are no numbers for '{}'", name_of(joint)));
    }
    measure_times();
    return std::move(trajectory_);
  }

 private:
  [[nodiscard]] const std::string& name_of(const Joint& joint) const { return model_->objects()[joint.object].name; }

  /// Times must increase: samples are found by bisection.
  void read_row() {
    if (line_.size() != header_.cells) {
      cells_.fail(1, fmt::format("{} cells, where the first line has {}", line_.size(), header_.cells));
    }
    const double time = header_.time_factor * cells_.number(line_[0]);
    if (!std::isfinite(time)) cells_.fail(1, "the time must be a finite number");
    for (std::size_t i = 0; i < header_.columns.size(); ++i) {
      MUROSIMF_ASSERT(header_.columns[i].cell < line_.size());
      const CsvCell& cell = line_[header_.columns[i].cell];
      if (!files::is_blank(cell)) take(trajectory_.joints[i], time, header_.columns[i], cell);
    }
  }

  void take(Joint& joint, double time, const TrajectoryColumns::Column& column, const CsvCell& cell) const {
    const double value = column.factor * cells_.number(cell);
    if (!std::isfinite(value)) cells_.fail(cell.column, fmt::format("'{}' must be a finite number", name_of(joint)));
    if (value < column.lowest || value > column.highest) {
      cells_.fail(cell.column,
                  fmt::format("'{}' at {:.6g} rad is more than a turn beyond its range; are these degrees?",
                              name_of(joint), value));
    }
    if (!joint.times.empty() && time <= joint.times.back() + 2 * same_time) {
      cells_.fail(1, fmt::format("the time {:.9g} s does not come after {:.9g} s", time, joint.times.back()));
    }
    // twice the tolerance, so that value_at never takes two rows for the same instant
    joint.times.push_back(time);
    joint.values.push_back(value);
  }

  /// Joints may have gaps: the one with most samples shows the spacing of the file.
  void measure_times() {
    MUROSIMF_ASSERT(!trajectory_.joints.empty());
    const auto& longest =
        *std::ranges::max_element(trajectory_.joints, {}, [](const Joint& joint) { return joint.times.size(); });
    trajectory_.first = longest.times.front();
    trajectory_.last = longest.times.back();
    for (const Joint& joint : trajectory_.joints) {
      trajectory_.first = std::min(trajectory_.first, joint.times.front());
      trajectory_.last = std::max(trajectory_.last, joint.times.back());
    }
    trajectory_.spacing = spacing_of(longest.times);
  }

  /// Times in files have few digits: 0.0083, 0.0167, 0.0250 are 120 Hz. Hence the tolerance of a tenth of the spacing.
  static std::optional<double> spacing_of(const std::vector<double>& at) {
    if (at.size() < 2) return std::nullopt;
    const double mean = (at.back() - at.front()) / static_cast<double>(at.size() - 1);
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (std::abs(at.front() + mean * static_cast<double>(i) - at[i]) > 0.1 * mean) return std::nullopt;
    }
    return mean;
  }

  CsvCells cells_;
  const Model* model_;
  std::vector<CsvCell> line_;
  TrajectoryColumns header_;
  JointTrajectory trajectory_;
};

}  // namespace

JointTrajectory read_trajectory(const std::filesystem::path& file, const Model& model, const LogColumns& log) {
  return TrajectoryReader(file, model).read(log);
}

}  // namespace murosimf::control_software
