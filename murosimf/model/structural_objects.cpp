#include "murosimf/model/structural_objects.h"

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

}  // namespace

std::optional<Mat3d> structural_value(const Model& model, const ColumnStore& columns, const Property<Mat3d>& property,
                                      int object) {
  if (!model.objects()[object].structural || !is(property, properties::orientation)) return std::nullopt;
  const auto* R = rows_of(columns, properties::orientation);
  if (!R) return std::nullopt;
  const FixedObject place = model.placement(object);
  const Mat3d& link = (*R)[model.tree().links[place.link].object];
  return place.turned ? link * place.turn : link;
}

std::optional<Vec3d> structural_value(const Model& model, const ColumnStore& columns, const Property<Vec3d>& property,
                                      int object) {
  if (!model.objects()[object].structural) return std::nullopt;
  const FixedObject place = model.placement(object);
  const int link = model.tree().links[place.link].object;
  const auto *r = rows_of(columns, properties::position), *v = rows_of(columns, properties::linear_velocity),
             *w = rows_of(columns, properties::angular_velocity);
  const auto* R = rows_of(columns, properties::orientation);
  if (!r || !R) return std::nullopt;
  const auto position = [&] { return (*r)[link] + (*R)[link] * place.offset; };
  if (is(property, properties::position)) return position();
  if (!v || !w) return std::nullopt;
  if (is(property, properties::angular_velocity)) return (*w)[link];
  // by the difference of rounded positions, as hashes have always had it
  if (is(property, properties::linear_velocity)) return (*v)[link] + cross((*w)[link], position() - (*r)[link]);
  const auto *a = rows_of(columns, properties::linear_acceleration),
             *alpha = rows_of(columns, properties::angular_acceleration);
  if (!a || !alpha) return std::nullopt;
  if (is(property, properties::angular_acceleration)) return (*alpha)[link];
  const Vec3d arm = position() - (*r)[link];
  if (is(property, properties::linear_acceleration)) {
    return (*a)[link] + cross((*alpha)[link], arm) + cross((*w)[link], cross((*w)[link], arm));
  }
  return std::nullopt;
}

}  // namespace murosimf
