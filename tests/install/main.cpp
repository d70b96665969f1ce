// The smallest program on the installed library: builds a two-legged model and counts its joints.

#include <iostream>

#include "murosimf/model/model.h"
#include "murosimf/model/properties.h"

using murosimf::Chain;
using murosimf::Model;

int main() {
  const auto leg = [](const char* knee, double y) {
    return Chain{}.translation({0, y, 0}).revolute(knee, {0, 1, 0}).with(murosimf::properties::mass, 0.3).endpoint();
  };
  const Chain body = Chain{}
                         .base("pelvis")
                         .with(murosimf::properties::mass, 1.2)
                         .fork(leg("left_knee", 0.05), leg("right_knee", -0.05));
  const Model biped("biped", body);

  std::cout << biped.name() << " has " << biped.joints().size() << " joints\n";
  return biped.joints().size() == 2 ? 0 : 1;
}
