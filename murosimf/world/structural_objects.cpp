#include "murosimf/world/structural_objects.h"

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf {
namespace {

bool is(const PropertyInfo& property, const PropertyInfo& other) { return property.name == other.name; }

/// Null if there is no such column.
template <class T>
const std::vector<T>* rows_of(const ColumnStore& columns, const Property<T>& property) {
  const Column<T>* column = columns.find(property);
  return column ? &column->values : nullptr;
}

/// All columns that structural objects follow from, except accelerations, which are rarely requested.
StructuralRows::Columns columns_of(const ColumnStore& columns) {
  return {.position = rows_of(columns, properties::position),
          .linear_velocity = rows_of(columns, properties::linear_velocity),
          .angular_velocity = rows_of(columns, properties::angular_velocity),
          .linear_acceleration = nullptr,
          .angular_acceleration = nullptr,
          .orientation = rows_of(columns, properties::orientation)};
}

void add_accelerations(StructuralRows::Columns& rows, const ColumnStore& columns) {
  rows.linear_acceleration = rows_of(columns, properties::linear_acceleration);
  rows.angular_acceleration = rows_of(columns, properties::angular_acceleration);
}

std::optional<Mat3d> worked_out(const Model& model, const std::vector<Mat3d>* R, int object) {
  MUROSIMF_ASSERT(object >= 0 && object < model.size());
  if (!R) return std::nullopt;
  const FixedObject place = model.placement(object);
  const Mat3d& link = (*R)[model.tree().links[place.link].object];
  return place.turned ? link * place.turn : link;
}

std::optional<Vec3d> worked_out(const Model& model, const StructuralRows::Columns& rows,
                                const Property<Vec3d>& property, int object) {
  const FixedObject place = model.placement(object);
  MUROSIMF_ASSERT(object >= 0 && object < model.size());
  const int link = model.tree().links[place.link].object;
  const auto *r = rows.position, *v = rows.linear_velocity, *w = rows.angular_velocity;
  const auto* R = rows.orientation;
  if (!r || !R) return std::nullopt;
  const auto position = [&] { return (*r)[link] + (*R)[link] * place.offset; };
  if (is(property, properties::position)) return position();
  if (!v || !w) return std::nullopt;
  if (is(property, properties::angular_velocity)) return (*w)[link];
  // by the difference of rounded positions: recorded hashes depend on this order of operations
  if (is(property, properties::linear_velocity)) return (*v)[link] + cross((*w)[link], position() - (*r)[link]);
  const auto *a = rows.linear_acceleration, *alpha = rows.angular_acceleration;
  if (!a || !alpha) return std::nullopt;
  if (is(property, properties::angular_acceleration)) return (*alpha)[link];
  // accelerations are for display: their arm may have the same rounding
  const Vec3d arm = position() - (*r)[link];
  if (is(property, properties::linear_acceleration)) {
    return (*a)[link] + cross((*alpha)[link], arm) + cross((*w)[link], cross((*w)[link], arm));
  }
  return std::nullopt;
}

bool is_structural(const Model& model, int object) {
  MUROSIMF_ASSERT(object >= 0 && object < model.size());
  return model.objects()[object].structural;
}

}  // namespace

std::optional<Mat3d> structural_value(const Model& model, const ColumnStore& columns, const Property<Mat3d>& property,
                                      int object) {
  if (!is_structural(model, object) || !is(property, properties::orientation)) return std::nullopt;
  return worked_out(model, rows_of(columns, properties::orientation), object);
}

std::optional<Vec3d> structural_value(const Model& model, const ColumnStore& columns, const Property<Vec3d>& property,
                                      int object) {
  if (!is_structural(model, object)) return std::nullopt;
  StructuralRows::Columns rows = columns_of(columns);
  const bool accelerations =
      is(property, properties::linear_acceleration) || is(property, properties::angular_acceleration);
  if (accelerations) add_accelerations(rows, columns);
  return worked_out(model, rows, property, object);
}

StructuralRows::StructuralRows(const Model& model, const ColumnStore& columns)
    : model_(&model), columns_(columns_of(columns)) {
  add_accelerations(columns_, columns);
}

std::optional<Mat3d> StructuralRows::value(const Property<Mat3d>& property, int object) const {
  if (!is_structural(*model_, object) || !is(property, properties::orientation)) return std::nullopt;
  return worked_out(*model_, columns_.orientation, object);
}

std::optional<Vec3d> StructuralRows::value(const Property<Vec3d>& property, int object) const {
  if (!is_structural(*model_, object)) return std::nullopt;
  return worked_out(*model_, columns_, property, object);
}

}  // namespace murosimf
