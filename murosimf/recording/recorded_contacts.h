/// recorded_contacts.h - where things touch, as scene::add_contact_marks has it, for who looks at every instant.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "murosimf/collision/contact.h"
#include "murosimf/model/world.h"
#include "murosimf/runtime/pose_frame.h"

namespace murosimf::recording {

/// Looks columns up only where another level moves an entity (RecordedColumns).
class ContactWatch {
 public:
  void add(const World& world, std::vector<ContactMark>& marks);

 private:
  struct Known {
    const Entity* entity = nullptr;
    std::string level;
    std::shared_ptr<ColumnBase> kept;
    const Column<collision::ContactSet>* column = nullptr;  // null: it has none
  };
  std::vector<Known> known_;  // by place in the world
};

}  // namespace murosimf::recording
