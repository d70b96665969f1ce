/// new_name.h - law between moving bodies: a damped spring that cannot pull, without friction; explicit.
///
/// With depth delta, unit normal n (from B to A) and velocity v of A against B at the beginning of the step:
///
///     f = max(0, k delta - d n . v) n on A, -f on B
///
/// This place is for the equations of the law, their source, and the steps at which it is stable.
#pragma once

#include "murosimf/collision/contact_laws/body_contact_law.h"

namespace murosimf::collision {

class NewName final : public BodyContactLaw {
 public:
  void push(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt,
            ParallelFor& parallel_for) noexcept override;
};

}  // namespace murosimf::collision
