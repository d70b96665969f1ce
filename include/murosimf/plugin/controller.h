/// controller.h - for plug-ins with a controller: `registries.controllers.add({name, meaning, keys, attach, options})`, where attach()
/// attaches an Algorithm that writes joint targets, or the command of a walk engine, which it attaches, too.
#pragma once

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/walk_engine.h"
#include "murosimf/model/properties.h"
#include "murosimf/plugin/interface.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"
