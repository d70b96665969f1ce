// Control software for tests: has the motion engine kick after half a second, and says each time that it does something else what it does.
#include <cstdio>
#include <cstring>

#include "murosimf/control_software/murosimf_controller.h"

namespace {

struct Instance {
  const murosimf_robot* robot = nullptr;
  const murosimf_signal *mode = nullptr, *phase = nullptr, *odometry = nullptr, *fallen = nullptr;
  murosimf_command* kick = nullptr;
  double last = -1;
};

void* create(const murosimf_robot* robot, char*, size_t) {
  return new Instance{robot,
                      robot->signal(robot, "motion.mode"),
                      robot->signal(robot, "motion.phase"),
                      robot->signal(robot, "motion.odometry"),
                      robot->signal(robot, "motion.fallen"),
                      robot->command(robot, "motion.kick")};
}

void destroy(void* instance) { delete static_cast<Instance*>(instance); }

void start(void* instance) { static_cast<Instance*>(instance)->last = -1; }

void step(void* instance, int64_t now) {
  auto& self = *static_cast<Instance*>(instance);
  if (now >= 500000000 && self.kick->values[0] == 0) {
    self.kick->values[0] = 1;
    self.kick->values[1] = 0.4;
    self.kick->values[2] = -1;
  }
  if (self.mode->values[0] == self.last) return;
  self.last = self.mode->values[0];
  const char* played = "nothing";
  for (size_t i = 0; i < self.phase->count; ++i) {
    if (self.phase->values[i] >= 0) played = self.robot->label(self.robot, "motion.phase", i);
  }
  char line[200];
  std::snprintf(line, sizeof line, "mode %g, plays %s, heading %.1f, fallen %g", self.last, played,
                self.odometry->values[2] + 1e-9, self.fallen->values[0]);
  self.robot->say(self.robot, line);
}

const murosimf_controller functions{
    MUROSIMF_CONTROLLER_ABI, MUROSIMF_INDEPENDENT_INSTANCES, 50, create, destroy, start, step, nullptr, nullptr};

}  // namespace

extern "C" const murosimf_controller* murosimf_controller_entry() { return &functions; }
