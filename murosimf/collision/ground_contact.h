/// ground_contact.h - algorithm: contact of one dynamic entity with the ground and all that stands on it for good.
///
/// Finds the points of every shape below the ground planes and inside static shapes (goals), gives each the memory that
/// its feature had in the step before, lets the law linearize them, and writes external_force (pushes of users,
/// ground) and external_damping. Contacts with other moving bodies come on top of that (body_contact.h). The motion
/// algorithm that comes after it settles the rest with the law (contact.h). While forces do not move the entity
/// (`dynamic` 0: kinematic walking) it has no contacts and costs nothing.
///
/// Constants (contact_parameters.h) are those of implicit laws where the law is one and joints give way. Where they
/// move exactly as told, soft ground stands for the give of legs and servos: with stiff ground open-loop walks of
/// such levels slip and fall.
///
/// An entity with longer steps of its own (multirate_stepping.h) has contacts as they fit these, also while it makes those of the scene: what
/// it stands on does not become stiffer when another entity comes near.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "murosimf/collision/contact.h"
#include "murosimf/collision/contact_interface.h"
#include "murosimf/collision/contact_laws/contact_law.h"
#include "murosimf/collision/ground_finder.h"
#include "murosimf/model/material.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::collision {

class GroundContact final : public Algorithm {
 public:
  /// `environment`: its plane shapes are the ground, its others stand there; null for none (free flight: pushes only).
  GroundContact(Setup& setup, const Entity* environment, std::shared_ptr<const ContactLaw> law,
                const MaterialTable& materials);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::contact; }
  void initialize() override;
  void model_exchanged(const Entity& entity) override;
  void step(const Instant& instant) noexcept override;
  [[nodiscard]] bool goes_with(const Algorithm& other) const override;
  [[nodiscard]] std::unique_ptr<LaneGroup> join(std::span<Algorithm* const> members) const override;

  /// From the next step on. Points keep their memory if both laws have the same (contact_law.h, island_use), else it
  /// begins anew. To be called between steps.
  void exchange_law(std::shared_ptr<const ContactLaw> law);
  /// From the next step on; points keep their memory. To be called between steps.
  void exchange_materials(const MaterialTable& materials);

 private:
  friend GroundLanes;

  void make_terms();
  void renew_terms();
  [[nodiscard]] const Model& model() const { return entity_.model(); }
  [[nodiscard]] bool wants_stiff_terms() const noexcept;
  void choose_terms() noexcept;
  void clear_loads() noexcept;
  void rest() noexcept;
  [[nodiscard]] bool begin_step(const Instant& instant) noexcept;
  void find_rest(std::size_t first) noexcept;
  void set_velocities(std::size_t first) noexcept;
  void end_step(const Instant& instant) noexcept;
  void begin_lift(ContactPoint& point) const noexcept;
  void remember();
  [[nodiscard]] bool has_crossed(const ContactPoint& point) const noexcept;
  void note_interpenetration(Duration now) noexcept;

  const Entity& entity_;
  const Entity* environment_entity_;
  MaterialTable materials_;
  Vec3d gravity_;  // [m/s^2] world
  std::shared_ptr<const ContactLaw> law_;
  GroundFinder finder_;
  int number_;                              // of the entity in the world
  int environment_;                         // its number in the world, -1 for none
  std::vector<ContactPoint> previous_;      // of the step before
  ContactTerms soft_terms_, stiff_terms_;   // for explicit laws, for implicit ones
  std::vector<int> environment_objects_;    // by Contact::surface
  std::vector<double> thicknesses_;         // [m] of the environment, by Contact::surface
  std::span<const Vec3d> r_;                // [m] origins, world
  std::span<const Mat3d> R_;                // orientations
  std::span<const Vec3d> v_;                // [m/s] of the origins, world
  std::span<const Vec3d> w_;                // [rad/s] world
  std::span<const Wrenchd> applied_force_;  // [N m, N] users' pushes
  const double& dynamic_;
  std::span<Wrenchd> external_force_;
  std::span<Sym6d> external_damping_;
  bool terms_are_stiff_ = false;  // those of the interface
  ContactSet& set_;
  ContactInterface& interface_;
};

}  // namespace murosimf::collision
