// Control software for tests: says every change of what it sees of the game, and turns its head by it.
#include <cstdio>
#include <cstring>
#include <string>

#include "murosimf/control_software/murosimf_controller.h"

namespace {

constexpr const char* names[] = {"state", "penalty", "penalty_remaining", "kick_off", "half", "number", "team"};
constexpr size_t count = sizeof names / sizeof names[0];

struct Instance {
  const murosimf_robot* robot = nullptr;
  const murosimf_signal *signals[count] = {}, *score = nullptr, *remaining = nullptr;
  murosimf_command *head = nullptr, *walk = nullptr, *answer = nullptr;
  double speed = 0, answers = 2;
  std::string said;
};

void* create(const murosimf_robot* robot, char*, size_t) {
  auto* self = new Instance;
  self->robot = robot;
  for (size_t i = 0; i < count; ++i) self->signals[i] = robot->signal(robot, (std::string("game.") + names[i]).c_str());
  self->score = robot->signal(robot, "game.score");
  self->remaining = robot->signal(robot, "game.remaining");
  self->walk = robot->command(robot, "walk.velocity");
  self->head = robot->command(robot, "walk.other_joints");
  self->answer = robot->command(robot, "game.answer");
  robot->number_option(robot, "speed", &self->speed);
  robot->number_option(robot, "answers", &self->answers);
  return self;
}

void destroy(void* instance) { delete static_cast<Instance*>(instance); }

void start(void* instance) { static_cast<Instance*>(instance)->said.clear(); }

void step(void* instance, int64_t) {
  auto& self = *static_cast<Instance*>(instance);
  self.walk->values[0] = self.speed;
  self.answer->values[0] = self.answers;
  self.head->values[0] = 0.001 * self.remaining->values[0];
  if (self.remaining->samples == 0) return;
  std::string line;
  for (size_t i = 0; i < count; ++i) {
    if (std::strcmp(names[i], "penalty_remaining") == 0) continue;  // changes in each word
    line += std::string(names[i]) + " " + std::to_string(static_cast<int>(self.signals[i]->values[0])) + " ";
  }
  line += std::to_string(static_cast<int>(self.score->values[0])) + ":" +
          std::to_string(static_cast<int>(self.score->values[1]));
  if (line != self.said) self.robot->say(self.robot, line.c_str());
  self.said = line;
}

const murosimf_controller functions{
    MUROSIMF_CONTROLLER_ABI, MUROSIMF_INDEPENDENT_INSTANCES, 100, create, destroy, start, step, nullptr, nullptr};

}  // namespace

extern "C" const murosimf_controller* murosimf_controller_entry() { return &functions; }
