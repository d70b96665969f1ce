// Control software for tests: says of each new picture that its camera has taken what it is, and a sum over its bytes.
#include <cstdio>

#include "murosimf/control_software/murosimf_controller.h"

namespace {

struct Instance {
  const murosimf_robot* robot = nullptr;
  const murosimf_picture* picture = nullptr;
  uint64_t seen = 0;
};

void* create(const murosimf_robot* robot, char*, size_t) {
  const char* name = robot->text_option(robot, "picture");
  const murosimf_picture* picture = robot->picture(robot, name ? name : "camera.color");
  if (!picture || picture->bytes) return nullptr;
  return new Instance{robot, picture};
}

void destroy(void* instance) { delete static_cast<Instance*>(instance); }

void start(void* instance) { static_cast<Instance*>(instance)->seen = 0; }

void step(void* instance, int64_t now) {
  auto& self = *static_cast<Instance*>(instance);
  const murosimf_picture& picture = *self.picture;
  if (picture.number == self.seen) return;
  self.seen = picture.number;
  unsigned long sum = 0;
  for (size_t i = 0; i < picture.size; ++i) sum = 31 * sum + static_cast<const unsigned char*>(picture.bytes)[i];
  char line[200];
  std::snprintf(line, sizeof line, "%u x %u %s, %g s, number %llu of %lld ms at %lld ms: %lu", picture.width,
                picture.height, picture.format, picture.period, static_cast<unsigned long long>(picture.number),
                static_cast<long long>(picture.time / 1000000), static_cast<long long>(now / 1000000), sum);
  self.robot->say(self.robot, line);
  const double border[] = {0, 0, 0, 1, 0, 0, 0, 2, 0};
  const murosimf_shape shapes[] = {{MUROSIMF_POLYGON, border, 3, 0, {0, 1, 0.5}, 0.5, nullptr},
                                   {MUROSIMF_TEXT, border + 6, 1, 0.1, {1, 1, 1}, 1, "seen"}};
  self.robot->draw(self.robot, "picture", 1, shapes, 2);
}

const murosimf_controller functions{
    MUROSIMF_CONTROLLER_ABI, MUROSIMF_INDEPENDENT_INSTANCES, 50, create, destroy, start, step, nullptr, nullptr};

}  // namespace

extern "C" const murosimf_controller* murosimf_controller_entry() { return &functions; }
