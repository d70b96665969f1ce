#include "murosimf/recording/additions_now.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "murosimf/recording/recorded_addition.h"
#include "murosimf/recording/state_file.h"

namespace murosimf::recording {

void AdditionsNow::know(const AttachedFiles& files) {
  for (const auto& [name, what] : files.list.values) known_files_.insert(name);
}

void AdditionsNow::take(const scene::Scene& scene, Duration first, RecordedPaths& paths) {
  const std::vector<scene::Addition>& all = scene.parts().additions;
  if (taken_ == all.size()) return;
  if (with_files_) take_files(scene, paths);
  for (; taken_ < all.size(); ++taken_) texts_.push_back(json_of(scene, all[taken_], first, paths));
}

/// Several of a kind are read once.
void AdditionsNow::take_files(const scene::Scene& scene, RecordedPaths& paths) {
  const files::FilesRead& read = *scene.parts().files_of_additions;
  paths.extend(read.list(), read.names());
  std::vector<std::filesystem::path> added;
  for (const std::filesystem::path& file : read.list()) {
    if (known_files_.insert(paths.reduced(file)).second) added.push_back(file);
  }
  AttachedFiles now = files_now(added, paths);
  files_.list.name = now.list.name;
  files_.list.values.merge(now.list.values);
  files_.folders = std::move(now.folders);
  std::ranges::move(now.contents, std::back_inserter(files_.contents));
}

/// One that came before the first frame is part of all states.
std::string AdditionsNow::json_of(const scene::Scene& scene, const scene::Addition& addition, Duration first,
                                  const RecordedPaths& paths) const {
  const scene::SceneParts& parts = scene.parts();
  RecordedAddition recorded{.what = addition.what};
  recorded.time = std::max(addition.time, first);
  recorded.in_state = recorded.time == scene.simulation().now();
  if (parts.outside.notes) recorded.channels = parts.outside.notes->names();
  if (with_files_) {
    RunDescription names;
    names.names = parts.files_of_additions->names();
    recorded.names = paths.in_description(std::move(names)).names;
  }
  std::visit([&](auto& spec) { spec.model = paths.in_text(spec.model); }, recorded.what);
  return to_json(recorded);
}

void AdditionsNow::write(McapWriter& file, Duration now) {
  if (!files_.list.values.empty()) attach_files(file, std::exchange(files_, {}));
  for (const std::string& text : std::exchange(texts_, {})) {
    file.attach(text_attachment(fmt::format("{}{}.json", additions_prefix, ++written_), text, now));
  }
}

}  // namespace murosimf::recording
