/// named_columns.h - columns of an entity by the names of their properties, for algorithms that get names instead of types.
#pragma once

#include <string_view>
#include <vector>

#include "murosimf/world/column.h"
#include "murosimf/world/setup.h"

namespace murosimf::control_software {

struct NamedColumn {
  const PropertyInfo* info = nullptr;
  ColumnBase::Memory memory{};
};

// Declare the access in `setup`, as its own functions do. Null `info`: there is no such property.
[[nodiscard]] NamedColumn column_to_read(Setup& setup, std::string_view property);
[[nodiscard]] NamedColumn column_to_write(Setup& setup, std::string_view property);

/// For messages.
[[nodiscard]] std::vector<std::string_view> names_of_columns();

}  // namespace murosimf::control_software
