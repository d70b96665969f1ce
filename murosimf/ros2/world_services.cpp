// Services of simulation_interfaces that ask for worlds, or load them.
#include "murosimf/files/data_path.h"
#include "murosimf/ros2/simulation_services.h"

namespace murosimf::ros2 {

void SimulationServices::get_current_world(dds::CdrReader&, Answer& out) {
  std::string name, file;
  put(out, attempt([&] {
        visit([&](scene::Scene& scene) {
          name = scene.spec().name;
          file = scene.spec().file.stem().string();
        });
      }));
  put_world(out, file, name);
}

void SimulationServices::get_available_worlds(dds::CdrReader& in, Answer& out) {
  (void)read_texts(in);
  EntityFilters filter;
  read_tags_into(in, filter);
  if (!in.good()) return;
  std::vector<std::string> names;
  if (has_tags(filter, {})) names = files::data_file_names("scenes", ".toml");  // worlds have no tags
  put(out, Result{});
  out.u32(static_cast<std::uint32_t>(names.size()));
  for (const std::string& name : names) put_world(out, name, "");
}

/// The present run ends then; the next one, stopped at its start, has the wanted scene, and services of the same names.
void SimulationServices::load_world(dds::CdrReader& in, Answer& out) {
  const std::string uri = in.text(), resource = in.text();
  for (int i = 0; i < 2; ++i) (void)in.number<std::uint8_t>();
  if (!in.good()) return;
  const auto answer_with = [&](const Result& result) {
    put(out, result);
    put_world(out, result.code == ResultCode::ok ? uri : "", "");
  };
  if (uri.empty() && resource.empty()) return answer_with({ResultCode::no_world_resource, "no uri"});
  if (uri.empty() || !options_.exchange)
    return answer_with(
        {ResultCode::feature_unsupported, "scenes are loaded by uri, where the run may change its scene"});
  Result result = attempt([&] {
    visit([&](scene::Scene&) { options_.exchange({.scene = uri, .overrides = {}, .seed = {}, .paused = true}); });
  });
  if (result.code != ResultCode::ok) return answer_with({ResultCode::world_parse_error, result.message});
  answer_with(result);
  finishes_ = true;
}

}  // namespace murosimf::ros2
