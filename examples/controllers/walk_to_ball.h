/// walk_to_ball.h - the behavior of examples that walk to the ball, as shared library (walk_to_ball.cpp) and over TCP
/// (walk_to_ball_tcp.cpp): it does not depend on how its robot is connected.
#pragma once

#include <algorithm>
#include <cmath>

/// What it sees: in the world.
struct Seen {
  const double* ball;   // [m, m, m]
  const double* place;  // [m, m, m] of the robot
  double heading;       // [rad] of the robot
};

class WalkToBall {
 public:
  /// Writes the velocity [m/s, m/s, rad/s] forward, to the left, turning. True when it has just arrived.
  bool step(const Seen& seen, double* velocity) {
    const double x = seen.ball[0] - seen.place[0], y = seen.ball[1] - seen.place[1];
    const double turn = std::remainder(std::atan2(y, x) - seen.heading, 6.283185307179586);
    const bool there = std::hypot(x, y) < 0.25;  // [m]
    const bool arrives = there && !arrived;
    arrived = arrived || there;
    velocity[0] = arrived ? 0 : speed * std::max(0.0, std::cos(turn));
    velocity[2] = arrived ? 0 : std::clamp(1.5 * turn, -0.7, 0.7);
    return arrives;
  }

  double speed = 0.15;   // [m/s]
  bool arrived = false;  // its whole state
};
