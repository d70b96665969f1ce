// Control software for tests: nods, and makes the error that its options ask for, at the time that they name.
//
// It has a global variable that all instances use, so what it does depends on the order in which they are called; and a version, that
// tests of exchanged libraries see.
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include "murosimf/control_software/murosimf_controller.h"

namespace {

double all_calls = 0;  // grows with every call of any instance

struct Instance {
  const murosimf_robot* robot = nullptr;
  const murosimf_signal *position = nullptr, *gyroscope = nullptr;
  murosimf_command* target = nullptr;
  size_t head = 0;
  std::string error;
  double at = 0;     // [s]
  double seen = 0;   // sum of what the signals showed
  double steps = 0;  // state, besides `seen`
};

volatile double zero = 0;
volatile int nothing = 0;

__attribute__((noinline)) int deeper(volatile char* above) {
  volatile char here[4096];
  here[0] = static_cast<char>(above[0] + 1);
  return nothing != 0 ? 0 : deeper(here) + here[0];
}

void make(const std::string& error, Instance& self) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  if (error == "no_number") self.target->values[self.head] = nan;
  if (error == "infinite") self.target->values[self.head] = 1 / zero;
  if (error == "far") self.target->values[self.head] = 1e4;
  if (error == "throw") throw std::runtime_error("no such state");
  if (error == "throw_number") throw 42;
  if (error == "abort") std::abort();
  if (error == "segv") *static_cast<volatile int*>(nullptr) = 1;
  if (error == "fpe") (void)std::raise(SIGFPE);
  if (error == "overflow") {
    volatile char first[1] = {0};
    nothing = deeper(first);
  }
  while (error == "loop") nothing = nothing + 1;
}

void* create(const murosimf_robot* robot, char* error, size_t size) {
  auto* self = new Instance;
  self->robot = robot;
  self->position = robot->signal(robot, "joint.position");
  self->gyroscope = robot->signal(robot, "imu.gyroscope");
  self->target = robot->command(robot, "joint.target");
  double refuse = 0;
  robot->number_option(robot, "refuse", &refuse);
  robot->number_option(robot, "at", &self->at);
  if (const char* made = robot->text_option(robot, "error")) self->error = made;
  const char* wanted = robot->text_option(robot, "signal");
  if (refuse != 0) std::strncpy(error, "it is Monday", size);
  if ((wanted && !robot->signal(robot, wanted)) || refuse != 0 || !self->target) {
    delete self;
    return nullptr;
  }
  if (self->error == "create") {
    delete self;
    throw std::runtime_error("no memory");
  }
  while (std::strcmp(robot->label(robot, "joint.target", self->head), "j_head") != 0) ++self->head;
  return self;
}

void destroy(void* instance) { delete static_cast<Instance*>(instance); }

#ifdef WITH_START
void start(void* instance) {
  auto& self = *static_cast<Instance*>(instance);
  self.seen = self.steps = 0;
  self.target->values[self.head] = 0.05;
}
#endif

void step(void* instance, int64_t now) {
  auto& self = *static_cast<Instance*>(instance);
  if (!self.error.empty() && static_cast<double>(now) * 1e-9 >= self.at) make(self.error, self);
  if (self.error == "no_number" || self.error == "infinite" || self.error == "far") return;
  for (size_t i = 0; i < self.position->count; ++i) self.seen += self.position->values[i];
  for (size_t i = 0; i < self.gyroscope->count; ++i) self.seen += 0.1 * self.gyroscope->values[i];
  all_calls += 1;
  self.steps += 1;
  self.target->values[self.head] =
      0.1 * VERSION + 0.05 * std::sin(0.1 * self.steps + 0.01 * self.seen + 0.2 * all_calls);
}

size_t save(void* instance, void* bytes, size_t size) {
  auto& self = *static_cast<Instance*>(instance);
  const double all[] = {self.seen, self.steps, all_calls};
  if (size >= sizeof all) std::memcpy(bytes, all, sizeof all);
  return sizeof all;
}

int load(void* instance, const void* bytes, size_t size) {
  auto& self = *static_cast<Instance*>(instance);
  double all[3];
  if (size != sizeof all) return 0;
  std::memcpy(all, bytes, sizeof all);
  self.seen = all[0];
  self.steps = all[1];
  all_calls = all[2];
  return 1;
}

const murosimf_controller functions{MUROSIMF_CONTROLLER_ABI,
                                    0,
                                    50,
                                    create,
                                    destroy,
#ifdef WITH_START
                                    start,
#else
                                    nullptr,
#endif
                                    step,
                                    save,
                                    load};

}  // namespace

extern "C" const murosimf_controller* murosimf_controller_entry() { return &functions; }
