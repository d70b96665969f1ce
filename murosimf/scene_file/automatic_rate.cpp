#include "murosimf/scene_file/automatic_rate.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"

namespace murosimf::scene_file {
namespace {

constexpr std::array<double, 5> choices{0.01, 0.005, 0.002, 0.001, 0.0005};  // [s]
constexpr double longest_kinematic = 0.005;  // [s] 1.2 % of the way in a curve; 2.8 % at 10 ms

/// The shortest of the steps that somebody demands.
class Demands {
 public:
  void add(double longest_step, std::string who) {
    if (!because_.empty() && longest_step >= longest_) return;
    longest_ = longest_step;
    because_ = std::move(who);
  }
  [[nodiscard]] AutomaticRate rate() const {
    if (because_.empty()) return {usual_step_rate, "nothing moves"};
    const auto fits = [&](double step) { return step <= longest_ * (1 + 1e-9); };
    const auto* step = std::ranges::find_if(choices, fits);
    return {1 / (step == choices.end() ? longest_ : *step), because_};
  }

 private:
  double longest_ = choices.front();
  std::string because_;
};

/// What a robot begins with and what events give it of this key.
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

}  // namespace

AutomaticRate automatic_rate(const SceneSpec& scene) {
  Demands demands;
  for (const RobotSpec& robot : scene.robots) add_robot(robot, scene.events, demands);
  if (scene.ball) add_thing("ball", scene.ball->contact, demands);
  std::size_t things = scene.robots.size() + (scene.ball ? 1 : 0);
  for (const BodySpec& body : scene.bodies) {
    if (body.is_static) continue;
    add_thing(body.name, body.contact, demands);
    ++things;
  }
  if (things > 1) {
    const catalog::BodyContactLawType& law = catalog::body_contacts().find(scene.body_contact);
    demands.add(law.accurate_step, fmt::format("bodies that touch, under {}", law.name));
  }
  return demands.rate();
}

}  // namespace murosimf::scene_file
