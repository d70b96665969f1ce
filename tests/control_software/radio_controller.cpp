// Control software for tests: sends what its options say, reads what has come, says it, and turns its head by it, so that the state of the
// robot hangs on every message.
#include <cstdio>
#include <cstring>
#include <string>

#include "murosimf/control_software/murosimf_controller.h"

namespace {

struct Instance {
  const murosimf_robot* robot = nullptr;
  murosimf_command* target = nullptr;
  std::size_t head = 0;
  double every = 1, bytes = 8;  // steps; of a message
  int says = 0;
  double steps = 0, heard = 0;  // state
};

void* create(const murosimf_robot* robot, char*, size_t) {
  if (!robot->use_messages(robot) || !robot->use_messages(robot)) return nullptr;
  auto* self = new Instance;
  self->robot = robot;
  self->target = robot->command(robot, "joint.target");
  robot->number_option(robot, "every", &self->every);
  robot->number_option(robot, "bytes", &self->bytes);
  robot->truth_option(robot, "says", &self->says);
  while (std::strcmp(robot->label(robot, "joint.target", self->head), "j_head") != 0) ++self->head;
  return self;
}

void destroy(void* instance) { delete static_cast<Instance*>(instance); }

void start(void* instance) {
  auto& self = *static_cast<Instance*>(instance);
  self.steps = self.heard = 0;
}

void hear(Instance& self, const murosimf_message& message, int64_t now) {
  self.heard += static_cast<const unsigned char*>(message.bytes)[0] + 0.001 * static_cast<double>(message.sender[0]);
  if (self.says == 0) return;
  char line[100];
  std::snprintf(line, sizeof line, "%s %lld %lld %zu", message.sender, static_cast<long long>(message.sent / 1000000),
                static_cast<long long>(now / 1000000), message.size);
  self.robot->say(self.robot, line);
}

void step(void* instance, int64_t now) {
  auto& self = *static_cast<Instance*>(instance);
  murosimf_message message;
  while (self.robot->receive(self.robot, &message)) hear(self, message, now);
  const auto number = static_cast<long>(self.steps);
  self.steps += 1;
  self.target->values[self.head] = 0.3 * (self.heard / 50 - static_cast<double>(static_cast<long>(self.heard / 50)));
  if (self.every == 0 || number % static_cast<long>(self.every) != 0) return;
  const std::string bytes(static_cast<std::size_t>(self.bytes), static_cast<char>('A' + number % 26));
  self.robot->send(self.robot, bytes.data(), bytes.size());
}

size_t save(void* instance, void* bytes, size_t size) {
  auto& self = *static_cast<Instance*>(instance);
  const double all[] = {self.steps, self.heard};
  if (size >= sizeof all) std::memcpy(bytes, all, sizeof all);
  return sizeof all;
}

int load(void* instance, const void* bytes, size_t size) {
  auto& self = *static_cast<Instance*>(instance);
  double all[2];
  if (size != sizeof all) return 0;
  std::memcpy(all, bytes, sizeof all);
  self.steps = all[0];
  self.heard = all[1];
  return 1;
}

const murosimf_controller functions{
    MUROSIMF_CONTROLLER_ABI, MUROSIMF_INDEPENDENT_INSTANCES, 50, create, destroy, start, step, save, load};

}  // namespace

extern "C" const murosimf_controller* murosimf_controller_entry() { return &functions; }
