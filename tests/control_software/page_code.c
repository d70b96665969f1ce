/* What docs/library.md quotes in C: it compiles. */
#include <murosimf/control_software/murosimf_controller.h>
#include <stddef.h>

static void show(const murosimf_robot* robot, const double* ball) { /* in start and step */
  const murosimf_shape shapes[] = {{MUROSIMF_CIRCLE, ball, 1, 0.2, {1, 0.5, 0}, 1, NULL},
                                   {MUROSIMF_TEXT, ball, 1, 0.1, {1, 1, 1}, 1, "ball"}};
  robot->draw(robot, "ball", 0, shapes, 2); /* in the place of the group "ball" before; 0 shapes: it is gone */
}

void (*const page_code_show)(const murosimf_robot*, const double*) = show;
