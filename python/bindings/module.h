/// module.h - the parts of the module murosimf._core. What users see is the package around it (python/murosimf), which gives arrays
/// their shapes, and has all docstrings.
#pragma once

#include <nanobind/nanobind.h>

namespace murosimf::python {

void bind_errors();
void bind_entities(nanobind::module_& module);
void bind_robots(nanobind::module_& module);
void bind_sensors(nanobind::module_& module);
void bind_kinematics(nanobind::module_& module);
void bind_scenes(nanobind::module_& module);
void bind_recordings(nanobind::module_& module);
void bind_batches(nanobind::module_& module);

}  // namespace murosimf::python
