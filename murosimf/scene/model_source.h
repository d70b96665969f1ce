/// model_source.h - the models of a scene's entities: read once for equal robots, copied where the scene overrides constants.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "murosimf/model/model.h"
#include "murosimf/scene/assets.h"
#include "murosimf/scene/diagnostics.h"
#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene {

/// Throws SetupError for a material that is not in the table.
void check_materials(const Model& model, const MaterialTable& materials);

class ModelSource {
 public:
  ModelSource(const scene_file::SceneSpec& spec, Assets& assets, bool lenient, Diagnostics& diagnostics)
      : spec_(spec), assets_(assets), lenient_(lenient), diagnostics_(diagnostics) {}

  /// A robot's model by name or file, with the sensors of its files. Throws SetupError: no such file, an error in it,
  /// an unknown material.
  [[nodiscard]] const RobotKind& robot(const scene_file::RobotSpec& robot);
  /// The same for a body with a file.
  [[nodiscard]] const RobotKind& robot(const scene_file::BodySpec& body);

  /// The model, or a copy with the constants that the scene overrides for this entity.
  [[nodiscard]] ModelPtr changed_for(const std::string& entity, const ModelPtr& model);

  /// Throws SetupError for a material that is not in the scene.
  void check_materials(const Model& model) const { scene::check_materials(model, spec_.materials); }

 private:
  const RobotKind& read(const std::string& name, const std::string& where, const robot_formats::ReaderOptions& options);

  const scene_file::SceneSpec& spec_;
  Assets& assets_;
  bool lenient_;
  Diagnostics& diagnostics_;
  using RobotKey = std::tuple<std::string, std::string, std::map<std::string, std::string>>;
  std::map<RobotKey, std::shared_ptr<const RobotKind>> robots_;          // those checked against the scene
  std::map<std::pair<ModelPtr, std::string>, ModelPtr> with_constants_;  // shared for equal changes
};

}  // namespace murosimf::scene
