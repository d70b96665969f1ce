/// contact_interface.h - connection of the algorithms that share the contacts of one entity.
///
/// Contact with the ground brings the law, the level that moves the entity what answers to impulses. Both can be exchanged
/// between two steps, and neither is state: the points (contact.h) are, and do not depend on these algorithms.
#pragma once

#include "murosimf/collision/contact_point.h"
#include "murosimf/model/property.h"
#include "murosimf/world/state_archive.h"

namespace murosimf::collision {

class ContactLaw;
class ImpulseResponse;

struct ContactInterface {
  const ContactLaw* law = nullptr;      ///< of contact with the ground, which owns it; null: no such contact
  ContactTerms terms;                   ///< motion must have steps of the same dt
  bool damped_by_others = false;        ///< contact between bodies adds external damping: motion must be implicit in it
  ImpulseResponse* response = nullptr;  ///< of the level that moves the entity, for island solvers; null: none
};

/// No state: it is made again when the algorithms are attached again.
inline void append_hash(Hasher&, const ContactInterface&) {}
inline void state(StateArchive&, ContactInterface&) {}

/// One for each entity. Written by contact with the ground, contact between bodies and levels.
inline constexpr Property<ContactInterface> contact_interface{
    {"contact_interface", "-", "-", "law and level that work on the contacts of the entity", Scope::wiring}};

}  // namespace murosimf::collision
