#include "murosimf/control_software/python/python_rows.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/locomotion/rest_positions.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::control_software {
namespace {

std::vector<std::string> names_of(const Model& model, bool of_joints) {
  std::vector<std::string> names;
  if (of_joints) {
    for (const int joint : model.joints()) names.push_back(model.objects()[static_cast<std::size_t>(joint)].name);
  } else {
    for (const auto& object : model.objects()) names.push_back(object.name);
  }
  return names;
}

/// Rows of a column that are shown: of properties of joints those with a joint.
std::vector<std::size_t> rows_of(const Model& model, const PropertyInfo& info, std::size_t rows) {
  std::vector<std::size_t> shown;
  if (info.frame == "joint") {
    for (const int joint : model.joints()) shown.push_back(static_cast<std::size_t>(joint));
  } else {
    for (std::size_t row = 0; row < rows; ++row) shown.push_back(row);
  }
  return shown;
}

void append_places(const ColumnBase::Memory& memory, std::size_t row, std::vector<double*>& places) {
  const ValueLayout& layout = memory.layout;
  double* const first = memory.data + row * memory.stride + layout.first;
  for (std::size_t i = 0; i < layout.shape[0]; ++i) {
    for (std::size_t j = 0; j < layout.shape[1]; ++j) {
      places.push_back(first + static_cast<std::ptrdiff_t>(i) * layout.strides[0] +
                       static_cast<std::ptrdiff_t>(j) * layout.strides[1]);
    }
  }
}

/// Without axes of length 1, but for the only one.
std::vector<std::size_t> shape_of(bool has_rows, std::size_t rows, const ValueLayout& layout) {
  std::vector<std::size_t> shape;
  if (has_rows) shape.push_back(rows);
  for (const std::size_t side : layout.shape) {
    if (side > 1) shape.push_back(side);
  }
  if (shape.empty()) shape.push_back(1);
  return shape;
}

/// `of_port`: why it is no signal or command either; empty: it was not asked.
std::string unknown(const PythonTraits& traits, const std::string& name, bool written, const std::string& of_port) {
  const std::string verb = written ? "writes" : "reads";
  if (!of_port.empty()) return fmt::format("{}: {} '{}': {}", traits.where, verb, name, of_port);
  return fmt::format("{}: {} '{}': {}", traits.where, verb, name, unknown_name("property", name, names_of_columns()));
}

}  // namespace

PythonRows::PythonRows(Setup& setup, RobotPort* port, const std::vector<Entity*>& others, PythonObject& object,
                       sensors::Reading* reading)
    : object_(&object), controls_(port != nullptr) {
  const PythonTraits& traits = object.traits();
  for (const std::string& name : traits.writes) add(setup, port, others, name, true);
  for (const std::string& name : traits.reads) {
    // what is written can be read, too
    if (std::ranges::find(traits.writes, name) == traits.writes.end()) add(setup, port, others, name, false);
  }
  if (reading) add_outputs(*reading);
}

void PythonRows::add_outputs(sensors::Reading& reading) {
  std::span<double> values(reading.values);
  for (const sensors::Output& output : reading.info->outputs) {
    outputs_.emplace_back(values.first(output.size()), new_array({.kind = PythonRow::output,
                                                                  .name = output.name,
                                                                  .shape = {output.size()},
                                                                  .labels = output.labels,
                                                                  .writable = true}));
    values = values.subspan(output.size());
  }
}

void PythonRows::add(Setup& setup, RobotPort* port, const std::vector<Entity*>& others, const std::string& name,
                     bool written) {
  std::string why;
  try {
    if (name.find('.') == std::string::npos) {
      if (add_of_robot(setup, name, written)) return;
    } else if (add_of_other(setup, others, name, written)) {
      return;
    } else if (port) {
      if (add_of_port(*port, name, written)) return;
    } else {
      if (written) throw SetupError("only properties of entities can be written");
      return add_of_sensor(setup, name, name);
    }
  } catch (const SetupError& error) {
    why = error.what();
  }
  throw SetupError(unknown(object_->traits(), name, written, why));
}

bool PythonRows::add_of_robot(Setup& setup, const std::string& name, bool written) {
  const NamedColumn column = written ? column_to_write(setup, name) : column_to_read(setup, name);
  if (column.info) add_column(name, column, setup.entity(), true, written);
  return column.info != nullptr;
}

/// ENTITY.PROPERTY
bool PythonRows::add_of_other(Setup& setup, const std::vector<Entity*>& others, const std::string& name, bool written) {
  const std::string first = name.substr(0, name.find('.')), property = name.substr(first.size() + 1);
  const auto other = std::ranges::find_if(others, [&](const Entity* entity) { return entity->name() == first; });
  if (other == others.end()) return false;
  Setup of_other = setup.of(**other);
  if (!written && property.find('.') != std::string::npos) {
    add_of_sensor(of_other, name, property);
    return true;
  }
  const NamedColumn column = written ? column_to_write(of_other, property) : column_to_read(of_other, property);
  if (!column.info) throw SetupError(unknown_name("property", property, names_of_columns()));
  add_column(name, column, **other, false, written);
  return true;
}

/// SENSOR.OUTPUT of an entity, without the delays of a link.
void PythonRows::add_of_sensor(Setup& of_entity, const std::string& name, const std::string& path) {
  const std::span<const double> values = sensors::read_output(of_entity, path);
  readings_.push_back({values, new_array({.kind = PythonRow::signal, .name = name, .shape = {values.size()}})});
}

void PythonRows::add_column(const std::string& name, const NamedColumn& column, const Entity& entity, bool of_robot,
                            bool written) {
  const Model& model = entity.model();
  const bool has_rows = of_every_object(column.info->scope), of_joints = column.info->frame == "joint";
  OfColumn added{.name = name, .written = written};
  const std::vector<std::size_t> rows = rows_of(model, *column.info, column.memory.rows);
  for (const std::size_t row : rows) append_places(column.memory, row, added.places);
  if (has_rows) added.labels = names_of(model, of_joints);
  added.at_start.resize(added.places.size());
  if (of_robot && name == "joint_target") {
    const std::vector<double> rest = locomotion::rest_positions(model);
    for (std::size_t i = 0; i < rows.size(); ++i) added.at_start[i] = rest[rows[i]];
  }
  added.array = new_array({.kind = !of_robot && written ? PythonRow::command
                                   : of_robot           ? PythonRow::property
                                                        : PythonRow::signal,
                           .name = name,
                           .shape = shape_of(has_rows, rows.size(), column.memory.layout),
                           .labels = added.labels,
                           .writable = written});
  columns_.push_back(std::move(added));
}

bool PythonRows::add_of_port(RobotPort& port, const std::string& name, bool written) {
  OfPort added{};
  if (written) {
    added.command = port.command(name);
  } else {
    added.signal = port.signal(name);
  }
  const std::vector<std::string>* labels = port.labels(name);
  added.array = new_array({.kind = written ? PythonRow::command : PythonRow::signal,
                           .name = name,
                           .shape = {written ? added.command->count : added.signal->count},
                           .labels = labels ? *labels : std::vector<std::string>{},
                           .writable = written});
  ports_.push_back(added);
  return true;
}

double* PythonRows::new_array(const PythonRow& row) {
  PythonOutcome outcome;
  double* const memory = object_->add(row, outcome);
  if (!memory) throw SetupError(outcome.text);
  return memory;
}

void PythonRows::restart() noexcept {
  for (const OfColumn& column : columns_) {
    if (!column.written) continue;
    for (std::size_t i = 0; i < column.places.size(); ++i) {
      // numbers that are not finite are those that no other algorithm gives
      if (controls_ || !std::isfinite(*column.places[i])) *column.places[i] = column.at_start[i];
    }
  }
}

void PythonRows::show() noexcept {
  for (const OfColumn& column : columns_) {
    for (std::size_t i = 0; i < column.places.size(); ++i) column.array[i] = *column.places[i];
  }
  for (const OfPort& row : ports_) {
    if (row.signal) std::copy_n(row.signal->values, row.signal->count, row.array);
    if (row.command) std::copy_n(row.command->values, row.command->count, row.array);
  }
  for (const OfReading& reading : readings_) std::ranges::copy(reading.values, reading.array);
}

std::string PythonRows::take() {
  for (const OfColumn& column : columns_) {
    if (!column.written) continue;
    for (std::size_t i = 0; i < column.places.size(); ++i) {
      if (std::isfinite(column.array[i])) continue;
      MUROSIMF_ASSERT(!column.places.empty());
      const std::size_t row = column.labels.empty() ? 0 : i / (column.places.size() / column.labels.size());
      return fmt::format("'{}'{} was set to {}", column.name, column.labels.empty() ? "" : " of " + column.labels[row],
                         column.array[i]);
    }
  }
  for (const OfColumn& column : columns_) {
    if (!column.written) continue;
    for (std::size_t i = 0; i < column.places.size(); ++i) *column.places[i] = column.array[i];
  }
  for (const OfPort& row : ports_) {
    if (row.command) std::copy_n(row.array, row.command->count, row.command->values);
  }
  for (const auto& [values, array] : outputs_) std::copy_n(array, values.size(), values.begin());
  return {};
}

std::vector<double> PythonRows::written() const {
  std::vector<double> numbers;
  for (const OfColumn& column : columns_) {
    if (!column.written) continue;
    for (const double* place : column.places) numbers.push_back(*place);
  }
  return numbers;
}

void PythonRows::write(const std::vector<double>& numbers) noexcept {
  std::size_t next = 0;
  for (const OfColumn& column : columns_) {
    if (!column.written) continue;
    for (double* place : column.places) {
      if (next < numbers.size()) *place = numbers[next++];
    }
  }
}

}  // namespace murosimf::control_software
