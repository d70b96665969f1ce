/// level.h - for plug-ins with a level of detail: `registries.levels.add({name, meaning, traits, keys, inputs, make})`, where make()
/// returns a MotionLevel that writes the poses and velocities of its entity's objects.
#pragma once

#include "murosimf/dynamics/joint_reference.h"
#include "murosimf/dynamics/pose_columns.h"
#include "murosimf/model/properties.h"
#include "murosimf/plugin/interface.h"
#include "murosimf/world/motion_level.h"
