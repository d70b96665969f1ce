#include "murosimf/scene/scene_checks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/dynamics/mimic_joints.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/loops.h"
#include "murosimf/scene/model_constants.h"
#include "murosimf/scene/property_checks.h"
#include "murosimf/scene/start_overlaps.h"
#include "murosimf/scene_file/automatic_rate.h"
#include "murosimf/scene_file/section_change.h"
#include "murosimf/scene_file/setting_targets.h"
#include "murosimf/scene_file/unsteady_stacks.h"
#include "murosimf/scene_file/unused_settings.h"

namespace murosimf::scene {
namespace {

void add_materials(const Model& model, std::set<std::string>& names) {
  for (const int object : model.having(properties::shapes)) {
    for (const PlacedShape& placed : *model.find(properties::shapes, object)) {
      if (!placed.surface.material.empty()) names.insert(placed.surface.material);
    }
  }
}

/// Names of bodies are checked against the model, which the reader of the file does not have.
void check_no_contact(Diagnostics& diagnostics, const scene_file::RobotSpec& robot, const Model& model) {
  const auto given = robot.given.find("no_contact");
  if (given == robot.given.end()) return;
  for (const auto& [a, b] : robot.collision.never) {
    for (const std::string& name : {a, b}) {
      if (model.find_object(name)) continue;
      throw SetupError(fmt::format("{}: model '{}': {}", given->second.where, model.name(),
                                   unknown_name("object", name, model.object_names())));
    }
  }
  if (!robot.collision.never.empty() && !robot.collision.self_collision) {
    diagnostics.warn(robot.name, "'no_contact' changes nothing without 'self_collision = true'");
  }
}

void check_property(SceneParts& parts, const scene_file::PropertySetting& setting, double time) {
  for (const std::string& entity : setting.entities) {
    with_context(setting.where, [&] {
      if (const auto line = check_setting(*parts.simulation, parts.spec, setting, entity, time); !line.empty()) {
        parts.diagnostics.warn(entity, fmt::format("{}; it changes nothing ({})", line, setting.where));
      }
    });
    if (setting.property != properties::walk_command.name || setting.numbers.size() != 3) continue;
    const Vec3d command{setting.numbers[0], setting.numbers[1], setting.numbers[2]};
    for (std::size_t i = 0; i < parts.robots.size(); ++i) {
      const scene_file::RobotSpec& robot = parts.spec.robots[i];
      if (robot.name != entity) continue;
      const auto line = check_command(robot, parts.robots[i]->model(), command);
      if (!line.empty()) parts.diagnostics.warn(entity, fmt::format("{} ({})", line, setting.where));
    }
  }
}

/// Contact of an entity with the ground.
struct ContactUse {
  std::string contact;
  OptionValues options;
  std::string level;
  double step;  ///< [s]
  bool servos = false;
};

/// A law has a longest stable step: beyond, bodies may vibrate or fly apart.
void warn_about_steps(SceneParts& parts, const std::string& entity, const ContactUse& use) {
  MUROSIMF_ASSERT(use.step > 0);
  const catalog::ContactLawType& law = find_entry(catalog::contacts(), "contact law", use.contact);
  const catalog::LongestSteps steps = catalog::stable_steps(law, use.options);
  const double longest = use.servos ? steps.with_servos : steps.without_servos;
  if (use.step <= longest * (1 + 1e-9)) return;
  parts.diagnostics.warn(entity,
                         fmt::format("{} under {} is stable with steps up to {:.0f} ms; these are {:.3g} ms long",
                                     use.contact, use.level, 1e3 * longest, 1e3 * use.step));
}

void warn_about_things(SceneParts& parts) {
  const double step = 1 / parts.spec.rate;
  if (const auto& ball = parts.spec.ball) {
    warn_about_steps(parts, "ball", {ball->contact, {}, "simplified_dynamics", step});
  }
  for (const scene_file::BodySpec& body : parts.spec.bodies) {
    if (body.is_static) continue;
    warn_about_steps(parts, body.name, {body.contact, {}, "simplified_dynamics", step});
    const bool round = body.shape && std::holds_alternative<Sphere>(*body.shape);
    const double stiff = scene_file::longest_stiff_step(parts.spec, body.contact, body.material, body.mass);
    if (round || step <= stiff) continue;
    parts.diagnostics.warn(
        body.name, fmt::format("the 'stiffness' of its pair of materials needs steps of {:.2g} ms under {}; these "
                               "are {:.3g} ms long",
                               1e3 * stiff, body.contact, 1e3 * step));
  }
}

/// Whether each joint is driven: by a servo, its own or that of a coupled joint, or by the joint that it follows; and all joints of
/// a loop with a driven one.
std::vector<bool> driven_joints(const Model& model) {
  std::vector<int> leader(static_cast<std::size_t>(model.size()));
  std::iota(leader.begin(), leader.end(), 0);
  const dynamics::MimicJoints coupled(model);
  for (const auto& pair : coupled.pairs()) leader[pair.follower] = pair.leader;
  std::set<int> driven;
  for (const int i : model.having(properties::servo)) driven.insert(leader[i]);
  for (const auto& tendon : coupled.tendons()) {
    if (model.find(properties::servo, tendon.follower)) {
      for (const int joint : tendon.joints) driven.insert(leader[joint]);
    }
    driven.insert(tendon.follower);  // it moves nothing itself
  }
  const auto loops = multibody::loops_of(model);
  const auto taken_along = [&](int joint) {
    return std::ranges::any_of(loops, [&](const multibody::Loop& loop) {
      return is_in(model, loop, joint) && std::ranges::any_of(driven, [&](int i) { return is_in(model, loop, i); });
    });
  };
  std::vector<bool> result;
  for (const int i : model.joints()) result.push_back(leader[i] != i || driven.contains(i) || taken_along(i));
  return result;
}

/// Without a servo a joint is limp at levels with servos, which is rarely intended.
void warn_about_missing_servos(SceneParts& parts, const scene_file::RobotSpec& robot) {
  const Model& model = parts.simulation->world().entity(robot.name).model();
  const auto joints = model.joints();
  const auto without = std::ranges::count(driven_joints(model), false);
  if (without == 0) return;
  parts.diagnostics.warn(robot.name,
                         fmt::format("{} of its {} joints have no servo and hang free", without, joints.size()));
}

/// Gaits and motions were tuned at the weight on earth; a controller with balance measures gravity.
std::string other_gravity(const scene_file::RobotSpec& robot, double gravity) {
  static const std::set<std::string> made_for_earth{"walk",        "trot",     "keyframes",
                                                    "ball_chaser", "localize", "obstacle_course"};
  constexpr double earth = 9.81, like = 0.1;  // [m/s^2], [1]
  if (std::abs(gravity - earth) <= like * earth || !made_for_earth.contains(robot.controller)) return {};
  if (!catalog::levels().find(robot.level).traits.dynamic) return {};
  const std::string what = robot.motion.empty() ? fmt::format("controller '{}'", robot.controller)
                                                : fmt::format("motion '{}'", robot.motion);
  return fmt::format("{} was made for gravity of {} m/s^2; with {:.3g} a robot may end otherwise", what, earth,
                     gravity);
}

/// Robots of the same kind get one line.
void note_other_gravity(SceneParts& parts) {
  std::vector<SharedDiagnostic> diagnostics;
  for (const scene_file::RobotSpec& robot : parts.spec.robots) {
    add_diagnostic(other_gravity(robot, norm(parts.spec.gravity)), robot.name, diagnostics);
  }
  for (const SharedDiagnostic& diagnostic : diagnostics) parts.diagnostics.note(to_text(diagnostic));
}

}  // namespace

void warn_about_settings(SceneParts& parts) {
  const scene_file::SceneSpec& spec = parts.spec;
  parts.diagnostics.warn(scene_file::unused_keys(spec));
  if (spec.automatic_rate) {
    parts.diagnostics.note(fmt::format("rate \"auto\" is {:g} Hz: {}", spec.rate, spec.rate_because));
  }
  std::set<std::string> materials;
  add_materials(parts.field->model(), materials);
  for (const Entity* moving_entity : parts.moving_entities) add_materials(moving_entity->model(), materials);
  for (const scene_file::SceneEvent& event : spec.events) {
    if (event.section == "ball" && event.key == "material") materials.insert(changed(*spec.ball, event).material);
  }
  const std::vector<std::string> used(materials.begin(), materials.end());
  parts.diagnostics.warn(scene_file::unused_pairs(spec, used));
  if (auto line = scene_file::unused_friction_direction(spec, used); !line.empty())
    parts.diagnostics.warn(std::move(line));
  parts.diagnostics.warn(scene_file::unsteady_stacks(spec));
  warn_about_things(parts);
  MUROSIMF_ASSERT(parts.robots.size() == spec.robots.size());
  for (std::size_t i = 0; i < parts.robots.size(); ++i) {
    const scene_file::RobotSpec& robot = spec.robots[i];
    const Model& model = parts.robots[i]->model();
    check_no_contact(parts.diagnostics, robot, model);
    if (const auto line = check_command(robot, model, robot.command); !line.empty())
      parts.diagnostics.warn(robot.name, line);
  }
  note_other_gravity(parts);
}

void check_properties(SceneParts& parts) {
  for (const scene_file::PropertySetting& setting : parts.spec.settings) {
    if (!is_constant(setting)) check_property(parts, setting, 0);  // constants were checked with the model
  }
  for (const scene_file::SceneEvent& event : parts.spec.events) {
    if (event.setting) check_property(parts, *event.setting, event.time);
  }
}

void warn_about_start(SceneParts& parts) {
  parts.diagnostics.warn(start_overlaps(*parts.field, parts.moving_entities));
}

void warn_about_level(SceneParts& parts, const scene_file::RobotSpec& robot) {
  const LevelTraits level = find_entry(catalog::levels(), "level", robot.level).traits;
  if (level.dynamic)
    warn_about_steps(parts, robot.name,
                     {robot.contact, robot.contact_options, robot.level, 1 / step_rate(parts.spec, robot),
                      level.servos});
  if (level.servos) warn_about_missing_servos(parts, robot);
}

}  // namespace murosimf::scene
