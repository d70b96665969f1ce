/// structural_objects.h - rows of objects that only give a model its shape: worked out when somebody asks for them.
///
/// Levels keep no pose of such an object (model/object.h). It is fixed to a link with the row l, at the offset d and the
/// turn T in that link's axes, so that
///
///     r = r_l + R_l d     R = R_l T     w = w_l     v = v_l + w_l x (r - r_l)
#pragma once

#include "murosimf/model/column_store.h"
#include "murosimf/model/model.h"

namespace murosimf {

/// Writes pose and velocity of a structural object, as far as there are columns of them. Does nothing to other objects,
/// whose rows their level keeps. It writes: not to be called while somebody else reads or steps.
void update_structural(const Model& model, const ColumnStore& columns, int object);

}  // namespace murosimf
