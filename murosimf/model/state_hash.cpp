#include "murosimf/model/state_hash.h"

#include "murosimf/model/entity.h"
#include "murosimf/model/structural_objects.h"

namespace murosimf {

void append_state(Hasher& hasher, const Entity& entity) {
  hasher.add(std::string_view(entity.name()));
  hasher.add(std::uint64_t{entity.frozen() ? 1u : 0u});
  for (int i = 0; i < entity.model().size(); ++i) update_structural(entity.model(), entity.columns(), i);
  for (const auto& [name, column] : entity.columns()) {
    if (!is_state(column->info().scope)) continue;
    hasher.add(std::string_view(name));
    column->append_to(hasher);
  }
}

}  // namespace murosimf
