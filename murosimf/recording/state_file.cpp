#include "murosimf/recording/state_file.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "murosimf/files/file_access.h"
#include "murosimf/files/input_file.h"
#include "murosimf/files/output_file.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/additions_now.h"
#include "murosimf/recording/frame_writer.h"
#include "murosimf/recording/recorded_addition.h"
#include "murosimf/recording/recorded_series.h"
#include "murosimf/recording/recorded_states.h"
#include "murosimf/recording/recording_schemas.h"
#include "murosimf/recording/scratch_folder.h"
#include "murosimf/recording/unpacked_files.h"

namespace murosimf::recording {

Metadata run_metadata(const scene::Scene& scene, const std::string& program, const std::string& command_line) {
  return {.name = "murosimf",
          .values = {{"program", program},
                     {"command_line", command_line},
                     {"scene", scene.spec().name},
                     {"seed", fmt::format("{}", scene.spec().seed)},
                     {"step_rate_hz", fmt::format("{}", scene.spec().rate)}}};
}

Attachment text_attachment(const std::string& name, const std::string& text, Duration time) {
  MUROSIMF_ASSERT(time >= Duration{});
  return {.log_time = static_cast<std::uint64_t>(time.count()),
          .create_time = 0,
          .name = name,
          .media_type = name.ends_with(".json") ? "application/json" : "text/plain",
          .data = text};
}

namespace {

void attach_additions(McapWriter& out, const scene::Scene& scene, const StateFileOptions& options) {
  RecordedPaths paths = options.paths;
  AdditionsNow additions(true);
  additions.know(options.files);
  additions.take(scene, Duration{}, paths);
  additions.write(out, scene.simulation().now());
}

/// Of a robot or body.
std::string added_name(const auto& added) {
  return std::visit([](const auto& spec) { return spec.name; }, added);
}

/// Those of a state that the scene lacks: it may have had them before, as one that goes back.
std::vector<RecordedAddition> missing_in(const scene::Scene& scene, const McapReader& reader, Duration state) {
  std::vector<RecordedAddition> missing = recorded_additions(reader);
  std::erase_if(missing, [&](const RecordedAddition& one) {
    const auto& there = scene.parts().additions;
    const bool is_there = std::ranges::any_of(there, [&](const scene::Addition& addition) {
      return added_name(addition.what) == added_name(one.what);
    });
    return is_there || !is_part_of(one, state);
  });
  return missing;
}

files::FoundNames names_of(const McapReader& reader, const std::vector<RecordedAddition>& additions) {
  const std::string run = attached_text(reader, "run.json");
  files::FoundNames names = run.empty() ? files::FoundNames{} : parse_run_description(run).names;
  for (const RecordedAddition& addition : additions) names.insert(addition.names.begin(), addition.names.end());
  return names;
}

/// Where the file of a model stands now; as it is called, if the state does not have it. The scene is where it always is, so that names in it mean what
/// they meant from there.
std::string place_of(const std::string& model, const files::FoundNames& names, const files::MovedFiles& moved) {
  const auto name = names.lower_bound(model + "\nmodels\n");
  const bool is_found = name != names.end() && name->first.starts_with(model + "\nmodels\n") && !name->second.empty();
  const bool is_reduced = model.starts_with('/') && std::filesystem::exists(moved.to_here(model));
  if (!is_found && !is_reduced) return model;
  return moved.to_here(is_found ? name->second : model).string();
}

/// From the files that the state has with it, which stay as long as the scene may name them.
void add_all(scene::Scene& scene, const McapReader& reader, const std::vector<RecordedAddition>& additions) {
  if (additions.empty()) return;
  const auto unpacked = std::make_shared<const UnpackedFiles>(reader);
  const files::FoundNames names = names_of(reader, additions);
  const auto moved = std::make_shared<const files::MovedFiles>(unpacked->folder(), names);
  scene.parts().files_of_additions->keep(unpacked);
  const files::FileScope scope({.moved = moved});
  for (RecordedAddition addition : additions) {
    std::visit([&](auto& spec) { spec.model = place_of(spec.model, names, *moved); }, addition.what);
    add_to(scene, addition);
  }
}

void let_leave(scene::Scene& scene, std::size_t first) {
  const auto& all = scene.parts().additions;
  for (std::size_t i = first; i < all.size(); ++i) {
    const std::string name = added_name(all[i].what);
    if (scene.simulation().world().entity(name).present()) scene.leave(name);
  }
}

enum class Additions { taken, refused };

void load(scene::Scene& scene, const std::filesystem::path& file, Additions additions) {
  const McapReader reader(file);
  const RecordedStates states(reader);
  const RecordedState* last = states.last_until(Duration::max());
  if (!last) throw SetupError(fmt::format("{}: there is no whole state in it (--record-what states)", file.string()));
  const std::vector<RecordedAddition> missing = missing_in(scene, reader, last->time);
  if (additions == Additions::refused && !missing.empty()) {
    throw SetupError(
        fmt::format("{}: {} came to that run after its start, which this one does not have", file.string(),
                    missing.size() == 1 ? "a robot or body" : fmt::format("{} robots and bodies", missing.size())));
  }
  const std::size_t before = scene.parts().additions.size();
  try {
    with_context(file.string(), [&] { add_all(scene, reader, missing); });
    states.load(scene, *last);
  } catch (const SetupError&) {
    let_leave(scene, before);
    throw;
  }
}

/// Plain states of older versions have no container.
void load_any(scene::Scene& scene, const std::filesystem::path& file, Additions additions) {
  if (is_recording(file)) return load(scene, file, additions);
  const std::string bytes = files::read_input_file(file, files::most_state_bytes);
  with_context(file.string(), [&] { scene.load(std::as_bytes(std::span(bytes))); });
}

}  // namespace

/// Through a file, since the writer needs one; its folder goes with it.
std::string state_bytes(scene::Scene& scene, const StateFileOptions& options) {
  const Duration now = scene.simulation().now();
  const ScratchFolder folder;
  const std::filesystem::path part = folder.path() / "state.mcap";
  McapWriter out(part, {.library = options.program});
  out.add(run_metadata(scene, options.program, options.command_line));
  attach_files(out, options.files);
  RunDescription run = options.run;
  run.start = now;
  out.attach(text_attachment("run.json", to_json(run), now));
  attach_additions(out, scene, options);
  const auto schema = out.add_schema("murosimf.State", "protobuf", descriptors_of(find_schema("murosimf.State")));
  const auto channel = out.add_channel("/state", "protobuf", schema);
  std::string bytes;
  put_state(bytes, now, scene.simulation().state_hash(), scene.save());
  out.write(channel, now, bytes);
  out.close();
  return files::read_input_file(part, std::numeric_limits<std::int64_t>::max());
}

void write_state(scene::Scene& scene, const std::filesystem::path& file, const StateFileOptions& options) {
  files::write_file(file, state_bytes(scene, options));
}

void load_state_bytes(scene::Scene& scene, const std::string& bytes, const std::string& name) {
  const ScratchFolder folder;
  files::write_file(folder.path() / name, bytes);
  load_any(scene, folder.path() / name, Additions::refused);
}

/// Older files do not say it.
std::optional<bool> was_pushable(const std::filesystem::path& file) {
  if (!is_recording(file)) return std::nullopt;
  const McapReader reader(file);
  const auto& all = reader.contents().attachments;
  const bool says = std::ranges::any_of(all, [](const AttachmentIndex& one) { return one.name == "run.json"; });
  if (!says) return std::nullopt;
  return parse_run_description(attached_text(reader, "run.json")).pushable;
}

void load_state(scene::Scene& scene, const std::filesystem::path& file) { load_any(scene, file, Additions::taken); }

}  // namespace murosimf::recording
