/// body_contact_law.h - how two moving bodies push each other: chosen by name, for a whole scene.
///
/// * island_gauss_seidel (default): all contacts of touching entities are settled together (body_contact.h).
/// * carry: either body is implicit in its own acceleration alone. With b = b_n n n^T + b_t (1 - n n^T), B = h b and
///   f0 the force at the present velocity (implicit_stick_law.h), A feels f0 - B a_A and B feels -f0 - B a_B. Together that
///   should be nothing, but is e = -B (a_A + a_B); half of it is taken back from either one in the next step, so
///   momentum comes late but is not lost. For steps up to 2 ms.
/// * kelvin_voigt: explicit spring and damper, and viscous friction up to the cone:
///   f_n = max(0, k depth - d v_n),  f_t = -min(mu f_n, ct |v_t|) v_t / |v_t|. For steps of 1 ms.
///
/// Source: measured with the project's prototype. Law of action and reaction: at every instant (kelvin_voigt, island) or
/// summed over time (carry).
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "murosimf/collision/moving_entity.h"

namespace murosimf::collision {

enum class BodyContactLaw { island_gauss_seidel, carry, kelvin_voigt };

struct PairLawEntry {
  std::string_view name, meaning;
  BodyContactLaw law;
};

[[nodiscard]] std::span<const PairLawEntry> body_contact_laws();

/// Force of the contacts of this step, by `carry`; also takes back what the step before left over.
void push_by_carry(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt) noexcept;

/// Force of one contact of this step, by `kelvin_voigt`.
void push_by_kelvin_voigt(std::vector<MovingEntity>& moving_entities, PairContact& contact,
                          const ContactParameters& parameters, double dt) noexcept;

}  // namespace murosimf::collision
