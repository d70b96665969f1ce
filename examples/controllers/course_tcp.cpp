// Control software in a program of its own: the behavior of course.h over TCP.
//   murosimf run examples/controllers/course.toml --listen 5000 &
//   course_tcp 5000 runner
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "course_tcp.h"

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "usage: course_tcp PORT ROBOT\n");
    return 2;
  }
  try {
    cross_course_over_tcp(arguments[2], static_cast<std::uint16_t>(std::strtoul(arguments[1], nullptr, 10)));
    return 0;
  } catch (const murosimf::client::ClientError& error) {
    std::fprintf(stderr, "%s: %s\n", arguments[2], error.what());
    return 1;
  }
}
