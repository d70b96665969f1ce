#include "module.h"

#include "forks.h"
#include "murosimf/version.h"

NB_MODULE(_core, module) {
  using namespace murosimf::python;
  nanobind::set_leak_warnings(false);  // scripts end with scenes that are still there
  count_forks();
  bind_errors();
  bind_entities(module);
  bind_sensors(module);
  bind_kinematics(module);
  bind_robots(module);
  bind_scenes(module);
  bind_recordings(module);
  bind_batches(module);
  module.def("version", &murosimf::version);
}
