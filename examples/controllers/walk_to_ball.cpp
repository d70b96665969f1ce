// Control software in C++: a robot walks to the ball by the walk engine of the simulator and looks at it. Needs nothing but the header.
//   c++ -std=c++17 -shared -fPIC -o walk_to_ball.so examples/controllers/walk_to_ball.cpp -I include
//   murosimf run examples/controllers/to_the_ball.toml --libraries
#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include <murosimf/connect/murosimf_controller.h>

namespace {

/// All that it remembers from step to step.
struct Memory {
  bool arrived = false;
};

class WalkToBall {
 public:
  explicit WalkToBall(const murosimf_robot& robot)
      : robot_(&robot),
        ball_(signal("ground_truth.ball_position")),
        place_(signal("ground_truth." + std::string(robot.name) + "_position")),
        heading_(signal("ground_truth." + std::string(robot.name) + "_heading")),
        velocity_(command("walk.velocity")) {
    robot.number_option(&robot, "speed", &speed_);
  }

  void start() { memory_ = {}; }

  void step() {
    if (ball_->samples == 0) return;
    const double x = ball_->values[0] - place_->values[0], y = ball_->values[1] - place_->values[1];
    const double turn = std::remainder(std::atan2(y, x) - heading_->values[0], 6.283185307179586);
    const double distance = std::hypot(x, y);
    const bool there = distance < 0.25;  // [m]
    if (there && !memory_.arrived) robot_->say(robot_, "I am at the ball");
    memory_.arrived = memory_.arrived || there;
    velocity_->values[0] = memory_.arrived ? 0 : speed_ * std::max(0.0, std::cos(turn));
    velocity_->values[2] = memory_.arrived ? 0 : std::clamp(1.5 * turn, -0.7, 0.7);
  }

  Memory& memory() { return memory_; }

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
  double speed_ = 0.15;                              // [m/s]
  Memory memory_;
};

WalkToBall& self(void* instance) { return *static_cast<WalkToBall*>(instance); }

void* create(const murosimf_robot* robot, char*, size_t) { return new WalkToBall(*robot); }
void destroy(void* instance) { delete static_cast<WalkToBall*>(instance); }
void start(void* instance) { self(instance).start(); }
void step(void* instance, int64_t) { self(instance).step(); }

size_t save(void* instance, void* bytes, size_t size) {
  if (size >= sizeof(Memory)) std::memcpy(bytes, &self(instance).memory(), sizeof(Memory));
  return sizeof(Memory);
}
int load(void* instance, const void* bytes, size_t size) {
  if (size != sizeof(Memory)) return 0;
  std::memcpy(&self(instance).memory(), bytes, size);
  return 1;
}

const murosimf_controller functions{
    MUROSIMF_CONTROLLER_ABI, MUROSIMF_INDEPENDENT_INSTANCES, 20, create, destroy, start, step, save, load};

}  // namespace

const murosimf_controller* murosimf_controller_entry() { return &functions; }
