// Control software for the real bus: the behavior of course.h at a serial line.
//   murosimf run examples/controllers/course.toml --set runner.controller=serial --serial ports --speed 1 &
//   course_serial ports/runner
#include <cstdio>
#include <exception>

#include "course_serial.h"

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: course_serial PORT\n");
    return 2;
  }
  try {
    cross_course_over_serial(arguments[1], [] { return true; });
    std::puts("I am there");
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
