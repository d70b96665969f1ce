/// deferred_impulse_law.h - law between moving bodies: either one implicit by itself, what is left over given back a step later.
///
/// With b = b_n n n^T + b_t (1 - n n^T), B = h b and f0 the force at the present velocity (implicit_stick_law.h), A feels
/// f0 - B a_A and B feels -f0 - B a_B. Together that should be nothing, but is e = -B (a_A + a_B); half of it is taken back from
/// either one in the next step, so momentum comes late but is not lost. For steps up to 2 ms.
/// Source: measured with the project's prototype.
#pragma once

#include "murosimf/collision/contact_laws/body_contact_law.h"

namespace murosimf::collision {

class DeferredImpulseLaw final : public BodyContactLaw {
 public:
  [[nodiscard]] bool damps() const noexcept override { return true; }
  void push(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt,
            ParallelFor& parallel_for) noexcept override;
};

}  // namespace murosimf::collision
