/// requested_scene.h - scenes requested over a network: the files they may use, and the error details that are reported.
///
///     const auto allowed = files_of_run(scene, folders, files_read.list());   // when the run begins
///     ...
///     for_outside(name, {.overrides = asked, .files = {.only_from = allowed}}, [&](const SceneOptions& options) { Scene next(name, options); });
///
/// Every interface that accepts the name of a scene uses this. Overrides: scene_file/remote_override.h.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/files/allowed_files.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/scene.h"

namespace murosimf::scene {

/// Error in such a scene. `what()` is for the client: it quotes no file.
class RequestError : public SetupError {
 public:
  RequestError(const std::string& told, std::string whole) : SetupError(told), whole_(std::move(whole)) {}
  /// For the operator of the run.
  [[nodiscard]] const std::string& whole() const { return whole_; }

 private:
  std::string whole_;
};

/// The folders of a scene, of its models, and of supplied files; `folders` and `files` from the command line.
[[nodiscard]] std::shared_ptr<const files::AllowedFiles> files_of_run(const Scene& scene,
                                                                      std::vector<std::filesystem::path> folders,
                                                                      std::vector<std::filesystem::path> files);

/// Looks at what is asked, then calls `build`, which finds and opens files of `options.files.only_from` alone (not null). Throws SetupError
/// for errors in the request, RequestError for all that has to do with what stands in files.
void for_outside(const std::string& name, const SceneOptions& options, const std::function<void()>& build);

/// "walk.toml:12: kid.xml:7" of "/home/me/walk.toml:12:3: /home/me/kid.xml:7: message"; empty if it begins with no place.
[[nodiscard]] std::string places_in(std::string_view message);

}  // namespace murosimf::scene
