#include "murosimf/world/state_hash.h"

#include <cstddef>
#include <span>
#include <typeinfo>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/entity.h"
#include "murosimf/world/structural_objects.h"

namespace murosimf {
namespace {

/// Appends all rows, including those of structural objects, if the column is that of `property`.
template <class T>
bool append_if(Hasher& hasher, const StructuralRows& structural, const ColumnBase& column,
               const Property<T>& property) {
  if (column.info().name != property.name || column.type() != typeid(T)) return false;
  std::vector<T> rows = static_cast<const Column<T>&>(column).values;
  MUROSIMF_ASSERT(rows.size() == column.rows());
  // rows of structural objects hold no numbers; what they would be is part of the state all the same
  structural.work_out(property, std::span(rows));
  for (const T& value : rows) append_hash(hasher, value);
  return true;
}

bool has_faded(const ColumnBase& column) {
  if (!column.info().fades) return false;
  for (std::size_t row = 0; row < column.rows(); ++row) {
    for (std::size_t i = 0; i < column.numbers(); ++i) {
      if (column.get(row, i) != 0) return false;
    }
  }
  return true;
}

void append_rows(Hasher& hasher, const StructuralRows& structural, const ColumnBase& column) {
  if (append_if(hasher, structural, column, properties::position) ||
      append_if(hasher, structural, column, properties::orientation) ||
      append_if(hasher, structural, column, properties::linear_velocity) ||
      append_if(hasher, structural, column, properties::angular_velocity)) {
    return;
  }
  column.append_to(hasher);
}

}  // namespace

void append_state(Hasher& hasher, const Entity& entity) {
  hasher.add(std::string_view(entity.name()));
  hasher.add(std::uint64_t{(entity.frozen() ? 1u : 0u) + (entity.present() ? 0u : 2u)});
  const StructuralRows structural(entity.model(), entity.columns());
  // in the order of names: independent of the order in which algorithms were attached
  for (const auto& [name, column] : entity.columns()) {
    if (!is_state(column->info().scope) || has_faded(*column)) continue;
    hasher.add(std::string_view(name));
    append_rows(hasher, structural, *column);
  }
}

}  // namespace murosimf
