/// viewed_shapes.h - what an entity looks like: its shapes where they are now.
#pragma once

#include <vector>

#include "murosimf/model/entity.h"
#include "murosimf/render/scene_view.h"

namespace murosimf::appearance {

/// All shapes but planes, world frame. Those of the gray that shapes have by default take the entity's color. An entity
/// that nothing moves stands at the world's origin, joints at zero.
[[nodiscard]] std::vector<render::ViewedShape> viewed_shapes(const Entity& entity);

}  // namespace murosimf::appearance
