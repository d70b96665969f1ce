#include "murosimf/api/batch_random.h"

#include <cmath>

#include <fmt/format.h>

#include "murosimf/api/told.h"
#include "murosimf/math/random.h"

namespace murosimf::api {

BatchRandom::BatchRandom(const Entity& robot, const JointRows& joints, const std::vector<Randomized>& properties) {
  for (const Randomized& what : properties) {
    if (!std::isfinite(what.low) || !std::isfinite(what.high) || what.low > what.high) {
      throw InputError(
          fmt::format("{} from {} to {}: the first must not be above the second", what.property, what.low, what.high));
    }
    drawn_.push_back({what, named_rows(robot, joints, what.property, "property")});
  }
}

/// What is drawn hangs on the names only: not on the order of the list, and not on the number of worlds.
void BatchRandom::apply(Entity& robot, std::uint64_t seed) const {
  for (const auto& [what, named] : drawn_) {
    ColumnBase* const column = robot.columns().find(named.property);
    if (!column) continue;  // of a whole scene whose level has been exchanged
    const RandomStream random(seed, robot.name() + "/" + what.property);
    for (const std::size_t row : named.rows) {
      for (std::size_t i = 0; i < named.numbers; ++i) {
        const double number = random.uniform(named.numbers * row + i, what.low, what.high);
        column->set(row, i, what.scales ? number * column->get(row, i) : number);
      }
    }
  }
}

}  // namespace murosimf::api
