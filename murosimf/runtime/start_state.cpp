#include "murosimf/runtime/start_state.h"

#include "murosimf/world/entity.h"

namespace murosimf {

void keep_columns(Entity& entity) {
  for (const auto& [name, column] : entity.columns()) column->keep();
}

void go_back_to_start(Entity& entity) {
  entity.unfreeze();
  entity.set_present(entity.options().present);
  for (const auto& [name, column] : entity.columns()) {
    if (column->info().scope != Scope::wiring) column->go_back();
  }
}

}  // namespace murosimf
