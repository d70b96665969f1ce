/// sensor.h - for plug-ins with a sensor: `registries.sensors.add({...})`, with a Sensor that says in measure() how properties become
/// numbers; errors, rate and delay are its for nothing.
#pragma once

#include "murosimf/model/properties.h"
#include "murosimf/plugin/interface.h"
#include "murosimf/sensors/mounting.h"
#include "murosimf/sensors/sensor.h"
