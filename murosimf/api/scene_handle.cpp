// include/murosimf/scene.h: the run itself. Its contents are in scene_contents.cpp.
#include "murosimf/scene.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/api/scene_inside.h"
#include "murosimf/api/told.h"
#include "murosimf/scene/scene_python.h"

namespace murosimf {
inline namespace v0 {

using api::told;

namespace {

void check_seconds(double seconds, std::string_view what) {
  constexpr double longest = 3e9;  // [s] nanoseconds in 64 bits end after that
  if (!(seconds >= 0 && seconds <= longest)) throw InputError(fmt::format("{} {} s: 0 to 3e9 s", what, seconds));
}

/// A quoted string of TOML; control characters were refused before.
std::string toml_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace

Scene::Scene(const std::string& name, const SceneOptions& options) : inside_(api::open_scene(name, options)) {}
Scene::Scene(std::shared_ptr<api::SceneInside> inside) : inside_(std::move(inside)) {}
Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

Scene Scene::of_text(const std::string& toml, const SceneOptions& options) {
  return Scene(api::open_text(toml, options));
}

/// Through the text of a scene, so that defaults and checks are those of scene files.
Scene Scene::of_robot(const std::string& model, const SceneOptions& options) {
  for (const char c : model) {
    if (c == '\n' || c == '\r') throw InputError("a name of a robot file has no line ends");
  }
  return of_text(fmt::format("[[robots]]\nname = \"robot\"\nmodel = {}\nlevel = \"articulated_dynamics\"\n"
                             "controller = \"none\"\n",
                             toml_text(model)),
                 options);
}

Scene Scene::copy() const {
  api::SceneInside& from = inside();
  if (!from.controllers.empty()) {
    throw InputError(fmt::format("'{}' has a controller of the program, which cannot be copied",
                                 from.entity(from.controllers.begin()->first).name()));
  }
  const std::vector<std::byte> state = told([&] { return from.scene.save(); });
  from.begun = true;  // save() has initialized it
  Scene copied(api::another_scene(from, {}));
  copied.load(state);
  return copied;
}

api::SceneInside& Scene::inside() const {
  if (!inside_) throw Error("this scene was moved from");
  return *inside_;
}

const std::string& Scene::name() const { return inside().scene.spec().name; }
double Scene::time() const { return seconds(inside().simulation().now()); }
std::int64_t Scene::nanoseconds() const { return inside().simulation().now().count(); }

double Scene::step_length() const {
  inside().begin();
  return seconds(inside().simulation().tick());
}

void Scene::step(int steps) {
  if (steps < 0) throw InputError(fmt::format("{} steps", steps));
  for (int i = 0; i < steps; ++i) inside().step();
}

void Scene::run(double duration) {
  check_seconds(duration, "a run of");
  const Duration end = inside().simulation().now() + from_seconds(duration);
  while (inside().simulation().now() < end && ended().empty()) inside().step();
}

void Scene::reset() {
  told([&] { inside().scene.reset(); });
  inside().begun = true;
}

void Scene::reset(std::uint64_t seed) {
  told([&] { inside().scene.reset(seed); });
  inside().begun = true;
}

std::vector<std::byte> Scene::save() {
  inside().begin();
  return told([&] { return inside().scene.save(); });
}

void Scene::load(std::span<const std::byte> state) {
  inside().begin();
  told([&] { inside().scene.load(state); });
}

std::string Scene::ended() const { return scene::end_of_run(inside().scene.parts()); }

std::uint64_t Scene::state_hash() const {
  inside().begin();
  return inside().simulation().state_hash();
}

void Scene::change(const std::string& assignment) { change(std::vector<std::string>{assignment}); }

void Scene::change(const std::vector<std::string>& assignments) {
  inside().begin();
  told([&] { inside().scene.change(assignments); });
}

std::vector<RunEvent> Scene::events() const {
  std::vector<RunEvent> events;
  for (const Event& event : inside().simulation().events()) events.push_back({seconds(event.time), event.text});
  return events;
}

std::vector<std::string> Scene::warnings() const {
  std::vector<std::string> all = inside().scene.parts().diagnostics.warnings();
  const auto& later = inside().simulation().warnings();
  all.insert(all.end(), later.begin(), later.end());
  return all;
}

}  // namespace v0
}  // namespace murosimf
