/// body_explicit_laws.h - laws between moving bodies whose forces follow from the beginning of a step alone. For steps of 1 ms.
#pragma once

#include "murosimf/collision/contact_laws/body_contact_law.h"
#include "murosimf/collision/contact_laws/effective_mass.h"
#include "murosimf/collision/contact_laws/paper_law.h"

namespace murosimf::collision {

/// Spring, damper, and viscous friction up to the cone:
///
///     f_n = max(0, k depth - d v_n),  f_t = -min(mu f_n, ct |v_t|) v_t / |v_t|
class BodyKelvinVoigtLaw final : public BodyContactLaw {
 public:
  void push(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt,
            ParallelFor& parallel_for) noexcept override;
};

/// Force of one contact; also for contacts that another law has to leave out. `parameters` are those of the contact.
void push_by_kelvin_voigt(std::vector<MovingEntity>& moving_entities, PairContact& contact,
                          const ContactParameters& parameters, double dt) noexcept;

/// The paper's collision response (paper_law.h) between bodies that move: `paper` at the deepest point of two
/// bodies, as there, and `paper_multipoint` at every point.
///
/// A feels f_n + f_fric and n_fric, B the opposite; v_t and w are those of A against B. With `bounded`, our addition, friction
/// takes the velocities that the step ends with if nothing but this contact acts:
///
///     f_fric = -c v_t / (1 + dt c S),   c = s_mu |f_n|
///
/// and the same of n_fric, with S [1/kg] what both bodies yield to 1 N s in the direction of sliding, at most, times the contacts
/// that they have (effective_mass.h). So friction never adds energy: with x = dt c S / (1 + dt c S) < 1 it gives back at
/// most x / 2 of what it takes, and the same again where it also turns.
/// Source:  paper 5.3, eq. (4) and (5).
/// Limits:  the spring is explicit: dt^2 s_c S must stay below 4.
class BodyPaperLaw final : public BodyContactLaw {
 public:
  explicit BodyPaperLaw(const PaperLawOptions& options = {}) : options_(options) {}

  void push(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt,
            ParallelFor& parallel_for) noexcept override;

 private:
  PaperLawOptions options_;
  EffectiveMass parts_;
  struct Touched {
    EffectiveMass::Number a, b;
  };
  std::vector<Touched> touched_;  // by contact
};

}  // namespace murosimf::collision
