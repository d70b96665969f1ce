#include <cstdio>

#include <murosimf/scene.h>

int main() {
  murosimf::Scene scene("walk", {.set = {"walker.level=simplified_dynamics"}});
  scene.run(5.0);
  const murosimf::Vector3 head = scene.robot("walker").pose("head").position;
  std::printf("after %.0f s the head is at (%.2f, %.2f, %.2f) m\n", scene.time(), head.x, head.y, head.z);
}
