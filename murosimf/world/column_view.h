/// column_view.h - a column as numbers in memory, for callers with names but no types: C, Python, recorders, viewers.
///
///     ColumnView positions = robot.view("position");     // 3 numbers per row, one row per object
///     positions(12, 2) += 0.1;                           // [m] z of object 12; its level sees it in its next step
///
/// A view is to be used between two steps only, by one thread at a time if it writes. Numbers of a row are in the order
/// of ObjectAccess, matrices row by row. Rows of objects that only give a model its shape (structural_objects.h)
/// are unused.
#pragma once

#include <memory>
#include <string_view>

#include "murosimf/math/assert.h"
#include "murosimf/world/column.h"

namespace murosimf {

/// `Number` is double, or const double for read access.
///
/// A view keeps its column: if a level is exchanged and no algorithm uses the column afterwards, it is no property of the entity then,
/// and keeps its last values; if the property is requested again, it is the same column again.
template <class Number>
class BasicColumnView {
 public:
  explicit BasicColumnView(std::shared_ptr<ColumnBase> column)
      : column_(std::move(column)), memory_(column_->memory()) {}

  [[nodiscard]] const PropertyInfo& info() const { return column_->info(); }
  [[nodiscard]] std::size_t rows() const { return memory_.rows; }
  /// Of one value: {3, 3} of a matrix, {3, 1} of a vector, {2, 3} of force and moment.
  [[nodiscard]] const std::array<std::size_t, 2>& shape() const { return memory_.layout.shape; }
  /// [doubles] from row to row of the column, and from number to number along both sides of a value.
  [[nodiscard]] std::array<std::ptrdiff_t, 3> strides() const {
    return {static_cast<std::ptrdiff_t>(memory_.stride), memory_.layout.strides[0], memory_.layout.strides[1]};
  }
  /// The number (0, 0) of row 0.
  [[nodiscard]] Number* data() const { return memory_.data + memory_.layout.first; }
  [[nodiscard]] Number& operator()(std::size_t row, std::size_t i, std::size_t j = 0) const {
    const auto [next_row, next_i, next_j] = strides();
    MUROSIMF_ASSERT(row < rows() && i < shape()[0] && j < shape()[1]);
    return data()[static_cast<std::ptrdiff_t>(row) * next_row + static_cast<std::ptrdiff_t>(i) * next_i +
                  static_cast<std::ptrdiff_t>(j) * next_j];
  }

 private:
  std::shared_ptr<ColumnBase> column_;
  ColumnBase::Memory memory_;
};

using ColumnView = BasicColumnView<double>;
using ConstColumnView = BasicColumnView<const double>;

}  // namespace murosimf
