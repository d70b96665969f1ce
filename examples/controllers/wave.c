/* Control software in C: a robot waves with one joint. Needs nothing but the header.
 *   cc -shared -fPIC -o wave.so examples/controllers/wave.c -lm -I include      (where the package's headers are)
 *   murosimf run walk --set walker.controller=library --set walker.library=./wave.so --set walker.options.joint=j_r_sh_pitch
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <murosimf/control_software/murosimf_controller.h>

typedef struct wave {
  murosimf_command* target;
  size_t joint;     /* its number in the row of targets */
  double amplitude; /* [rad] */
  double period;    /* [s] */
} wave;

static void* create(const murosimf_robot* robot, char* error, size_t size) {
  const char* joint = robot->text_option(robot, "joint");
  const char* label;
  wave* self = calloc(1, sizeof *self);
  if (!self) return NULL;
  if (!joint) joint = "j_l_sh_pitch";
  self->amplitude = 0.5;
  self->period = 1;
  robot->number_option(robot, "amplitude", &self->amplitude);
  robot->number_option(robot, "period", &self->period);
  self->target = robot->command(robot, "joint.target");
  while (self->target && (label = robot->label(robot, "joint.target", self->joint)) != NULL) {
    if (strcmp(label, joint) == 0) return self;
    ++self->joint;
  }
  if (self->target) snprintf(error, size, "%s has no joint '%s'", robot->model, joint);
  free(self);
  return NULL;
}

static void destroy(void* instance) { free(instance); }

static void step(void* instance, int64_t now) {
  const wave* self = instance;
  self->target->values[self->joint] = self->amplitude * sin(2 * 3.14159265358979 * (double)now * 1e-9 / self->period);
}

static const murosimf_controller functions = {MUROSIMF_CONTROLLER_ABI,
                                              MUROSIMF_INDEPENDENT_INSTANCES,
                                              100, /* Hz */
                                              create,
                                              destroy,
                                              NULL, /* start: a new instance */
                                              step,
                                              NULL, /* no state: all follows from the time */
                                              NULL};

const murosimf_controller* murosimf_controller_entry(void) { return &functions; }
