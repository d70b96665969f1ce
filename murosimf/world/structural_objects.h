/// structural_objects.h - pose and velocity of objects that only give a model its shape: computed on request.
///
/// Levels keep no pose of such an object (model/object.h). It is fixed to a link with the row l, at the offset d and the
/// turn T in that link's axes, so that
///
///     r = r_l + R_l d     R = R_l T     w = w_l     v = v_l + w_l x (r - r_l)
///     alpha = alpha_l     a = a_l + alpha_l x (r - r_l) + w_l x (w_l x (r - r_l))
///
/// Its own rows in the columns are unused. Requests only read: any number of threads may make them, while no step runs.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/model/model.h"
#include "murosimf/world/column_store.h"

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

/// The same for one entity and many objects: its columns are looked up once, here. It must not outlive them.
class StructuralRows {
 public:
  StructuralRows(const Model& model, const ColumnStore& columns);

  [[nodiscard]] std::optional<Vec3d> value(const Property<Vec3d>& property, int object) const;
  [[nodiscard]] std::optional<Mat3d> value(const Property<Mat3d>& property, int object) const;

  /// Writes the values of all structural objects to their rows; `rows` has one for each object.
  template <class T>
  void work_out(const Property<T>& property, std::span<T> rows) const {
    MUROSIMF_ASSERT(rows.size() == static_cast<std::size_t>(model_->size()));
    for (int i = 0; i < model_->size(); ++i) {
      if (const auto known = value(property, i)) rows[static_cast<std::size_t>(i)] = *known;
    }
  }

  /// Null: there is no such column.
  struct Columns {
    const std::vector<Vec3d>*position = nullptr, *linear_velocity = nullptr, *angular_velocity = nullptr,
          *linear_acceleration = nullptr, *angular_acceleration = nullptr;
    const std::vector<Mat3d>* orientation = nullptr;
  };

 private:
  const Model* model_;
  Columns columns_;
};

}  // namespace murosimf
