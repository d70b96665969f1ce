#include "murosimf/api/scene_inside.h"

#include <fstream>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/api/told.h"
#include "murosimf/files/data_path.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::api {
namespace {

scene::SceneOptions options_of(SceneInside& inside, const SceneOptions& options,
                               std::shared_ptr<scene::Assets> assets) {
  return {.threads = options.threads,
          .seed = options.seed,
          .overrides = options.set,
          .events = options.events,
          .pushes = options.pushes,
          .libraries = options.libraries,
          .lenient = options.lenient,
          .cameras = options.cameras,
          .pushable = true,
          .assets = std::move(assets),
          .stop = [&inside] { return inside.failed.load(); }};
}

void check_threads(const SceneOptions& options) {
  if (options.threads < 1) throw InputError(fmt::format("threads = {}: at least 1", options.threads));
}

/// Reads and builds; `file` contains the scene.
std::shared_ptr<SceneInside> open(const std::filesystem::path& file, SceneOrigin origin) {
  const SceneOptions& options = origin.options;
  const auto spec = scene_file::read_scene(file, options.set, options.events, options.pushes);
  return std::make_shared<SceneInside>(spec, std::move(origin), std::make_shared<scene::Assets>());
}

/// Without a range, a joint has infinite limits: programs can compare with them.
JointInfo info_of(const Model& model, int object) {
  const Object& joint = model.objects()[static_cast<std::size_t>(object)];
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const Vec3d* range = model.find(properties::joint_range, object);
  return {joint.name, joint.kind == Kind::prismatic ? "m" : "rad", range ? range->x : -infinite,
          range ? range->y : infinite};
}

}  // namespace

JointRows::JointRows(const Model& model) : objects(model.joints().begin(), model.joints().end()) {
  for (const int object : objects) infos.push_back(info_of(model, object));
  position.resize(objects.size());
  velocity = torque = target = position;
}

SceneInside::SceneInside(const scene_file::SceneSpec& spec, SceneOrigin from, std::shared_ptr<scene::Assets> shared)
    : origin(std::move(from)), assets(std::move(shared)), scene(spec, options_of(*this, origin.options, assets)) {}

SceneInside::~SceneInside() = default;

int SceneInside::number_of(std::string_view entity) {
  if (const Entity* found = world().find(entity)) return world().index_of(found);
  std::vector<std::string_view> names;
  for (const auto& each : world().entities()) names.emplace_back(each->name());
  throw_unknown("entity", entity, names);
}

void SceneInside::begin() {
  if (begun) return;
  told([&] { simulation().initialize(); });
  begun = true;
}

void SceneInside::step() {
  begun = true;
  told([&] {
    simulation().step();
    scene.parts().crashes->check();
  });
  check_failure();
}

/// Exceptions of controllers are thrown by steps that must not throw: they are kept, and thrown here.
void SceneInside::check_failure() {
  if (!failed) return;
  const std::lock_guard lock(failing_);
  MUROSIMF_ASSERT(failure_ != nullptr);
  failed = false;
  std::rethrow_exception(std::exchange(failure_, nullptr));
}

void SceneInside::fail(std::exception_ptr reason) {
  MUROSIMF_ASSERT(reason != nullptr);
  const std::lock_guard lock(failing_);
  if (failed) return;  // the first exception counts
  failure_ = std::move(reason);
  failed = true;
}

JointRows& SceneInside::joints(int number) {
  return joint_rows.try_emplace(number, entity(number).model()).first->second;
}

collision::QueryScene& SceneInside::fresh_queries() {
  begin();
  if (!queries) told([&] { queries = std::make_unique<collision::QueryScene>(world()); });
  queries->refresh();
  return *queries;
}

void SceneInside::check_targets_are_free(int number) {
  begin();
  const auto [known, is_new] = targets_are_free.try_emplace(number, false);
  const auto writers =
      is_new ? simulation().writers_of(entity(number), properties::joint_target.name) : std::vector<std::string>{};
  if (is_new) known->second = writers.empty();
  if (known->second) return;
  targets_are_free.erase(known);  // checked again next time: the controller may change
  throw InputError(fmt::format("joint targets of '{}' are written by '{}' in every step; give it the controller 'none'",
                               entity(number).name(), fmt::join(writers, "', '")));
}

/// Through the command of the run, so that recordings have it.
void SceneInside::push(int number, std::string_view object, const Vector3& force, double duration,
                       const Vector3& moment) {
  const Model& model = entity(number).model();
  const std::string pushed(object.empty() ? std::string_view(model.objects()[0].name) : object);
  if (!model.find_object(pushed))
    throw_unknown(fmt::format("object of '{}'", entity(number).name()), pushed, model.object_names());
  told([&] {
    scene.change({fmt::format("{}.{}.push=[{}, {}, {}, {}, {}, {}, {}]", entity(number).name(), pushed, force.x,
                              force.y, force.z, moment.x, moment.y, moment.z, duration)});
  });
}

std::shared_ptr<SceneInside> open_scene(const std::string& name, const SceneOptions& options) {
  check_threads(options);
  return told([&] {
    SceneOrigin origin{name, options, std::make_shared<files::FilesRead>(), nullptr};
    const files::FileScope noting({.noted = origin.files});
    return open(files::find_data_file(name, "scenes", ".toml"), std::move(origin));
  });
}

/// Scenes read their files by name: the text gets a file, in a folder that lives as long as the scene.
std::shared_ptr<SceneInside> open_text(const std::string& toml, const SceneOptions& options) {
  check_threads(options);
  auto folder = told([] { return std::make_shared<recording::ScratchFolder>(); });
  const std::filesystem::path file = folder->path() / "scene.toml";
  if (!(std::ofstream(file) << toml).flush()) throw Error(fmt::format("{} cannot be written", file.string()));
  try {
    SceneOrigin origin{file.string(), options, std::make_shared<files::FilesRead>(), folder};
    const files::FileScope noting({.noted = origin.files});
    return open(files::find_data_file(file.string(), "scenes", ".toml"), std::move(origin));
  } catch (const SetupError& error) {
    std::string text = error.what();
    const std::string prefix = folder->path().string() + "/";
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
      text.erase(at, prefix.size());
    }
    throw InputError(text);
  }
}

std::shared_ptr<SceneInside> another_scene(SceneInside& like, std::optional<std::uint64_t> seed) {
  SceneOrigin origin = like.origin;
  if (seed) origin.options.seed = seed;
  return told([&] { return std::make_shared<SceneInside>(like.scene.spec(), std::move(origin), like.assets); });
}

}  // namespace murosimf::api
