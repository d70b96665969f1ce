/// recorded_contacts.h - contacts, as of scene::add_contact_marks, for repeated use at every instant.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "murosimf/collision/contact.h"
#include "murosimf/runtime/pose_frame.h"
#include "murosimf/world/world.h"

namespace murosimf::recording {

/// Looks up columns only after a change of the entity's level (RecordedColumns).
class ContactWatch {
 public:
  void add(const World& world, std::vector<ContactMark>& marks);

 private:
  struct Known {
    const Entity* entity = nullptr;
    std::string level;
    std::shared_ptr<ColumnBase> kept;
    const Column<collision::ContactSet>* column = nullptr;  // null: no contacts
  };
  std::vector<Known> known_;  // by index in the world
};

}  // namespace murosimf::recording
