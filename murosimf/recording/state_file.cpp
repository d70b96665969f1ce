#include "murosimf/recording/state_file.h"

#include <algorithm>
#include <limits>
#include <span>

#include <fmt/format.h>

#include "murosimf/files/input_file.h"
#include "murosimf/files/output_file.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/frame_writer.h"
#include "murosimf/recording/recorded_addition.h"
#include "murosimf/recording/recorded_series.h"
#include "murosimf/recording/recorded_states.h"
#include "murosimf/recording/recording_schemas.h"
#include "murosimf/recording/scratch_folder.h"

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
  load_state(scene, folder.path() / name);
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

/// Plain states of older versions have no container.
void load_state(scene::Scene& scene, const std::filesystem::path& file) {
  if (!is_recording(file)) {
    const std::string bytes = files::read_input_file(file, files::most_state_bytes);
    return with_context(file.string(), [&] { scene.load(std::as_bytes(std::span(bytes))); });
  }
  const McapReader reader(file);
  const RecordedStates states(reader);
  const RecordedState* last = states.last_until(Duration::max());
  if (!last) throw SetupError(fmt::format("{}: there is no whole state in it (--record-what states)", file.string()));
  const auto additions = recorded_additions(reader);
  const auto in_it = std::ranges::count_if(additions, [&](const auto& one) { return is_part_of(one, last->time); });
  if (in_it > 0) {
    throw SetupError(fmt::format(
        "{}: {} came to that run after its start, which the scene does not have; 'murosimf branch' goes on from it",
        file.string(), in_it == 1 ? "a robot or body" : fmt::format("{} robots and bodies", in_it)));
  }
  states.load(scene, *last);
}

}  // namespace murosimf::recording
