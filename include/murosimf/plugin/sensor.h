/// sensor.h - for plug-ins with a sensor: `registries.sensors.add({...})`, with a Sensor whose measure() computes its numbers from
/// properties; errors, rate and delay are added by the base class.
#pragma once

#include "murosimf/model/properties.h"
#include "murosimf/plugin/interface.h"
#include "murosimf/sensors/mounting.h"
#include "murosimf/sensors/sensor.h"
