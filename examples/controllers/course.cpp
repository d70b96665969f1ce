// Control software in C++: the behavior of course.h as a shared library.
//   c++ -std=c++17 -shared -fPIC -o course.so examples/controllers/course.cpp -I include
//   murosimf run examples/controllers/course.toml --set runner.controller=library --set runner.library=./course.so
#include <array>
#include <cstring>
#include <stdexcept>
#include <string>

#include <murosimf/control_software/murosimf_controller.h>

#include "course.h"

namespace {

class LibraryRunner {
 public:
  explicit LibraryRunner(const murosimf_robot& robot)
      : robot_(&robot),
        position_(robot.signal(&robot, "joint.position")),
        target_(robot.command(&robot, "joint.target")),
        led_(robot.command(&robot, "robot.led")) {
    if (!position_ || !target_ || !led_) throw std::invalid_argument("it needs joints");
    for (std::size_t i = 0; i < runner.joints.size(); ++i) place_[i] = find(runner.joints[i]);
  }

  void step() {
    CourseRunner::Angles measured, target;
    for (std::size_t i = 0; i < place_.size(); ++i) measured[i] = position_->values[place_[i]];
    if (runner.step(measured, target)) robot_->say(robot_, "I am there");
    for (std::size_t i = 0; i < place_.size(); ++i) target_->values[place_[i]] = target[i];
    led_->values[1] = runner.arrived ? 1 : 0;  // green
  }

  CourseRunner runner;

 private:
  std::size_t find(const char* joint) const {
    for (std::size_t i = 0; const char* label = robot_->label(robot_, "joint.target", i); ++i) {
      if (std::strcmp(label, joint) == 0) return i;
    }
    throw std::invalid_argument(std::string("there is no '") + joint + "'");
  }

  const murosimf_robot* robot_;
  const murosimf_signal* position_;  // [rad]
  murosimf_command *target_, *led_;  // [rad], red, green, blue
  std::array<std::size_t, CourseRunner::joint_count> place_{};
};

LibraryRunner& self(void* instance) { return *static_cast<LibraryRunner*>(instance); }

void* create(const murosimf_robot* robot, char*, size_t) { return new LibraryRunner(*robot); }
void destroy(void* instance) { delete static_cast<LibraryRunner*>(instance); }
void start(void* instance) { self(instance).runner = {}; }
void step(void* instance, int64_t) { self(instance).step(); }

size_t save(void* instance, void* bytes, size_t size) {
  if (size >= sizeof(CourseRunner)) std::memcpy(bytes, &self(instance).runner, sizeof(CourseRunner));
  return sizeof(CourseRunner);
}
int load(void* instance, const void* bytes, size_t size) {
  if (size != sizeof(CourseRunner)) return 0;
  std::memcpy(&self(instance).runner, bytes, size);
  return 1;
}

const murosimf_controller functions{MUROSIMF_CONTROLLER_ABI,
                                    MUROSIMF_INDEPENDENT_INSTANCES,
                                    1 / CourseRunner::period,
                                    create,
                                    destroy,
                                    start,
                                    step,
                                    save,
                                    load};

}  // namespace

const murosimf_controller* murosimf_controller_entry() { return &functions; }
