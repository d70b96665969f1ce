#include "murosimf/scene_file/automatic_rate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <variant>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/math/assert.h"

namespace murosimf::scene_file {
namespace {

constexpr std::array<double, 7> choices{0.01, 0.005, 0.002, 0.001, 0.0005, 0.0002, 0.0001};  // [s]
constexpr double longest_kinematic = 0.005;  // [s] error of 1.2 % of the path in a curve; 2.8 % at 10 ms

constexpr double share_of_radius = 0.2;       // [1] travelled by a ball in a step
constexpr double shortest_fast = 0.0005;      // [s] for fast balls
constexpr double explicit_resolution = 0.02;  // [1] dt^2 k / m_p

/// The shortest of the required steps.
class Demands {
 public:
  void add(double longest_step, std::string reason) {
    MUROSIMF_ASSERT(!(longest_step <= 0));
    if (!because_.empty() && longest_step >= longest_) return;
    longest_ = longest_step;
    because_ = std::move(reason);
  }
  [[nodiscard]] AutomaticRate rate() const {
    if (because_.empty()) return {usual_step_rate, "nothing moves"};
    // round rates only: their periods are whole nanoseconds, and controllers divide them
    const auto fits = [&](double step) { return step <= longest_ * (1 + 1e-9); };
    const auto* step = std::ranges::find_if(choices, fits);
    return {1 / (step == choices.end() ? longest_ : *step), because_};
  }

 private:
  double longest_ = choices.front();
  std::string because_;
};

/// Initial value of this key of a robot, and those that events set.
std::vector<std::string> values_of(const RobotSpec& robot, std::string_view key, const std::string& first,
                                   const std::vector<SceneEvent>& events) {
  std::vector<std::string> values{first};
  for (const SceneEvent& event : events) {
    const bool concerns = event.key == key && std::ranges::count(event.entities, robot.name) > 0;
    if (concerns && !event.setting) values.push_back(event.value);
  }
  return values;
}

void add_robot(const RobotSpec& robot, const std::vector<SceneEvent>& events, Demands& demands) {
  for (const std::string& level : values_of(robot, "level", robot.level, events)) {
    const LevelTraits traits = catalog::levels().find(level).traits;
    if (!traits.dynamic) {
      demands.add(longest_kinematic, fmt::format("{} at {}", robot.name, level));
      continue;
    }
    for (const std::string& contact : values_of(robot, "contact", robot.contact, events)) {
      const catalog::LongestSteps steps =
          catalog::accurate_steps(catalog::contacts().find(contact), robot.contact_options);
      demands.add(traits.servos ? steps.with_servos : steps.without_servos,
                  fmt::format("{} at {} under {}", robot.name, level, contact));
    }
  }
}

void add_thing(const std::string& name, const std::string& contact, Demands& demands) {
  const catalog::LongestSteps steps = catalog::accurate_steps(catalog::contacts().find(contact), {});
  demands.add(steps.without_servos, fmt::format("{} under {}", name, contact));
}

void add_speed(const std::string& name, double radius, double speed, Demands& demands) {
  if (speed == 0) return;
  demands.add(std::max(share_of_radius * radius / speed, shortest_fast), fmt::format("{} at {:.3g} m/s", name, speed));
}

/// Small and fast bodies need short steps, or they pass through others.
void add_body(const SceneSpec& scene, const BodySpec& body, Demands& demands) {
  add_thing(body.name, body.contact, demands);
  const auto* sphere = body.shape ? std::get_if<Sphere>(&*body.shape) : nullptr;
  if (sphere) return add_speed(body.name, sphere->radius, norm(body.velocity), demands);
  const double stiff = longest_stiff_step(scene, body.contact, body.material, body.mass);
  demands.add(std::max(stiff, choices.back()), fmt::format("{} on stiff ground under {}", body.name, body.contact));
}

}  // namespace

double longest_stiff_step(const SceneSpec& scene, const std::string& contact, const std::string& material,
                          double mass) {
  const double stiffness = scene.materials.find({.material = material}, {.material = scene.field.surface}).stiffness;
  if (stiffness == 0 || mass == 0 || catalog::make_contact_law(contact)->implicit())
    return std::numeric_limits<double>::infinity();
  const double mass_at_point = mass / 2;  // two of four points carry the body when it tilts
  return std::sqrt(explicit_resolution * mass_at_point / stiffness);
}

/// The shortest step that any part of the scene demands, with the reason for it.
AutomaticRate automatic_rate(const SceneSpec& scene) {
  Demands demands;
  for (const RobotSpec& robot : scene.robots) add_robot(robot, scene.events, demands);
  if (const auto& ball = scene.ball) {
    add_thing("ball", ball->contact, demands);
    add_speed("ball", ball->radius, norm(ball->velocity), demands);
  }
  std::size_t things = scene.robots.size() + (scene.ball ? 1 : 0);
  for (const BodySpec& body : scene.bodies) {
    if (body.is_static) continue;
    add_body(scene, body, demands);
    ++things;
  }
  if (things > 1) {
    const catalog::BodyContactLawType& law = catalog::body_contacts().find(scene.body_contact);
    demands.add(law.accurate_step, fmt::format("bodies that touch, under {}", law.name));
  }
  return demands.rate();
}

}  // namespace murosimf::scene_file
