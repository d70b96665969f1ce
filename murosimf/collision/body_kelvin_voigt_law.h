/// body_kelvin_voigt_law.h - law between moving bodies: spring, damper, and viscous friction up to the cone, all explicit.
///
///     f_n = max(0, k depth - d v_n),  f_t = -min(mu f_n, ct |v_t|) v_t / |v_t|
///
/// For steps of 1 ms.
#pragma once

#include "murosimf/collision/body_contact_law.h"

namespace murosimf::collision {

class BodyKelvinVoigtLaw final : public BodyContactLaw {
 public:
  void push(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt, Helpers& helpers) noexcept override;
};

/// Force of one contact; also for contacts that another law has to leave out. `parameters` are those of the contact.
void push_by_kelvin_voigt(std::vector<MovingEntity>& moving_entities, PairContact& contact,
                          const ContactParameters& parameters, double dt) noexcept;

}  // namespace murosimf::collision
