/// scene_inside.h - implementation of the handles of include/murosimf: a scene, and data of the handles.
#pragma once

#include <atomic>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/collision/queries.h"
#include "murosimf/files/file_access.h"
#include "murosimf/recording/recorder.h"
#include "murosimf/recording/scratch_folder.h"
#include "murosimf/robot.h"
#include "murosimf/scene.h"
#include "murosimf/scene/assets.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_pictures.h"

namespace murosimf::api {

class ControllerTask;  // controller_algorithm.h

/// A robot's joints as rows without the other objects.
struct JointRows {
  explicit JointRows(const Model& model);

  std::vector<int> objects;  ///< by joint
  std::vector<JointInfo> infos;
  std::vector<double> position, velocity, torque, target;  ///< memory of Robot's spans
};

/// Origin of a scene, for recordings and copies.
struct SceneOrigin {
  std::string name;  ///< as named by the user
  SceneOptions options;
  std::shared_ptr<files::FilesRead> files;              ///< shared by copies, read by the first
  std::shared_ptr<recording::ScratchFolder> text_file;  ///< contains the text of a scene while it is read
};

struct SceneInside {
  SceneInside(const scene_file::SceneSpec& spec, SceneOrigin from, std::shared_ptr<scene::Assets> assets);
  ~SceneInside();

  [[nodiscard]] Simulation& simulation() { return scene.simulation(); }
  [[nodiscard]] World& world() { return scene.simulation().world(); }
  [[nodiscard]] Entity& entity(int number) { return *world().entities()[static_cast<std::size_t>(number)]; }
  /// Index of the entity. Throws UnknownName.
  [[nodiscard]] int number_of(std::string_view entity);
  /// Creates all data that are read from now on; cameras without a handle are not drawn.
  void begin();
  void step();
  /// Rethrows an exception of the program's controller.
  void check_failure();
  /// From any thread.
  void fail(std::exception_ptr reason);

  [[nodiscard]] JointRows& joints(int number);
  /// Queries in the present state of the world.
  [[nodiscard]] collision::QueryScene& fresh_queries();
  /// Throws InputError if an algorithm of the scene writes them.
  void check_targets_are_free(int number);
  /// EntityHandle::push, once the scene has begun.
  void push(int number, std::string_view object, const Vector3& force, double duration, const Vector3& moment);

  SceneOrigin origin;
  std::shared_ptr<scene::Assets> assets;
  std::atomic<bool> failed = false;
  scene::Scene scene;
  bool begun = false;
  std::map<int, JointRows> joint_rows;
  std::map<int, ControllerTask*> controllers;                   ///< of the program
  std::map<int, bool> targets_are_free;                         ///< results of earlier checks
  std::unique_ptr<collision::QueryScene> queries;               ///< null: before the first query
  std::unique_ptr<scene::ScenePainter> painter;                 ///< likewise
  std::vector<std::unique_ptr<recording::Recorder>> recorders;  ///< the simulation calls them

 private:
  std::mutex failing_;
  std::exception_ptr failure_;
};

/// From a file or name.
[[nodiscard]] std::shared_ptr<SceneInside> open_scene(const std::string& name, const SceneOptions& options);
/// From a text in the format of a file.
[[nodiscard]] std::shared_ptr<SceneInside> open_text(const std::string& toml, const SceneOptions& options);
/// Another scene with the same spec and options.
[[nodiscard]] std::shared_ptr<SceneInside> another_scene(SceneInside& like, std::optional<std::uint64_t> seed);

}  // namespace murosimf::api
