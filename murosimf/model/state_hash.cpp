#include "murosimf/model/state_hash.h"

#include "murosimf/model/entity.h"
#include "murosimf/model/properties.h"
#include "murosimf/model/structural_objects.h"

namespace murosimf {
namespace {

/// With the rows of structural objects, if the column is that of a `property`.
template <class T>
bool append_if(Hasher& hasher, const Entity& entity, const ColumnBase& column, const Property<T>& property) {
  if (column.info().name != property.name) return false;
  for (const T& value : all_rows(entity.model(), entity.columns(), property)) append_hash(hasher, value);
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

void append_rows(Hasher& hasher, const Entity& entity, const ColumnBase& column) {
  if (append_if(hasher, entity, column, properties::position) ||
      append_if(hasher, entity, column, properties::orientation) ||
      append_if(hasher, entity, column, properties::linear_velocity) ||
      append_if(hasher, entity, column, properties::angular_velocity)) {
    return;
  }
  column.append_to(hasher);
}

}  // namespace

void append_state(Hasher& hasher, const Entity& entity) {
  hasher.add(std::string_view(entity.name()));
  hasher.add(std::uint64_t{(entity.frozen() ? 1u : 0u) + (entity.present() ? 0u : 2u)});
  for (const auto& [name, column] : entity.columns()) {
    if (!is_state(column->info().scope) || has_faded(*column)) continue;
    hasher.add(std::string_view(name));
    append_rows(hasher, entity, *column);
  }
}

}  // namespace murosimf
