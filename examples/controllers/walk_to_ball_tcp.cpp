// Control software in a program of its own: the behavior of walk_to_ball.h over TCP.
//   murosimf run examples/controllers/to_the_ball_tcp.toml --listen 5000 &
//   walk_to_ball_tcp 5000 left & walk_to_ball_tcp 5000 right
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "walk_to_ball_tcp.h"

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "usage: walk_to_ball_tcp PORT ROBOT\n");
    return 2;
  }
  try {
    walk_to_ball(arguments[2], static_cast<std::uint16_t>(std::strtoul(arguments[1], nullptr, 10)));
    return 0;
  } catch (const murosimf::client::ClientError& error) {
    std::fprintf(stderr, "%s: %s\n", arguments[2], error.what());
    return 1;
  }
}
