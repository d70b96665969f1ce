// Control software in C++: a robot walks to the ball by the walk engine of the simulator and looks at it. Needs nothing but
// the simulator's header and walk_to_ball.h.
//   c++ -std=c++17 -shared -fPIC -o walk_to_ball.so examples/controllers/walk_to_ball.cpp -I include
//   murosimf run examples/controllers/to_the_ball.toml --libraries
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include <murosimf/control_software/murosimf_controller.h>

#include "walk_to_ball.h"

namespace {

class LibraryController {
 public:
  explicit LibraryController(const murosimf_robot& robot)
      : robot_(&robot),
        ball_(signal("ground_truth.ball_position")),
        place_(signal("ground_truth." + std::string(robot.name) + "_position")),
        heading_(signal("ground_truth." + std::string(robot.name) + "_heading")),
        velocity_(command("walk.velocity")) {
    robot.number_option(&robot, "speed", &behavior_.speed);
  }

  void start() { behavior_.arrived = false; }

  void step() {
    if (ball_->samples == 0) return;
    const Seen seen{ball_->values, place_->values, heading_->values[0]};
    if (behavior_.step(seen, velocity_->values)) robot_->say(robot_, "I am at the ball");
  }

  bool& memory() { return behavior_.arrived; }

 private:
  const murosimf_signal* signal(const std::string& name) const {
    if (const murosimf_signal* found = robot_->signal(robot_, name.c_str())) return found;
    throw std::invalid_argument("there is no '" + name + "'");
  }
  murosimf_command* command(const char* name) const {
    if (murosimf_command* found = robot_->command(robot_, name)) return found;
    throw std::invalid_argument(std::string("there is no '") + name + "'");
  }

  const murosimf_robot* robot_;
  const murosimf_signal *ball_, *place_, *heading_;  // [m], [m], [rad] in the world
  murosimf_command* velocity_;                       // [m/s, m/s, rad/s] forward, to the left, turning
  WalkToBall behavior_;
};

LibraryController& self(void* instance) { return *static_cast<LibraryController*>(instance); }

void* create(const murosimf_robot* robot, char*, size_t) { return new LibraryController(*robot); }
void destroy(void* instance) { delete static_cast<LibraryController*>(instance); }
void start(void* instance) { self(instance).start(); }
void step(void* instance, int64_t) { self(instance).step(); }

size_t save(void* instance, void* bytes, size_t size) {
  if (size >= sizeof(bool)) std::memcpy(bytes, &self(instance).memory(), sizeof(bool));
  return sizeof(bool);
}
int load(void* instance, const void* bytes, size_t size) {
  if (size != sizeof(bool)) return 0;
  std::memcpy(&self(instance).memory(), bytes, size);
  return 1;
}

const murosimf_controller functions{
    MUROSIMF_CONTROLLER_ABI, MUROSIMF_INDEPENDENT_INSTANCES, 20, create, destroy, start, step, save, load};

}  // namespace

const murosimf_controller* murosimf_controller_entry() { return &functions; }
