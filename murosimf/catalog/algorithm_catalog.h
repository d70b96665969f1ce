/// algorithm_catalog.h - names of algorithms, as files and the command line use them, and how to attach what they mean.
///
/// A new level, contact law or controller is one more line in algorithm_catalog.cpp; sensors have sensor_types.h.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "murosimf/collision/body_contact_law.h"
#include "murosimf/collision/contact_law.h"
#include "murosimf/locomotion/keyframe_motion.h"
#include "murosimf/model/find_entry.h"
#include "murosimf/motion/moving_tree.h"
#include "murosimf/motion/simplified_dynamics.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf::catalog {

/// How a level moves a robot; all levels take the same options and use what concerns them.
struct LevelOptions {
  motion::JointReferenceOptions reference;
  bool base_rigid = false;         ///< simplified_dynamics: the paper's literal reading
  std::string servo_law;           ///< articulated_dynamics: of all servos; empty: their own
  motion::MovingTreeOptions tree;  ///< full_dynamics, articulated_dynamics; its integrator: simplified_dynamics too
};

struct LevelType {
  std::string_view name, meaning;
  LevelTraits traits;
  std::string_view options;  ///< keys of a robot that it uses, besides those that all levels use
  std::string_view inputs;   ///< properties that may be set and act at this level, besides those that do at all levels
  std::unique_ptr<MotionLevel> (*make)(Setup&, const LevelOptions&);
};

struct ContactLawType {
  std::string_view name, meaning;
  std::shared_ptr<const collision::ContactLaw> (*make)();
  double longest_step;        ///< [s] with which a robot stands and walks at levels without servos (docs/scenes.md)
  double longest_servo_step;  ///< [s] the same at articulated_dynamics
};

/// Law between moving bodies.
struct BodyContactLawType {
  std::string_view name, meaning;
  std::unique_ptr<collision::BodyContactLaw> (*make)();
};

/// What a controller may want to know about its robot's place in the scene.
struct ControllerOptions {
  std::vector<Entity*> everybody;  ///< robots and ball
  Vec3d half_field{3, 2, 0};       ///< [m] from the middle to the touch and goal lines
  double attacks = 1;              ///< +1: the robot's team plays towards positive x, -1: the other way
  Vec3d command;                   ///< [m/s, m/s, rad/s] first walk_command
  std::optional<locomotion::KeyframeMotion> motion;
  Vec3d start;             ///< [m, m, rad] x, y and heading that the scene's file gives the robot, without its jitter
  Markings markings;       ///< of the field
  std::uint64_t seed = 1;  ///< of the scene
};

struct ControllerType {
  std::string_view name, meaning;
  std::string_view options;  ///< keys of a robot that it uses, besides those that all controllers use
  void (*attach)(Simulation&, Entity&, const ControllerOptions&);
  Vec3d (*attainable)(const Model&, const Vec3d& command) = nullptr;  ///< [m/s, m/s, rad/s] what it makes of a command
};

/// True if `word` is among the words of a list in the catalog.
[[nodiscard]] bool has_word(std::string_view words, std::string_view word);

[[nodiscard]] std::span<const LevelType> levels();
[[nodiscard]] std::span<const ContactLawType> contacts();
[[nodiscard]] std::span<const BodyContactLawType> body_contacts();
[[nodiscard]] std::span<const ControllerType> controllers();

}  // namespace murosimf::catalog
