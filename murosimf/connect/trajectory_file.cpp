#include "murosimf/connect/trajectory_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "murosimf/files/csv_cells.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::connect {
namespace {

using files::CsvCell;
using files::CsvCells;
using files::CsvHeader;

struct Unit {
  std::string_view name;
  double factor;  // to rad, m or s
};
constexpr std::array angles{Unit{"rad", 1}, Unit{"deg", pi / 180}};
constexpr std::array lengths{Unit{"m", 1}, Unit{"cm", 1e-2}, Unit{"mm", 1e-3}};
constexpr std::array times{Unit{"s", 1}, Unit{"ms", 1e-3}};

double factor_of(const CsvCells& cells, const CsvCell& cell, std::span<const Unit> units) {
  const CsvHeader said = files::csv_header(cell.text);
  std::vector<std::string_view> names;
  for (const Unit& unit : units) {
    if (unit.name == said.unit) return unit.factor;
    names.push_back(unit.name);
  }
  cells.fail(cell.column,
             said.unit.empty()
                 ? fmt::format("'{}' has no unit; write '{} [{}]'", said.name, said.name, fmt::join(names, "]' or '["))
                 : fmt::format("'{}' is in {}; known units: {}", said.name, said.unit, fmt::join(names, ", ")));
}

/// "walker.l_knee.joint_target" in its parts; nothing if the name is no such path.
struct LogPath {
  std::string_view entity, joint, property;
};
std::optional<LogPath> log_path(std::string_view name) {
  const auto first = name.find('.'), last = name.rfind('.');
  if (first == std::string_view::npos || first == last) return std::nullopt;
  return LogPath{name.substr(0, first), name.substr(first + 1, last - first - 1), name.substr(last + 1)};
}

/// Where a column goes.
struct Target {
  std::size_t cell = 0;
  double factor = 1;       // to rad or m
  double lowest, highest;  // [rad | m] what is farther out is a mistake
  JointTrajectory::Joint* joint = nullptr;
};

class TrajectoryReader {
 public:
  TrajectoryReader(const std::filesystem::path& file, const Model& model, const LogColumns& log)
      : cells_(file), model_(&model), log_(&log) {}

  JointTrajectory read() {
    if (!cells_.next(line_)) cells_.fail(1, "the file is empty");
    read_header();
    while (cells_.next(line_)) read_row();
    for (const JointTrajectory::Joint& joint : trajectory_.joints) {
      if (joint.times.empty()) cells_.fail(1, fmt::format("there are no numbers for '{}'", name_of(joint)));
    }
    measure_times();
    return std::move(trajectory_);
  }

 private:
  [[nodiscard]] const std::string& name_of(const JointTrajectory::Joint& joint) const {
    return model_->objects()[joint.object].name;
  }

  void read_header() {
    header_size_ = line_.size();
    for (const CsvCell& cell : line_) {
      if (files::number_in_cell(cell.text))
        cells_.fail(cell.column, "a number where the first line should have a name");
    }
    time_factor_ = factor_of(cells_, line_[0], times);
    const std::optional<std::string> entity = entity_of_log();
    for (std::size_t i = 1; i < line_.size(); ++i) take_column(i, entity);
    if (targets_.empty()) cells_.fail(1, nothing_to_play());
    for (std::size_t i = 0; i < targets_.size(); ++i) targets_[i].joint = &trajectory_.joints[i];
  }

  [[nodiscard]] std::string nothing_to_play() const {
    if (!is_log_) return "there must be a column of time and at least one joint";
    return fmt::format("this log has no column ENTITY.JOINT.{}", log_->property);
  }

  /// Whose columns of a log count; nothing if the file is none.
  std::optional<std::string> entity_of_log() {
    std::set<std::string, std::less<>> entities;
    for (std::size_t i = 1; i < line_.size(); ++i) {
      const CsvHeader said = files::csv_header(line_[i].text);
      if (joint_named(said.name)) continue;
      const std::optional<LogPath> path = log_path(said.name);
      if (!path) continue;
      is_log_ = true;
      if (path->property == log_->property) entities.insert(std::string(path->entity));
    }
    if (!is_log_) return std::nullopt;
    if (entities.size() > 1 && !entities.contains(log_->entity)) {
      cells_.fail(1, fmt::format("this log is of {}; say whose it is to be", fmt::join(entities, ", ")));
    }
    return entities.size() == 1 ? *entities.begin() : log_->entity;
  }

  [[nodiscard]] std::optional<int> joint_named(std::string_view name) const {
    const std::optional<int> object = model_->find_object(name);
    return object && model_->objects()[*object].is_joint() ? object : std::nullopt;
  }

  void take_column(std::size_t i, const std::optional<std::string>& entity) {
    const CsvHeader said = files::csv_header(line_[i].text);
    if (const auto joint = joint_named(said.name)) return add_target(i, *joint);
    const std::optional<LogPath> path = log_path(said.name);
    if (is_log_ && path) {
      if (path->property != log_->property || path->entity != *entity) return;
      if (const auto joint = joint_named(path->joint)) return add_target(i, *joint);
      return refuse_joint(i, path->joint);
    }
    if (!is_log_) refuse_joint(i, said.name);
  }

  [[noreturn]] void refuse_joint(std::size_t i, std::string_view name) const {
    std::vector<std::string_view> known;
    for (const int joint : model_->joints()) known.emplace_back(model_->objects()[joint].name);
    cells_.fail(line_[i].column, fmt::format("model '{}': {}", model_->name(), unknown_name("joint", name, known)));
  }

  void add_target(std::size_t i, int object) {
    const auto same = [&](const JointTrajectory::Joint& joint) { return joint.object == object; };
    if (std::ranges::any_of(trajectory_.joints, same)) {
      cells_.fail(line_[i].column, fmt::format("'{}' comes twice", model_->objects()[object].name));
    }
    const bool turns = model_->objects()[object].kind == Kind::revolute;
    const double factor = turns ? factor_of(cells_, line_[i], angles) : factor_of(cells_, line_[i], lengths);
    Target target{i, factor, -any_distance, any_distance};
    const Vec3d* range = model_->find(properties::joint_range, object);
    if (turns) target = {i, factor, (range ? range->x : 0) - 2 * pi, (range ? range->y : 0) + 2 * pi};
    targets_.push_back(target);
    trajectory_.joints.push_back({object, {}, {}});
  }

  void read_row() {
    if (line_.size() != header_size_) {
      cells_.fail(1, fmt::format("{} cells, where the first line has {}", line_.size(), header_size_));
    }
    const double time = time_factor_ * cells_.number(line_[0]);
    if (!std::isfinite(time)) cells_.fail(1, "the time must be a finite number");
    for (const Target& target : targets_) {
      const CsvCell& cell = line_[target.cell];
      if (files::is_blank(cell)) continue;
      take(*target.joint, time, target, cell);
    }
  }

  void take(JointTrajectory::Joint& joint, double time, const Target& target, const CsvCell& cell) const {
    const double value = target.factor * cells_.number(cell);
    if (!std::isfinite(value)) cells_.fail(cell.column, fmt::format("'{}' must be a finite number", name_of(joint)));
    if (value < target.lowest || value > target.highest) {
      cells_.fail(cell.column,
                  fmt::format("'{}' at {:.6g} rad is more than a turn beyond its range; are these degrees?",
                              name_of(joint), value));
    }
    if (!joint.times.empty() && time <= joint.times.back() + 2 * same_time) {
      cells_.fail(1, fmt::format("the time {:.9g} s does not come after {:.9g} s", time, joint.times.back()));
    }
    joint.times.push_back(time);
    joint.values.push_back(value);
  }

  void measure_times() {
    const auto& longest = *std::ranges::max_element(trajectory_.joints, {}, [](const JointTrajectory::Joint& joint) {
      return joint.times.size();
    });
    trajectory_.first = longest.times.front();
    trajectory_.last = longest.times.back();
    for (const JointTrajectory::Joint& joint : trajectory_.joints) {
      trajectory_.first = std::min(trajectory_.first, joint.times.front());
      trajectory_.last = std::max(trajectory_.last, joint.times.back());
    }
    trajectory_.spacing = spacing_of(longest.times);
  }

  /// Times of files have few digits: 0.0083, 0.0167, 0.0250 are 120 Hz.
  static std::optional<double> spacing_of(const std::vector<double>& at) {
    if (at.size() < 2) return std::nullopt;
    const double mean = (at.back() - at.front()) / static_cast<double>(at.size() - 1);
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (std::abs(at.front() + mean * static_cast<double>(i) - at[i]) > 0.1 * mean) return std::nullopt;
    }
    return mean;
  }

  static constexpr double any_distance = 1e300;  // [m] of sliding joints

  CsvCells cells_;
  const Model* model_;
  const LogColumns* log_;
  std::vector<CsvCell> line_;
  std::size_t header_size_ = 0;
  double time_factor_ = 1;  // to s
  bool is_log_ = false;
  std::vector<Target> targets_;  // one for each joint of the trajectory
  JointTrajectory trajectory_;
};

}  // namespace

JointTrajectory read_trajectory(const std::filesystem::path& file, const Model& model, const LogColumns& log) {
  return TrajectoryReader(file, model, log).read();
}

}  // namespace murosimf::connect
