/// start_state.h - columns of an entity as they were before the first start, where every reset begins.
///
/// What algorithms remember besides columns is kept with their tasks (task.h).
#pragma once

namespace murosimf {

class Entity;

/// Columns keep what they have now.
void keep_columns(Entity& entity);
/// Gives the entity all of that again but what describes how it is wired; it is there or not as it was at first, and not frozen.
void go_back_to_start(Entity& entity);

}  // namespace murosimf
