/// batch_random.h - properties of a robot that differ from world to world of a batch, drawn at each start.
#pragma once

#include <cstdint>
#include <vector>

#include "murosimf/api/named_rows.h"
#include "murosimf/batch.h"

namespace murosimf::api {

class BatchRandom {
 public:
  BatchRandom() = default;  ///< none
  /// Throws UnknownName, and InputError for limits that are none.
  BatchRandom(const Entity& robot, const JointRows& joints, const std::vector<Randomized>& properties);

  [[nodiscard]] bool empty() const { return drawn_.empty(); }
  /// To a robot that was built alike and has just started, in a world of this seed.
  void apply(Entity& robot, std::uint64_t seed) const;

 private:
  struct Drawn {
    Randomized what;
    NamedRows named;
  };
  std::vector<Drawn> drawn_;
};

}  // namespace murosimf::api
