#include "murosimf/studies/doctor_cases.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/find_entry.h"
#include "murosimf/model/properties.h"

namespace murosimf::studies {
namespace {

/// Results should not depend on the step.
std::vector<DoctorCase> steps(bool quick) {
  std::vector<DoctorCase> cases;
  for (const double ms : quick ? std::vector{0.5, 10.0} : std::vector{0.5, 1.0, 2.0, 5.0, 10.0}) {
    cases.push_back({fmt::format("{:g} ms", ms), {fmt::format("rate={:g}", 1000 / ms)}, {}});
  }
  return cases;
}

std::vector<DoctorCase> levels(const scene::Scene& scene) {
  std::vector<DoctorCase> cases;
  for (const catalog::LevelType& level : catalog::levels()) {
    DoctorCase one{level.name, {}, {}};
    for (const scene_file::RobotSpec& robot : scene.spec().robots) {
      one.overrides.push_back(fmt::format("{}.level={}", robot.name, level.name));
    }
    cases.push_back(std::move(one));
  }
  return cases;
}

std::vector<DoctorCase> gravities(bool quick) {
  std::vector<DoctorCase> cases{{"none", {"gravity=[0,0,0]"}, {}}, {"moon", {"gravity=[0,0,-1.62]"}, {}}};
  if (!quick) cases.push_back({"earth", {"gravity=[0,0,-9.81]"}, {}});
  return cases;
}

std::vector<DoctorCase> seeds(bool quick) {
  std::vector<DoctorCase> cases;
  for (std::uint64_t seed = 1; seed <= (quick ? 2U : 5U); ++seed) cases.push_back({fmt::format("{}", seed), {}, seed});
  return cases;
}

void add_gains(const Entity& robot, double factor, std::vector<std::string>& overrides) {
  MUROSIMF_ASSERT(factor > 0);
  const Model& model = robot.model();
  for (const int joint : model.joints()) {
    const Servo* servo = model.find(properties::servo, joint);
    if (!servo) continue;
    // A gain of 0 stays 0.
    const auto add = [&](const char* gain, double value) {
      if (value <= 0) return;
      overrides.push_back(
          fmt::format("{}.{}.servo.{}={}", robot.name(), model.objects()[joint].name, gain, factor * value));
    };
    add("position_gain", servo->position_gain);
    add("velocity_gain", servo->velocity_gain);
  }
}

/// Of robots that servos move.
std::vector<DoctorCase> servos(const scene::Scene& scene) {
  std::vector<DoctorCase> cases;
  for (const double factor : {0.8, 1.2}) {
    DoctorCase one{fmt::format("{:+.0f} %", 100 * (factor - 1)), {}, {}};
    for (const Entity* entity : scene.moving_entities()) {
      const MotionLevel* level = scene.simulation().level_of(*entity);
      if (level && level->traits().servos) add_gains(*entity, factor, one.overrides);
    }
    if (!one.overrides.empty()) cases.push_back(std::move(one));
  }
  return cases;
}

CasesOfDimension cases_of(const std::string& name, bool quick, const scene::Scene& scene) {
  if (name == "steps") return {name, {}, steps(quick)};
  if (name == "gravity") return {name, {}, gravities(quick)};
  if (name == "seeds") return {name, {}, seeds(quick)};
  if (name == "levels") {
    if (scene.spec().robots.empty()) return {name, "the scene has no robots", {}};
    return {name, {}, levels(scene)};
  }
  MUROSIMF_ASSERT(name == "servos");
  std::vector<DoctorCase> cases = servos(scene);
  if (cases.empty()) return {name, "no robot is moved by servos: that is so at articulated_dynamics only", {}};
  return {name, {}, std::move(cases)};
}

}  // namespace

const std::vector<std::string>& doctor_dimensions() {
  static const std::vector<std::string> names = {"steps", "levels", "gravity", "seeds", "servos"};
  return names;
}

std::vector<CasesOfDimension> doctor_cases(const DoctorOptions& options, const scene::Scene& scene) {
  for (const std::string& name : options.dimensions) {
    if (std::ranges::find(doctor_dimensions(), name) != doctor_dimensions().end()) continue;
    const std::vector<std::string_view> known(doctor_dimensions().begin(), doctor_dimensions().end());
    throw SetupError("--only: " + unknown_name("dimension", name, known));
  }
  std::vector<CasesOfDimension> all;
  for (const std::string& name : doctor_dimensions()) {
    const auto& wanted = options.dimensions;
    if (!wanted.empty() && std::ranges::find(wanted, name) == wanted.end()) continue;
    all.push_back(cases_of(name, options.quick, scene));
  }
  return all;
}

}  // namespace murosimf::studies
