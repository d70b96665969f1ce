/// spawned_entities.h - entities that SpawnEntity adds to a running scene: from a model's file, or from the text of one.
///
/// They are added absent: a command of the run lets them in, and a reset leaves them out. What is deleted stays in the scene, absent, and
/// comes back when the same is spawned by its name again.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "murosimf/files/allowed_files.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/scratch_folder.h"
#include "murosimf/ros2/simulation_messages.h"
#include "murosimf/scene/scene.h"

namespace murosimf::ros2 {

/// The request of SpawnEntity, as far as it was understood.
struct SpawnRequest {
  std::string name;  ///< empty: by the model
  bool may_rename = false;
  std::string uri;   ///< name or file of a model; empty: `text`
  std::string text;  ///< of a file: MJCF, URDF or SDF
  std::string entity_namespace;
  EntityState pose;
};

class RefusedSpawn : public SetupError {
 public:
  RefusedSpawn(ResultCode code, const std::string& why) : SetupError(why), code_(code) {}
  [[nodiscard]] ResultCode code() const { return code_; }

 private:
  ResultCode code_;
};

class SpawnedEntities {
 public:
  /// `models_from`: files that a uri may mean; null: those that come with the program. `say`: the whole of an error of which a
  /// client is told the place only.
  SpawnedEntities(std::shared_ptr<const files::AllowedFiles> models_from,
                  std::function<void(const std::string& line)> say);

  /// Whether it was added by one of these.
  [[nodiscard]] bool has(const std::string& name) const { return all_.contains(name); }
  /// One that was deleted, or that a reset has left out, and is what is wanted; empty: there is none.
  [[nodiscard]] std::string waiting_for(const scene::Scene& scene, const SpawnRequest& wanted) const;
  /// Adds it, absent, between two steps; returns its name. Throws RefusedSpawn, and changes nothing.
  [[nodiscard]] std::string add(scene::Scene& scene, const SpawnRequest& wanted);

 private:
  [[nodiscard]] std::filesystem::path file_of(const scene::Scene& scene, const SpawnRequest& wanted);
  [[nodiscard]] std::filesystem::path written(const std::string& text);
  [[noreturn]] void refuse(const SpawnRequest& wanted, const std::string& whole) const;

  std::shared_ptr<const files::AllowedFiles> models_from_;
  std::function<void(const std::string&)> say_;
  std::unique_ptr<recording::ScratchFolder> texts_;       // as files; null: none has come
  std::shared_ptr<const files::AllowedFiles> with_text_;  // what a text may read
  std::map<std::string, std::string> all_;                // what each was made of
  int count_ = 0;                                         // of texts
};

}  // namespace murosimf::ros2
