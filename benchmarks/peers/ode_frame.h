/// ode_frame.h - where the links of a robot are in the world, by ODE's own functions: its bodies know no joint coordinates.
#pragma once

#include <ode/ode.h>

#include <vector>

#include "benchmarks/peers/description.h"

namespace peers {

struct Frame {
  dVector3 r;
  dQuaternion q;
};

/// What stands in the frame `outer` there.
inline Frame inside(const Frame& outer, const peers::Vector& position, const peers::Quaternion& rotation) {
  Frame result;
  dMatrix3 R;
  dQtoR(outer.q, R);
  const dVector3 local{position[0], position[1], position[2]};
  dMultiply0_331(result.r, R, local);
  for (int i = 0; i < 3; ++i) result.r[i] += outer.r[i];
  const dQuaternion turn{rotation[0], rotation[1], rotation[2], rotation[3]};
  dQMultiply0(result.q, outer.q, turn);
  return result;
}

/// Where the links are, at the start or with all joints at zero.
inline std::vector<Frame> frames(const std::vector<Link>& links, const Start& start, bool bent) {
  std::vector<Frame> frames;
  const Frame world{{0, 0, 0, 0}, {1, 0, 0, 0}};
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Link& link = links[i];
    if (link.parent < 0) {
      frames.push_back(inside(world, start.position, start.rotation));
      continue;
    }
    Frame frame = inside(frames[static_cast<std::size_t>(link.parent)], link.offset, link.rotation);
    if (bent) {
      dQuaternion turn;
      dQFromAxisAndAngle(turn, link.axis[0], link.axis[1], link.axis[2], start.joints[i - 1]);
      frame = inside(frame, {0, 0, 0}, {turn[0], turn[1], turn[2], turn[3]});
    }
    frames.push_back(frame);
  }
  return frames;
}

}  // namespace peers
