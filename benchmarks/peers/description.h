/// description.h - a scene in numbers that any engine can be built of: robots that are all of one model, what drives their joints, what
/// stands around them. `murosimf_peer_describe` writes it, the programs of the peers read it.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace peers {

using Vector = std::array<double, 3>;      ///< x y z
using Quaternion = std::array<double, 4>;  ///< w x y z, unit; body axes to the axes of the frame it is in

struct Shape {
  std::string kind;       ///< "sphere", "box", "capsule"; the long axis of a capsule is z
  Vector size{};          ///< [m] sphere: radius; box: half edges; capsule: radius, half length of the straight part
  Vector position{};      ///< [m] of its center, link frame; of what stands around: world
  Quaternion rotation{};  ///< its axes to those of the link, or of the world
};

struct Link {
  std::string joint;                ///< name; empty: the base
  int parent = -1;                  ///< index of a link before this one
  Vector axis{};                    ///< [1] of the hinge, link frame
  Vector offset{};                  ///< [m] of the hinge, frame of the parent
  Quaternion rotation{};            ///< link axes to the parent's at joint position 0
  double mass = 0;                  ///< [kg]
  Vector center{};                  ///< [m] of mass, link frame
  std::array<double, 6> inertia{};  ///< [kg m^2] xx yy zz xy xz yz at the center of mass, link axes
  std::vector<Shape> shapes;
  // the servo: torque = gain (target - position), no more than limit, - damping * velocity, dry friction against that
  double gain = 0;      ///< [N m/rad]
  double damping = 0;   ///< [N m s/rad]
  double limit = 0;     ///< [N m]
  double armature = 0;  ///< [kg m^2] of its rotor, seen at the joint
  double friction = 0;  ///< [N m] Coulomb
};

struct Start {
  Vector position{};           ///< [m] of the base, world
  Quaternion rotation{};       ///< of the base
  std::vector<double> joints;  ///< [rad] of links 1 and on
};

struct Description {
  double step = 0;          ///< [s]
  double friction = 0;      ///< [1] Coulomb coefficient of all pairs
  int steps_per_cycle = 0;  ///< targets are held for so many steps
  std::vector<Link> links;  ///< base first, parents before children
  std::vector<Shape> statics;
  std::vector<Start> robots;
  std::vector<std::vector<double>> targets;  ///< [rad] by control cycle: joints of the first robot, of the second, ...

  [[nodiscard]] std::size_t joints() const { return links.size() - 1; }  ///< of one robot
};

/// Throws std::runtime_error naming the file and what is wrong with it.
[[nodiscard]] Description read_description(const std::filesystem::path& file);
void write_description(const Description& description, const std::filesystem::path& file);

}  // namespace peers
