#include "murosimf/control_software/trajectory_columns.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::control_software {
namespace {

using files::CsvCell;
using files::CsvCells;
using files::CsvHeader;

constexpr double any_distance = 1e300;  // [m] of sliding joints

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

/// The parts of "walker.l_knee.joint_target"; nothing if the name is no such path.
struct LogPath {
  std::string_view entity, joint, property;
};
std::optional<LogPath> log_path(std::string_view name) {
  const auto first = name.find('.'), last = name.rfind('.');
  if (first == std::string_view::npos || first == last) return std::nullopt;
  return LogPath{name.substr(0, first), name.substr(first + 1, last - first - 1), name.substr(last + 1)};
}

/// Interprets the columns of the first line for one model.
class ColumnReader {
 public:
  ColumnReader(const CsvCells& cells, const std::vector<CsvCell>& line, const Model& model, const LogColumns& log)
      : cells_(&cells), line_(&line), model_(&model), log_(&log) {
    MUROSIMF_ASSERT(!line.empty());
  }

  TrajectoryColumns read() {
    for (const CsvCell& cell : *line_) {
      if (cells_->find_number(cell)) {
        cells_->fail(cell.column, "a number where the first line should have a name");
      }
    }
    found_.cells = line_->size();
    found_.time_factor = factor_of(*cells_, line_->front(), times);
    find_out_whose_log();
    for (std::size_t i = 1; i < line_->size(); ++i) take((*line_)[i], i);
    if (found_.columns.empty()) cells_->fail(1, nothing_to_play());
    return found_;
  }

 private:
  [[nodiscard]] std::string nothing_to_play() const {
    if (!is_log_) return "there must be a column of time and at least one joint";
    return fmt::format("this log has no column {}.JOINT.{}", entity_.empty() ? "ENTITY" : entity_, log_->property);
  }

  /// Determines whether the file is a log, and of which entity the columns are used.
  void find_out_whose_log() {
    std::set<std::string, std::less<>> entities;
    for (std::size_t i = 1; i < line_->size(); ++i) {
      const CsvHeader said = files::csv_header((*line_)[i].text);
      const std::optional<LogPath> path = joint_named(said.name) ? std::nullopt : log_path(said.name);
      if (!path) continue;
      is_log_ = true;
      if (path->property == log_->property) entities.insert(std::string(path->entity));
    }
    entity_ = log_->entity;
    if (entities.contains(entity_) || entities.empty() || log_->no_other) return;
    if (entities.size() > 1) {
      cells_->fail(1, fmt::format("this log is of {}; say whose it is to be", fmt::join(entities, ", ")));
    }
    entity_ = *entities.begin();
  }

  [[nodiscard]] std::optional<int> joint_named(std::string_view name) const {
    const std::optional<int> object = model_->find_object(name);
    return object && model_->objects()[*object].is_joint() ? object : std::nullopt;
  }

  void take(const CsvCell& cell, std::size_t i) {
    const CsvHeader said = files::csv_header(cell.text);
    if (const auto joint = joint_named(said.name)) return add(cell, i, *joint);
    if (!is_log_) refuse_joint(cell, said.name);
    const std::optional<LogPath> path = log_path(said.name);
    if (!path || path->property != log_->property || path->entity != entity_) return;
    const auto joint = joint_named(path->joint);
    if (!joint) refuse_joint(cell, path->joint);
    add(cell, i, *joint);
  }

  [[noreturn]] void refuse_joint(const CsvCell& cell, std::string_view name) const {
    std::vector<std::string_view> known;
    for (const int joint : model_->joints()) known.emplace_back(model_->objects()[joint].name);
    cells_->fail(cell.column, fmt::format("model '{}': {}", model_->name(), unknown_name("joint", name, known)));
  }

  void add(const CsvCell& cell, std::size_t i, int object) {
    if (std::ranges::find(found_.columns, object, &TrajectoryColumns::Column::object) != found_.columns.end()) {
      cells_->fail(cell.column, fmt::format("'{}' comes twice", model_->objects()[object].name));
    }
    if (model_->objects()[object].kind == Kind::prismatic) {
      found_.columns.push_back({i, object, factor_of(*cells_, cell, lengths), -any_distance, any_distance});
      return;
    }
    const Vec3d* given = model_->find(properties::joint_range, object);
    const Vec3d range = given ? *given : Vec3d{};
    found_.columns.push_back({i, object, factor_of(*cells_, cell, angles), range.x - 2 * pi, range.y + 2 * pi});
  }

  const CsvCells* cells_;
  const std::vector<CsvCell>* line_;
  const Model* model_;
  const LogColumns* log_;
  bool is_log_ = false;
  std::string entity_;  // the entity of the log whose columns are used
  TrajectoryColumns found_;
};

}  // namespace

TrajectoryColumns trajectory_columns(const CsvCells& cells, const std::vector<CsvCell>& line, const Model& model,
                                     const LogColumns& log) {
  return ColumnReader(cells, line, model, log).read();
}

}  // namespace murosimf::control_software
