/// contact_marks.h - the contacts of a world, as points and forces for display.
#pragma once

#include <vector>

#include "murosimf/runtime/pose_frame.h"

namespace murosimf::scene {

/// Adds the contacts with the ground, and those between entities: the force is that on the first of the two.
void add_contact_marks(const World& world, std::vector<ContactMark>& marks);

}  // namespace murosimf::scene
