#include "murosimf/logging/log_catalog.h"

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/value.h"
#include "murosimf/sensors/reading.h"

namespace murosimf::logging {
namespace {

std::vector<std::string> split(std::string_view text, std::string_view separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    parts.emplace_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return parts;
    begin = end + separator.size();
  }
}

/// Names of a property's numbers, as in notation.md; indices where there are none.
std::vector<std::string> labels_of(const ColumnBase& column) {
  const auto& type = column.type();
  if (column.numbers() == 1) return {""};
  if (type == typeid(Vec3d)) return {"x", "y", "z"};
  if (type == typeid(Quaterniond)) return {"w", "x", "y", "z"};
  if (type == typeid(Wrenchd)) return {"fx", "fy", "fz", "nx", "ny", "nz"};
  if (type == typeid(Twistd)) return {"wx", "wy", "wz", "vx", "vy", "vz"};
  if (type == typeid(SymMat3d)) return {"xx", "yy", "zz", "xy", "xz", "yz"};
  if (type == typeid(Mat3d)) return {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < column.numbers(); ++i) labels.push_back(fmt::format("{}", i));
  return labels;
}

std::string joined(std::string_view path, std::string_view label) {
  return label.empty() ? std::string(path) : fmt::format("{}.{}", path, label);
}

bool is_joint(Kind kind) { return kind == Kind::revolute || kind == Kind::prismatic; }

void append_property(std::vector<LoggedNumber>& numbers, Entity& entity, std::string_view name,
                     const ColumnBase& column) {
  const int object = entity.model().object_index(name);
  if (object != 0 && !of_every_object(column.info().scope)) return;
  if (column.info().frame == "joint" && !is_joint(entity.model().objects()[object].kind)) return;
  const std::string path = fmt::format("{}.{}.{}", entity.name(), name, column.info().name);
  const bool prismatic = entity.model().objects()[object].kind == Kind::prismatic;
  const auto labels = labels_of(column);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    numbers.push_back({.entity = &entity,
                       .object = object,
                       .property = std::string(column.info().name),
                       .index = i,
                       .path = path_parts(joined(path, labels[i])),
                       .unit = unit_of(column.info().unit, i, labels.size(), prismatic)});
  }
}

}  // namespace

std::vector<std::string> path_parts(std::string_view path) { return split(path, "."); }

std::string unit_of(std::string_view units, std::size_t index, std::size_t numbers, bool prismatic) {
  MUROSIMF_ASSERT(numbers > 0 && index < numbers);
  const auto kinds = split(units, " | ");
  const auto parts = split(kinds.size() == 2 && prismatic ? kinds[1] : kinds[0], ", ");
  return numbers % parts.size() == 0 ? parts[index / (numbers / parts.size())] : std::string(units);
}

std::vector<LoggedNumber> numbers_of_sensors(Entity& entity) {
  std::vector<LoggedNumber> numbers;
  for (const sensors::Reading* reading : sensors::readings_of(entity)) {
    std::size_t index = 0;
    for (const sensors::Output& output : reading->info->outputs) {
      const std::string path = fmt::format("{}.{}.{}", entity.name(), reading->info->name, output.name);
      for (std::size_t i = 0; i < output.size(); ++i) {
        numbers.push_back({.entity = &entity,
                           .sensor = reading->info->name,
                           .index = index++,
                           .path = path_parts(joined(path, output.labels.empty() ? "" : output.labels[i])),
                           .unit = unit_of(output.unit, i, output.size())});
      }
    }
  }
  return numbers;
}

/// In the order of the model, then of the properties: columns of a log are in the same order in every run.
std::vector<LoggedNumber> numbers_of_properties(Entity& entity) {
  std::vector<LoggedNumber> numbers;
  for (const std::string_view object : entity.model().object_names()) {
    for (const auto& [name, column] : entity.columns()) {
      if (column->numbers() > 0) append_property(numbers, entity, object, *column);
    }
  }
  return numbers;
}

}  // namespace murosimf::logging
