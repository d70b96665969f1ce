/// structural_objects.h - pose and velocity of objects that only give a model its shape: worked out when somebody asks.
///
/// Levels keep no pose of such an object (model/object.h). It is fixed to a link with the row l, at the offset d and the
/// turn T in that link's axes, so that
///
///     r = r_l + R_l d     R = R_l T     w = w_l     v = v_l + w_l x (r - r_l)
///     alpha = alpha_l     a = a_l + alpha_l x (r - r_l) + w_l x (w_l x (r - r_l))
///
/// Its own rows in the columns hold nothing. Asking only reads: any number of threads may, while nobody steps.
#pragma once

#include <optional>
#include <vector>

#include "murosimf/model/column_store.h"
#include "murosimf/model/model.h"

namespace murosimf {

/// The value of a structural object; nothing for other objects and properties, whose rows stand in the columns, and where there
/// are no such columns.
[[nodiscard]] std::optional<Vec3d> structural_value(const Model& model, const ColumnStore& columns,
                                                    const Property<Vec3d>& property, int object);
[[nodiscard]] std::optional<Mat3d> structural_value(const Model& model, const ColumnStore& columns,
                                                    const Property<Mat3d>& property, int object);
template <class T>
[[nodiscard]] std::optional<T> structural_value(const Model&, const ColumnStore&, const Property<T>&, int) {
  return std::nullopt;
}

/// All rows of a column, those of structural objects worked out.
template <class T>
[[nodiscard]] std::vector<T> all_rows(const Model& model, const ColumnStore& columns, const Property<T>& property) {
  std::vector<T> rows = columns.find(property)->values;
  for (int i = 0; i < model.size(); ++i) {
    if (const auto value = structural_value(model, columns, property, i)) rows[static_cast<std::size_t>(i)] = *value;
  }
  return rows;
}

}  // namespace murosimf
